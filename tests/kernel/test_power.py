"""The controller is killed at random moments; what is lost is within what it had published."""

import random

from bench import frames
from bench.case import Case
from bench.controller import Ear, Profile, Setup

CUTS = 20
STORAGE_PAGE = 6
# About 1.6e-4 a cycle and ten cycles a second: the unsaved damage fits its 24 bits of 1e-9.
PROFILE = Profile(20, 40)


class PowerCutTest(Case):
    def test_no_more_is_lost_than_was_published(self):
        self.bus("vcan0")
        setup = Setup(self, "vcan0", profile=PROFILE)
        moment = random.Random(20240229)
        shown_ppb, unsaved_ppb, sequence, first_ppb = 0, 0, 0, None
        for cut in range(CUTS + 1):
            ear = Ear(self, "vcan0")
            controller = setup.run()
            ear.until(lambda e: e.status and STORAGE_PAGE in e.pages, f"life number {cut}")
            again_ppb = ear.statuses[0].damage_ppb
            with self.subTest(cut=cut, shown_ppb=shown_ppb, unsaved_ppb=unsaved_ppb, again_ppb=again_ppb):
                self.assertNotEqual(ear.status.state, "unknown")
                self.assertTrue(ear.status.storage_ok)
                self.assertGreaterEqual(again_ppb, shown_ppb - unsaved_ppb)
                self.assertGreaterEqual(frames.field(ear.pages[STORAGE_PAGE], 2, 4), sequence)
            first_ppb = again_ppb if first_ppb is None else first_ppb
            if cut == CUTS:
                break
            ear.listen_for(moment.uniform(0.0, 1.5))
            controller.kill()
            ear.listen(0.05)
            shown_ppb = ear.status.damage_ppb
            unsaved_ppb = frames.field(ear.pages[STORAGE_PAGE], 5, 7)
            sequence = frames.field(ear.pages[STORAGE_PAGE], 2, 4)
            self.assertLess(unsaved_ppb, 0xFFFFFF, "the published figure has stopped")
        self.assertGreater(again_ppb, first_ppb, "damage goes up over all of it")
