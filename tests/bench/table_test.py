"""The table of the benchmarks.

usage: table_test.py FOLDER_OF_bench_table.py
"""

import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))
import bench_table  # noqa: E402


def run_of(name, samples_per_s, aggregate="median"):
    return {"run_name": name, "aggregate_name": aggregate, "items_per_second": samples_per_s}


RESULTS = {"benchmarks": [
    *(run_of(f"by_block/{signal}", 1e6 * value) for signal, value in
      [("walk", 77.04), ("noisy_sine", 247.4), ("white_noise", 55), ("sine", 1219.6)]),
    *(run_of(f"by_block/{signal}", 1, "mean") for signal in bench_table.SIGNALS),
    *(run_of(f"peer/{signal}", 4e6) for signal in bench_table.SIGNALS),
    run_of("by_sample/walk", 1e6),
    {"run_name": "whole", "aggregate_name": "median"},
]}
TABLE = ["| | random walk | noisy sine | white noise | sine |", "|---|---|---|---|---|",
         "| `Estimator::replay()` | 77 | 247 | 55 | 1220 |"]


class Table(unittest.TestCase):
    def test_has_the_medians_of_what_was_measured_whole(self):
        self.assertEqual(bench_table.table_of(RESULTS, bench_table.ROWS),
                         TABLE + ["| the peer | 4 | 4 | 4 | 4 |"])

    def test_replaces_its_own_and_leaves_the_peer_out(self):
        before = ["# A page", "| other | table |", "|---|---|", "| 1 | 2 |", "",
                  TABLE[0], "|---|---|---|---|---|", "| old | 1 | 2 | 3 | 4 |", "", "The end."]
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "results.json").write_text(json.dumps(RESULTS))
            (folder / "README.md").write_text("\n".join(before))
            with contextlib.redirect_stdout(io.StringIO()):
                bench_table.main([str(folder / "results.json"), "--write", str(folder / "README.md")])
            self.assertEqual((folder / "README.md").read_text().split("\n"),
                             before[:5] + TABLE + before[8:])

    def test_refuses_a_page_without_it(self):
        with self.assertRaises(SystemExit):
            bench_table.replaced("# A page\n", TABLE)


if __name__ == "__main__":
    unittest.main()
