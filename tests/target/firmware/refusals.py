"""Bad command lines and files: each ends with its exit code and a text that says what is wrong.

usage: refusals.py RECORD PROGRAM      called as PROGRAM SERIAL NAME=VALUE...
"""

import pathlib
import struct
import subprocess
import sys
import tempfile

record, program = sys.argv[1:]
BAD_INPUT, USAGE = 1, 2


def expect(code, text, **words):
    run = subprocess.run([program, folder / "serial", *(f"{k}={v}" for k, v in words.items())],
                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         text=True, timeout=60, check=False)
    if run.returncode != code or text not in run.stdout:
        sys.exit(f"{words}: exit code {run.returncode}, expected {code}; {text!r} not in {run.stdout!r}")


def header(magic=0x46504C54, version=1, tendons=2, period_us=1000):
    return struct.pack("<4I", magic, version, tendons, period_us)


def file(name, content):
    (folder / name).write_bytes(content)
    return folder / name


def event(at_ms, kind, payload):
    return struct.pack("<II32s", at_ms, kind, payload)


with tempfile.TemporaryDirectory() as folder_name:
    folder = pathlib.Path(folder_name)
    subprocess.run([record, "--block", folder / "block"], check=True)
    good = file("good", header() + bytes(8) * 1000)
    block = (folder / "block").read_bytes()

    expect(0, "", profile=good, block=folder / "block", flash=folder / "new", summary=folder / "end")
    assert (folder / "new").stat().st_size == 40960 and (folder / "end").stat().st_size > 100

    expect(USAGE, "profile", node=1)
    expect(USAGE, "profile, block, events", profile=good, speed=1)
    expect(USAGE, "1 .. 127", profile=good, node=0)
    expect(USAGE, "1 .. 127", profile=good, node=128)
    expect(USAGE, "32 hexadecimal digits", profile=good, key="0011")
    expect(USAGE, "32 hexadecimal digits", profile=good, key="g" * 32)
    expect(USAGE, "0 .. 4294967295", profile=good, seed=4294967296)
    expect(USAGE, "0 or 1", profile=good, real_time=2)

    expect(BAD_INPUT, "cannot be opened", profile=folder / "missing")
    expect(BAD_INPUT, "shorter than its header", profile=file("p", header()[:15]))
    expect(BAD_INPUT, "does not begin with TLPF", profile=file("p", header(magic=1)))
    expect(BAD_INPUT, "another version; accepted: 1", profile=file("p", header(version=2)))
    expect(BAD_INPUT, "another number of tendons; accepted: 2", profile=file("p", header(tendons=1)))
    for period_us in (9, 1001):
        expect(BAD_INPUT, "accepted: 10 .. 1000 us", profile=file("p", header(period_us=period_us)))

    expect(BAD_INPUT, "block: cannot be opened", profile=good, block=folder / "missing")
    expect(BAD_INPUT, "block: wrong size", profile=good, block=file("b", block[:-1]))
    expect(BAD_INPUT, "block: extension damaged", profile=good, block=file("b", block + b"x"))
    expect(BAD_INPUT, "block: damaged", profile=good, block=file("b", block[:20] + b"x" + block[21:]))
    expect(BAD_INPUT, "events: cannot be opened", profile=good, events=folder / "missing")
    expect(BAD_INPUT, "unknown kind", profile=good, events=file("e", event(5, 6, b"")))
    expect(BAD_INPUT, "faster than the node reads", profile=good,
           events=file("e", event(5, 1, b"V" * 31 + b"\r") * 17))

    for size in (40959, 40961):
        flash = file("f", bytes(size))
        expect(BAD_INPUT, "another size", profile=good, flash=flash)
        assert flash.read_bytes() == bytes(size)
    expect(BAD_INPUT, "cannot be opened or made", profile=good, flash=folder / "no" / "folder")
    expect(BAD_INPUT, "summary: cannot be written", profile=good, summary=folder / "no" / "folder")
