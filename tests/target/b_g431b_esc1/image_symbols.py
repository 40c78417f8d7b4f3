"""Fails where a linked image has what the firmware must not need: a heap, exceptions, run-time type
information, floating point in software or in instructions, or 64-bit division.

usage: image_symbols.py NM OBJDUMP IMAGE.elf
"""

import re
import subprocess
import sys

BANNED = re.compile(
    r"^(malloc|calloc|realloc|free|_?sbrk|_Zn[wa].*|_Zd[la].*|__cxa_.*|_Unwind.*|__gxx.*|_ZTI.*|_ZTV.*"
    r"|__aeabi_[fd].*|__aeabi_[iul]+2[fd]|__aeabi_u?ldivmod|__u?divdi3|__u?moddi3|__.*[sd]f[23]?"
    r"|abort|exit|printf|sprintf|snprintf)$")
FLOATING_POINT = re.compile(r"^\s+[0-9a-f]+:\s+(?:[0-9a-f]{4} ?){1,2}\s+(v[a-z]+[.a-z0-9]*)", re.MULTILINE)


def output(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


nm, objdump, image = sys.argv[1:]
names = output(nm, "--format=just-symbols", image).split()
if not names:
    sys.exit("no symbols")
banned = [name for name in names if BANNED.match(name)]
instructions = sorted(set(FLOATING_POINT.findall(output(objdump, "-d", image))))
if banned or instructions:
    sys.exit(f"banned: {', '.join(banned + instructions)}")
print(f"{len(names)} symbols, none banned")
