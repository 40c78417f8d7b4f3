"""The view on a terminal, as its user meets it: the program in tmux.

    terminal_test.py HOST_SIM
"""

import itertools
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from logs import Log, LoggedNode

HOST_SIM = ""
SKIPPED = 77


class Pane:
    """A terminal of its own with a shell in it."""

    numbers = itertools.count()

    def __init__(self, folder, columns, rows, environment=()):
        self._socket = f"monitor-{os.getpid()}-{next(Pane.numbers)}"
        settings = [item for name, value in environment for item in ("-e", f"{name}={value}")]
        self._tmux("-f", "/dev/null", "new-session", "-d", "-c", folder, "-x", columns, "-y", rows, *settings, "sh")

    def _tmux(self, *arguments):
        done = subprocess.run(["tmux", "-L", self._socket, *map(str, arguments)], capture_output=True, text=True,
                              check=True, env={**os.environ, "TERM": "xterm-256color", "ENV": "", "PS1": "$ "})
        return done.stdout

    def type(self, *keys):
        self._tmux("send-keys", *keys)

    def run(self, *command):
        self.type(shlex.join(map(str, command)) + "; echo status=$?; stty -a", "Enter")

    def screen(self, colours=False):
        return self._tmux("capture-pane", "-p", *(["-e"] if colours else []))

    def resize(self, columns, rows):
        self._tmux("resize-window", "-x", columns, "-y", rows)

    def close(self):
        self._tmux("kill-server")


class TerminalTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="terminal-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def pane(self, columns=110, rows=24, environment=()):
        pane = Pane(self.folder, columns, rows, environment)
        self.addCleanup(pane.close)
        return pane

    def eventually(self, pane, condition, what, seconds=20):
        deadline = time.monotonic() + seconds
        while not condition(pane.screen()):
            if time.monotonic() > deadline:
                self.fail(f"not within {seconds} s: {what}\n{pane.screen()}")
            time.sleep(0.05)

    def log(self, *nodes, seconds=2.0):
        log = Log()
        for number, state, damage_ppb in nodes:
            LoggedNode(log, number, state, damage_ppb, rate_ppb_per_h=1234).speak(0, seconds)
        return log.write(self.folder / "run.log").name

    def show(self, pane, *nodes):
        pane.run(HOST_SIM, "monitor", "--log", self.log(*nodes), "--replay-speed", "max")
        self.eventually(pane, lambda screen: "at its end" in screen, "the end of the log")

    def test_a_row_for_each_node_in_words_and_colours(self):
        pane = self.pane()
        self.show(pane, (1, "normal", 20_000_000), (2, "inspect", 612_345_678), (3, "worn", 1_200_000_000))
        rows = [line.split() for line in pane.screen().splitlines()]
        self.assertIn("1 normal 2 12.3 - 45.6 h - 0.0001234 0.9 s 0 0".split(), rows)
        self.assertIn("2 inspect 61.2345678 12.3 - 45.6 h - 0.0001234 0.9 s 0 0".split(), rows)
        self.assertIn("3 worn 120 12.3 - 45.6 h - 0.0001234 0.9 s 0 0".split(), rows)
        coloured = pane.screen(colours=True)
        for look in ("\x1b[32mnormal", "\x1b[33minspect", "\x1b[1m\x1b[37m\x1b[41mworn"):
            self.assertIn(look, coloured)

    def test_no_color_is_obeyed(self):
        pane = self.pane(environment=[("NO_COLOR", "1")])
        self.show(pane, (3, "worn", 1_200_000_000))
        self.assertNotIn("\x1b[", pane.screen(colours=True))
        self.assertIn("worn", pane.screen())

    def test_a_silent_node_turns_stale_and_vanishes(self):
        log = Log()
        LoggedNode(log, 4, "inspect", 500_000_000).speak(0, 1)
        log.add(600, 0x7FF, b"")
        pane = self.pane()
        pane.run(HOST_SIM, "monitor", "--log", log.write(self.folder / "silent.log"))
        self.eventually(pane, lambda screen: "inspect STALE" in screen and "50 STALE" in screen, "stale values")
        self.assertIn("\x1b[90minspect STALE", pane.screen(colours=True))
        self.eventually(pane, lambda screen: "inspect VANISHED" in screen, "the node has vanished")
        pane.type("q")
        self.eventually(pane, lambda screen: "status=0" in screen, "q ends it")

    def test_the_width_is_respected(self):
        pane = self.pane(columns=34)
        self.show(pane, (1, "normal", 20_000_000))
        self.assertEqual([line for line in pane.screen().splitlines() if line][1:6],
                         ["Too narrow for LEFT B10 - B90,", "BREAK RISK, RATE %/h, HEARTBEAT,", "LOST, NOTES",
                          "NODE  STATE   DAMAGE %  FAILED", "1     normal  2         0"])
        pane.resize(110, 24)
        self.eventually(pane, lambda screen: "HEARTBEAT" in screen and "Too narrow" not in screen, "all columns")

    def test_rows_that_have_no_room_are_counted(self):
        pane = self.pane(rows=6)
        self.show(pane, *((node, "normal", 0) for node in range(1, 11)))
        self.assertIn("7 more; q ends", pane.screen())

    def test_the_terminal_is_as_before(self):
        for key in ("q", "C-c"):
            pane = self.pane()
            pane.run("echo", "before")
            self.show(pane, (1, "normal", 0))
            self.assertNotIn("before", pane.screen())
            pane.type(key)
            self.eventually(pane, lambda screen: "status=0" in screen, f"{key} ends it")
            screen = pane.screen()
            self.assertIn("before", screen)
            for mode in ("icanon", "echo", "isig"):
                self.assertRegex(screen, rf"(^|\s){mode}\b")

    def test_the_last_table_stays(self):
        pane = self.pane(columns=60)
        self.show(pane, (1, "normal", 20_000_000), (2, "worn", 1_200_000_000))
        pane.type("q")
        self.eventually(pane, lambda screen: "status=0" in screen, "q ends it")
        lines = [line.rstrip() for line in pane.screen().splitlines()]
        head = next(i for i, line in enumerate(lines) if line.startswith("NODE"))
        self.assertRegex(lines[head - 2], r"run\.log, at its end  \d+ frames")
        self.assertEqual([line.split()[:3] for line in lines[head + 1:head + 3]],
                         [["2", "worn", "120"], ["1", "normal", "2"]])
        self.assertEqual(lines[head + 3], "status=0")

    def test_it_is_paused_and_goes_back_and_on(self):
        log = Log()
        node = LoggedNode(log, 1)
        for second in range(40):
            node.damage_ppb = 10_000_000 * second
            node.speak(second, second + 1)
        pane = self.pane(environment=[("TZ", "UTC")])
        pane.run(HOST_SIM, "monitor", "--log", log.write(self.folder / "long.log").name, "--replay-speed", "max")
        self.eventually(pane, lambda screen: "at its end" in screen, "the end of the log")

        def shows(second, time):
            def shown(screen):
                rows = [line.split() for line in screen.splitlines()]
                return f"PAUSED at 2020-09-13 {time} UTC" in screen and any(
                    row[:3] == ["1", "normal", str(second)] for row in rows)
            self.eventually(pane, shown, f"the damage of {time}")

        pane.type("Space")  # the log begins at 12:26:40 and ends 39.9 s later
        shows(39, "12:27:19.9")
        pane.type("Left")
        shows(29, "12:27:09.9")
        self.assertIn("10.0 s before the newest; counts are of the last 10 min", pane.screen())
        pane.type("Left", "Left", "Right")
        shows(19, "12:26:59.9")
        pane.type("PageUp")
        shows(0, "12:26:40.0")
        pane.type("End")
        self.eventually(pane, lambda screen: "PAUSED" not in screen and "normal" in screen, "the newest")
        pane.type("q")
        self.eventually(pane, lambda screen: "status=0" in screen, "q ends it")


def main(host_sim):
    global HOST_SIM
    HOST_SIM = host_sim
    if not shutil.which("tmux"):
        print("SKIPPED, NOTHING WAS TESTED: tmux is missing (toolchains/setup.sh all installs it)")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)


if __name__ == "__main__":
    main(sys.argv[1])
