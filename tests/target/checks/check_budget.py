"""Compares a file of measured numbers with a section of the budget file.

usage: check_budget.py SECTION MEASURED.json [BUDGET.json]
"""

import json
import pathlib
import sys

import budget

section, measured = sys.argv[1], json.loads(pathlib.Path(sys.argv[2]).read_text())
failed = budget.check(section, measured, *sys.argv[3:4])
if failed:
    sys.exit(f"{section}: {', '.join(failed)}")
