"""Virtual buses and what is done to them."""

import json
import subprocess


def run(*arguments):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(done.args)}: {done.stderr.strip()}")
    return done.stdout


class Bus:
    """A vcan interface: every socket on it hears every frame."""

    def __init__(self, name):
        self.name = name
        run("ip", "link", "add", "dev", name, "type", "vcan")
        self.up()

    def up(self):
        run("ip", "link", "set", self.name, "up")

    def down(self):
        run("ip", "link", "set", self.name, "down")

    def close(self):
        run("ip", "link", "delete", self.name)


class Cable:
    """A vxcan pair: what goes in at `near` comes out at `far`, after the faults set on `near`."""

    def __init__(self, near, far):
        self.near, self.far = near, far
        run("ip", "link", "add", "dev", near, "type", "vxcan", "peer", "name", far)
        run("ip", "link", "set", near, "up")
        run("ip", "link", "set", far, "up")

    def fault(self, *netem):
        """Replaces the faults, in the words of tc-netem(8)."""
        run("tc", "qdisc", "replace", "dev", self.near, "root", "netem", *netem)

    def queue(self):
        """What tc(8) counts of the queue at `near`: `qlen` frames wait in it, `drops` found no room."""
        return json.loads(run("tc", "-s", "-j", "qdisc", "show", "dev", self.near))[0]

    def heal(self):
        run("tc", "qdisc", "delete", "dev", self.near, "root")

    def close(self):
        run("ip", "link", "delete", self.near)
