"""Runs what the pages of a source tree show with its output, and compares it.

    printed_test.py SOURCE HOST_SIM

It is in a block without a language, where a command is what follows `$ ` (and goes on behind a backslash),
and in a block right behind one of commands. Each line shown has to be one that its command
prints, in the same order, `...` for anything (toolchains/readme.py). Commands run in a folder of their own,
in which the folders of the sources are; the blocks that need more are left out and counted.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import links_test

CONSOLE = re.compile(r"^```\n(\$ .*?)^```$", re.MULTILINE | re.DOTALL)
COMMAND = re.compile(r"^\$ ((?:.*\\\n)*.*)\n", re.MULTILINE)
NEEDS_MORE = re.compile(r"\b(toolchains/|cmake|ctest|logs\b|fleet\.csv)")


def shown_in(page, readme):
    """Each block that runs: the number of its first line, its commands and what is shown of their output."""
    text = page.read_text(encoding="utf-8")
    for match in CONSOLE.finditer(text):
        parts = COMMAND.split(match[1])
        yield text.count("\n", 0, match.start(1)) + 1, parts[1::2], "\n".join(parts[2::2])
    for block in readme.blocks_of(text):
        if block.printed is not None:
            yield block.line + 1, readme.commands_of(block.text), block.printed.text


def main():
    source, host_sim = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    sys.path.insert(0, str(source / "toolchains"))
    import readme
    environment = os.environ | {"PATH": f"{host_sim.parent}:{os.environ['PATH']}", "NO_COLOR": "1"}
    faults, ran, left_out = [], 0, 0
    for page in links_test.pages_in(source):
        for number, commands, shown in shown_in(page, readme):
            if NEEDS_MORE.search("\n".join(commands)):
                left_out += 1
                continue
            with tempfile.TemporaryDirectory() as folder:
                for child in source.iterdir():
                    if child.name not in ("build", "README.md"):
                        (pathlib.Path(folder) / child.name).symlink_to(child)
                done = subprocess.run(["bash", "-c", "\n".join(commands)], cwd=folder, env=environment, text=True,
                                      stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            line = readme.not_printed(shown, done.stdout)
            ran += 1
            if line is not None:
                faults.append(f"{page.relative_to(source)}:{number}: not printed: {line[1]}")
    print(*faults, f"{ran} blocks ran, {left_out} need more, {len(faults)} print something else", sep="\n")
    return 1 if faults or not ran else 0


if __name__ == "__main__":
    sys.exit(main())
