"""Measured numbers against the budget file: budgets must hold, and no number may grow past what was
committed by more than the tolerance."""

import json
import pathlib

BUDGET_FILE = pathlib.Path(__file__).resolve().parent.parent / "budget.json"


def compare(section, measured, limits, tolerance):
    """Prints a table; returns the names that fail. A number that only one side knows fails."""
    failed = []
    print(f"{section:<24}{'measured':>12}{'committed':>12}{'budget':>9}")
    for name in sorted(set(measured) | set(limits)):
        value = measured.get(name)
        entry = limits.get(name, {})
        committed, budget = entry.get("measured"), entry.get("budget")
        if value is None:
            verdict = "not measured"
        elif committed is None:
            verdict = "not committed"
        elif budget is not None and value > budget:
            verdict = "over budget"
        elif value > committed * (1 + tolerance):
            verdict = "grown"
        else:
            verdict = ""
        if verdict:
            failed.append(name)
        shown = ["-" if v is None else f"{v:g}" for v in (value, committed, budget)]
        print(f"{name:<24}{shown[0]:>12}{shown[1]:>12}{shown[2]:>9}  {verdict}")
    return failed


def check(section, measured, path=BUDGET_FILE):
    """The failed names of one section of a budget file."""
    budget = json.loads(pathlib.Path(path).read_text())
    return compare(section, measured, budget[section], budget["tolerance"])
