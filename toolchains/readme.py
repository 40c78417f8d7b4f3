#!/usr/bin/env python3
"""The commands of a page, and what the page says that they print.

    readme.py commands PAGE      a script of all commands that run
    readme.py compare PAGE LOG   compares what the script has printed with the page

Every block of `sh` in the page runs, in one shell, from the folder of the sources, but where a comment in
the line before it says otherwise:

    <!-- not run: REASON -->     needs what is not everywhere
    <!-- serves: ADDRESS -->     a command runs until it is ended: the address has to answer

A block without a language right behind one of `sh` is what its commands print: each of its lines is one of
theirs, in the same order, where `...` stands for anything.
"""
import pathlib
import re
import shlex
import sys

BLOCK = re.compile(r"(?:^<!-- (not run|serves): ([^\n]+) -->\n)?^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
MARK = "readme.py: block in line"


class Block:
    def __init__(self, page, match):
        self.line = page.count("\n", 0, match.start(4))
        self.mark, self.detail, self.language, self.text = match.groups()
        self.printed = None

    def script(self):
        """The block as a part of a script, which says before each command what it is."""
        yield f"echo {shlex.quote(f'{MARK} {self.line}')}"
        for command in commands_of(self.text):
            yield f"command={shlex.quote(command)}"
            yield f"echo \"+ $command\""
            if self.mark == "serves":
                yield f"serve {shlex.quote(self.detail)} {shlex.quote(command)}"
            else:
                yield command


def blocks_of(page):
    blocks = []
    end = 0
    for match in BLOCK.finditer(page):
        block = Block(page, match)
        if block.language == "sh" and (block.mark is None or block.mark == "serves"):
            blocks.append(block)
        elif block.language == "" and blocks and end is not None:
            if page[end:match.start()].strip() == "" or re.fullmatch(r"\s*[^\n#`]*\n\s*", page[end:match.start()]):
                blocks[-1].printed = block
        end = match.end() if block.language == "sh" and block.mark != "not run" else None
    return blocks


def commands_of(text):
    """Commands of one line each, or several that end with a backslash."""
    return [command for command in re.split(r"(?<!\\)\n", text) if command.strip()]


PRELUDE = """\
set -eEuo pipefail
trap 'echo "FAILED: $command" >&2' ERR
serve() {
  bash -c "exec $2" & server=$!
  for try in $(seq 50); do
    if curl -sf --noproxy '*' -o /dev/null "$1"; then kill "$server"; wait "$server" || true; return; fi
    sleep 0.1
  done
  echo "nothing answers at $1" >&2
  return 1
}
exec < /dev/null"""


def not_printed(shown, printed):
    """The first line shown that is not printed, behind how many are before it; None if all are."""
    rest = printed.splitlines()
    for number, line in enumerate(shown.splitlines()):
        if line.strip() in ("", "..."):
            continue
        pattern = re.compile(".*".join(re.escape(part) for part in line.split("...")) + r"\s*$")
        at = next((i for i, other in enumerate(rest) if pattern.match(other)), None)
        if at is None:
            return number, line
        rest = rest[at + 1:]
    return None


def compare(blocks, log):
    parts = re.split(rf"^{MARK} (\d+)\n", log, flags=re.MULTILINE)
    printed = dict(zip(map(int, parts[1::2]), parts[2::2]))
    lines = 0
    for block in blocks:
        if block.printed is None:
            continue
        line = not_printed(block.printed.text, printed[block.line])
        if line is not None:
            sys.exit(f"line {block.printed.line + 1 + line[0]} is not what the commands above it print: {line[1]}")
        lines += sum(line.strip() not in ("", "...") for line in block.printed.text.splitlines())
    print(f"{len(blocks)} blocks ran, and {lines} lines are as they were printed")


def main():
    page = pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")
    blocks = blocks_of(page)
    if sys.argv[1] == "commands":
        print(PRELUDE)
        for block in blocks:
            print("\n".join(block.script()))
    else:
        compare(blocks, pathlib.Path(sys.argv[3]).read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
