"""Bytes of an image in each memory, as JSON.

usage: sizes.py IMAGE.elf OUT.json
"""

import json
import pathlib
import sys

from elf import Elf
from memory import CCM, SRAM

ALLOCATED = 2

image = Elf(sys.argv[1])


def used(memory):
    return sum(s[5] for s in image.sections.values() if s[2] & ALLOCATED and s[3] in memory)


measured = {
    "flash": sum(len(data) for _, data in image.loads()),
    "sram": used(SRAM),
    "ccm": used(CCM),
}
pathlib.Path(sys.argv[2]).write_text(json.dumps(measured, indent=2) + "\n")
