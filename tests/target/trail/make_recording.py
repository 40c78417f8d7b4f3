"""Writes 20,000 samples of a tendon at work as little-endian 32-bit steps of tension.

usage: make_recording.py OUT
"""

import math
import random
import struct
import sys

NEWTON = 3026330  # 1 N in steps of 2^-29 of 177.4 N
SAMPLES = 20_000

draw = random.Random(20)
level_N = 28.5
with open(sys.argv[1], "wb") as out:
    for i in range(SAMPLES):
        if i % 700 == 0:
            level_N = draw.uniform(20.0, 60.0)
        tension_N = level_N + 12.0 * math.sin(i / 55.0) + draw.gauss(0.0, 0.15)
        out.write(struct.pack("<i", round(tension_N * NEWTON)))
