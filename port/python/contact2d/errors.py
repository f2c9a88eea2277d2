"""What went wrong, as exceptions that know the line and the column of the deck, sketch or script it is about."""

from . import header

SEVERITIES = {header.C2D_NOTE: "note", header.C2D_WARNING: "warning", header.C2D_FAULT: "error"}


class Message:
    """A fault, a warning or a note: `severity` ("error", "warning", "note"), `text`, and, 0 where it is about none, `line`,
    `column`, `body`, `zone`, `pair`, `element`, `node`; `load`: the load factor at which it happened; `status`: its number."""

    def __init__(self, severity, text, line=0, column=0, column_end=0, status=0, body=0, zone=0, pair=0, element=0, node=0,
                 load=0.0, name=None):
        self.severity, self.text, self.name = severity, text, name
        self.line, self.column, self.column_end, self.status = line, column, column_end, status
        self.body, self.zone, self.pair, self.element, self.node, self.load = body, zone, pair, element, node, load

    @classmethod
    def of(cls, entry):
        """From a c2d_error."""
        return cls(SEVERITIES.get(entry.severity, "error"), entry.text.decode("utf-8", "replace"), entry.line, entry.column,
                   entry.column_end, entry.status, entry.body, entry.zone, entry.pair, entry.element, entry.node, entry.load)

    def __str__(self):
        place = ":".join(str(part) for part in (self.name, self.line, self.column) if part)
        return "%s: %s" % (place, self.text) if place else self.text

    def __repr__(self):
        return "<%s %s>" % (self.severity, self)


class Error(Exception):
    """A call failed. `messages`: every fault that was found; `text`, `line`, `column`: those of the first (0: none is known);
    `status`: the c2d_status of a call, or the exit status of the program."""

    def __init__(self, messages, status=0):
        self.messages, self.status = list(messages), status
        first = self.messages[0]
        self.text, self.line, self.column = first.text, first.line, first.column
        super().__init__("\n".join(str(message) for message in self.messages))

    def __reduce__(self):
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


def kind_of(status):
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
