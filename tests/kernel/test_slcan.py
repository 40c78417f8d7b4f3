"""The whole firmware on the QEMU board, attached by slcand: a CAN interface as any other."""

import os
import time

from bench import frames
from bench.case import Case
from bench.controller import Ear
from bench.decoder import decode
from bench.diagnosis import OPEN_EPOCH, NONCE, Tester
from bench.frames import Status
from bench.links import run
from bench.program import binary

NODE = 5
INTERFACE = "slcan0"


class SlcanTest(Case):
    @classmethod
    def setUpClass(cls):
        cls.serial = os.environ["TENDONLIFE_SERIAL"]

    def test_the_board_is_a_node_on_a_bus(self):
        self.start("slcand", "-o", "-c", "-s8", "-F", self.serial, INTERFACE)
        self.eventually(lambda: os.path.exists(f"/sys/class/net/{INTERFACE}"), "slcand has the interface")
        run("ip", "link", "set", INTERFACE, "up")
        log = self.log(INTERFACE)
        receiver = self.start(binary("receiver"), INTERFACE, NODE)
        ear = Ear(self, INTERFACE, NODE)
        ear.until(lambda e: len(e.statuses) > 20 and len(e.pages) >= 13, "statuses and all pages", 60)
        ear.until(lambda e: e.status.damage_ppb > e.statuses[0].damage_ppb, "damage grows", 60)
        ear.until(lambda e: len({s.damage_ppb for s in e.statuses[-10:]}) == 1, "the tendons rest", 60)

        tester = self._kept(Tester(INTERFACE, NODE))
        life = tester.life()
        self.assertEqual(life.damage_ppb, ear.status.damage_ppb)
        self.assertEqual(int.from_bytes(life.exact, "little") * 10**9 >> 104, life.damage_ppb)
        self.assertGreater(tester.life(1).damage_ppb, 0)
        nonce = tester.read(NONCE)
        forged = tester.command(OPEN_EPOCH, b"\x00", bytes(16), nonce, tester.storage_counter())
        self.assertIsNotNone(tester.start(forged))
        self.assertEqual(tester.life().epoch, life.epoch)

        receiver.kill()
        time.sleep(0.5)
        log.stop()
        self.judge(log, receiver)

    def judge(self, log, receiver):
        """Each decoder makes the same of the frames that came over the serial line."""
        heard = [f for f in log.frames() if f.id == frames.STATUS + NODE]
        lives = [Status.of(frame) for frame in heard]
        self.assertGreater(len(lives), 20)

        check = frames.Check(frames.STATUS, NODE)
        self.assertEqual({check.verdict(frame) for frame in heard}, {"initial", "ok"})

        shown = [line.split() for line in receiver.output().splitlines()]
        shown = [tuple(int(n) for n in line[3:]) for line in shown if line[2:3] == ["life"]]
        self.assertGreater(len(shown), 20)
        logged = [life.life for life in lives]
        runs = [logged[i:i + len(shown)] for i in range(len(logged) - len(shown) + 1)]
        self.assertIn(shown, runs, "what the receiver heard between its start and its end")

        decoded = [entry for entry in decode(log.out, NODE) if "Damage" in entry.get("signals", {})]
        self.assertEqual([round(entry["signals"]["Damage"] * 1e9) for entry in decoded],
                         [life.damage_ppb for life in lives])
