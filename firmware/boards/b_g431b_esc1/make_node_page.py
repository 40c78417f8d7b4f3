#!/usr/bin/env python3
"""Makes the settings of one node, to be flashed at 0x08015800; node_page.hpp has the layout.

usage: make_node_page.py --node 1..127 --termination open|closed [--key KEY_FILE] --out node.bin

KEY_FILE has the AES-128 key as 32 hexadecimal digits and must be readable by its owner alone.
Without a key nothing that needs authority is allowed. The 120 ohm are closed at the two ends of the bus
and open at all nodes between.
"""

import argparse
import os
import pathlib
import stat
import struct
import sys
import zlib

MAGIC, VERSION, KEY_BYTES, OPEN = 0x444E4C54, 1, 16, 0x100


def read_key(path):
    mode = stat.S_IMODE(os.stat(path).st_mode)
    if mode & 0o077:
        sys.exit(f"{path}: mode {mode:04o}; accepted: readable by its owner alone, 0600")
    text = pathlib.Path(path).read_text(encoding="ascii", errors="replace").strip()
    try:
        key = bytes.fromhex(text)
    except ValueError:
        key = b""
    if len(key) != KEY_BYTES or len(text) != 2 * KEY_BYTES:
        sys.exit(f"{path}: not a key; accepted: 32 hexadecimal digits")
    return key


def main():
    parser = argparse.ArgumentParser(description="Makes the settings of one node.")
    parser.add_argument("--node", type=int, required=True)
    parser.add_argument("--termination", choices=["open", "closed"], required=True)
    parser.add_argument("--key")
    parser.add_argument("--out", required=True)
    arguments = parser.parse_args()
    if not 1 <= arguments.node <= 127:
        sys.exit(f"node {arguments.node}; accepted: 1 .. 127")
    try:
        key = read_key(arguments.key) if arguments.key else bytes(KEY_BYTES)
        word = arguments.node | (OPEN if arguments.termination == "open" else 0)
        body = struct.pack("<III", MAGIC, VERSION, word) + key
        # The key is in it: nobody else may read it.
        out = os.open(arguments.out, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
        with os.fdopen(out, "wb") as file:
            file.write(body + struct.pack("<I", zlib.crc32(body)))
    except OSError as error:
        sys.exit(f"{error.filename}: {error.strerror}")


main()
