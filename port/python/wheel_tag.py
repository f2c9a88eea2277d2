"""The platform that a wheel is for, by what its files ask of the system that loads them.

manylinux_X_Y (PEP 600) promises any Linux with glibc X.Y or newer: every file may need libraries of glibc alone, in versions of
symbols up to X.Y, and instructions of the processor's base. Otherwise the wheel is for Linux as on this machine.
"""

import pathlib
import re
import struct
import sysconfig

GLIBC = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1",
         "ld-linux.so.2", "ld-linux-armhf.so.3", "ld64.so.2"}
OLDEST = (2, 17)  # what installers still know
PT_LOAD, PT_DYNAMIC = 1, 2
DT_NEEDED, DT_STRTAB, DT_VERNEED, DT_VERNEEDNUM = 1, 5, 0x6FFFFFFE, 0x6FFFFFFF


class Elf:
    """Of a file in ELF: `needed`, its libraries, and `versions`, a set of (library, version of a symbol)."""

    def __init__(self, data):
        if data[:4] != b"\x7fELF":
            raise ValueError("no file in ELF")
        self.data, self.is_64, self.order = data, data[4] == 2, "<" if data[5] == 1 else ">"
        at, size, count = self.header()
        self.segments = [self.segment(at + i * size) for i in range(count)]
        dynamic = next((s for s in self.segments if s[0] == PT_DYNAMIC), None)
        self.needed, self.versions = set(), set()
        if dynamic is not None:
            self.read(self.entries(dynamic[1]))

    def take(self, form, at):
        return struct.unpack_from(self.order + form, self.data, at)

    def header(self):
        """(offset, size, number) of the program headers."""
        if self.is_64:
            return self.take("Q", 32)[0], *self.take("HH", 54)
        return self.take("I", 28)[0], *self.take("HH", 42)

    def segment(self, at):
        """(type, offset, address, size in the file)"""
        if self.is_64:
            kind, _, offset, address, _, size = self.take("IIQQQQ", at)
        else:
            kind, offset, address, _, size = self.take("IIIII", at)
        return kind, offset, address, size

    def entries(self, at):
        out, form, size = [], "QQ" if self.is_64 else "II", 16 if self.is_64 else 8
        while True:
            tag, value = self.take(form, at)
            if tag == 0:
                return out
            out.append((tag, value))
            at += size

    def place(self, address):
        """In the file, of an address in memory."""
        for kind, offset, begin, size in self.segments:
            if kind == PT_LOAD and begin <= address < begin + size:
                return offset + address - begin
        raise ValueError("an address lies in no segment")

    def text(self, at):
        return self.data[at : self.data.index(b"\0", at)].decode()

    def read(self, entries):
        found = dict(entries)
        names = self.place(found[DT_STRTAB])
        self.needed = {self.text(names + value) for tag, value in entries if tag == DT_NEEDED}
        at = self.place(found[DT_VERNEED]) if DT_VERNEED in found else 0
        for _ in range(found.get(DT_VERNEEDNUM, 0)):
            _, count, library, first, following = self.take("HHIII", at)
            version = at + first
            for _ in range(count):
                _, _, _, name, after = self.take("IHHII", version)
                self.versions.add((self.text(names + library), self.text(names + name)))
                version += after
            at += following


def glibc_of(data):
    """(major, minor) of the glibc that a file in ELF asks for; None: it asks for more than glibc."""
    elf, newest = Elf(data), OLDEST
    if not elf.needed <= GLIBC:
        return None
    for _, version in elf.versions:
        number = re.match(r"GLIBC_(\d+)\.(\d+)", version)
        if number is None:  # GLIBC_PRIVATE, GLIBC_ABI_DT_RELR and their like
            return None
        newest = max(newest, (int(number.group(1)), int(number.group(2))))
    return newest


def platform_tag(paths, flags=""):
    """Of a wheel with these files in it, compiled with these flags."""
    own = re.sub(r"[-.]", "_", sysconfig.get_platform())
    if not own.startswith("linux_") or re.search(r"-m(arch|cpu|tune)=|-mavx|-msse", flags):
        return own
    try:
        found = [glibc_of(pathlib.Path(path).read_bytes()) for path in paths]
    except (ValueError, struct.error):
        return own
    if None in found:
        return own
    return own.replace("linux_", "manylinux_%d_%d_" % max(found), 1)
