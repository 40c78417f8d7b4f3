"""Checks the links in all README.md of a source tree: each file is there, and so is each heading.

    links_test.py SOURCE
"""
import os
import pathlib
import re
import sys
import unicodedata

LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(\s*<?([^)\s>]*)>?[^)]*\)")
CODE = re.compile(r"(`+)(?:(?!\1).)+\1")
HEADING = re.compile(r"#{1,6}\s+(.*?)\s*#*$")
ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:", re.IGNORECASE)


def prose_of(page):
    """The lines of a page, empty ones for code."""
    fence = None
    for line in page.read_text(encoding="utf-8").splitlines():
        mark = re.match(r" {0,3}(```+|~~~+)", line)
        is_code = fence is not None or mark or line.startswith("    ")
        if mark and (fence is None or mark[1].startswith(fence)):
            fence = mark[1] if fence is None else None
        yield "" if is_code else line


def links_of(page):
    """The target of each link, which may go over an end of line, with the number of its first line."""
    prose = "\n".join(CODE.sub("``", line) for line in prose_of(page))
    for link in LINK.finditer(prose):
        yield prose.count("\n", 0, link.start()) + 1, link[1]


def anchors_of(page):
    """What GitHub makes of the headings: small letters, digits, - and _; a second of a kind has -1."""
    anchors = set()
    seen = {}
    for line in prose_of(page):
        heading = HEADING.match(line)
        if heading:
            text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).lower()
            anchor = "".join(c for c in text if c in " -_" or unicodedata.category(c)[0] in "LN").replace(" ", "-")
            count = seen[anchor] = seen.get(anchor, -1) + 1
            anchors.add(f"{anchor}-{count}" if count else anchor)
    return anchors


def fault_of(target, page, source):
    path, _, anchor = target.partition("#")
    if path.startswith("/"):
        return "is not relative"
    file = pathlib.Path(os.path.normpath(page.parent / path)) if path else page
    if not file.is_relative_to(source):
        return "leaves the source tree"
    if not file.exists():
        return "there is no such file"
    if anchor and (file.suffix != ".md" or anchor not in anchors_of(file)):
        return "there is no such heading"
    return None


def pages_in(source):
    for folder, folders, files in os.walk(source):
        folders[:] = sorted(name for name in folders if name != "build" and not name.startswith("."))
        if "README.md" in files:
            yield pathlib.Path(folder) / "README.md"


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    faults = []
    count = 0
    pages = list(pages_in(source))
    for page in pages:
        for number, target in links_of(page):
            if ELSEWHERE.match(target):
                continue
            count += 1
            fault = fault_of(target, page, source)
            if fault:
                faults.append(f"{page.relative_to(source)}:{number}: {target}: {fault}")
    print(*faults, f"{count} links in {len(pages)} pages, {len(faults)} dead", sep="\n")
    return 1 if faults or not count else 0


if __name__ == "__main__":
    sys.exit(main())
