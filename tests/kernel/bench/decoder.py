"""The third-party decoder of DBC files, over logs of candump."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from bench.program import binary

SCRIPT = pathlib.Path(__file__).parents[2] / "protocol" / "decode_log.mjs"
SKIPPED = 77  # of the script, where the decoder is not installed


def decode(log, node):
    """What the decoder makes of each frame of a log, by the DBC file of this node."""
    with tempfile.TemporaryDirectory() as folder:
        dbc = pathlib.Path(folder) / "node.dbc"
        subprocess.run([binary("protocol_generate"), "dbc", "--nodes", str(node), "--out", dbc], check=True)
        done = subprocess.run(["node", SCRIPT, log, dbc], capture_output=True, text=True, check=False)
    if done.returncode == SKIPPED and os.environ.get("TENDONLIFE_REQUIRE_KERNEL") != "1":
        raise unittest.SkipTest(done.stderr.strip())
    if done.returncode != 0:
        raise AssertionError(f"{SCRIPT.name}: {done.stderr}")
    return [json.loads(line) for line in done.stdout.splitlines()]
