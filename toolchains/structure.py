#!/usr/bin/env python3
"""Prints how the sources are divided up: files and lines by folder, include cycles, headers with one includer.

    structure.py [--list] [--max-cycles N] [--max-single N]

--list names each cycle and the headers that one file alone includes beside the source of the same name. Exit status 1 where there are more of
either than the bounds allow. Files are those that git tracks, and outside of a checkout all that are there; a header is looked for by its path
from the top.
"""
import argparse
import collections
import pathlib
import re
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent
FLOORS = ("lifemodel", "hal", "firmware", "host_sim", "tests", "toolchains")
SOURCES = {".c", ".cpp", ".h", ".hpp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def tracked():
    try:
        names = subprocess.run(["git", "-C", TOP, "ls-files", "-z"], check=True, capture_output=True, text=True).stdout
    except (OSError, subprocess.CalledProcessError):
        found = sorted(file.relative_to(TOP) for floor in FLOORS for file in (TOP / floor).rglob("*") if file.is_file())
        return [pathlib.PurePosixPath(file) for file in found]
    return [pathlib.PurePosixPath(name) for name in names.split("\0") if name and (TOP / name).is_file()]


def include_graph(sources):
    """What each file includes, of the files given."""
    graph = {}
    for file in sources:
        found = set()
        for written in INCLUDE.findall((TOP / file).read_text()):
            for place in (pathlib.PurePosixPath(written), file.parent / written):
                if place in sources:
                    found.add(place)
                    break
        graph[file] = found
    return graph


def folder_cycles(graph):
    """Sets of folders, two levels deep, that include each other round about (Tarjan's components)."""
    def folder(file):
        return "/".join(file.parts[:2]) if len(file.parts) > 2 else file.parts[0]

    edges = collections.defaultdict(set)
    for file, includes in graph.items():
        if file.parts[0] != "tests":
            edges[folder(file)] |= {folder(other) for other in includes} - {folder(file)}
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in sorted(edges[node]):
            if other not in index:
                visit(other)
            if other in stack:
                low[node] = min(low[node], low[other])
        if low[node] == index[node]:
            component = set()
            while node not in component:
                component.add(stack.pop())
            if len(component) > 1:
                found.append(sorted(component))

    for node in sorted(edges):
        if node not in index:
            visit(node)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--max-cycles", type=int)
    parser.add_argument("--max-single", type=int)
    arguments = parser.parse_args()

    files = tracked()
    sources = {file for file in files if file.suffix in SOURCES}
    print(f"{'floor':12} {'files':>6} {'C, C++':>6} {'lines':>7} {'a file':>6} {'CMakeLists':>10}")
    for floor in FLOORS:
        here = [file for file in files if file.parts[0] == floor]
        code = [file for file in here if file in sources]
        lines = sum((TOP / file).read_text().count("\n") for file in code)
        lists = sum(file.name == "CMakeLists.txt" for file in here)
        print(f"{floor:12} {len(here):6} {len(code):6} {lines:7} {lines / max(len(code), 1):6.0f} {lists:10}")

    graph = include_graph(sources)
    cycles = folder_cycles(graph)
    includers = collections.Counter(
        other for file, includes in graph.items() for other in includes if other.with_suffix("") != file.with_suffix(""))
    single = sorted(file for file in sources
                    if file.suffix == ".hpp" and file.parts[0] == "host_sim" and includers[file] == 1)
    print(f"folders that include each other: {len(cycles)}")
    print(f"headers of host_sim that one file alone includes: {len(single)}")
    if arguments.list:
        print(*("  " + " <-> ".join(cycle) for cycle in cycles), sep="\n")
        print(*(f"  {file}" for file in single), sep="\n")
    too_many = [
        f"{what}: {count}, at most {bound} are allowed"
        for what, count, bound in (("cycles", len(cycles), arguments.max_cycles),
                                   ("headers with one includer", len(single), arguments.max_single))
        if bound is not None and count > bound
    ]
    print(*too_many, sep="\n", end="\n" if too_many else "")
    return 1 if too_many else 0


if __name__ == "__main__":
    sys.exit(main())
