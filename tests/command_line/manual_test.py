"""Manual pages: man and mandoc have nothing to say of them, and they tell every option of the help.

    manual_test.py PROGRAM PAGE

PAGE is a file, or `-` for what `PROGRAM manual` writes.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
VERBS = re.compile(r"^Subcommands:\n((?:  .*\n)+)", re.MULTILINE)
OPTION = re.compile(r"^  (?:-\w,)?(--[\w-]+)", re.MULTILINE)
POSITIONAL = re.compile(r"^  ([A-Z]+) ", re.MULTILINE)


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def complaints_of(page):
    """What the two formatters warn of."""
    complaints = []
    for command in (["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page],
                    ["mandoc", "-T", "lint", "-W", "warning", page]):
        result = subprocess.run(command, capture_output=True, text=True)
        text = result.stderr + (result.stdout if command[0] == "mandoc" else "")
        if result.returncode != 0 or text:
            complaints.append(f"{' '.join(command)}: status {result.returncode}\n{text}")
    return complaints


def told_in(page):
    """What each heading of the page tells: {heading: options and positionals}, as it is read."""
    text = re.sub(".\x08", "", output_of("mandoc", "-T", "ascii", "-O", "width=300", page))
    told = {}
    words = set()
    for line in text.splitlines():
        if heading := re.fullmatch(r" {0,3}(\S.*)", line):
            words = told.setdefault(heading.group(1), set())
        elif entry := re.fullmatch(r" {7}(?:-\w, )?(--[\w-]+|[A-Z]+)( .*)?", line):
            words.add(entry.group(1))
    return told


def missing_in(told, program, verbs=()):
    """What the help of the program and its verbs has and the page has not."""
    text = output_of(program, *verbs, "--help")
    section = VERBS.search(text)
    own = text[:section.start()] if section else text
    words = set(OPTION.findall(own)) | set(POSITIONAL.findall(own))
    heading = " ".join(verbs) or "OPTIONS"
    if verbs and not section:
        words.discard("--help")
    missing = []
    if words - {"--help"} or not verbs:
        missing = [f"{heading}: {word}" for word in sorted(words - told.get(heading, set()))]
    for line in section.group(1).splitlines() if section else ():
        if line[2] != " ":
            missing += missing_in(told, program, (*verbs, line.split()[0]))
    return missing


def main():
    program, page = sys.argv[1:]
    lacking = [tool for tool in ("man", "mandoc") if shutil.which(tool) is None]
    if lacking:
        print(f"not installed: {', '.join(lacking)}")
        return 1 if os.environ.get("CI") == "true" else SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        if page == "-":
            page = f"{folder}/page"
            with open(page, "w", encoding="utf-8") as file:
                file.write(output_of(program, "manual"))
        failures = complaints_of(page) + missing_in(told_in(page), program)
        told = sum(len(words) for words in told_in(page).values())
    print("\n".join(failures) or f"{told} options and arguments told")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
