"""The table of million samples a second that lifemodel_bench has measured: medians, three digits.

usage: bench_table.py RESULTS.json [--write README.md]

With --write it replaces the table of the same first row in that file, without the peer.
"""

import json
import pathlib
import sys

SIGNALS = {"walk": "random walk", "noisy_sine": "noisy sine", "white_noise": "white noise", "sine": "sine"}
ROWS = {
    "in_bulk/AVX2": "`bulk::Replay`, AVX2",
    "in_bulk/SSE4.1": "`bulk::Replay`, SSE4.1",
    "in_bulk/NEON": "`bulk::Replay`, NEON",
    "in_bulk/one lane": "`bulk::Replay`, one number at a time",
    "by_block": "`Estimator::replay()`",
    "by_sample": "`push()` and `settle()`",
    "peer": "the peer",
}
HEAD = "| | " + " | ".join(SIGNALS.values()) + " |"


def rounded(value):
    """Three digits at most, the last ones zero: 1,234,567 is 1230 million."""
    digits = f"{value:.2e}"
    return f"{float(digits):.0f}" if value >= 100 else f"{float(digits):g}"


def table_of(results, rows):
    medians = {}
    for run in results["benchmarks"]:
        if run.get("aggregate_name") == "median" and "items_per_second" in run:
            medians[run["run_name"]] = run["items_per_second"] / 1e6
    lines = [HEAD, "|---" * (len(SIGNALS) + 1) + "|"]
    for way in rows:
        figures = [medians.get(f"{way}/{signal}") for signal in SIGNALS]
        if None not in figures:
            lines.append(f"| {ROWS[way]} | " + " | ".join(map(rounded, figures)) + " |")
    return lines


def replaced(text, table):
    """The text with the lines of its table of the same head replaced."""
    lines = text.split("\n")
    if lines.count(HEAD) != 1:
        sys.exit(f"no table, or several, with the first row {HEAD}")
    begin = end = lines.index(HEAD)
    while end < len(lines) and lines[end].startswith("|"):
        end += 1
    return "\n".join(lines[:begin] + table + lines[end:])


def main(arguments):
    if len(arguments) not in (1, 3) or (len(arguments) == 3 and arguments[1] != "--write"):
        sys.exit(__doc__)
    results = json.loads(pathlib.Path(arguments[0]).read_text())
    print("\n".join(table_of(results, ROWS)))
    if len(arguments) == 3:
        readme = pathlib.Path(arguments[2])
        own = [way for way in ROWS if way != "peer"]
        readme.write_text(replaced(readme.read_text(), table_of(results, own)))


if __name__ == "__main__":
    main(sys.argv[1:])
