"""Fails where object files need more from outside than the memory functions that compilers call.

usage: symbols.py NM OBJECT...
"""

import subprocess
import sys

ALLOWED = {"memcpy", "memmove", "memset", "memcmp", "memchr", "strlen",
           "__aeabi_memcpy", "__aeabi_memcpy4", "__aeabi_memcpy8",
           "__aeabi_memmove", "__aeabi_memmove4", "__aeabi_memmove8",
           "__aeabi_memset", "__aeabi_memset4", "__aeabi_memset8",
           "__aeabi_memclr", "__aeabi_memclr4", "__aeabi_memclr8"}


def names(nm, option, objects):
    run = subprocess.run([nm, "--format=just-symbols", option, *objects],
                         stdout=subprocess.PIPE, text=True, check=True)
    # Names of archives and their members end with a colon.
    return {line for line in run.stdout.split("\n") if line and not line.endswith(":")}


nm, objects = sys.argv[1], sys.argv[2:]
if not objects:
    sys.exit("no object files")
defined = names(nm, "--defined-only", objects)
if not defined:
    sys.exit("the object files define nothing")
needed = names(nm, "--undefined-only", objects) - defined
banned = sorted(needed - ALLOWED)
print(f"{len(objects)} files define {len(defined)} symbols and need:",
      ", ".join(sorted(needed)) or "nothing")
if banned:
    sys.exit(f"banned: {', '.join(banned)}")
