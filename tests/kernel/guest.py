"""The first process of the guest once its file systems are there: runs the tests and ends it.

    guest.py SEED MARKER COMMAND...

SEED is a file of random bytes of the host: the guest has no source of its own, and programs that
ask for random numbers would wait for one.
"""

import ctypes
import fcntl
import pathlib
import struct
import subprocess
import sys

ADD_ENTROPY = 0x40085203  # RNDADDENTROPY of linux/random.h
POWER_OFF = 0x4321FEDC  # RB_POWER_OFF of sys/reboot.h


def add_entropy(seed):
    pool = struct.pack(f"ii{len(seed)}s", 8 * len(seed), len(seed), seed)
    with open("/dev/urandom", "wb") as device:
        fcntl.ioctl(device, ADD_ENTROPY, pool)


def main(seed, marker, *command):
    code = 1
    try:
        add_entropy(pathlib.Path(seed).read_bytes())
        code = subprocess.run(command, check=False).returncode
    finally:
        print(marker, code, flush=True)
        ctypes.CDLL(None).reboot(POWER_OFF)


main(*sys.argv[1:])
