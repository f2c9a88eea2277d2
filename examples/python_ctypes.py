"""Solves a deck from Python with ctypes, the standard library alone.

    python3 examples/python_ctypes.py build/libcontact2d.so.0.2.0 examples/hertz.dat

The structs below are those of contact2d.h. A host may know fewer members than the library has: struct_size tells the
library how many, so a struct here may end early.
"""

import ctypes
import sys
from ctypes import CFUNCTYPE, POINTER, byref, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32
from ctypes import c_uint64, c_void_p

TN = 3  # C2D_TN, the column of the pressure


class Sized(ctypes.Structure):
    """A struct that knows its size, as C2D_INIT makes it."""

    def __init__(self):
        super().__init__(struct_size=ctypes.sizeof(self))


class BodyLimits(ctypes.Structure):
    _fields_ = [("points", c_int32), ("elements", c_int32), ("regions", c_int32), ("reserved", c_int32)]


class Limits(Sized):
    _fields_ = [("struct_size", c_uint32), ("bodies", c_int32), ("body", POINTER(BodyLimits)),
                ("sizes", c_int32 * 28)]  # more than it has today

    def __init__(self):
        super().__init__()
        self.bodies, self.body = 2, (BodyLimits * 2)()  # so many have room


class Error(Sized):
    _fields_ = [
        ("struct_size", c_uint32), ("status", c_int32), ("severity", c_int32), ("host_code", c_int32),
        ("line", c_int32), ("column", c_int32), ("column_end", c_int32), ("body", c_int32), ("zone", c_int32),
        ("pair", c_int32), ("element", c_int32), ("node", c_int32), ("tape", c_int32), ("block", c_int64),
        ("bytes_needed", c_uint64), ("load", c_double), ("text", c_char * 320),
    ]


class Step(Sized):
    _fields_ = [
        ("struct_size", c_uint32), ("kind", c_int32), ("coefficient", c_int32), ("step", c_int32), ("pairs", c_int32),
        ("changes", c_int32), ("iterations", c_int32), ("outcome", c_int32), ("stride", c_int64), ("mu", c_double),
        ("load", c_double), ("table", POINTER(c_double)),
    ]


Open = CFUNCTYPE(c_int32, c_void_p, c_int32, c_uint64, c_uint64)
Transfer = CFUNCTYPE(c_int32, c_void_p, c_int32, c_uint64, c_void_p, c_uint64)
Tape = CFUNCTYPE(c_int32, c_void_p, c_int32)
ReadLine = CFUNCTYPE(c_int32, c_void_p, c_void_p, c_int32)
ShowStep = CFUNCTYPE(c_int32, c_void_p, POINTER(Step))


class Port(Sized):
    _fields_ = [("struct_size", c_uint32), ("context", c_void_p), ("open", Open), ("read", Transfer),
                ("write", Transfer), ("sync", Tape), ("close", Tape)]


class Blocks:
    """A block store in a dictionary. A function that fails returns a number other than 0."""

    def __init__(self):
        self.blocks = {}

    def open(self, _, tape, blocks, block_bytes):
        return 0

    def read(self, _, tape, block, data, size):
        kept = self.blocks.get((tape, block), b"")
        if len(kept) < size:
            return 1
        ctypes.memmove(data, kept, size)
        return 0

    def write(self, _, tape, block, data, size):
        self.blocks[tape, block] = ctypes.string_at(data, size)
        return 0

    def nothing(self, _, tape):
        return 0

    def port(self):
        port = Port()
        port.open, port.read, port.write = Open(self.open), Transfer(self.read), Transfer(self.write)
        port.sync = port.close = Tape(self.nothing)
        return port


def cards(name):
    """read_line for the lines of a file."""
    lines = iter(open(name, "rb").read().splitlines())

    def next_card(_, text, size):
        card = next(lines, None)
        if card is None:
            return -1
        kept = card[: size - 1] + b"\0"
        ctypes.memmove(text, kept, len(kept))
        return len(card)

    return ReadLine(next_card)


def show_step(_, step):
    now = step.contents
    peak = max(now.table[pair * now.stride + TN] for pair in range(now.pairs))
    print(f"mu {now.mu:.4f}  step {now.step}  load {now.load:.5f}  peak pressure {peak:.10f}")
    return 0


def load_library(name):
    library = ctypes.CDLL(name)
    library.c2d_message.restype = c_char_p
    library.c2d_create.argtypes = [POINTER(c_void_p), c_void_p, c_size_t, POINTER(Limits), POINTER(Port),
                                   POINTER(Error)]
    for name in ("c2d_prepare", "c2d_close"):
        getattr(library, name).argtypes = [c_void_p]
    library.c2d_read_deck.argtypes = [c_void_p, ReadLine, c_void_p]
    library.c2d_run.argtypes = [c_void_p, ShowStep, c_void_p]
    return library


def main(library_name, deck):
    library = load_library(library_name)
    limits, why = Limits(), Error()

    def check(status):
        if status != 0:
            sys.exit(f"{library.c2d_message(status).decode()}: {why.text.decode()}")

    check(library.c2d_scan_deck(cards(deck), None, byref(limits), byref(why)))
    minimum, in_core = c_uint64(), c_uint64()
    check(library.c2d_memory_need(byref(limits), byref(minimum), byref(in_core), byref(why)))
    memory = ctypes.create_string_buffer(in_core.value)
    port = Blocks().port()  # kept until the solver is closed
    solver = c_void_p()
    check(library.c2d_create(byref(solver), memory, len(memory), byref(limits), byref(port), byref(why)))
    check(library.c2d_read_deck(solver, cards(deck), None))
    check(library.c2d_prepare(solver))
    check(library.c2d_run(solver, ShowStep(show_step), None))
    check(library.c2d_close(solver))


if __name__ == "__main__":
    main(*sys.argv[1:3])
