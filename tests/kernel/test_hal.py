"""The Linux back ends of the hal on a real kernel: their contract, and what goes beyond it."""

import os
import subprocess

from bench.case import Case
from bench.converter import Converter
from bench.program import binary


class HalTest(Case):
    def passes(self, tests, **settings):
        done = subprocess.run([binary("hal_tests"), "--gtest_brief=1", f"--gtest_filter={tests}"],
                              capture_output=True, text=True, check=False, env={**os.environ, **settings})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("[  PASSED  ] 0 tests", done.stdout)
        self.assertIn("[  PASSED  ]", done.stdout)

    def test_bus_and_lines(self):
        cable = self.cable()
        chip = self.chip("stop", "drive")
        self.passes("-IioOnKernel.*", TENDONLIFE_NEAR=cable.near, TENDONLIFE_FAR=cable.far,
                    TENDONLIFE_CHIP=chip.path, TENDONLIFE_CHIP_STATE=str(chip.state))

    def test_converter(self):
        if not Converter.there():
            self.skipTest("no simulated converter (modprobe iio_dummy iio-trig-hrtimer)")
        converter = self._kept(Converter())
        self.passes("IioOnKernel.*", TENDONLIFE_CONVERTER=converter.name, TENDONLIFE_TRIGGER=converter.trigger)
