"""Plays one profile on two builds of the firmware with an extended model: each frame, the final lives
and the flash must agree byte for byte. With the nominal block of the same model the lives must differ.

usage: compare_extended.py HOST PROGRAM_A PROGRAM_B    HOST writes the inputs, see extended_host.cpp
"""

import pathlib
import subprocess
import sys
import tempfile

BLOCK_BYTES = 84


def require(holds, what):
    if not holds:
        sys.exit(what)


def play(program, folder, name, block):
    files = {what: folder / f"{name}.{what}" for what in ("serial", "summary", "flash")}
    words = {"profile": folder / "profile", "block": block, "summary": files["summary"],
             "flash": files["flash"], "node": 5, "seed": 7}
    subprocess.run([program, files["serial"], *(f"{k}={v}" for k, v in words.items())],
                   stdin=subprocess.DEVNULL, timeout=600, check=True)
    return {what: path.read_bytes() for what, path in files.items()}


def main():
    host, a, b = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        block = folder / "block"
        subprocess.run([host, "--write", folder / "profile", block], check=True)
        first, second = (play(program, folder, who, block) for who, program in (("A", a), ("B", b)))
        for what in first:
            require(first[what] == second[what], f"{what} of B differs from that of A")
        nominal = folder / "nominal"
        nominal.write_bytes(block.read_bytes()[:BLOCK_BYTES])
        require(play(a, folder, "N", nominal)["summary"] != first["summary"],
                "the extension changes no life")
        print(f"{len(first['serial'])} bytes of frames, lives and flash are identical")


main()
