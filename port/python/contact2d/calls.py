"""Calls of the C interface with Python's own arguments: what header.FUNCTIONS says of each decides how they are passed."""

import ctypes
import inspect
import keyword
from collections.abc import Mapping
from types import SimpleNamespace

from . import arrays, header
from .errors import offer
from .library import lib

COUNTS = ("cases", "zones")  # of the list before them


def text(where, value):
    """Text as bytes that end at their first zero byte, which is the one that C adds."""
    value = value.encode("utf-8") if isinstance(value, str) else value
    if not isinstance(value, bytes):
        raise TypeError("%s is %r, expected text" % (where, value))
    if b"\0" in value:
        raise ValueError("%s has a character that is zero" % where)
    return value


def member(where, kind, value):
    """What a member of a struct is set to."""
    if issubclass(kind, header.Struct):
        if isinstance(value, Mapping):
            return fill(kind(), value)
        if not isinstance(value, kind):
            raise TypeError("%s is %r, expected a mapping or a %s" % (where, value, kind.__name__))
        return value
    if issubclass(kind, ctypes.Array):
        if kind._type_ is ctypes.c_char:
            value = text(where, value)
        elif not arrays.is_list(value):
            raise TypeError("%s is %r, expected %d numbers" % (where, value, kind._length_))
        else:
            value = list(value)
        if kind._type_ is ctypes.c_char and len(value) >= kind._length_:
            raise ValueError("%s has %d bytes, expected at most %d" % (where, len(value), kind._length_ - 1))
        if kind._type_ is ctypes.c_char:
            return value
        if len(value) != kind._length_:
            raise TypeError("%s has %d numbers, expected %d" % (where, len(value), kind._length_))
        return kind(*[member(where, kind._type_, each) for each in value])
    if kind is ctypes.c_double:
        return arrays.real(where, value)
    if issubclass(kind, ctypes._SimpleCData) and kind not in (ctypes.c_void_p, ctypes.c_char_p):
        return arrays.integer(where, value, kind)
    raise TypeError("%s cannot be set" % where)  # a pointer


def fill(struct, members):
    """Sets members of a struct from a mapping: lists for arrays, text for characters, mappings for structs in it."""
    kinds = dict(struct._fields_)
    for name, value in members.items():
        if name not in kinds:
            raise TypeError("%s has no member %r%s" % (type(struct).__name__, name, offer(name, kinds)))
        setattr(struct, name, member("%s.%s" % (type(struct).__name__, name), kinds[name], value))
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


def inputs_of(function):
    """(name, may it be left out?, are its members arguments, too?) of what is given to a call, the solver excepted."""
    for name, kind, is_const, length in header.FUNCTIONS[function][1][1:]:
        if kind is ctypes.c_char_p or not hasattr(kind, "contents"):
            if name not in COUNTS:
                yield name, False, False
        elif is_const:
            is_struct = issubclass(kind._type_, header.Struct)
            yield name, is_struct or length is not None, is_struct


def signature_of(function):
    """The signature of a method that makes this call."""
    kinds = inspect.Parameter
    given, has_members = list(inputs_of(function)), False
    if any(keyword.iskeyword(name) for name, _, _ in given):
        return inspect.Signature([kinds("self", kinds.POSITIONAL_OR_KEYWORD), kinds("given", kinds.VAR_POSITIONAL),
                                  kinds("named", kinds.VAR_KEYWORD)])
    out, is_last = [], True  # from the end: with a default if all that follow have one
    for name, is_optional, is_struct in reversed(given):
        is_last, has_members = is_last and is_optional, has_members or is_struct
        out.insert(0, kinds(name, kinds.POSITIONAL_OR_KEYWORD, default=None if is_last else kinds.empty))
    out.insert(0, kinds("self", kinds.POSITIONAL_OR_KEYWORD))
    return inspect.Signature(out + ([kinds("members", kinds.VAR_KEYWORD)] if has_members else []))


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
            elif kind is ctypes.c_char_p or not hasattr(kind, "contents"):
                self.scalar(name, kind)
            elif is_const:
                self.input(name, kind._type_, length)
            else:
                self.output(kind._type_, length)
        if self.given or self.named:
            unknown = [repr(value) for value in self.given] + sorted(self.named)
            raise TypeError("%s: not expected: %s" % (self.function, ", ".join(unknown)))
        return self

    def where(self, name):
        return "%s: '%s'" % (self.function, name)

    def scalar(self, name, kind):
        value = self.take(name)
        if kind is ctypes.c_char_p:
            value = None if value is None else text(self.where(name), value)
        elif kind is ctypes.c_double:
            value = arrays.real(self.where(name), value)
        else:
            value = arrays.integer(self.where(name), value, kind)
        self.values.append(value)

    def input(self, name, kind, length):
        if issubclass(kind, header.Struct):
            self.struct(name, kind)
            return
        value = self.take(name) if self.given or name in self.named or length is None else None
        if value is None and length is not None:
            self.values.append(None)
            return
        if kind is ctypes.c_int32:
            if not arrays.is_list(value):
                raise TypeError("%s is %r, expected a list of whole numbers" % (self.where(name), value))
            numbers = [arrays.integer(self.where(name), number) for number in value]
            pointer, self.length = (ctypes.c_int32 * len(numbers))(*numbers), len(numbers)
        else:
            pointer, self.length, kept = arrays.doubles(self.where(name), value)
            self.kept.append(kept)
        if length is not None and self.length != length:
            raise TypeError("%s has %d numbers, expected %d" % (self.where(name), self.length, length))
        self.values.append(pointer)

    def struct(self, name, kind):
        """A struct, a mapping, or members by their names among the arguments."""
        value = self.given.pop(0) if self.given else self.named.pop(name, None)
        if value is None:
            mine = {member: self.named.pop(member) for member, *_ in kind._fields_ if member in self.named}
            value = fill(kind(), mine)
        else:
            value = member(self.where(name), kind, value)
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
    """A c2d_read_line for lines of bytes, from the first one on. (It is called in a worker's thread: no signal's handler can
    raise in it.)"""
    rest = iter(lines)

    def next_line(_, to, size):
        line = next(rest, None)
        if line is None:
            return -1
        kept = line[: size - 1] + b"\0"
        ctypes.memmove(to, kept, len(kept))
        return len(line)

    return header.c2d_read_line(next_line)


def message(status):
    return lib.c2d_message(status).decode()
