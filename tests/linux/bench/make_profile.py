#!/usr/bin/env python3
"""Makes a profile at 1 kHz from whole numbers alone.

usage: make_profile.py {motor_current_A|input_tension_N|drive|pair} SEED ROWS > profile.csv

A triangle of 250 rows whose height wanders, with noise; one row in 500 is missing. A drive is motor
current with what it was taken in, a pair the output tension of two tendons, below 0 that of the
other.
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


SURROUNDINGS = "tendon_velocity_m_s,motor_angle_rad,sheath_temperature_C,winding_temperature_C"


def surroundings(i):
    """0.08 m/s to and fro over 10 mm, while it warms by a degree a second."""
    phase = i % 250
    pulling = phase < 125
    way = phase if pulling else 250 - phase
    velocity = (80 if pulling else -80) if phase % 125 else 0
    return f"{velocity / 1000:.3f},{(way - 62) * 8 / 100:.2f},{20 + i / 1000:.3f},{30 + i / 500:.3f}"


def main():
    kind, seed, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    if kind in ("drive", "pair"):
        column, divisor = {"drive": ("motor_current_A", 200), "pair": ("output_tension_N", 10)}[kind]
        print(f"time_s,{column},{SURROUNDINGS}")
        for i, value in rows(seed, count):
            load = (value - (400 if kind == "pair" else 0)) / divisor
            print(f"{i / 1000:.3f},{load:.6f},{surroundings(i)}")
        return
    column = kind
    divisor = {"motor_current_A": 200, "input_tension_N": 8}[column]
    print(f"time_s,{column}")
    for i, value in rows(seed, count):
        print(f"{i / 1000:.3f},{value / divisor:.6f}")


if __name__ == "__main__":
    main()
