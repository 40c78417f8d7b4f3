"""The bench itself: a kernel with buses that lose frames and lines that make edges."""

import errno

from bench.case import Case
from bench.links import run
from bench.raw_can import ERROR_BUS_OFF, ERROR, Frame


class BenchTest(Case):
    def test_candump_hears_what_a_node_sends(self):
        log = self.log(self.bus().name)
        self.node("vcan0").send(0x185, bytes(range(8)))
        self.eventually(lambda: Frame(0x185, bytes(range(8))) in log.frames(), "the frame is in the log")

    def test_an_error_frame_reaches_the_others(self):
        self.bus()
        sender, listener = self.node("vcan0"), self.node("vcan0", errors=ERROR_BUS_OFF)
        sender.send_error(ERROR_BUS_OFF)
        self.assertEqual(listener.receive(5.0).id, ERROR | ERROR_BUS_OFF)

    def test_a_cable_can_lose_all(self):
        cable = self.cable()
        sender, receiver = self.node(cable.near), self.node(cable.far)
        cable.fault("loss", "100%")
        sender.send(0x101, b"")
        cable.heal()
        sender.send(0x102, b"")
        self.assertEqual(receiver.receive(5.0), Frame(0x102, b""))

    def test_a_short_queue_is_full_after_ten_frames(self):
        cable = self.cable()
        sender = self.node(cable.near)
        cable.fault("delay", "1000ms", "limit", "10")
        for i in range(10):
            sender.send(0x100 + i, b"")
        with self.assertRaises(OSError) as refused:
            sender.send(0x110, b"")
        self.assertEqual(refused.exception.errno, errno.ENOBUFS)

    def test_lines_make_edges(self):
        chip = self.chip("stop", "drive")
        chip.pull("stop", up=True)
        monitor = self.start("gpiomon", "--chip", chip.path, "-n", "2", "-p", "2ms", "0", unbuffered=True)
        # gpiomon says nothing when it is ready: the line is in use from then on.
        self.eventually(lambda: "consumer" in run("gpioinfo", "-c", chip.path, "0"), "gpiomon has the line")
        chip.pull("stop", up=False)
        self.eventually(lambda: "falling" in monitor.output(), "a falling edge")
        chip.pull("stop", up=True)
        self.assertEqual(monitor.wait(10), 0)
        self.assertIn("rising", monitor.output())

    def test_an_output_can_be_read(self):
        chip = self.chip("stop", "drive")
        self.start("gpioset", "--chip", chip.path, "1=1")
        self.eventually(lambda: chip.value("drive"), "the output is up")
