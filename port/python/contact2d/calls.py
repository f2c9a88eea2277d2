"""Calls of the C interface with Python's own arguments: what header.FUNCTIONS says of each decides how they are passed."""

import ctypes
from collections.abc import Mapping
from types import SimpleNamespace

from . import arrays, header
from .library import lib

COUNTS = ("cases", "zones")  # of the list before them


def fill(struct, members):
    """Sets members of a struct from a mapping: lists for arrays, text for characters, mappings for structs in it."""
    kinds = dict(struct._fields_)
    for name, value in members.items():
        if name not in kinds:
            raise TypeError("%s has no member %r; it has %s" % (type(struct).__name__, name, ", ".join(kinds)))
        kind = kinds[name]
        if isinstance(value, str):
            value = value.encode("utf-8")
        if issubclass(kind, header.Struct) and isinstance(value, Mapping):
            value = fill(kind(), value)
        elif issubclass(kind, ctypes.Array) and not isinstance(value, bytes):
            value = kind(*value)
        setattr(struct, name, value)
    return struct


def plain(value):
    """A struct, or an array of C, as Python's own objects: attributes, lists, text."""
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    if isinstance(value, ctypes.Array):
        return [plain(each) for each in value]
    if isinstance(value, header.Struct):
        return SimpleNamespace(**{name: plain(getattr(value, name)) for name, *_ in value._fields_
                                  if name != "struct_size" and not name.startswith("reserved")})
    return value


class Arguments:
    """The arguments of one call, taken from what was given by place and by name."""

    def __init__(self, function, given, named):
        self.function, self.given, self.named = function, list(given), dict(named)
        self.values, self.kept, self.outputs = [], [], []
        self.length = 0  # of the last list
        _, self.expected, _ = header.FUNCTIONS[function]

    def take(self, name):
        if self.given:
            return self.given.pop(0)
        if name in self.named:
            return self.named.pop(name)
        raise TypeError("%s: '%s' is missing" % (self.function, name))

    def bind(self):
        for name, kind, is_const, length in self.expected[1:]:
            if name in COUNTS:
                self.values.append(self.length)
            elif kind in (ctypes.c_void_p, ctypes.c_char_p) or not hasattr(kind, "contents"):
                self.scalar(name, kind)
            elif is_const:
                self.input(name, kind._type_, length)
            else:
                self.output(kind._type_, length)
        if self.given or self.named:
            unknown = [repr(value) for value in self.given] + sorted(self.named)
            raise TypeError("%s: not expected: %s" % (self.function, ", ".join(unknown)))
        return self

    def scalar(self, name, kind):
        value = self.take(name)
        self.values.append(value.encode("utf-8") if isinstance(value, str) else value)

    def input(self, name, kind, length):
        if issubclass(kind, header.Struct):
            self.struct(name, kind)
            return
        value = self.take(name) if self.given or name in self.named or length is None else None
        if value is None:
            self.values.append(None)
            return
        if kind is ctypes.c_int32:
            numbers = [int(number) for number in value]
            pointer, self.length = (ctypes.c_int32 * len(numbers))(*numbers), len(numbers)
        else:
            pointer, self.length, kept = arrays.doubles(value)
            self.kept.append(kept)
        if length is not None and self.length != length:
            raise TypeError("%s: '%s' has %d numbers, expected %d" % (self.function, name, self.length, length))
        self.values.append(pointer)

    def struct(self, name, kind):
        """A struct, a mapping, or members by their names among the arguments."""
        value = self.given.pop(0) if self.given else self.named.pop(name, None)
        if value is None:
            mine = {member: self.named.pop(member) for member, *_ in kind._fields_ if member in self.named}
            value = fill(kind(), mine)
        elif isinstance(value, Mapping):
            value = fill(kind(), value)
        self.kept.append(value)
        self.values.append(ctypes.byref(value))

    def output(self, kind, length):
        buffer = (kind * length)() if length else kind()
        self.outputs.append(buffer)
        self.values.append(buffer if length else ctypes.byref(buffer))

    def results(self):
        out = [list(each) if isinstance(each, ctypes.Array) else plain(each.value if hasattr(each, "value") else each)
               for each in self.outputs]
        return out[0] if len(out) == 1 else tuple(out) if out else None


def read_line(lines):
    """A c2d_read_line for lines of bytes, from the first one on."""
    rest = iter(lines)

    def next_line(_, text, size):
        line = next(rest, None)
        if line is None:
            return -1
        kept = line[: size - 1] + b"\0"
        ctypes.memmove(text, kept, len(kept))
        return len(line)

    return header.c2d_read_line(next_line)


def message(status):
    return lib.c2d_message(status).decode()
