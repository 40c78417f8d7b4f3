"""Deepest stack of functions over the call graph that GCC writes with -fcallgraph-info=su, as JSON.

Recursion, frames of unknown size, calls through pointers and calls of functions that are neither in
the graphs nor given with their stack count as infinite. With --seen, fails where a painted stack saw
more than was computed.

usage: stack.py --roots NAME,... --external NAME=BYTES,... [--seen SEEN.json] [--out OUT.json] GRAPH.ci...
"""

import argparse
import json
import math
import pathlib
import re
import sys

NODE = re.compile(r'^node: \{ title: "([^"]*)" label: "([^"]*)"')
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"')
FRAME = re.compile(r"\\n(\d+) bytes \((static|dynamic,bounded)\)$")


def pairs(text):
    return {k: int(v) for k, v in (item.split("=") for item in text.split(",") if item)}


def one_name(title):
    """Complete and base constructors and destructors of a class without virtual bases are one function
    with two names (Itanium C++ ABI 5.1.4.3), of which the graph defines only one."""
    return re.sub(r"([CD])1(E)", r"\g<1>2\2", title)


def read_graphs(paths):
    frames, calls = {}, {}
    for path in paths:
        for line in pathlib.Path(path).read_text().splitlines():
            if node := NODE.match(line):
                name, frame = one_name(node[1]), FRAME.search(node[2])
                if frame:
                    frames[name] = max(int(frame[1]), frames.get(name, 0))
            elif edge := EDGE.match(line):
                calls.setdefault(one_name(edge[1]), set()).add(one_name(edge[2]))
    return frames, calls


def deepest(function, frames, calls, path=()):
    """The deepest stack and the chain of calls that leads there."""
    if function in path or function not in frames:
        return math.inf, [function]
    below = [deepest(callee, frames, calls, (*path, function))
             for callee in sorted(calls.get(function, ()))]
    depth, chain = max(below, key=lambda item: item[0], default=(0, []))
    return frames[function] + depth, [function, *chain]


parser = argparse.ArgumentParser()
parser.add_argument("--roots", required=True)
parser.add_argument("--external", type=pairs, default={})
parser.add_argument("--seen")
parser.add_argument("--out")
parser.add_argument("graphs", nargs="+")
arguments = parser.parse_args()

frames, calls = read_graphs(arguments.graphs)
frames.update(arguments.external)
seen = json.loads(pathlib.Path(arguments.seen).read_text()) if arguments.seen else {}

computed, failures = {}, []
for root in arguments.roots.split(","):
    depth, chain = deepest(root, frames, calls)
    chain_text = " > ".join(f"{name.split(':')[-1]} {frames.get(name, '?')}" for name in chain)
    print(f"{root}: {depth} bytes: {chain_text}")
    if math.isinf(depth):
        failures.append(f"{root}: infinite")
    computed[root] = depth
for name, most in seen.items():
    bound = computed.get(name, arguments.external.get(name))
    if bound is None:
        failures.append(f"{name}: seen, but not computed")
    elif most > bound:
        failures.append(f"{name}: {most} bytes seen, {bound} computed")
    else:
        print(f"{name}: {most} bytes seen under QEMU")
if failures:
    sys.exit("\n".join(failures))
if arguments.out:
    pathlib.Path(arguments.out).write_text(json.dumps(computed, indent=2) + "\n")
