"""The Linux back ends of the hal on a real kernel: their contract, and what goes beyond it."""

import os
import subprocess

from bench.case import Case
from bench.program import binary


class HalTest(Case):
    def test_back_ends(self):
        cable = self.cable()
        chip = self.chip("stop", "drive")
        settings = {
            "TENDONLIFE_NEAR": cable.near,
            "TENDONLIFE_FAR": cable.far,
            "TENDONLIFE_CHIP": chip.path,
            "TENDONLIFE_CHIP_STATE": str(chip.state),
        }
        done = subprocess.run([binary("hal_tests"), "--gtest_brief=1"], capture_output=True, text=True,
                              check=False, env={**os.environ, **settings})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("PASSED", done.stdout)
