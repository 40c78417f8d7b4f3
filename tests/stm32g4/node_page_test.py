"""The tool that makes the settings of a node: what it writes, and what it refuses.

usage: node_page_test.py make_node_page.py SCRATCH_FOLDER
"""

import pathlib
import stat
import subprocess
import sys

tool, scratch = sys.argv[1], pathlib.Path(sys.argv[2])
scratch.mkdir(parents=True, exist_ok=True)
out, key = scratch / "node.bin", scratch / "node.key"


def run(*arguments):
    return subprocess.run([sys.executable, tool, *arguments, "--out", str(out)],
                          stderr=subprocess.PIPE, text=True)


def write_key(text, mode=0o600):
    key.write_text(text)
    key.chmod(mode)


def expect_refusal(words, *arguments):
    out.unlink(missing_ok=True)
    done = run(*arguments)
    assert done.returncode == 1 and words in done.stderr, done
    assert not out.exists(), "a refusal left a file"


write_key("000102030405060708090a0b0c0d0e0f\n")
CLOSED = "--termination", "closed"
assert run("--node", "5", *CLOSED, "--key", str(key)).returncode == 0
# The same bytes as in node_page_test.cpp.
assert out.read_bytes().hex() == (
    "544c4e440100000005000000000102030405060708090a0b0c0d0e0f1e598097"), out.read_bytes().hex()
assert stat.S_IMODE(out.stat().st_mode) == 0o600

assert run("--node", "127", "--termination", "open").returncode == 0
assert out.read_bytes()[8:28] == bytes([127, 1]) + bytes(18)
assert run("--node", "5").returncode == 2, "nobody but the user knows where the bus ends"

for node in "0", "128", "-1":
    expect_refusal("accepted: 1 .. 127", "--node", node, *CLOSED)
write_key("0001")
expect_refusal("accepted: 32 hexadecimal digits", "--node", "5", *CLOSED, "--key", str(key))
write_key("g" * 32)
expect_refusal("accepted: 32 hexadecimal digits", "--node", "5", *CLOSED, "--key", str(key))
write_key("00" * 16, 0o640)
expect_refusal("mode 0640", "--node", "5", *CLOSED, "--key", str(key))
expect_refusal("No such file", "--node", "5", *CLOSED, "--key", str(scratch / "missing"))
