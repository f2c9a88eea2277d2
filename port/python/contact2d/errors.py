"""What went wrong, as exceptions that know the line and the column of the deck, sketch or script it is about."""

from __future__ import annotations

import difflib
from typing import Any, Iterable, List, Optional, Type

from . import header

SEVERITIES = {header.C2D_NOTE: "note", header.C2D_WARNING: "warning", header.C2D_FAULT: "error"}


def offer(name: object, names: Iterable[str]) -> str:
    """To be appended to the message that there is no such name: the one that is near, or all.

    >>> offer("peak presure", ["peak pressure", "mean pressure"])
    ", did you mean 'peak pressure'?"
    >>> offer("x", ["tn", "tt"])
    '; there are tn, tt'
    """
    names = list(names)
    near = difflib.get_close_matches(str(name).lower(), [each.lower() for each in names], 1, 0.75)
    if near:
        return ", did you mean %r?" % next(each for each in names if each.lower() == near[0])
    return "; there are %s" % ", ".join(names) if names else ""


class Message:
    """A fault, a warning or a note: `severity` ("error", "warning", "note"), `text`, and, 0 where it is about none, `line`,
    `column`, `body`, `zone`, `pair`, `element`, `node`; `load`: the load factor at which it happened; `status`: its number."""

    def __init__(self, severity: str, text: str, line: int = 0, column: int = 0, column_end: int = 0, status: int = 0,
                 body: int = 0, zone: int = 0, pair: int = 0, element: int = 0, node: int = 0, load: float = 0.0,
                 name: Optional[str] = None) -> None:
        self.severity, self.text, self.name = severity, text, name
        self.line, self.column, self.column_end, self.status = line, column, column_end, status
        self.body, self.zone, self.pair, self.element, self.node, self.load = body, zone, pair, element, node, load

    @classmethod
    def of(cls, entry: header.c2d_error) -> Message:
        """From a c2d_error."""
        return cls(SEVERITIES.get(entry.severity, "error"), entry.text.decode("utf-8", "replace"), entry.line, entry.column,
                   entry.column_end, entry.status, entry.body, entry.zone, entry.pair, entry.element, entry.node, entry.load)

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.name, self.line, self.column) if part)
        return "%s: %s" % (place, self.text) if place else self.text

    def __repr__(self) -> str:
        return "<%s %s>" % (self.severity, self)


class Error(Exception):
    """A call failed. `messages`: every fault that was found; `text`, `line`, `column`: those of the first (0: none is known);
    `status`: the c2d_status of a call, or the exit status of the program."""

    def __init__(self, messages: Iterable[Message], status: int = 0) -> None:
        self.messages: List[Message] = list(messages)
        self.status = status
        first = self.messages[0]
        self.text, self.line, self.column = first.text, first.line, first.column
        super().__init__("\n".join(str(message) for message in self.messages))

    def __reduce__(self) -> Any:
        """From one process to another, and copies."""
        return type(self), (self.messages, self.status), self.__dict__


class InputError(Error, ValueError):
    """The deck, the sketch or the model is wrong."""


class UsageError(Error, ValueError):
    """An argument is out of range, or a call is not legal now."""


class SingularError(Error, ArithmeticError):
    """Elimination met a column without a usable pivot."""


class WorkspaceError(Error, MemoryError):
    """The workspace is too small; `bytes_needed` would do."""

    bytes_needed = 0


class StoreError(Error, OSError):
    """The block store or an output file failed; `host_code`: what it said."""

    host_code = 0


class Cancelled(Error):
    """Somebody called cancel(). The solver is valid, at the last load it reached."""


class IncompleteWarning(UserWarning):
    """The load path ended before the requested load; the result contains where and why."""


def kind_of(status: int) -> Type[Error]:
    """The exception for a c2d_status."""
    if status in (header.C2D_ERR_ARGUMENT, header.C2D_ERR_STATE, header.C2D_ERR_BUSY):
        return UsageError
    if status in (header.C2D_ERR_INPUT, header.C2D_ERR_READ, header.C2D_ERR_LIMIT):
        return InputError
    if status in (header.C2D_ERR_MEMORY, header.C2D_ERR_OVERFLOW):
        return WorkspaceError
    if header.C2D_ERR_STORE_OPEN <= status <= header.C2D_ERR_MISMATCH:
        return StoreError
    return {header.C2D_ERR_CANCELLED: Cancelled, header.C2D_ERR_SINGULAR: SingularError}.get(status, Error)
