"""The monitor beside candump: the same frames, and no damage that nobody told, whatever the cable does."""

import re
import time

from bench.case import Case
from bench.frames import EMERGENCY, STATUS, USABLE, Check, Status
from bench.program import binary
from bench.raw_can import ERROR_BUS_OFF, read_log

NODE = 5
SENT = 400
PROBE = 0x7FF
ALL = ("0:0", "#FFFFFFFF")  # filters of candump: frames of every kind, and of every error
BAD = ("wrong_crc", "wrong_length")


def status_of(i):
    return Status(i % 16, "normal", 1_000_000 + 977 * i, 0, 0, 3)


class Monitor:
    """A monitor that has begun to hear; its record, and the table that it prints at its end."""

    def __init__(self, case, interface, *options):
        self._case, self._folder = case, case.folder() / "logs"
        self.program = case.start(binary("host_sim"), "monitor", "--interface", interface,
                                  "--record", self._folder, *options)
        self.hears(interface)

    def hears(self, interface):
        """A frame of now comes through."""
        before, probe = len(self.frames(True)), self._case.node(interface)
        self._case.eventually(lambda: (probe.send(PROBE, b""), len(self.frames(True)))[1] > before, "the monitor hears")

    def frames(self, probes=False):
        logs = sorted(self._folder.glob("*.log")) if self._folder.exists() else []
        return [frame for log in logs for frame in read_log(log) if probes or frame.id != PROBE]

    def rests(self):
        """Nothing more comes to the record."""
        size = -1
        while size != (now := sum(log.stat().st_size for log in self._folder.glob("*.log"))):
            size = now
            time.sleep(1)

    def table(self):
        """The row of each node, and the text above them; once the program has ended."""
        lines = self.program.output().splitlines()
        head = next(i for i, line in enumerate(lines) if line.startswith("NODE"))
        return {int(line.split()[0]): line.split() for line in lines[head + 1:]}, "\n".join(lines[:head])


class MonitorBesideCandumpTest(Case):
    def watch(self, *faults):
        """What candump and the monitor heard of a sender behind a cable with these faults."""
        cable = self.cable()
        monitor = Monitor(self, cable.far)
        candump = self.log(cable.far, *ALL)
        if faults:
            cable.fault(*faults)
        sender = self.node(cable.near)
        for i in range(SENT):
            sender.send(STATUS + NODE, status_of(i).encoded(NODE))
            time.sleep(0.005)
        heard = -1
        while heard != len(candump.frames()):
            heard = len(candump.frames())
            time.sleep(1)
        self.assertEqual(monitor.program.stop(), 0)
        frames = [frame for frame in candump.frames() if frame.id != PROBE]
        self.assertEqual(monitor.frames(), frames)
        rows, text = monitor.table()
        self.assertEqual(int(re.search(r"(\d+) frames", text).group(1)),
                         len([f for f in monitor.frames(True) if not f.id & 0x2000_0000]))
        self.verify(rows, frames)
        return rows, frames

    def verify(self, rows, frames):
        """No other node, no damage that was not told, and each damaged frame counted."""
        self.assertEqual(list(rows), [NODE])
        shown_ppb = round(float(rows[NODE][2 if rows[NODE][2] not in ("STALE", "VANISHED") else 3]) * 1e7)
        arrived = self.judged(frames, STATUS)
        told = [Status.of(frame).damage_ppb for frame, verdict in arrived if verdict not in BAD]
        usable = [Status.of(frame).damage_ppb for frame, verdict in arrived if verdict in USABLE]
        self.assertIn(shown_ppb, [status_of(i).damage_ppb for i in range(SENT)])
        self.assertIn(shown_ppb, told)
        self.assertGreaterEqual(shown_ppb, max(usable))
        failed = rows[NODE][-2] if rows[NODE][-2].isdigit() else rows[NODE][-3]
        # One bit of the identifier makes an Emergency of a LifeStatus.
        both = arrived + self.judged(frames, EMERGENCY)
        self.assertEqual(int(failed), len([verdict for _, verdict in both if verdict in BAD]))

    def judged(self, frames, kind):
        check = Check(kind, NODE)
        return [(frame, check.verdict(frame)) for frame in frames if frame.id == kind + NODE]

    def test_without_a_fault_every_frame_is_seen(self):
        rows, frames = self.watch()
        self.assertEqual(len(frames), SENT)
        self.assertIn(f"{status_of(SENT - 1).damage_ppb / 1e7:.7f}".rstrip("0"), rows[NODE])

    def test_loss(self):
        _, frames = self.watch("loss", "30%")
        self.assertLess(len(frames), SENT)

    def test_bit_errors(self):
        _, frames = self.watch("corrupt", "40%")
        self.assertTrue(any(frame.id != STATUS + NODE for frame in frames), "an identifier was damaged too")

    def test_everything_at_once(self):
        self.watch("delay", "20ms", "10ms", "loss", "10%", "duplicate", "10%", "corrupt", "10%",
                   "reorder", "20%", "limit", "1000")


class MonitorInterfaceTest(Case):
    def test_once_listens_and_ends(self):
        bus = self.bus()
        monitor = Monitor(self, bus.name, "--once", "--listen", "3")
        sender = self.node(bus.name)
        for i in range(20):
            sender.send(STATUS + NODE, status_of(i).encoded(NODE))
            time.sleep(0.05)
        self.assertEqual(monitor.program.wait(20), 0)
        self.assertEqual(list(monitor.table()[0]), [NODE])

    def test_a_flood_is_seen_or_its_losses_are_counted(self):
        bus = self.bus()
        monitor = Monitor(self, bus.name)
        monitor.rests()
        before = len(monitor.frames(True))
        sender, flood = self.node(bus.name), 30_000
        began = time.monotonic()
        for i in range(flood):
            sender.send(STATUS + NODE, bytes(8))
        rate = flood / (time.monotonic() - began)
        monitor.rests()
        sender.send(STATUS + NODE, bytes(8))  # the kernel tells with it what had no room before
        monitor.rests()
        self.assertEqual(monitor.program.stop(), 0)
        text = monitor.table()[1]
        lost = re.search(r"(\d+) frames were lost before the monitor", text)
        seen = int(re.search(r"(\d+) frames", text).group(1))
        print(f"{rate:.0f} frames a second; {seen} seen, {lost.group(1) if lost else 0} lost", flush=True)
        self.assertEqual(seen + int(lost.group(1) if lost else 0), before + flood + 1)
        self.assertEqual(len(monitor.frames(True)), seen)

    def test_bus_off_is_shown(self):
        bus = self.bus()
        monitor = Monitor(self, bus.name)
        self.node(bus.name).send_error(ERROR_BUS_OFF)
        self.eventually(lambda: any(frame.id & ERROR_BUS_OFF for frame in monitor.frames()), "the error is recorded")
        self.assertEqual(monitor.program.stop(), 0)
        self.assertIn("BUS OFF", monitor.table()[1])

    def test_an_interface_that_is_down_and_gone_and_back(self):
        bus = self.bus()
        monitor = Monitor(self, bus.name)
        bus.down()
        time.sleep(0.5)
        self.assertTrue(monitor.program.running())
        bus.up()
        monitor.hears(bus.name)
        bus.close()
        time.sleep(0.5)
        self.assertTrue(monitor.program.running())
        again = self.bus_again(bus)
        monitor.hears(again.name)
        again.down()
        time.sleep(0.5)
        self.assertEqual(monitor.program.stop(), 0)
        self.assertIn(f"BUS LOST: {again.name} is down", monitor.table()[1])

    def bus_again(self, bus):
        """The interface anew, which the cleanup of the first one removes."""
        return type(bus)(bus.name)
