"""Copies a file with one character of its middle line changed.

usage: flip.py FROM TO
"""

import pathlib
import sys

lines = pathlib.Path(sys.argv[1]).read_text().splitlines()
middle = len(lines) // 2
digit = "0" if lines[middle][12] != "0" else "1"
lines[middle] = lines[middle][:12] + digit + lines[middle][13:]
pathlib.Path(sys.argv[2]).write_text("\n".join(lines) + "\n")
