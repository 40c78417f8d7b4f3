"""The frame plan, written down a second time by hand from its description, to judge the code by."""

import dataclasses

LIFE_STATES = ("unknown", "normal", "inspect", "replace", "worn")
HEARTBEAT, STATUS, DETAIL, EMERGENCY, COMMAND = 0x700, 0x180, 0x280, 0x080, 0x200

EMERGENCY_STOP, OVERLOAD, BUS_OFF, DEADLINE, AUTHORITY = 0xFF01, 0xFF20, 0xFF60, 0xFF70, 0xFF80
ALL_OVER = 0x0000


def crc8h2f(data):
    """CRC-8H2F of AUTOSAR: polynomial 0x2f, start 0xff, final exclusive or 0xff."""
    crc = 0xFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc << 1 ^ 0x2F) & 0xFF if crc & 0x80 else crc << 1
    return crc ^ 0xFF


CRC_BYTE = {STATUS: 0, DETAIL: 0, EMERGENCY: 3, COMMAND: 0}
ID_LIST = {STATUS: 0, DETAIL: 1, EMERGENCY: 2, COMMAND: 3}


def crc_of(kind, node, data):
    """The CRC that a frame of this kind and node ought to have: Profile 22."""
    at = CRC_BYTE[kind]
    number = 128 * ID_LIST[kind] + node
    counter = data[at + 1] & 15
    shift = 1 if ID_LIST[kind] < 2 else 2
    data_id = number % 256 ^ (counter ^ counter << 1) << shift
    return crc8h2f(data[:at] + data[at + 1:] + bytes([data_id]))


def protect(kind, node, counter, data):
    """`data` with its counter and CRC in place."""
    at = CRC_BYTE[kind]
    data = bytearray(data)
    data[at + 1] = data[at + 1] & 0xF0 | counter & 15
    data[at] = crc_of(kind, node, bytes(data))
    return bytes(data)


class Check:
    """What a receiver has to find in the frames of one kind of one node (Profile 22)."""

    MAX_DELTA = 3

    def __init__(self, kind, node):
        self._kind, self._node, self._last = kind, node, None

    def verdict(self, frame):
        if frame.id != self._kind + self._node:
            return "other_frame"
        if len(frame.data) != 8:
            return "wrong_length"
        at = CRC_BYTE[self._kind]
        if frame.data[at] != crc_of(self._kind, self._node, frame.data):
            return "wrong_crc"
        counter = frame.data[at + 1] & 15
        last, self._last = self._last, counter
        if last is None:
            return "initial"
        delta = (counter - last) % 16
        if delta == 0:
            return "repeated"
        if delta > self.MAX_DELTA:
            return "wrong_sequence"
        return "ok" if delta == 1 else "ok_some_lost"


USABLE = ("initial", "ok", "ok_some_lost")


@dataclasses.dataclass(frozen=True)
class Status:
    counter: int
    state: str
    damage_ppb: int
    worst_tendon: int
    quality: int
    flags: int

    @classmethod
    def of(cls, frame):
        d = frame.data
        return cls(d[1] & 15, LIFE_STATES[d[1] >> 4], int.from_bytes(d[2:6], "little"), d[6] & 31, d[6] >> 5, d[7])

    def encoded(self, node):
        head = bytes([0, LIFE_STATES.index(self.state) << 4])
        tail = bytes([self.worst_tendon | self.quality << 5, self.flags])
        data = head + self.damage_ppb.to_bytes(4, "little") + tail
        return protect(STATUS, node, self.counter, data)

    @property
    def storage_ok(self):
        return bool(self.flags & 1)

    @property
    def sensor_ok(self):
        return bool(self.flags & 2)

    @property
    def overrun(self):
        return bool(self.flags & 16)

    @property
    def locked(self):
        return bool(self.flags & 32)

    @property
    def life(self):
        """All that a display shows of it."""
        return (LIFE_STATES.index(self.state), self.damage_ppb, self.worst_tendon, self.quality, self.flags)


@dataclasses.dataclass(frozen=True)
class Emergency:
    code: int
    error_register: int
    damage_ppm: int

    @classmethod
    def of(cls, frame):
        d = frame.data
        return cls(int.from_bytes(d[0:2], "little"), d[2], int.from_bytes(d[5:8], "little"))


def page(frame):
    return frame.data[1] >> 4


def field(frame, first, last, signed=False):
    """Bytes `first` to `last` of a frame as one number."""
    return int.from_bytes(frame.data[first:last + 1], "little", signed=signed)
