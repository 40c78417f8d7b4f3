#!/usr/bin/env python3
"""Starts the QEMU board with its serial line on a pseudo terminal, whose path QEMU prints.

    board.py HOST_SIM IMAGE QEMU...

QEMU is the command line of the emulator without -serial and -append; its last word asks for the
image. The board plays 5 s of cycles and 10 s of rest again and again, in real time.
"""

import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

from bench.controller import DRIVE, KEY, MODEL

NODE = 5
RATE_HZ = 1000
NEWTON_PER_AMPERE = 0.0325 * 9.0 * 0.88 / 0.0125  # of DRIVE: K_t N eta_g / r_spool


def write_profile(path):
    """40 N +- 30 N at 4 Hz on one tendon, half of that on the other: raw current, Q7.24."""
    with open(path, "wb") as out:
        out.write(struct.pack("<4I", 0x46504C54, 1, 2, 1_000_000 // RATE_HZ))
        for i in range(15 * RATE_HZ):
            active = i < 5 * RATE_HZ
            tension = 40 + (30 * math.sin(2 * math.pi * 4 * i / RATE_HZ) if active else 0)
            raw = round(tension / NEWTON_PER_AMPERE * 2**24)
            out.write(struct.pack("<2i", raw, raw // 2))


def main(host_sim, image, *emulator):
    folder = pathlib.Path(tempfile.mkdtemp(prefix="board-"))  # in the folder of the runner
    model = folder / "model.toml"
    model.write_text(MODEL.format(rate=float(RATE_HZ)) + DRIVE)
    subprocess.run([host_sim, "pack", model, "--out", folder / "block"], check=True, capture_output=True)
    write_profile(folder / "profile")
    words = {"profile": folder / "profile", "block": folder / "block", "flash": folder / "flash",
             "key": KEY.hex(), "node": NODE, "real_time": 1}
    append = " ".join(f"{name}={value}" for name, value in words.items())
    os.execvp(emulator[0], [*emulator, image, "-serial", "pty", "-append", append])


main(*sys.argv[1:])
