"""A receiver behind a bus that loses, doubles, damages, delays and shuffles never shows a wrong life.

The sender and the judge of every verdict are written apart from the code under test.
"""

import time

from bench.case import Case
from bench.frames import EMERGENCY, STATUS, USABLE, Check, Emergency, Status, protect
from bench.links import run
from bench.program import binary
from bench.raw_can import Frame

NODE = 5
SENT = 300


def status_of(i):
    """The i-th status of the sender: all of its fields differ from those of its neighbours."""
    return Status(i % 16, "normal" if i < SENT // 2 else "inspect", 1000 + 977 * i, i % 4, i % 5, i % 64)


class Receiver:
    """The receiver under test, and what it said of each frame."""

    def __init__(self, case, interface):
        self.program = case.start(binary("receiver"), interface, NODE)
        # It says nothing when it is ready: a frame of the tests must come through.
        node = case.node(interface)
        case.eventually(lambda: (node.send(STATUS + NODE, b""), self.lines())[1], "the receiver hears")
        self._skip = None
        case.eventually(lambda: self._quiet(), "the receiver is done with the frames that woke it")

    def _quiet(self):
        before = len(self.lines())
        time.sleep(0.2)
        self._skip = len(self.lines())
        return before == self._skip

    def lines(self):
        return [line.split() for line in self.program.output().splitlines()]

    def said(self):
        return self.lines()[self._skip:]

    def shown(self):
        return [tuple(int(n) for n in line[3:]) for line in self.said() if line[2:3] == ["life"]]


class FaultyCableTest(Case):
    def setUp(self):
        self._cable = self.cable()
        self._receiver = Receiver(self, self._cable.far)
        self._far = self.log(self._cable.far)
        self._heard = len(self._far.frames())
        self._sender = self.node(self._cable.near)

    def send_all(self, pause_s=0.002):
        for i in range(SENT):
            self._sender.send(STATUS + NODE, status_of(i).encoded(NODE))
            time.sleep(pause_s)

    def arrived(self):
        """The frames at the far end, once no more come."""
        count = -1
        while count != len(self._far.frames()):
            count = len(self._far.frames())
            time.sleep(0.5)
        return [f for f in self._far.frames()[self._heard:] if f.id != 0x7FF]

    def verify(self):
        """Each verdict is exact and each shown life was sent; gives the verdicts of the statuses."""
        arrived = self.arrived()
        checks = {kind: Check(kind, NODE) for kind in (STATUS, EMERGENCY)}
        expected = []
        for frame in arrived:
            for kind, check in checks.items():
                if frame.id == kind + NODE:
                    expected.append([f"{frame.id:03X}#{frame.data.hex().upper()}", check.verdict(frame)])
        said = [line for line in self._receiver.said() if not line[0].startswith("285")]
        self.assertEqual([line[:2] for line in said], expected)

        sent = {status_of(i).life: i for i in range(SENT)}
        for life in self._receiver.shown():
            self.assertIn(life, sent)
        usable = [e for e in expected if e[0].startswith("185") and e[1] in USABLE]
        self.assertEqual(len(self._receiver.shown()), len(usable))
        return [e[1] for e in expected if e[0].startswith("185")]

    def test_without_a_fault_all_is_shown(self):
        self.send_all()
        verdicts = self.verify()
        self.assertEqual(verdicts, ["initial"] + ["ok"] * (SENT - 1))
        self.assertEqual(self._receiver.shown(), [status_of(i).life for i in range(SENT)])

    def test_loss(self):
        self._cable.fault("loss", "30%")
        self.send_all()
        verdicts = self.verify()
        self.assertIn("ok_some_lost", verdicts)
        self.assertLess(len(verdicts), SENT)

    def test_duplicates(self):
        self._cable.fault("duplicate", "30%")
        self.send_all()
        verdicts = self.verify()
        self.assertEqual(verdicts.count("repeated"), len(verdicts) - SENT)
        self.assertGreater(len(verdicts), SENT)
        self.assertEqual(self._receiver.shown(), [status_of(i).life for i in range(SENT)])

    def test_bit_errors(self):
        # One bit of a frame is inverted, be it of its id, its length or its data.
        self._cable.fault("corrupt", "50%")
        self.send_all()
        self.assertIn("wrong_crc", self.verify())

    def test_delay(self):
        self._cable.fault("delay", "500ms", "limit", "1000")
        self.send_all()
        self.assertEqual(self.verify(), ["initial"] + ["ok"] * (SENT - 1))

    def test_shuffled(self):
        self._cable.fault("delay", "20ms", "reorder", "30%", "limit", "1000")
        self.send_all()
        self.assertIn("wrong_sequence", self.verify())

    def test_everything_at_once(self):
        self._cable.fault("delay", "20ms", "10ms", "loss", "10%", "duplicate", "10%", "corrupt", "10%",
                          "reorder", "20%", "limit", "1000")
        self.send_all()
        self.verify()

    def test_a_full_queue(self):
        self._cable.fault("delay", "300ms", "limit", "10")
        refused = 0
        for i in range(SENT):
            try:
                self._sender.send(STATUS + NODE, status_of(i).encoded(NODE))
            except OSError:
                refused += 1
            time.sleep(0.002)
        self.assertGreater(refused, 0)
        self.verify()

    def test_a_frame_of_another_node_is_not_taken(self):
        # A bit of the id is inverted on the way: the frame of node 7 comes in as one of node 5.
        run("cangw", "-A", "-s", self._cable.far, "-d", self._cable.far, "-e", "-i",
            "-f", "187:7FF", "-m", "SET:I:185.0.0000000000000000")
        self.addCleanup(run, "cangw", "-F")
        for i in range(64):
            self._sender.send(STATUS + 7, status_of(i).encoded(7))
            time.sleep(0.002)
        arrived = [frame for frame in self.arrived() if frame.id == STATUS + NODE]
        self.assertEqual(len(arrived), 64)
        self.assertEqual([line[1] for line in self._receiver.said()], ["wrong_crc"] * 64)

    def test_an_emergency_is_shown_once(self):
        self._cable.fault("duplicate", "100%")
        for counter, code in enumerate((0xFF01, 0x0000)):
            data = code.to_bytes(2, "little") + bytes([0x81 if code else 0, 0, 0]) + (123).to_bytes(3, "little")
            frame = Frame(EMERGENCY + NODE, protect(EMERGENCY, NODE, counter, data))
            self.assertEqual(Emergency.of(frame).code, code)
            self._sender.send(frame.id, frame.data)
        self.verify()
        self.assertEqual([line[1:] for line in self._receiver.said()], [
            ["initial", "emergency", str(0xFF01), str(0x81), "123"], ["repeated"],
            ["ok", "emergency", "0", "0", "123"], ["repeated"]])
