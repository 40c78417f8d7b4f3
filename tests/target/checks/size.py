"""Bytes of code and constants of linked images, and of objects by symbol, as JSON.

usage: size.py SIZE NM OUT.json NAME=IMAGE... -- NAME=SYMBOL=OBJECT...
"""

import json
import pathlib
import subprocess
import sys


def output(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


def image_bytes(size, image):
    text, data = output(size, image).splitlines()[1].split()[:2]
    return int(text) + int(data)


def symbol_bytes(nm, symbol, path):
    for line in output(nm, "--print-size", path).splitlines():
        fields = line.split()
        if len(fields) == 4 and fields[3] == symbol:
            return int(fields[1], 16)
    sys.exit(f"{path}: no symbol {symbol}")


size, nm, out, *items = sys.argv[1:]
images, symbols = items[:items.index("--")], items[items.index("--") + 1:]
measured = {}
for item in images:
    name, path = item.split("=", 1)
    measured[name] = image_bytes(size, path)
for item in symbols:
    name, symbol, path = item.split("=", 2)
    measured[name] = symbol_bytes(nm, symbol, path)
pathlib.Path(out).write_text(json.dumps(measured, indent=2) + "\n")
