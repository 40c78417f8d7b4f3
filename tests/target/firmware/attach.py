"""Attaches to the serial line of the running board as slcand does, and uses it: frames, a command, the
life record by UDS, a power cut and a restart.

usage: attach.py RECORD QEMU... IMAGE      the emulator's command line without -serial, -append
"""

import math
import os
import pathlib
import re
import select
import struct
import subprocess
import sys
import tempfile
import termios
import time
import tty

NODE = 5
KEY = "00112233445566778899aabbccddeeff"
PATIENCE_S = 60


def require(holds, what):
    if not holds:
        raise SystemExit(what)


class Board:
    """The emulator with its pty, and the host's end of the line."""

    def __init__(self, emulator, words):
        append = " ".join(f"{k}={v}" for k, v in words.items())
        self.process = subprocess.Popen([*emulator, "-serial", "pty", "-append", append],
                                        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT)
        said = b""
        while not (found := re.search(rb"redirected to (\S+)", said)):
            chunk = os.read(self.process.stdout.fileno(), 4096)
            require(chunk, f"the emulator ended: {said.decode()}")
            said += chunk
        self.line = os.open(found[1].decode(), os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.line)
        self.text = ""
        self.frames = []

    def write(self, text):
        os.write(self.line, text.encode("ascii"))

    def read(self):
        """Takes what has come; waits a little."""
        if select.select([self.line], [], [], 0.05)[0]:
            self.text += os.read(self.line, 4096).decode("ascii")
        *lines, self.text = re.split(r"[\r\a]", self.text)
        self.frames += [line for line in lines if line and line[0] in "tT"]

    def wait_for(self, pattern, since=0):
        """The first frame from `since` on that matches."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            for i in range(since, len(self.frames)):
                if re.match(pattern, self.frames[i]):
                    return i, self.frames[i]
            require(self.process.poll() is None, "the emulator ended")
            self.read()
        raise SystemExit(f"no frame {pattern} in {self.frames[since:][-20:]}")

    def open(self):
        self.write("C\rS8\rO\r")
        self.wait_for(f"t7{NODE:02X}105")

    def ask(self, *request):
        """A request of one frame; the answer whole."""
        since = len(self.frames)
        data = bytes([len(request), *request]).ljust(8, b"\0")
        self.write(f"T18DA{NODE:02X}F18{data.hex().upper()}\r")
        i, first = self.wait_for(f"T18DAF1{NODE:02X}", since)
        data = bytes.fromhex(first[10:])
        if data[0] >> 4 == 0:
            return data[1:1 + data[0]]
        length, answer = (data[0] & 15) << 8 | data[1], data[2:]
        self.write(f"T18DA{NODE:02X}F13300000\r")
        while len(answer) < length:
            i, line = self.wait_for(f"T18DAF1{NODE:02X}", i + 1)
            answer += bytes.fromhex(line[10:])[1:]
        return answer[:length]

    def power_cut(self):
        self.process.kill()
        self.process.wait()
        os.close(self.line)


def write_profile(path, busy_s):
    """Cycles at 4 Hz, then rest until two minutes are over, at 1 kHz."""
    with open(path, "wb") as out:
        out.write(struct.pack("<4I", 0x46504C54, 1, 2, 1000))
        for i in range(120_000):
            tension_N = 40 + (30 * math.sin(2 * math.pi * 4 * i / 1000) if i < 1000 * busy_s else 0)
            raw = round(tension_N / 20.592 * 2**24)
            out.write(struct.pack("<2i", raw, raw // 2))


def life(board, tendon):
    answer = board.ask(0x22, 0x02, tendon)
    require(answer[:3] == bytes([0x62, 0x02, tendon]) and len(answer) == 64, f"life: {answer.hex()}")
    return {"epoch_ppb": int.from_bytes(answer[11:15], "little"),
            "exact": int.from_bytes(answer[19:35], "little"), "sequence": answer[3]}


def main():
    record, *emulator = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_profile(folder / "busy", 3)
        write_profile(folder / "rest", 0)
        subprocess.run([record, "--block", folder / "block"], check=True)
        words = {"profile": folder / "busy", "block": folder / "block", "flash": folder / "flash",
                 "key": KEY, "node": NODE, "real_time": 1}
        board = Board(emulator, words)
        try:
            board.open()
            require(board.ask(0x3E, 0x00) == bytes([0x7E, 0x00]), "TesterPresent is not answered")

            command = subprocess.run([record, "--command", str(NODE), "2", "8"], check=True,
                                     stdout=subprocess.PIPE).stdout.decode("ascii")
            since = len(board.frames)
            board.write(command)
            _, bus = board.wait_for(f"t28{NODE}8..8", since)
            require(bytes.fromhex(bus[5:])[6:8] == b"\0\0", f"a command was refused: {bus}")
            # The same once more is of no use to anybody.
            board.write(command)
            board.wait_for(f"t28{NODE}8..8.{{9}}0100", since)

            refusal = board.ask(0x31, 0x01, 0x02, 0x01)
            require(refusal == bytes([0x7F, 0x31, 0x13]), f"a routine without proof: {refusal.hex()}")
            # Until the tendon rests and all is saved that was counted.
            last, before = None, life(board, 0)
            while before != last or before["epoch_ppb"] == 0:
                board.wait_for(f"t28{NODE}8..2.{{9}}0000", len(board.frames))
                last, before = before, life(board, 0)
            require(before["epoch_ppb"] == before["exact"] * 10**9 >> 104, "exact and rounded differ")
        finally:
            board.power_cut()

        board = Board(emulator, {**words, "profile": folder / "rest"})
        try:
            board.open()
            after = life(board, 0)
            require(after == before, f"life {before} before the power cut, {after} after it")
        finally:
            board.power_cut()
        print(f"life {before['epoch_ppb']} ppb before and after the power cut")


main()
