"""Takes the numbers that the last test run measured into a budget file; budgets stay as they are.

usage: python3 tests/target/update_budget.py [BUILD_DIRECTORY [BUDGET.json]]
"""

import json
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
build = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parents[1] / "build" / "qemu-m4"

path = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else here / "budget.json"
measurements = build / path.parent.relative_to(here.parents[1])
budget = json.loads(path.read_text())
for section, entries in budget.items():
    if not isinstance(entries, dict):
        continue
    measured = json.loads((measurements / f"{section}.json").read_text())
    for name in entries.keys() - measured.keys():
        del entries[name]
    for name, value in measured.items():
        entry = entries.setdefault(name, {})
        before, entry["measured"] = entry.get("measured"), value
        if before != value:
            print(f"{section} {name}: {before} -> {value}")
path.write_text(json.dumps(budget, indent=2) + "\n")
