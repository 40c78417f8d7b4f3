"""What a bus does to a controller: full queues, bus-off, error-passive, babbling neighbours, and
interfaces that go away. The control loop and the emergency frame survive all of it."""

import time

from bench import frames
from bench.case import Case
from bench.controller import LINES, Ear, Profile, Setup
from bench.frames import Status
from bench.program import binary
from bench.raw_can import (CONTROLLER_ACTIVE, CONTROLLER_PASSIVE, ERROR_BUS_OFF, ERROR_CONTROLLER,
                           ERROR_COUNTERS)

NODE = 5
BUS_PAGE = 8
# While damage runs ahead of the store the bus hears of that in place of other pages: it rests too.
PROFILE = Profile(20, 120, active_s=2.0, rest_s=3.0)


class CableFaultTest(Case):
    """Between the controller and its receiver."""

    def setUp(self):
        self._cable = self.cable()
        self._chip = self.chip(*LINES)
        self._chip.pull("stop", up=False)
        self._receiver = self.start(binary("receiver"), self._cable.far, NODE)
        self._sent = self.log(self._cable.near)
        self._ear = Ear(self, self._cable.far)
        self._controller = Setup(self, self._cable.near, chip=self._chip, profile=PROFILE).run()
        self._ear.until(lambda ear: len(ear.statuses) > 2, "life statuses")

    def assert_loop_goes_on(self, toggles=4):
        """Level changes of the watchdog pin: the loop runs and the application with it."""
        for _ in range(toggles):
            level = self._chip.value("watchdog")
            self.eventually(lambda: self._chip.value("watchdog") != level, "the watchdog pin toggles")

    def shown(self):
        lines = [line.split() for line in self._receiver.output().splitlines()]
        return [tuple(int(n) for n in line[3:]) for line in lines if line[2:3] == ["life"]]

    def assert_only_sent_lives_were_shown(self, at_least):
        shown = self.shown()
        self.assertGreaterEqual(len(shown), at_least)

        def unsent():
            return set(shown) - {Status.of(f).life for f in self._sent.frames() if f.id == frames.STATUS + NODE}

        # The log of what was sent is another process, which may write after the receiver does.
        self.eventually(lambda: not unsent(), lambda: f"every life that was shown was sent, not {unsent()}", 5.0)

    def under(self, *netem, seconds=4.0, at_least=5):
        self._cable.fault(*netem)
        time.sleep(seconds)
        self._cable.heal()
        self._ear.forget()
        self._ear.until(lambda ear: len(ear.statuses) > 2, "life statuses after the fault")
        self.assert_only_sent_lives_were_shown(at_least)
        self.assertEqual(self._controller.stop(), 0)

    def test_loss(self):
        self.under("loss", "30%")

    def test_duplicates(self):
        self.under("duplicate", "50%")

    def test_bit_errors(self):
        self.under("corrupt", "50%")

    def test_delay_and_shuffling(self):
        self.under("delay", "150ms", "100ms", "reorder", "30%", "limit", "1000")

    def test_a_full_queue_blocks_nothing_and_the_emergency_survives(self):
        # Ten frames find room, then none until the queue has more.
        self._cable.fault("delay", "60s", "limit", "10")
        refused = self.eventually(lambda: self._cable.queue()["drops"], "the queue is full")
        self.assert_loop_goes_on()
        self.eventually(lambda: self._cable.queue()["drops"] > refused, "frames are offered in vain")
        self._chip.pull("stop", up=True)
        self.eventually(lambda: not self._chip.value("drive"), "the drive is off")
        self.assertEqual(self._cable.queue()["qlen"], 10, "not one frame found room")

        # While the kernel takes a queue away it loses frames that it has accepted: this one stays.
        self._cable.fault("limit", "1000")
        self._ear.until(lambda ear: frames.EMERGENCY_STOP in ear.codes(), "the emergency frame")
        self._ear.forget()
        self._ear.until(lambda ear: BUS_PAGE in ear.pages and frames.field(ear.pages[BUS_PAGE], 5, 5) > 0,
                        "the dropped pages are counted")
        self.assert_only_sent_lives_were_shown(3)
        self.assertEqual(self._controller.stop(), 0)
        self.assertGreater(self._controller.report()["can"]["queue_full"], 0)


class BusFaultTest(Case):
    def setUp(self):
        self._bus = self.bus("vcan0")
        self._driver = self.node("vcan0")
        self._ear = Ear(self, "vcan0")
        self._controller = Setup(self, "vcan0", profile=PROFILE).run()
        self._ear.until(lambda ear: BUS_PAGE in ear.pages, "the bus page")

    def bus_page(self, first, last, condition, what):
        self._ear.pages.pop(BUS_PAGE, None)
        self._ear.until(
            lambda ear: BUS_PAGE in ear.pages and condition(frames.field(ear.pages[BUS_PAGE], first, last)), what)

    def goes_on(self):
        """The controller speaks, and its damage grows."""
        self._ear.forget()
        self._ear.until(lambda ear: len(ear.statuses) > 2, "life statuses")
        before = self._ear.status.damage_ppb
        self._ear.until(lambda ear: ear.status.damage_ppb > before, "damage grows")

    def test_bus_off_is_recovered_from_and_counted(self):
        for count in (1, 2, 3):
            self._ear.forget()
            self._driver.send_error(ERROR_BUS_OFF)
            self._ear.until(lambda ear: frames.BUS_OFF in ear.codes(), "an emergency frame, once it is back")
            self._ear.until(lambda ear: frames.ALL_OVER in ear.codes(), "the end of the emergency")
            self.bus_page(4, 4, lambda bus_offs: bus_offs == count, f"{count} bus-offs are counted")
        self.goes_on()
        self.assertEqual(self._controller.stop(), 0)

    def test_error_passive_is_shown(self):
        self._driver.send_error(ERROR_CONTROLLER | ERROR_COUNTERS, CONTROLLER_PASSIVE, 130, 17)
        self.bus_page(2, 3, lambda counters: counters == 130 | 17 << 8, "the error counters")
        self.goes_on()
        self._driver.send_error(ERROR_CONTROLLER | ERROR_COUNTERS, CONTROLLER_ACTIVE, 0, 0)
        self.bus_page(2, 3, lambda counters: counters == 0, "no errors any more")
        self.assertEqual(self._controller.stop(), 0)

    def test_a_babbling_neighbour_is_survived_and_counted(self):
        floods = [self.start("cangen", "vcan0", "-g", "0", "-i", "-I", f"{frames.COMMAND + NODE:X}", "-L", "8"),
                  self.start("cangen", "vcan0", "-g", "0", "-i", "-I", "r", "-L", "r", "-D", "r")]
        time.sleep(3)
        for flood in floods:
            self.assertTrue(flood.running())
            flood.kill()
        self.goes_on()
        self.bus_page(6, 7, lambda refused: refused > 0, "the refused frames are counted")
        self.assertEqual(self._controller.stop(), 0)

    def test_an_interface_that_is_down_for_a_while(self):
        self._bus.down()
        time.sleep(1)
        self.assertTrue(self._controller.running())
        self._bus.up()
        self.goes_on()
        self.assertEqual(self._controller.stop(), 0)
