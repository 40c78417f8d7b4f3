"""Checks what the code in all README.md of a source tree names: each test, label and path is there.

    commands_test.py SOURCE

A test is what follows `-R` (each alternative has to match one, REGEX stands for any) or `--gtest_filter=`,
a label what follows `-L` or `-LE`. A path begins with a folder at the top of the tree; what has a word of
capitals in it stands for many.
"""
import fnmatch
import pathlib
import re
import sys

import links_test

MACRO = re.compile(r"^\s*(?:TEST(?:_F|_P)?|TYPED_TEST(?:_P)?|RC_GTEST\w*_PROP)\(\s*(\w+),\s*(\w+)", re.MULTILINE)
COMMAND = re.compile(r"^[ \t]*(\w+)\(([^()]*)", re.MULTILINE)
KEYWORD = re.compile(r"[A-Z_]+")
CODE = re.compile(r"(`+)(.*?)\1", re.DOTALL)
REGEX = re.compile(r"(?:^|ctest.* )-R ('[^']*'|\S+)")
FILTER = re.compile(r"--gtest_filter=('[^']*'|\S+)")
LABEL = re.compile(r"(?:^|ctest.* )-LE? ('[^']*'|\S+)")
PLACEHOLDER = re.compile(r"[A-Z]{2,}(?!\w*\.md)")


def commands_of(text):
    """Each command of CMake with its words, those of a loop once for each item."""
    loop = ("", [""])
    for match in COMMAND.finditer(re.sub(r"#.*", "", text)):
        name, words = match[1], match[2].replace('"', "").split()
        if name == "foreach":
            loop = (f"${{{words[0]}}}", [word for word in words[1:] if word not in ("IN", "ITEMS")])
        elif name == "endforeach":
            loop = ("", [""])
        else:
            for item in loop[1]:
                yield name, [word.replace(loop[0], item) if loop[0] else word for word in words]


def made_by_cmake(files):
    """The names that add_test() gives, also by functions that call it."""
    makers = {}
    for file in files:
        text = file.read_text(encoding="utf-8")
        for function in re.finditer(r"^function\((\w+)([^)]*)\)(.*?)^endfunction", text, re.MULTILINE | re.DOTALL):
            for template in re.findall(r"add_test\(NAME (\S+)", function[3]):
                makers.setdefault(function[1], []).append((function[2].split(), template))
    for file in files:
        for name, words in commands_of(file.read_text(encoding="utf-8")):
            if name == "add_test" and words[0] == "NAME":
                yield words[1]
            for parameters, template in makers.get(name, ()):
                for parameter, word in zip(parameters, words):
                    template = template.replace(f"${{{parameter}}}", word)
                yield template


def prefixes_of(files):
    """What the names of a folder's or a file's tests begin with."""
    for file in files:
        for name, words in commands_of(file.read_text(encoding="utf-8")):
            if name == "folder_tests":
                prefix = words[words.index("PREFIX") + 1] if "PREFIX" in words else ""
                keyword = ""
                for word in words[1:]:
                    if KEYWORD.fullmatch(word):
                        keyword = word
                    elif keyword in ("", "FILES"):
                        yield (file.parent / word).resolve(), prefix
            elif name == "gtest_discover_tests":
                yield file.parent, words[words.index("TEST_PREFIX") + 1] if "TEST_PREFIX" in words else ""


def tests_of(source):
    """Those of programs (Suite.Name), and all as ctest has them."""
    files = sorted(source.glob("tests/**/CMakeLists.txt"))
    prefixes = {}
    for place, prefix in prefixes_of(files):
        prefixes.setdefault(place, set()).add(prefix)
    suites = set()
    names = {name for name in made_by_cmake(files) if "$" not in name}
    for file in source.glob("tests/**/*.cpp"):
        for suite, name in MACRO.findall(file.read_text(encoding="utf-8")):
            suites.add(f"{suite}.{name}")
            names.update(f"{prefix}{suite}.{name}"
                         for prefix in prefixes.get(file, prefixes.get(file.parent, {""})))
    return suites, names


def labels_of(source):
    for file in source.glob("tests/**/CMakeLists.txt"):
        for words in re.findall(r"\bLABELS ([\w;\"]+)", file.read_text(encoding="utf-8")):
            yield from words.replace('"', "").split(";")


def code_of(page):
    """Each piece of code of a page, with the number of its first line."""
    text = page.read_text(encoding="utf-8")
    prose = list(links_test.prose_of(page))
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        if not prose[number - 1]:
            yield number, line
    text = "\n".join(prose)
    for match in CODE.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, match[2]


def missing_in(code, page, source, suites, names, labels):
    """What the code names and is not there, with why."""
    for match in REGEX.findall(code):
        regex = match.strip("'")
        for part in [regex] if "(" in regex else regex.split("|"):
            if not part.isupper() and not any(re.search(part, name) for name in names):
                yield part, "matches no test"
    for match in FILTER.findall(code):
        for pattern in match.strip("'").split(":"):
            if not any(fnmatch.fnmatchcase(name, pattern.lstrip("-")) for name in suites):
                yield pattern, "matches no test"
    for match in LABEL.findall(code):
        for label in match.strip("'").split("|"):
            if label not in labels:
                yield label, "is the label of no test"
    folders = "|".join(sorted(folder.name for folder in source.iterdir() if folder.is_dir() and folder.name != "build"))
    for path in re.findall(rf"(?<![\w./$-])((?:{folders})/[\w./*-]+)", code):
        path = path.rstrip(".")
        if PLACEHOLDER.search(path):
            continue
        if not any(list(folder.glob(path.rstrip("/"))) for folder in (source, page.parent)):
            yield path, "there is no such file"


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    suites, names = tests_of(source)
    labels = set(labels_of(source))
    faults = []
    pages = list(links_test.pages_in(source))
    for page in pages:
        for number, code in code_of(page):
            for name, why in missing_in(code, page, source, suites, names, labels):
                faults.append(f"{page.relative_to(source)}:{number}: {name}: {why}")
    print(*faults, f"{len(names)} tests, {len(pages)} pages, {len(faults)} names of nothing", sep="\n")
    return 1 if faults or not names else 0


if __name__ == "__main__":
    sys.exit(main())
