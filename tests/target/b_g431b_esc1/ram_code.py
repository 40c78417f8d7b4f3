"""Proves that code which has to run while the flash is busy never leads there: the given functions
lie in RAM, and nothing in their section refers to an address in flash. Calls through pointers
would need such a reference too.

usage: ram_code.py IMAGE.elf FUNCTION...
"""

import sys

from elf import Elf
from memory import CCM, FLASH

image, functions = Elf(sys.argv[1]), sys.argv[2:]
if not functions:
    sys.exit("no functions")
failures = []
for function in functions:
    address = image.symbols.get(function)
    if address is None:
        failures.append(f"{function}: not in the image")
    elif address & ~1 not in CCM:
        failures.append(f"{function}: at {address:#010x}, not in RAM")

begin, end = image.symbols["ram_code_begin"], image.symbols["ram_code_end"]
references = 0
for address, name, value in image.relocations(".ram_code"):
    references += 1
    if value & ~1 in FLASH:
        failures.append(f"{address:#010x} refers to {name} in flash")
    # A section as the target has the rest of the address in place.
    if address % 4 == 0 and name.startswith(".") and image.word(address) in FLASH:
        failures.append(f"{address:#010x} refers to {image.word(address):#010x} in flash")
if failures:
    sys.exit("\n".join(failures))
print(f"{end - begin} bytes in RAM with {references} references, none into the flash")
