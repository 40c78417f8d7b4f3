"""What the checks need of an ELF file of a 32-bit little-endian machine."""

import pathlib
import struct


class Elf:
    def __init__(self, path):
        self.data = pathlib.Path(path).read_bytes()
        if self.data[:6] != b"\x7fELF\x01\x01":
            raise SystemExit(f"{path}: not a 32-bit little-endian ELF file")
        (self.entry, phoff, shoff, _, _, phsize, phnum, shsize, shnum, names) = struct.unpack_from(
            "<IIIIHHHHHH", self.data, 24)
        self.segments = [struct.unpack_from("<IIIIIIII", self.data, phoff + i * phsize)
                         for i in range(phnum)]
        raw = [struct.unpack_from("<IIIIIIIIII", self.data, shoff + i * shsize)
               for i in range(shnum)]
        self.sections = {self._name(raw[names], s[0]): s for s in raw}
        self.raw_sections = raw
        self.symbols = {}
        self.symbol_table = []
        table = self.sections[".symtab"]
        for offset in range(table[4], table[4] + table[5], 16):
            name, value, size, info, _, section = struct.unpack_from("<IIIBBH", self.data, offset)
            text = self._name(raw[table[6]], name)
            self.symbol_table.append((text, value, size, info & 15, section))
            if section != 0:
                self.symbols[text] = value

    def _name(self, strings, offset):
        start = strings[4] + offset
        return self.data[start:self.data.index(b"\0", start)].decode()

    def loads(self):
        """(physical address, bytes) of what is loaded."""
        for kind, offset, _, physical, size, *_ in self.segments:
            if kind == 1 and size:
                yield physical, self.data[offset:offset + size]

    def relocations(self, section):
        """(address, symbol name, symbol address) of what a section refers to."""
        table = self.sections.get(f".rel{section}")
        if table is None:
            raise SystemExit(f"no relocations for {section}: link with --emit-relocs")
        for offset in range(table[4], table[4] + table[5], 8):
            address, info = struct.unpack_from("<II", self.data, offset)
            name, value, _, kind, index = self.symbol_table[info >> 8]
            if kind == 3:  # a section: its name is that of the section
                name = self._name(self.raw_sections[self._strings_index()],
                                  self.raw_sections[index][0])
            yield address, name, value

    def _strings_index(self):
        return struct.unpack_from("<H", self.data, 50)[0]

    def word(self, address):
        """The word that is loaded at an address where the program runs."""
        for section in self.raw_sections:
            if section[1] == 1 and section[2] & 2 and section[3] <= address < section[3] + section[5]:
                return struct.unpack_from("<I", self.data, section[4] + address - section[3])[0]
        raise SystemExit(f"nothing is loaded at {address:#x}")
