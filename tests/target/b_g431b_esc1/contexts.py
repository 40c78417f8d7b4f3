"""Whether the stack holds all contexts at once: the idle loop, settling, the control loop and the NMI
on top of each other, with what the core stacks for each exception (DDI 0403E B1.5.6).

usage: contexts.py IMAGE.elf DEPTHS.json OUT.json
"""

import json
import pathlib
import sys

from elf import Elf

EXCEPTION_FRAME = 8 * 4 + 4  # registers, and alignment to 8
GUARD = 32

image = Elf(sys.argv[1])
depths = json.loads(pathlib.Path(sys.argv[2]).read_text())
measured = {
    "idle": depths["isr_reset"] + depths["main"],
    "settle": depths["isr_settle"],
    "control": depths["isr_control"],
    "nmi": depths["isr_nmi"],
}
exceptions = len(measured) - 1
measured["total"] = sum(measured.values()) + exceptions * EXCEPTION_FRAME
reserved = image.symbols["stack_top"] - image.symbols["stack_guard"] - GUARD
print(f"{measured['total']} of {reserved} bytes")
if measured["total"] > reserved:
    sys.exit("the stack is too small")
pathlib.Path(sys.argv[3]).write_text(json.dumps(measured, indent=2) + "\n")
