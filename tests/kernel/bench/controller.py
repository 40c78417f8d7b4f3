"""The Linux controller with what it needs: model, parameter block, profile, configuration."""

import json
import math
import subprocess
import time

from bench import frames
from bench.program import binary
from bench.raw_can import Node

RATE_HZ = 100
DEBOUNCE_S = 0.005
KEY = bytes(range(1, 17))

MODEL = """schema = 1
[cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
[counting]
sample_rate_Hz = {rate}
hysteresis_N = 0.2
[life]
mean_stress = "gerber"
ipl_scale = 1.53e5
ipl_exponent = 1.38
weibull_shape = 5.94
"""

DRIVE = """[drive]
torque_constant_Nm_per_A = 0.0325
gear_ratio = 9.0
gear_efficiency = 0.88
spool_radius_mm = 12.5
current_offset_A = 0.0
"""

CONFIGURATION = """schema = 1
[node]
id = {node}
serial = "kernel-test"
authority_key = "{folder}/key"
[can]
interface = "{interface}"
[loop]
rate_Hz = {rate}
real_time = "off"
[store]
folder = "{folder}/store"
[sensor]
kind = "profile"
at_end = "{at_end}"
[[tendon]]
parameters = "{folder}/block"
profile = "{folder}/profile.csv"
[gpio]
{gpio}
"""

GPIO = """chip = "{chip}"
drive_enable = "drive"
brake = "brake"
emergency_stop = "stop"
debounce_ms = {debounce_ms}
status_light = "light"
watchdog = "watchdog"
"""

LINES = ("stop", "drive", "brake", "light", "watchdog")


class Profile:
    """A sine of input tension, in newton and seconds, and then a rest at its low end."""

    def __init__(self, low, high, period_s=0.1, active_s=5.0, rest_s=0.0):
        self.low, self.high, self.period_s = low, high, period_s
        self.active_s, self.rest_s = active_s, rest_s

    def write(self, path):
        middle, half = (self.low + self.high) / 2, (self.high - self.low) / 2
        with open(path, "w", encoding="ascii") as out:
            out.write("time_s,input_tension_N\n")
            for i in range(round((self.active_s + self.rest_s) * RATE_HZ)):
                time_s = i / RATE_HZ
                active = time_s < self.active_s
                swing = half * math.cos(2 * math.pi * time_s / self.period_s) if active else half
                out.write(f"{time_s:.4f},{middle - swing:.6f}\n")

    @property
    def cycles(self):
        return round(self.active_s / self.period_s)

    def damage_of_a_cycle(self):
        """Gerber, inverse power law and Miner: equations (11) and (19) of the paper."""
        mean, amplitude = (self.low + self.high) / 2, (self.high - self.low) / 2
        effective = amplitude / (1 - (mean / 177.4) ** 2)
        return effective ** 1.38 / 1.53e5


class Setup:
    """The files of one controller; run() starts it, as often as wanted, over the same store."""

    def __init__(self, case, interface, node=5, chip=None, profile=Profile(20, 120), at_end="repeat"):
        self._case, self.node, self.folder = case, node, case.folder()
        (self.folder / "store").mkdir()
        (self.folder / "key").write_text(KEY.hex() + "\n")
        (self.folder / "key").chmod(0o600)
        model = self.folder / "model.toml"
        model.write_text(MODEL.format(rate=float(RATE_HZ)))
        subprocess.run([binary("host_sim"), "pack", model, "--out", self.folder / "block"], check=True,
                       capture_output=True)
        profile.write(self.folder / "profile.csv")
        gpio = GPIO.format(chip=chip.path, debounce_ms=1000 * DEBOUNCE_S) if chip else 'chip = "none"\n'
        self.configuration = self.folder / "controller.toml"
        self.configuration.write_text(CONFIGURATION.format(
            node=node, folder=self.folder, interface=interface, rate=RATE_HZ, at_end=at_end, gpio=gpio))

    def replace(self, old, new):
        """Edits the configuration."""
        text = self.configuration.read_text()
        assert old in text, old
        self.configuration.write_text(text.replace(old, new))

    def run(self):
        report = self.folder / "report.json"
        report.unlink(missing_ok=True)
        arguments = ("--config", self.configuration, "--report", report)
        controller = self._case.start(binary("controller"), *arguments)
        controller.report = lambda: json.loads(report.read_text())
        return controller


class Ear:
    """Listens to one node and keeps what it said, after the check of its integrity."""

    def __init__(self, case, interface, node=5):
        self._case, self._node_id = case, node
        self._socket = Node(interface)
        case.addCleanup(self._socket.close)
        self._checks = {kind: frames.Check(kind, node) for kind in (frames.STATUS, frames.DETAIL, frames.EMERGENCY)}
        self.forget()

    def forget(self):
        """Only what comes from now on counts."""
        self.statuses, self.emergencies, self.heartbeats, self.pages = [], [], [], {}

    def listen(self, seconds=0.0):
        """Takes in what has come; waits so long for the first frame."""
        while frame := self._socket.receive(seconds):
            seconds = 0.0
            self._take(frame)
        return self

    def listen_for(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.listen(0.02)

    def _take(self, frame):
        if frame.id == frames.HEARTBEAT + self._node_id:
            self.heartbeats.append(frame)
        for kind, check in self._checks.items():
            if frame.id == kind + self._node_id and check.verdict(frame) in frames.USABLE:
                self._keep(kind, frame)

    def _keep(self, kind, frame):
        if kind == frames.STATUS:
            self.statuses.append(frames.Status.of(frame))
        elif kind == frames.EMERGENCY:
            self.emergencies.append(frames.Emergency.of(frame))
        else:
            self.pages[frames.page(frame)] = frame

    def until(self, condition, what, seconds=20.0):
        """Listens until the condition on this ear is true."""
        return self._case.eventually(lambda: condition(self.listen(0.05)), what, seconds)

    @property
    def status(self):
        return self.statuses[-1] if self.statuses else None

    def codes(self):
        return [emergency.code for emergency in self.emergencies]
