"""Programs under test and the tools around them."""

import os
import pathlib
import signal
import subprocess
import tempfile


def binary(name):
    """The program that the test runner was told under TENDONLIFE_<NAME>."""
    variable = f"TENDONLIFE_{name.upper()}"
    path = os.environ.get(variable)
    if not path or not os.access(path, os.X_OK):
        raise AssertionError(f"{variable}={path or ''} names no program")
    return path


class Program:
    """A running program; what it writes is kept in files."""

    def __init__(self, *arguments, stdin=subprocess.DEVNULL, unbuffered=False):
        self.arguments = [str(argument) for argument in arguments]
        self._folder = tempfile.TemporaryDirectory(prefix="program-")
        folder = pathlib.Path(self._folder.name)
        self.out, self.err = folder / "out", folder / "err"
        command = ["stdbuf", "-oL", *self.arguments] if unbuffered else self.arguments
        with self.out.open("wb") as out, self.err.open("wb") as err:
            self.process = subprocess.Popen(command, stdin=stdin, stdout=out, stderr=err)

    @property
    def name(self):
        return pathlib.Path(self.arguments[0]).name

    def output(self):
        return self.out.read_text(errors="replace")

    def errors(self):
        return self.err.read_text(errors="replace")

    def running(self):
        return self.process.poll() is None

    def wait(self, seconds):
        return self.process.wait(seconds)

    def kill(self):
        """As a power cut does: at once, and it is told nothing."""
        self.process.kill()
        self.process.wait()

    def stop(self, seconds=20):
        """Asks it to end; its exit code."""
        if self.running():
            self.process.send_signal(signal.SIGTERM)
        return self.process.wait(seconds)

    def close(self):
        if self.running():
            self.kill()
        self._folder.cleanup()

    def __str__(self):
        state = "running" if self.running() else f"exit {self.process.returncode}"
        tail = lambda text: "\n".join(f"    {line}" for line in text.splitlines()[-15:])
        return f"  {' '.join(self.arguments)}: {state}\n{tail(self.output())}\n{tail(self.errors())}"
