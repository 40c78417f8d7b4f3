"""The test case that cleans its bench, and shows what its programs said when a test fails."""

import pathlib
import tempfile
import time
import unittest

from bench.links import Bus, Cable
from bench.lines import Chip
from bench.program import Program
from bench.raw_can import Node, read_log


class Case(unittest.TestCase):
    def run(self, result=None):
        self._programs = []
        self._said = []
        before = self._count(result)
        super().run(result)
        if self._count(result) != before:
            print(f"\n--- programs of {self.id()}", *self._said, "---", sep="\n", flush=True)

    @staticmethod
    def _count(result):
        return len(result.failures) + len(result.errors) if result else 0

    def folder(self):
        """A folder that is gone after the test."""
        folder = tempfile.TemporaryDirectory(prefix="test-")
        self.addCleanup(folder.cleanup)
        return pathlib.Path(folder.name)

    def start(self, *arguments, **options):
        program = Program(*arguments, **options)

        def end():
            said = str(program)
            self._said.append(said)
            program.close()

        self.addCleanup(end)
        return program

    def _kept(self, thing):
        self.addCleanup(thing.close)
        return thing

    def bus(self, name="vcan0"):
        return self._kept(Bus(name))

    def cable(self, near="near0", far="far0"):
        return self._kept(Cable(near, far))

    def chip(self, *names):
        return self._kept(Chip(*names))

    def node(self, interface, errors=0):
        return self._kept(Node(interface, errors))

    def log(self, interface, *filters):
        """A `candump -L` of an interface that has begun to hear; frames() gives what it has so far."""
        program = self.start("candump", "-L", ",".join([interface, *filters]), unbuffered=True)
        program.frames = lambda: read_log(program.out)
        # candump says nothing when it is ready: a frame of the tests must come through.
        probe = Node(interface)
        try:
            self.eventually(lambda: (probe.offer(0x7FF, b""), program.output())[1], "candump hears the bus")
        finally:
            probe.close()
        return program

    def eventually(self, condition, what, seconds=20.0):
        """The first value of `condition` that is true; fails if there is none in time."""
        deadline = time.monotonic() + seconds
        while True:
            if value := condition():
                return value
            if time.monotonic() > deadline:
                self.fail(f"not within {seconds:.0f} s: {what}")
            time.sleep(0.02)
