"""Logs of nodes, made after the frame plan of tests/kernel/bench/frames.py, which is apart from the code under test."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "kernel"))

from bench.frames import DETAIL, EMERGENCY, HEARTBEAT, STATUS, Status, protect  # noqa: E402


class Log:
    """Lines of `candump -L`."""

    def __init__(self, begin_s=1_600_000_000):
        self.lines, self._begin_s = [], begin_s

    def add(self, time_s, id, data):
        microseconds = round((self._begin_s + time_s) * 1_000_000)
        stamp = f"{microseconds // 1_000_000:010}.{microseconds % 1_000_000:06}"
        self.lines.append((microseconds, f"({stamp}) can0 {id:03X}#{data.hex().upper()}\n"))

    def write(self, path):
        text = "".join(line for _, line in sorted(self.lines))
        pathlib.Path(path).write_text(text, encoding="ascii")
        return path


class LoggedNode:
    """A node that speaks into a log as the firmware does."""

    def __init__(self, log, node, state="normal", damage_ppb=0, rate_ppb_per_h=0):
        self.node, self.state, self.damage_ppb, self.rate_ppb_per_h = node, state, damage_ppb, rate_ppb_per_h
        self._log, self._counters = log, {STATUS: 0, DETAIL: 0, EMERGENCY: 0}

    def _send(self, time_s, kind, data, spoil=None):
        frame = bytearray(protect(kind, self.node, self._counters[kind], data))
        self._counters[kind] = (self._counters[kind] + 1) % 16
        if spoil is not None:
            frame[spoil] ^= 1
        self._log.add(time_s, kind + self.node, bytes(frame))

    def status(self, time_s, spoil=None):
        encoded = Status(0, self.state, self.damage_ppb, 0, 0, 3).encoded(self.node)
        self._send(time_s, STATUS, encoded, spoil)

    def page(self, time_s, page, content):
        self._send(time_s, DETAIL, bytes([0, page << 4]) + content.ljust(6, b"\0"))

    def emergency(self, time_s, code):
        self._send(time_s, EMERGENCY, code.to_bytes(2, "little") + bytes(6))

    def speak(self, begin_s, end_s):
        """Heartbeats, statuses, and two pages in turn."""
        for i in range(round((end_s - begin_s) * 10)):
            time_s = begin_s + i / 10
            if i % 10 == 0:
                self._log.add(time_s, HEARTBEAT + self.node, b"\x05")
            self.status(time_s)
            if i % 2 == 0:
                self.page(time_s, 2, self.rate_ppb_per_h.to_bytes(4, "little"))
            else:
                self.page(time_s, 5, b"".join(tenths.to_bytes(2, "little") for tenths in (123, 200, 456)))
