"""A tester: UDS over ISO-TP of the kernel, with the code that proves a command from OpenSSL."""

import socket
import struct
import subprocess

from bench.raw_can import EXTENDED

READ, ROUTINE, TESTER_PRESENT, NEGATIVE, POSITIVE = 0x22, 0x31, 0x3E, 0x7F, 0x40
LIFE, STORAGE_COUNTER, NONCE, AUTHORITY, LOG = 0x0200, 0x0240, 0x0241, 0x0242, 0x1000
OPEN_EPOCH, LOAD_PARAMETERS = 0x0201, 0x0202
CONDITIONS, SEQUENCE, INVALID_KEY, EXCEEDED, DELAY = 0x22, 0x24, 0x35, 0x36, 0x37


def cmac(key, message):
    """AES-CMAC of RFC 4493."""
    done = subprocess.run(
        ["openssl", "mac", "-cipher", "AES-128-CBC", "-macopt", f"hexkey:{key.hex()}", "-in", "-", "CMAC"],
        input=message, capture_output=True, check=True)
    return bytes.fromhex(done.stdout.decode().strip())


class Tester:
    def __init__(self, interface, node):
        self._node = node
        to_node, to_tester = 0x18DA00F1 | node << 8, 0x18DAF100 | node
        self._socket = socket.socket(socket.AF_CAN, socket.SOCK_DGRAM, socket.CAN_ISOTP)
        self._socket.bind((interface, to_tester | EXTENDED, to_node | EXTENDED))
        self._socket.settimeout(10)

    def ask(self, request):
        self._socket.send(request)
        return self._socket.recv(4095)

    def read(self, identifier):
        """The data behind an identifier, or the negative response code."""
        answer = self.ask(struct.pack(">BH", READ, identifier))
        if answer[:2] == bytes([NEGATIVE, READ]):
            return answer[2]
        assert answer[:3] == struct.pack(">BH", READ + POSITIVE, identifier), answer.hex()
        return answer[3:]

    def storage_counter(self):
        return int.from_bytes(self.read(STORAGE_COUNTER), "little")

    def command(self, routine, arguments, key, nonce, counter, node=None):
        """The request of an authenticated routine."""
        head = b"TLA1" + struct.pack(">BHB", node or self._node, routine, len(arguments))
        stored = counter.to_bytes(4, "little")
        code = cmac(key, head + nonce + stored + arguments)[:8]
        return struct.pack(">BBH", ROUTINE, 1, routine) + arguments + stored + code

    def start(self, request):
        """None where the routine was started, else the negative response code."""
        answer = self.ask(request)
        if answer[:2] == bytes([NEGATIVE, ROUTINE]):
            return answer[2]
        assert answer == bytes([ROUTINE + POSITIVE]) + request[1:4], answer.hex()
        return None

    def life(self, tendon=0):
        return Life(self.read(LIFE + tendon))

    def log(self):
        """The events of the authority's log, oldest first."""
        events = []
        while isinstance(line := self.read(LOG + len(events)), bytes):
            events.append(line[8])
        return events

    def close(self):
        self._socket.close()


class Life:
    """A life record as it is read: little-endian."""

    def __init__(self, data):
        assert len(data) == 61, data.hex()
        (self.sequence, self.tendon, self.flags, self.epoch, self.damage_ppb,
         self.lifetime_ppb) = struct.unpack_from("<IBBHII", data)
        self.exact, self.lifetime_exact = data[16:32], data[32:48]
        self.cycles, self.configuration, self.past_lost = struct.unpack_from("<QIB", data, 48)
