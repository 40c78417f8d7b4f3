"""Whether .elf, .bin and .hex are the same image, whether it fits its pages, and whether its vector
table makes sense.

usage: image.py IMAGE.elf IMAGE.bin IMAGE.hex
"""

import pathlib
import struct
import sys

from elf import Elf
from memory import CCM, CODE, SRAM

VECTORS = 16 + 102  # RM0440 14.3
NMI, PENDSV, CONTROL_LOOP = 2, 14, 16 + 18


def read_hex(path):
    """Bytes by address, of an Intel HEX file."""
    memory, base = {}, 0
    for number, line in enumerate(pathlib.Path(path).read_text().splitlines(), 1):
        record = bytes.fromhex(line.removeprefix(":"))
        if not line.startswith(":") or sum(record) % 256 or len(record) != record[0] + 5:
            sys.exit(f"{path}:{number}: not a whole record")
        address, kind, data = int.from_bytes(record[1:3], "big"), record[3], record[4:-1]
        if kind == 0:
            memory.update((base + address + i, byte) for i, byte in enumerate(data))
        elif kind == 4:
            base = int.from_bytes(data, "big") << 16
    return memory


image = Elf(sys.argv[1])
loaded = {address + i: byte for address, data in image.loads() for i, byte in enumerate(data)}
if not loaded:
    sys.exit("nothing is loaded")
outside = [address for address in loaded if address not in CODE]
if outside:
    sys.exit(f"{len(outside)} bytes outside the pages of code, the first at {outside[0]:#010x}")

flat = pathlib.Path(sys.argv[2]).read_bytes()
if flat != bytes(loaded.get(address, 0) for address in range(CODE.start, max(loaded) + 1)):
    sys.exit(f"{sys.argv[2]} is not {sys.argv[1]}")
if read_hex(sys.argv[3]) != loaded:
    sys.exit(f"{sys.argv[3]} is not {sys.argv[1]}")

stack, *handlers = struct.unpack_from(f"<{VECTORS}I", flat)
at = image.symbols
if stack != at["stack_top"] or stack % 8 or stack not in SRAM:
    sys.exit(f"initial stack at {stack:#010x}")
# Bit 0 stands for Thumb.
expected = {1: "isr_reset", NMI: "isr_nmi", PENDSV: "isr_settle", CONTROL_LOOP: "isr_control"}
for exception, handler in enumerate(handlers, 1):
    name = expected.get(exception, "isr_fault")
    if handler != at[name] | 1:
        sys.exit(f"exception {exception} goes to {handler:#010x}, not to {name}")
if at["isr_reset"] & ~1 not in CODE or any(
        at[name] & ~1 not in CCM for name in ("isr_nmi", "isr_control", "isr_fault")):
    sys.exit("a handler lies in the wrong memory")
if at["ram_vectors"] % 512 or at["ram_vectors"] not in CCM:
    sys.exit(f"the table in use is at {at['ram_vectors']:#010x}")
print(f"{len(flat)} bytes in all three files; {VECTORS} vectors")
