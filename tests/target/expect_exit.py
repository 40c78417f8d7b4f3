"""Runs a command and checks its exit code and what it prints.

usage: expect_exit.py CODE TEXT COMMAND...
"""

import subprocess
import sys

expected, text, command = int(sys.argv[1]), sys.argv[2], sys.argv[3:]
run = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                     stderr=subprocess.STDOUT, text=True, timeout=60, check=False)
print(run.stdout, end="")
if run.returncode != expected:
    sys.exit(f"exit code {run.returncode}, expected {expected}")
if text not in run.stdout:
    sys.exit(f"output lacks {text!r}")
