#!/usr/bin/env python3
"""Makes a profile of motor current or input tension at 1 kHz from whole numbers alone.

usage: make_profile.py {motor_current_A|input_tension_N} SEED ROWS > profile.csv

A triangle of 250 rows whose height wanders, with noise; one row in 500 is missing.
"""
import sys


def rows(seed, count):
    state = seed
    height = 500
    for i in range(count):
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        noise = (state >> 40) % 64 - 32
        phase = i % 250
        if phase == 0:
            height = 300 + (state >> 33) % 700
        if (state >> 20) % 500 != 0 or i == 0:
            yield i, (phase if phase < 125 else 250 - phase) * height // 125 + noise


def main():
    column, seed, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    divisor = {"motor_current_A": 200, "input_tension_N": 8}[column]
    print(f"time_s,{column}")
    for i, value in rows(seed, count):
        print(f"{i / 1000:.3f},{value / divisor:.6f}")


if __name__ == "__main__":
    main()
