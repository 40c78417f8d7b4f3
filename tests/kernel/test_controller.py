"""The Linux controller on a real bus and real lines."""

import time

from bench import frames
from bench.case import Case
from bench.controller import DEBOUNCE_S, LINES, Ear, Profile, Setup
from bench.decoder import decode

GLITCHES = 20


class ControllerTest(Case):
    def setUp(self):
        self._bus = self.bus("vcan0")
        self._chip = self.chip(*LINES)
        self._chip.pull("stop", up=False)
        self._ear = Ear(self, "vcan0")

    def running(self, **options):
        """A controller that has begun to speak."""
        setup = Setup(self, "vcan0", chip=self._chip, **options)
        controller = setup.run()
        self._ear.until(lambda ear: ear.status, "a life status")
        return controller

    def test_a_log_of_candump_decodes_to_the_life_that_the_controller_reports(self):
        log = self.log("vcan0")
        profile = Profile(20, 120, active_s=3.0, rest_s=0.5)
        controller = Setup(self, "vcan0", chip=self._chip, at_end="stop", profile=profile).run()
        self.assertEqual(controller.wait(60), 0)
        tendon = controller.report()["tendons"][0]

        def heard_ppb():
            return [frames.Status.of(frame).damage_ppb for frame in log.frames() if frame.id == frames.STATUS + 5][-1:]

        self.eventually(lambda: heard_ppb() == [tendon["damage_ppb"]], "the log has the last frames")
        log.stop()

        lives = [entry["signals"] for entry in decode(log.out, 5) if entry["name"] == "LifeStatus_5"]
        self.assertGreater(len(lives), 25)
        self.assertEqual(round(lives[-1]["Damage"] * 1e9), tendon["damage_ppb"])
        self.assertEqual([life["WorstTendon"] for life in lives], [0] * len(lives))
        # Against the equations of the paper: each cycle of the sine counts once.
        self.assertEqual(tendon["cycles"], profile.cycles - 1)
        self.assertAlmostEqual(tendon["damage_ppb"] / 1e9 / (profile.cycles * profile.damage_of_a_cycle()), 1,
                               delta=1e-4)

    def test_pulling_the_stop_drops_the_drive_and_raises_an_emergency(self):
        controller = self.running()
        self.eventually(lambda: self._chip.value("drive"), "the drive is enabled")
        self.eventually(lambda: not self._chip.value("brake"), "the brake is open")
        self.assertFalse(self._ear.status.locked)
        self._ear.forget()

        self._chip.pull("stop", up=True)
        self.eventually(lambda: not self._chip.value("drive"), "the drive is off")
        self.eventually(lambda: self._chip.value("brake"), "the brake is on")
        self._ear.until(lambda ear: frames.EMERGENCY_STOP in ear.codes(), "an emergency frame")
        self._ear.until(lambda ear: ear.status.locked, "a status that says so")

        self._ear.forget()
        self._chip.pull("stop", up=False)
        self._ear.until(lambda ear: frames.ALL_OVER in ear.codes(), "the end of the emergency")
        self._ear.until(lambda ear: len(ear.statuses) > 3, "more statuses")
        self.assertTrue(self._ear.status.locked, "the drive comes back with the next start only")
        self.assertFalse(self._chip.value("drive"))
        self.assertTrue(self._chip.value("brake"))
        self.assertEqual(controller.stop(), 0)

    def test_a_glitch_of_the_stop_does_nothing(self):
        # One that the scheduler has stretched may stop the drive: then all begins again.
        for _ in range(20):
            controller = self.running()
            self.eventually(lambda: self._chip.value("drive"), "the drive is enabled")
            self._ear.forget()
            short = stretched = 0
            while short < GLITCHES and stretched < 10 * GLITCHES and self._chip.value("drive"):
                if self._chip.glitch("stop", DEBOUNCE_S / 2) < 0.9 * DEBOUNCE_S:
                    short += 1
                else:
                    stretched += 1
                time.sleep(0.03)
            self._ear.until(lambda ear: len(ear.statuses) > 3, "more statuses")
            if self._chip.value("drive") or not stretched:
                break
            controller.kill()
        self.assertTrue(self._chip.value("drive"))
        self.assertFalse(self._ear.status.locked)
        self.assertNotIn(frames.EMERGENCY_STOP, self._ear.codes())
        self.assertEqual(short, GLITCHES, "glitches were short")
        self.assertEqual(controller.stop(), 0)

    def test_a_stop_that_is_pulled_at_the_start_keeps_the_drive_off(self):
        self._chip.pull("stop", up=True)
        controller = self.running()
        self._ear.until(lambda ear: ear.status.locked, "a status that says so")
        self.assertFalse(self._chip.value("drive"))
        self.assertTrue(self._chip.value("brake"))
        self.assertEqual(controller.stop(), 0)

    def test_the_end_of_the_controller_releases_the_drive(self):
        controller = self.running()
        self.eventually(lambda: self._chip.value("drive"), "the drive is enabled")
        self.assertEqual(controller.stop(), 0)
        self.assertFalse(self._chip.value("drive"))

    def test_a_controller_that_is_killed_drops_the_drive(self):
        self._chip.pull("drive", up=False)
        controller = self.running()
        self.eventually(lambda: self._chip.value("drive"), "the drive is enabled")
        controller.kill()
        self.eventually(lambda: not self._chip.value("drive"), "the kernel has taken the line back")

    def test_the_watchdog_pin_toggles(self):
        controller = self.running()
        for level in (True, False, True, False):
            self.eventually(lambda: self._chip.value("watchdog") == level, "the pin toggles")
        self.assertEqual(controller.stop(), 0)


class ErrorTest(Case):
    """What is wrong, where, and what is accepted; nothing is written."""

    def setUp(self):
        self.bus("vcan0")
        self._chip = self.chip(*LINES)
        self._setup = Setup(self, "vcan0", chip=self._chip)

    def refused(self, *texts):
        controller = self._setup.run()
        self.assertNotIn(controller.wait(20), (0, None))
        for text in texts:
            self.assertIn(text, controller.errors())
        self.assertEqual(list((self._setup.folder / "store").glob("*.life")), [])

    def test_a_missing_interface(self):
        self._setup.replace('interface = "vcan0"', 'interface = "can7"')
        self.refused("can7: no such network interface", "vcan0")

    def test_an_interface_that_is_no_can(self):
        self._setup.replace('interface = "vcan0"', 'interface = "lo"')
        self.refused("lo: not a CAN interface")

    def test_a_missing_chip(self):
        self._setup.replace(self._chip.path, "gpiochip77")
        self.refused("gpiochip77", self._chip.name)

    def test_a_missing_line(self):
        self._setup.replace('"brake"', '"no_brake"')
        self.refused("no line 'no_brake'")

    def test_a_line_in_use(self):
        self.start("gpioset", "--chip", self._chip.path, "--consumer", "somebody", "drive=1")
        self.eventually(lambda: self._chip.value("drive"), "the line is taken")
        self.refused("line 'drive' is in use by 'somebody'")
