"""UDS over the kernel's ISO-TP: the life record is read, and who has no authority is refused."""

import os
import signal
import subprocess
import time

from bench import diagnosis, frames
from bench.case import Case
from bench.controller import KEY, Ear, Profile, Setup
from bench.diagnosis import Tester

NODE = 5
RATE_PAGE = 2
GAP = 4
# storage::Event
EPOCH_OPENED, PARAMETERS_LOADED, WRONG_MAC, NONCE_REUSED, COUNTER_ROLLED_BACK = 1, 2, 3, 4, 6


class DiagnosisTest(Case):
    def setUp(self):
        self.bus("vcan0")
        self._ear = Ear(self, "vcan0")
        # It rests soon: once all is saved the storage counter stands still.
        self._setup = Setup(self, "vcan0", profile=Profile(20, 120, active_s=1.0, rest_s=100.0))
        self._controller = self._setup.run()
        self._ear.until(lambda ear: ear.status and ear.status.damage_ppb, "a life that is used")
        # A gap that the scheduler makes is saved at once: the first is made here, and is the last one.
        self._controller.process.send_signal(signal.SIGSTOP)
        time.sleep(0.2)
        self._controller.process.send_signal(signal.SIGCONT)
        self._ear.until(lambda ear: ear.status.flags & GAP, "the gap is told")
        self._ear.until(lambda ear: self.at_rest(), "the tendon rests")
        self._ear.pages.pop(RATE_PAGE, None)
        self._ear.until(lambda ear: self.all_saved(), "all is saved", 40)
        self._tester = self._kept(Tester("vcan0", NODE))

    def at_rest(self):
        lives = {status.damage_ppb for status in self._ear.statuses[-10:]}
        return len(self._ear.statuses) > 20 and len(lives) == 1

    def all_saved(self):
        page = self._ear.pages.get(RATE_PAGE)
        return page and frames.field(page, 6, 7) == 0

    def command(self, **changed):
        """A genuine command to open an epoch, but for what is changed."""
        parts = {"key": KEY, "nonce": self._tester.read(diagnosis.NONCE),
                 "counter": self._tester.storage_counter(), **changed}
        return self._tester.command(diagnosis.OPEN_EPOCH, b"\x00", **parts)

    def refused(self, request, code):
        before = self._tester.life()
        self.assertEqual(self._tester.start(request), code)
        after = self._tester.life()
        self.assertEqual(after.epoch, before.epoch)
        self.assertGreaterEqual(after.damage_ppb, before.damage_ppb)

    def test_the_life_record_is_what_the_bus_shows(self):
        self._ear.until(lambda ear: len(ear.statuses) > 1, "statuses")
        before = self._ear.listen().status.damage_ppb
        life = self._tester.life()
        self._ear.forget()
        self._ear.until(lambda ear: len(ear.statuses) > 1, "statuses")
        after = self._ear.status.damage_ppb
        self.assertLessEqual(before, life.damage_ppb)
        self.assertLessEqual(life.damage_ppb, after)
        self.assertEqual((life.tendon, life.past_lost), (0, 0))
        # Q24.104, least significant byte first.
        self.assertEqual(int.from_bytes(life.exact, "little") * 10**9 >> 104, life.damage_ppb)

    def test_isotprecv_of_can_utils_reads_it_too(self):
        receiver = self.start("isotprecv", "-s", f"18DA{NODE:02X}F1", "-d", f"18DAF1{NODE:02X}", "vcan0")
        time.sleep(0.3)
        subprocess.run(["isotpsend", "-s", f"18DA{NODE:02X}F1", "-d", f"18DAF1{NODE:02X}", "vcan0"],
                       input=b"22 02 00\n", check=True)
        self.assertEqual(receiver.wait(10), 0)
        answer = bytes.fromhex(receiver.output())
        self.assertEqual(answer[:3], bytes([0x62, 0x02, 0x00]))
        self.assertGreater(diagnosis.Life(answer[3:]).damage_ppb, 0)

    def test_a_genuine_command_opens_an_epoch_and_the_lifetime_stays(self):
        before = self._tester.life()
        self.assertIsNone(self._tester.start(self.command()))
        after = self._tester.life()
        self.assertEqual(after.epoch, before.epoch + 1)
        self.assertLess(after.damage_ppb, before.damage_ppb)
        self.assertGreaterEqual(after.lifetime_ppb, before.lifetime_ppb)
        self.assertEqual(self._tester.log(), [EPOCH_OPENED])

    def test_a_replayed_command_is_refused(self):
        command = self.command()
        self.assertIsNone(self._tester.start(command))
        self.refused(command, diagnosis.SEQUENCE)
        self._tester.read(diagnosis.NONCE)
        # With a fresh nonce open the counter has moved on, or the code proves another nonce.
        self.assertIn(self._tester.start(command), (diagnosis.CONDITIONS, diagnosis.INVALID_KEY))
        self.assertEqual(self._tester.log()[:2], [EPOCH_OPENED, NONCE_REUSED])

    def test_a_wrong_code_is_refused(self):
        request = bytearray(self.command())
        request[-1] ^= 1
        self.refused(bytes(request), diagnosis.INVALID_KEY)
        self.assertEqual(self._tester.log(), [WRONG_MAC])

    def test_a_command_for_another_node_is_refused(self):
        self.refused(self.command(node=NODE + 1), diagnosis.INVALID_KEY)

    def test_a_counter_of_the_past_is_refused(self):
        counter = self._tester.storage_counter()
        self.refused(self.command(counter=counter - 1), diagnosis.CONDITIONS)
        self.assertEqual(self._tester.log(), [COUNTER_ROLLED_BACK])

    def test_three_failures_lock_and_raise_an_emergency(self):
        for code in (diagnosis.INVALID_KEY, diagnosis.INVALID_KEY, diagnosis.EXCEEDED):
            self.assertEqual(self._tester.start(self.command(key=bytes(16))), code)
        self.refused(self.command(), diagnosis.DELAY)
        self._ear.until(lambda ear: frames.AUTHORITY in ear.codes(), "an emergency frame")

    def test_an_oversized_transfer_is_refused_and_the_link_lives(self):
        with self.assertRaises(OSError):
            self._tester.ask(os.urandom(4000))
        self.assertGreater(self._tester.life().damage_ppb, 0)
        self._ear.pages.clear()
        self._ear.until(lambda ear: 8 in ear.pages and frames.field(ear.pages[8], 6, 7) > 0, "it is counted")
