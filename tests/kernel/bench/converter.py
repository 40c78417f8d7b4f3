"""A simulated converter (iio_simple_dummy) with a timer that triggers it."""

import pathlib

CONFIGFS = pathlib.Path("/sys/kernel/config/iio")


class Converter:
    """Gives the same values in each scan; the name of the device and that of its trigger."""

    def __init__(self, name="shunts", trigger="sampler"):
        self.name, self.trigger = name, trigger
        self._folders = [CONFIGFS / "devices" / "dummy" / name, CONFIGFS / "triggers" / "hrtimer" / trigger]
        for folder in self._folders:
            folder.mkdir()

    @staticmethod
    def there():
        """Whether the kernel has all that it takes."""
        return all((CONFIGFS / folder).is_dir() for folder in ("devices/dummy", "triggers/hrtimer"))

    def close(self):
        for folder in self._folders:
            folder.rmdir()
