"""Runs the start-up code of the image under QEMU, which has no STM32G4: linked to the memory of
mps2-an386 the same objects start, take the RAM code and the vector table to RAM, and reach main().
There the clocks never get ready, so it fails safe, whose first deed is to switch the drive off; that
faults, for there is no such register, and the handler too comes from RAM, by the table in RAM.

usage: start_up.py IMAGE.elf QEMU...
"""

import re
import subprocess
import sys

from elf import Elf

GPIO_B_BSRR = 0x48000418

image, qemu = Elf(sys.argv[1]), sys.argv[2:]
run = subprocess.run([*qemu, sys.argv[1], "-d", "int", "-no-reboot"], stdin=subprocess.DEVNULL,
                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)
faults = [int(text, 16) for text in re.findall(r"BFAR (0x[0-9a-f]+)", run.stdout)]
if faults[:2] != [GPIO_B_BSRR, GPIO_B_BSRR]:
    sys.exit(f"faults at {[hex(f) for f in faults]}\n{run.stdout}")
handlers = [int(text, 16) for text in re.findall(r"loaded new PC (0x[0-9a-f]+)", run.stdout)]
tables = [int(text, 16) for text in re.findall(r"vector table at (0x[0-9a-f]+)", run.stdout)]
at = image.symbols
if handlers[:1] != [at["isr_fault"] | 1]:
    sys.exit(f"the fault went to {handlers}\n{run.stdout}")
if tables[:1] != [at["ram_vectors"] + 3 * 4]:
    sys.exit(f"the handler came from the table at {[hex(t) for t in tables]}\n{run.stdout}")
print("started, and failed safe from RAM")
