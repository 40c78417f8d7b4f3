"""The verb: what it prints, records and answers.

    verb_test.py HOST_SIM
"""

import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request

from logs import Log, LoggedNode

HOST_SIM = ""

MODEL = """schema = 1
[cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
[counting]
sample_rate_Hz = 100.0
hysteresis_N = 0.2
[life]
mean_stress = "gerber"
ipl_scale = 1.53e5
ipl_exponent = 1.38
weibull_shape = 5.94
[watch]
minimum_tension_N = 0.4
broken_tension_N = 0.2
broken_travel_mm = 20.0
slack_travel_mm = 2.0
"""


def monitor(*arguments, stdin=None, **options):
    return subprocess.run([HOST_SIM, "monitor", *map(str, arguments)], capture_output=True, text=True, check=False,
                          input=stdin, **options)


def full_disk(bytes):
    """Options of a program whose files can grow no further than this."""
    return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (bytes, resource.RLIM_INFINITY)),
            "restore_signals": False}


def fetch(url):
    with urllib.request.urlopen(url, timeout=10) as answer:
        return answer.read().decode()


def wait_for(holds, seconds=20):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        try:
            if holds():
                return
        except urllib.error.HTTPError:
            pass
        time.sleep(0.1)
    raise TimeoutError("waited in vain")


class VerbTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="verb-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def log(self, fill, seconds=2.0):
        log = Log()
        fill(log, seconds)
        return log.write(self.folder / "run.log")

    def status_of(self, state="normal", spoil=None, silent_s=0.0):
        def fill(log, seconds):
            node = LoggedNode(log, 5, state, 30_000_000)
            node.speak(0, seconds)
            if spoil is not None:
                node.status(seconds, spoil)
            if silent_s:
                log.add(seconds + silent_s, 0x7FF, b"")

        return monitor("--log", self.log(fill), "--once")

    def test_a_table_without_colours(self):
        done = self.status_of()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("\x1b", done.stdout)
        self.assertEqual(done.stdout.splitlines()[-1].split(), "5 normal 3 12.3 - 45.6 h - 0 0.9 s 0 0".split())
        self.assertIn("42 frames", done.stdout)
        self.assertEqual(done.stderr, "")

    def test_what_needs_attention_is_told_by_the_status(self):
        self.assertEqual(self.status_of("inspect").returncode, 0)
        self.assertEqual(self.status_of("replace").returncode, 3)
        self.assertEqual(self.status_of("worn").returncode, 3)
        damaged = self.status_of(spoil=4)
        self.assertEqual(damaged.returncode, 3)
        self.assertEqual(damaged.stdout.splitlines()[-1].split()[:3], ["5", "normal", "3"])
        vanished = self.status_of(silent_s=3.5)
        self.assertEqual(vanished.returncode, 3)
        self.assertIn("normal VANISHED", vanished.stdout)

    def test_two_controllers_with_one_node_id(self):
        def fill(log, seconds):
            LoggedNode(log, 5, "normal").speak(0, seconds)
            LoggedNode(log, 5, "normal").speak(0.04, seconds + 0.04)

        done = monitor("--log", self.log(fill), "--once")
        self.assertEqual(done.returncode, 3)
        self.assertIn("TWO CONTROLLERS (normal)", done.stdout)

    def test_an_old_status_after_a_silence_does_not_clear_the_alarm(self):
        def fill(log, seconds):
            LoggedNode(log, 5, "worn", 900_000_000).speak(0, seconds)
            LoggedNode(log, 5, "normal", 100_000_000).status(seconds + 0.4)

        done = monitor("--log", self.log(fill), "--once")
        self.assertEqual(done.returncode, 3)
        self.assertIn("worn", done.stdout)

    def test_standard_input_is_a_log(self):
        log = self.log(lambda log, seconds: LoggedNode(log, 5).speak(0, seconds))
        done = monitor("--log", "-", "--once", stdin=log.read_text())
        self.assertIn("42 frames", done.stdout)

    def test_the_record_is_the_log(self):
        log = self.log(lambda log, seconds: LoggedNode(log, 5).speak(0, seconds), seconds=60.0)
        logs = self.folder / "logs"
        done = monitor("--log", log, "--once", "--record", logs, "--record-rotate", "16K")
        self.assertEqual(done.returncode, 0, done.stderr)
        files = sorted(logs.iterdir())
        self.assertGreater(len(files), 2)
        self.assertTrue(all(file.stat().st_size <= 16 * 1024 for file in files))
        text = "".join(file.read_text() for file in files)
        self.assertEqual(text.replace(" log ", " can0 "), log.read_text())

    def test_a_torn_record_is_gone_on_with(self):
        log = self.log(lambda log, seconds: LoggedNode(log, 5).speak(0, seconds))
        logs = self.folder / "logs"
        monitor("--log", log, "--once", "--record", logs)
        only = logs / "frames-00000001.log"
        whole = only.read_text()
        with only.open("a") as file:
            file.write("(0000")
        done = monitor("--log", log, "--once", "--record", logs)
        self.assertEqual(done.stderr, f"{only}: a torn last line of 5 bytes was cut off\n")
        self.assertEqual(only.read_text(), 2 * whole)

    def test_a_record_on_a_full_disk_is_told_by_the_status(self):
        log = self.log(lambda log, seconds: LoggedNode(log, 5).speak(0, seconds))
        done = monitor("--log", log, "--once", "--record", self.folder / "logs", **full_disk(0))
        self.assertEqual(done.returncode, 1)
        only = self.folder / "logs" / "frames-00000001.log"
        self.assertEqual(done.stderr, f"{only}: cannot be written: File too large; 42 frames were not recorded\n")
        self.assertIn("42 frames", done.stdout)

    def test_trouble_is_told_at_once_without_a_terminal(self):
        log = self.log(lambda log, seconds: LoggedNode(log, 5).speak(0, seconds), seconds=60.0)
        with subprocess.Popen([HOST_SIM, "monitor", "--log", log, "--record", self.folder / "logs"], text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              **full_disk(0)) as process:
            self.assertIn("cannot be written: File too large", process.stderr.readline())
            self.assertIsNone(process.poll())
            process.terminate()
            self.assertEqual(process.wait(20), 1)

    def exported(self, log, *arguments):
        """What the live page gives as candump at the end of a log, of all and of node 5."""
        with subprocess.Popen([HOST_SIM, "monitor", "--log", log, "--replay-speed", "max", "--http", "127.0.0.1:0",
                               *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as process:
            try:
                page = process.stderr.readline().removeprefix("live page: ").strip()
                wait_for(lambda: json.loads(fetch(page + "api/fleet"))["source_ended"])
                return [fetch(page + f"export/{name}.candump").replace(" log ", " can0 ") for name in ("all", "5")]
            finally:
                process.terminate()

    def test_the_page_exports_what_was_seen_or_recorded(self):
        def fill(log, seconds):
            for node in (5, 6):
                LoggedNode(log, node).speak(0, seconds)

        log = self.log(fill, seconds=60.0)
        lines = log.read_text().splitlines(keepends=True)
        of_five = "".join(line for line in lines if int(line.split()[2].split("#")[0], 16) & 0x7F == 5)
        wanted = ["".join(lines), of_five]
        self.assertEqual(self.exported(log), wanted)
        self.assertEqual(self.exported(log, "--record", self.folder / "logs"), wanted)

    def test_a_wire_that_breaks_is_a_specimen(self):
        model = self.folder / "model.toml"
        model.write_text(MODEL)
        profile = self.folder / "profile.csv"
        # A triangle of 20 to 60 N in 2 s; then nothing is left but friction, while 100 mm are pulled.
        rows = [(20 + 40 * abs((i / 100) % 2 - 1), 0.01) for i in range(12_000)] + 2000 * [(0.1, 0.01)]
        with profile.open("w") as file:
            file.write("time_s,input_tension_N,tendon_velocity_m_s\n")
            file.writelines(f"{i / 100},{tension:.3f},{velocity}\n" for i, (tension, velocity) in enumerate(rows))
        log, offline, online = (self.folder / name for name in ("run.log", "offline.csv", "online.csv"))
        replayed = subprocess.run([HOST_SIM, "replay", profile, "--model", model, "--can", log, "--specimens", offline],
                                  capture_output=True, text=True, check=False)
        self.assertEqual(replayed.returncode, 0, replayed.stderr)
        done = monitor("--log", log, "--once", "--specimens", online, "--model", model)
        self.assertEqual((done.returncode, done.stderr), (3, ""))
        (wanted,), (found,) = ([line.split(",") for line in path.read_text().splitlines()[1:]]
                               for path in (offline, online))
        self.assertRegex(found[0], r"^node1-tendon0-\d+\.\d{3}$")
        self.assertEqual((found[1], found[2], found[5]), ("field", "0", "failed"))
        self.assertEqual(wanted[5], "failed")
        self.assertAlmostEqual(float(found[3]), float(wanted[3]), delta=0.02 * float(wanted[3]))
        self.assertAlmostEqual(float(found[4]), float(wanted[4]), delta=2)
        monitor("--log", log, "--once", "--specimens", online, "--model", model)
        self.assertEqual(len(online.read_text().splitlines()), 2)

        # By another law of life the same damage is of another tension.
        other = self.folder / "other.toml"
        other.write_text(MODEL.replace("ipl_exponent = 1.38", "ipl_exponent = 1.5"))
        done = monitor("--log", log, "--once", "--specimens", self.folder / "none.csv", "--model", other)
        self.assertEqual(done.returncode, 3)
        self.assertRegex(done.stderr, r"^\S+none.csv: node 1 counts with other parameters than the model "
                                      r"\(configuration [0-9a-f]{8}\): no rows of it\n$")
        self.assertEqual(len((self.folder / "none.csv").read_text().splitlines()), 1)

    def test_specimens_that_cannot_be_written_are_told_before_anything_runs(self):
        model = self.folder / "model.toml"
        model.write_text(MODEL)
        log = self.log(lambda log, seconds: LoggedNode(log, 5).speak(0, seconds))
        other = self.folder / "other.csv"
        other.write_text("a,b\n1,2\n")
        for path, wanted in ((self.folder, "cannot be written: "), (self.folder / "none" / "s.csv", "cannot be written: "),
                             (other, "accepted: a new file, or one that this option has written")):
            done = monitor("--log", log, "--once", "--specimens", path, "--model", model)
            self.assertEqual((done.returncode, done.stdout), (1, ""), path)
            self.assertIn(wanted, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertEqual(other.read_text(), "a,b\n1,2\n")
        self.assertEqual(monitor("--log", log, "--once", "--specimens", self.folder / "s.csv").returncode, 2)
        self.assertEqual(monitor("--log", log, "--once", "--model", model).returncode, 2)

    def test_wrong_usage(self):
        for arguments in ([], ["--log", "a", "--interface", "can0"], ["--log", "a", "--replay-speed", "fast"],
                          ["--interface", "can0", "--replay-speed", "2"], ["--log", "a", "--replay-speed", "-1"],
                          ["--log", "a", "--listen", "3"], ["--log", "a", "--record-keep", "3"],
                          ["--interface", "a-name-of-16-char"]):
            done = monitor(*arguments)
            self.assertEqual(done.returncode, 2, (arguments, done.stdout))
            self.assertTrue(done.stderr)

    def test_bad_input(self):
        missing = monitor("--log", self.folder / "none", "--once")
        self.assertEqual(missing.returncode, 1)
        bad = self.folder / "bad.log"
        bad.write_text("(1600000000.000000) can0 185#0102\n(1600000000.000000) can0 hello\n")
        done = monitor("--log", bad, "--once")
        self.assertEqual(done.returncode, 1)
        self.assertTrue(done.stderr.startswith(f"{bad}:2:"), done.stderr)
        nothing = monitor("--interface", "no_such_if", "--once")
        self.assertEqual(nothing.returncode, 1)
        self.assertIn("accepted: ", nothing.stderr)


if __name__ == "__main__":
    HOST_SIM = sys.argv[1]
    unittest.main(argv=sys.argv[:1], verbosity=2)
