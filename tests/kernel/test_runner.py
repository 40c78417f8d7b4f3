"""The runner on a machine that has buses and lines itself, which the guest is."""

import os
import pathlib
import subprocess
import sys

from bench.case import Case

RUNNER = pathlib.Path(__file__).with_name("run.py")


def run(*arguments, **settings):
    return subprocess.run([sys.executable, str(RUNNER), *arguments], capture_output=True, text=True,
                          check=False, env={**os.environ, **settings})


class RunnerTest(Case):
    def test_runs_on_a_machine_that_has_all_itself(self):
        done = run("test_bench")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("OK", done.stderr)

    def test_a_test_that_fails_is_a_failure(self):
        done = run("--where", "host", "test_that_is_not_there")
        self.assertEqual(done.returncode, 1, done.stderr)

    def test_what_takes_too_long_is_a_failure(self):
        done = run("--where", "host", "--timeout", "0.1", "test_bench")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("no end after 0.1 s", done.stderr)

    def test_without_a_kernel_nothing_passes_silently(self):
        options = ("--where", "uml", "--kernel", "/nowhere/linux", "test_bench")
        done = run(*options, TENDONLIFE_REQUIRE_KERNEL="0")
        self.assertEqual(done.returncode, 77)
        self.assertIn("SKIPPED, NOTHING WAS TESTED: /nowhere/linux is not there", done.stderr)
        self.assertEqual(run(*options, TENDONLIFE_REQUIRE_KERNEL="1").returncode, 1)

    def test_what_it_needs_is_named(self):
        done = run("--needs", "/nowhere/image", "test_bench", TENDONLIFE_REQUIRE_KERNEL="0")
        self.assertEqual(done.returncode, 77)
        self.assertIn("/nowhere/image is missing", done.stderr)

    def test_a_setting_without_a_value_is_a_usage_error(self):
        done = run("--set", "NAME", "test_bench")
        self.assertEqual(done.returncode, 2)
        self.assertIn("accepted is NAME=VALUE", done.stderr)
