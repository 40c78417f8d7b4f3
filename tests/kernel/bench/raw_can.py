"""A node of the tests: raw CAN in and out."""

import errno
import pathlib
import socket
import struct
import time

FRAME = struct.Struct("=IB3x8s")  # struct can_frame of linux/can.h
EXTENDED, REMOTE, ERROR = socket.CAN_EFF_FLAG, socket.CAN_RTR_FLAG, socket.CAN_ERR_FLAG

RAW_ERROR_FILTER = 2  # linux/can/raw.h; Python does not name it

# linux/can/error.h
ERROR_CONTROLLER, ERROR_BUS_OFF, ERROR_COUNTERS = 0x004, 0x040, 0x200
CONTROLLER_PASSIVE, CONTROLLER_ACTIVE = 0x20, 0x40


class Frame:
    """What a socket or a log gave: id with its flags, data, and the time in seconds."""

    __slots__ = ("id", "data", "time_s")

    def __init__(self, id, data, time_s=0.0):
        self.id, self.data, self.time_s = id, data, time_s

    def __repr__(self):
        return f"{self.id:X}#{self.data.hex().upper()}"

    def __eq__(self, other):
        return (self.id, self.data) == (other.id, other.data)


class Node:
    def __init__(self, interface, errors=0):
        self._socket = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
        self._socket.setsockopt(socket.SOL_CAN_RAW, RAW_ERROR_FILTER, errors)
        self._socket.bind((interface,))

    def send(self, id, data):
        self._socket.send(FRAME.pack(id, len(data), data))

    def offer(self, id, data):
        """Sends if the queue of the interface has room; whether it had."""
        try:
            self.send(id, data)
        except OSError as error:
            if error.errno != errno.ENOBUFS:
                raise
            return False
        return True

    def send_error(self, kind, controller=0, transmit_errors=0, receive_errors=0):
        data = bytes([0, controller, 0, 0, 0, 0, transmit_errors, receive_errors])
        self.send(ERROR | kind, data)

    def receive(self, seconds):
        """The next frame of the others, or None; None too where the interface goes down."""
        self._socket.settimeout(max(seconds, 0.001))
        try:
            id, length, data = FRAME.unpack(self._socket.recv(FRAME.size))
        except TimeoutError:
            return None
        except OSError as error:
            if error.errno != errno.ENETDOWN:
                raise
            return None
        return Frame(id, data[:length], time.monotonic())

    def close(self):
        self._socket.close()


def read_log(path):
    """The frames of a `candump -L` log."""
    frames = []
    whole, _, _ = pathlib.Path(path).read_text(encoding="ascii").rpartition("\n")
    for line in whole.splitlines():
        stamp, _, frame = line.split()[:3]
        id, data = frame.split("#", 1)
        remote = data.startswith("R")
        flags = (EXTENDED if len(id) == 8 and not int(id, 16) & ERROR else 0) | (REMOTE if remote else 0)
        frames.append(Frame(int(id, 16) | flags, b"" if remote else bytes.fromhex(data), float(stamp[1:-1])))
    return frames
