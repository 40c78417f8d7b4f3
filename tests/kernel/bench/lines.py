"""Simulated lines (gpio-sim): the tests pull the inputs and read the outputs."""

import os
import pathlib
import time

CONFIGFS = pathlib.Path("/sys/kernel/config/gpio-sim")


class Chip:
    """A chip with named lines at the offsets 0, 1, ..."""

    def __init__(self, *names):
        self._bank = CONFIGFS / f"tendonlife-{os.getpid()}-{id(self)}" / "bank"
        self._device = self._bank.parent
        self._bank.mkdir(parents=True)
        (self._bank / "num_lines").write_text(str(len(names)))
        self._offsets = {name: offset for offset, name in enumerate(names)}
        for name, offset in self._offsets.items():
            (self._bank / f"line{offset}").mkdir()
            (self._bank / f"line{offset}" / "name").write_text(name)
        (self._device / "live").write_text("1")
        self.name = (self._bank / "chip_name").read_text().strip()
        device = (self._device / "dev_name").read_text().strip()
        self.state = pathlib.Path("/sys/devices/platform") / device / self.name

    @property
    def path(self):
        return f"/dev/{self.name}"

    def pull(self, name, up):
        line = self.state / f"sim_gpio{self._offsets[name]}"
        (line / "pull").write_text("pull-up" if up else "pull-down")

    def glitch(self, name, seconds):
        """Pulls the line up for at least so long; how long it really was, in seconds."""
        pull = os.open(self.state / f"sim_gpio{self._offsets[name]}" / "pull", os.O_WRONLY)
        try:
            began = time.monotonic()
            os.pwrite(pull, b"pull-up", 0)
            while time.monotonic() < began + seconds:  # sleeping takes ten times as long here
                pass
            os.pwrite(pull, b"pull-down", 0)
            return time.monotonic() - began
        finally:
            os.close(pull)

    def value(self, name):
        line = self.state / f"sim_gpio{self._offsets[name]}"
        return (line / "value").read_text().strip() == "1"

    def close(self):
        (self._device / "live").write_text("0")
        for offset in self._offsets.values():
            (self._bank / f"line{offset}").rmdir()
        self._bank.rmdir()
        self._device.rmdir()
