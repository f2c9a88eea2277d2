"""Decks and sketches solved by the program: tables, pictures and messages of a run.

A run is a process of its own, so that nothing of it can harm the one that asked, any number of them go on at once in threads,
and Ctrl-C ends one in order. The outputs are the program's files (src/report/OUTPUT.md), with the program's digits.
"""

from __future__ import annotations

import csv
import html
import io
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import warnings
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from . import arrays, library
from .errors import (Cancelled, Error, IncompleteWarning, InputError, Message, StoreError, UsageError, WorkspaceError,
                     offer)
from .pictures import Picture, Pictures, is_as_written
from .tables import Table

Source = Union[str, "os.PathLike[str]"]  # the name of a file, or text of more than one line
Progress = Union[bool, None, Callable[[str], Any]]

TABLES = {"contact": "csv", "boundary": "boundary", "interior": "interior", "summary": "summary", "bodies": "bodies",
          "trace": "trace", "stresses": "stresses", "ranges": "ranges"}
FAILURES = {2: InputError, 3: StoreError, 4: WorkspaceError, 64: UsageError, 75: StoreError, 130: Cancelled, 143: Cancelled}
MESSAGE = re.compile(r"^contact2d: (?:(?P<name>.*?)(?::(?P<line>\d+)(?::(?P<column>\d+))?)?: )?"
                     r"(?P<severity>error|warning|note): (?P<text>.*)$")
INTERVAL = 0.2  # seconds between looks at the line of progress
PATIENCE = 10  # seconds for a run that was interrupted to end in order


def messages_of(text: str) -> List[Message]:
    """The messages on the program's standard error; cards that it quotes, and marks below them, are left out."""
    out = []
    for line in text.splitlines():
        match = MESSAGE.match(line)
        if match:
            out.append(Message(match["severity"], match["text"], int(match["line"] or 0), int(match["column"] or 0),
                               name=match["name"]))
    return out


def end(process: subprocess.Popen[bytes]) -> None:
    """Ends a run in order: a signal that it answers to, and the end if it does not, or if something is raised here."""
    try:
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        pass
    finally:
        if process.returncode is None:
            process.kill()
            process.communicate()


def read_from(file: Any, at: int) -> bytes:
    """The rest of a file that a process still writes; where it writes next does not move."""
    return os.pread(file.fileno(), os.fstat(file.fileno()).st_size - at, at)


class Line:
    """The program's line of progress, read from the file that is its standard error, and shown."""

    def __init__(self, progress: Progress, file: Any) -> None:
        self.show = progress if callable(progress) else self.print
        self.file, self.at, self.is_printed = file, 0, False

    def update(self) -> None:
        new = read_from(self.file, self.at)
        self.at += len(new)
        lines = re.findall(r"\r\033\[Kcontact2d: ([^\r\n]+)(?=\r|\Z)", new.decode("utf-8", "replace"))  # a message ends its line
        if lines:
            self.show(lines[-1])

    def print(self, line: str) -> None:
        sys.stderr.write("\r\033[K" + line)
        sys.stderr.flush()
        self.is_printed = True

    def clear(self) -> None:
        if self.is_printed:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()


def communicate(process: subprocess.Popen[bytes], given: Optional[bytes], line: Optional[Line]) -> bytes:
    """What the process writes to its standard output; meanwhile its line of progress is shown."""
    if line is None:
        return process.communicate(given)[0]
    while True:
        try:
            out = process.communicate(given, timeout=INTERVAL)[0]
            line.update()
            return out
        except subprocess.TimeoutExpired:
            given = None  # it is being written
            line.update()


def run_program(*words: Any, text: Optional[str] = None, legal: Sequence[int] = (0,),
                progress: Progress = False) -> Tuple[str, str, int]:
    """(standard output, standard error, exit status) of `contact2d WORDS`; exit statuses that are not `legal` are
    exceptions. `text`: what it reads from its standard input; `progress`: as in solve(), for commands with such an option.

    >>> run_program("--version")[0]
    'contact2d 0.2.0\\n'
    """
    shown = sys.stderr.isatty() if progress is None else bool(progress)
    arguments = [library.program()] + [os.fspath(word) for word in words]
    if shown:
        arguments.insert(2, "--progress")
    with tempfile.TemporaryFile() as messages:
        line = Line(progress, messages) if shown else None
        process = subprocess.Popen(arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=messages)
        try:
            output = communicate(process, None if text is None else text.encode("utf-8"), line)
        except BaseException:
            end(process)
            raise
        finally:
            if line is not None:
                line.clear()
        stderr = re.sub(r"\r\033\[K(contact2d: [^\r\n]*(?=\r))?", "", read_from(messages, 0).decode("utf-8", "replace"))
    out = output.decode("utf-8", "replace")
    if process.returncode in legal:
        return out, stderr, process.returncode
    faults = [message for message in messages_of(stderr) if message.severity == "error"]
    if not faults:
        said = " / ".join(line.replace("contact2d: ", "", 1) for line in stderr.splitlines()[:1])
        faults = [Message("error", said or "the program ended with status %d" % process.returncode)]
    raise FAILURES.get(process.returncode, Error)(faults, process.returncode)


def named(source: Source) -> Tuple[str, Optional[str]]:
    """(word for the command line, standard input) of a file's name, or of the text of a deck or sketch itself. Words stand
    behind `--`, where a dash begins a name; `-` alone is a file of that name, too."""
    if isinstance(source, str) and "\n" in source:
        return "-", source
    name = os.fsdecode(source)
    return os.path.join(os.curdir, name) if name == "-" else name, None


def settings(parameters: Mapping[str, Any]) -> List[str]:
    """Words NAME=VALUE."""
    for name, value in parameters.items():
        if not isinstance(name, str) or "=" in name:
            raise ValueError("%r is no name of a parameter" % (name,))
        if not isinstance(value, str):
            arrays.real("parameter '%s'" % name, value)
    return ["%s=%s" % (name, repr(float(value)) if isinstance(value, float) else value)
            for name, value in parameters.items()]


def option_words(options: Optional[Mapping[str, Any]]) -> List[str]:
    """Words --NAME=VALUE."""
    return ["--" + name.replace("_", "-") + ("" if value is True else "=%s" % value) for name, value in (options or {}).items()]


def room() -> tempfile.TemporaryDirectory[str]:
    """A folder for the outputs: in memory if there is such a place with room, since they are read at once."""
    shared = "/dev/shm"
    if os.access(shared, os.W_OK) and shutil.disk_usage(shared).free > 1 << 28:
        return tempfile.TemporaryDirectory(prefix="contact2d-", dir=shared)
    return tempfile.TemporaryDirectory(prefix="contact2d-")


class Result:
    """What a run gave.

    Tables by name, result["contact"] (OUTPUT.md describes their columns): "contact", "boundary", "summary", "bodies",
    "trace", "interior" if points were asked for, and, if they were, "stresses" and "ranges". `summary`: the program's JSON;
    `listing`, `report` (a page of HTML): texts; `pictures`: by name; `tolerances`: a table; `warnings`, `notes`: messages;
    `complete`, `outcome`, `why`: did the path reach its end?
    """

    def __init__(self, folder: pathlib.Path, stderr: str, status: int) -> None:
        self.files = {path.name: path.read_text(encoding="utf-8") for path in folder.iterdir() if path.is_file()}
        self.tables = {name: Table.of_csv(self.files[name + ".csv"]) for name in TABLES if name + ".csv" in self.files}
        self.summary = json.loads(self.files["summary.json"])
        self.listing = self.files["listing.txt"]
        self.report = self.files.get("report.html")
        figures = sorted((folder / "figures").glob("*.svg"))
        self.pictures = Pictures((path.stem, Picture(path.stem, path.read_text(encoding="utf-8"))) for path in figures)
        messages = messages_of(stderr)
        self.warnings = [message for message in messages if message.severity == "warning"]
        self.notes = [message for message in messages if message.severity == "note"]
        self.complete: bool = status == 0
        self.outcome: str = self.summary["outcome"]
        self.why: str = "" if self.complete else self.summary.get("incomplete", {}).get("why", self.outcome)

    def __getitem__(self, name: str) -> Table:
        if name not in self.tables:
            raise KeyError("there is no table %r%s" % (name, offer(name, self.tables)))
        return self.tables[name]

    def quantities(self) -> List[str]:
        """The names that quantity() knows, each once."""
        return list(dict.fromkeys(each["quantity"] for run in self.summary["runs"] for each in run.get("quantities", [])))

    def quantity(self, name: str, zone: Optional[int] = None, item: Optional[int] = None, mu: Optional[float] = None,
                 part: str = "value") -> float:
        """A number that sums up the contact at the last step, "peak pressure" for instance (OUTPUT.md, contact in numbers).

        part    of a place: "x", "y", "along" (its distance along the second side of the contact statement); "error": stated
        """
        found = [each for run in self.summary["runs"] if mu is None or run["mu"] == mu for each in run.get("quantities", [])
                 if each["quantity"] == name and zone in (None, each["zone"]) and item in (None, each["item"])]
        response = re.fullmatch(r"(.*?)(?: (\d+))?(?: (x|y|along|error))?", name)  # "contact edge 1 x", as responses are named
        if not found and response is not None and response.group(1) in self.quantities():
            if response.group(1) != name:
                return self.quantity(response.group(1), zone, int(response.group(2)) if response.group(2) else item, mu,
                                     response.group(3) or part)
            raise KeyError("there is no quantity %r with zone %s, item %s, mu %s" % (name, zone, item, mu))
        if not found:
            raise KeyError("there is no quantity %r%s" % (name, offer(name, self.quantities())))
        if part not in found[-1]:
            raise KeyError("quantity %r has no %r; it has %s" % (name, part, ", ".join(found[-1])))
        return float(found[-1][part])

    @property
    def tolerances(self) -> Table:
        """What parameters with tolerances do to the wanted numbers (OUTPUT.md, tolerances): a row per number and parameter. The sums
        over all parameters, worst_case and root_of_squares, are the same in all rows of a number. Where there is no usable
        derivative these numbers are NaN, and `why` has the reason. Empty without tolerances."""
        def real(value: Any) -> float:
            return float("nan") if value is None else float(value)

        all_of = self.summary.get("tolerances", {"numbers": []})["numbers"]
        rows = [(number, by) for number in all_of for by in number["by"]]
        columns: List[Tuple[str, Any]] = [
            ("quantity", [number["name"] for number, _ in rows])]
        columns += [(key, [number.get(key, 0) for number, _ in rows]) for key in ("zone", "body", "item")]
        columns += [(key, [real(number[key]) for number, _ in rows]) for key in ("value", "worst_case", "root_of_squares")]
        columns += [("parameter", [by["parameter"] for _, by in rows])]
        columns += [(key, [real(by[key]) for _, by in rows]) for key in ("derivative", "share")]
        columns += [("why", [by.get("why", "") for _, by in rows])]
        return Table((name, arrays.column(values)) for name, values in columns)

    def save(self, folder: Union[str, os.PathLike[str]]) -> None:
        """Writes all outputs into a folder, which is made if it is not there. Pictures there that an earlier run has left, and
        this one has not, go, if they are as they were written."""
        folder = pathlib.Path(folder)
        (folder / "figures" if self.pictures else folder).mkdir(parents=True, exist_ok=True)
        for name, text in self.files.items():
            (folder / name).write_text(text, encoding="utf-8")
        for picture in self.pictures.values():
            picture.save(folder / "figures" / (picture.name + ".svg"))
        for path in (folder / "figures").glob("*.svg"):
            if path.stem not in self.pictures and is_as_written(path):
                path.unlink()

    def __repr__(self) -> str:
        return "<Result of %r: %s; %s>" % (self.summary["title"], self.outcome, ", ".join(self.tables))

    def _repr_html_(self) -> str:
        out = ["<h3>%s</h3><p>%s</p>" % (html.escape(self.summary["title"]), html.escape(self.why or self.outcome))]
        out += ["<p>Warning: %s</p>" % html.escape(str(message)) for message in self.warnings]
        rows = [each for run in self.summary["runs"] for each in [dict(mu=run["mu"], **quantity)
                                                                  for quantity in run.get("quantities", [])]]
        columns = ["mu", "zone", "quantity", "item", "value", "error"]
        table = Table((name, [row.get(name, "") for row in rows]) for name in columns)
        shown = [picture for name, picture in self.pictures.items() if re.match("tractions|deformed|stress$", name)]
        return "".join(out) + table._repr_html_(most=40) + "".join(picture.as_image() for picture in shown)


def solve(source: Source, points: Any = None, pictures: bool = True, stresses: bool = False,
          options: Optional[Mapping[str, Any]] = None, set: Optional[Mapping[str, Any]] = None, progress: Progress = None,
          **parameters: Any) -> Result:
    """Solves a deck or a sketch: the name of its file, or its text (which has more than one line).

    >>> result = solve("roller.c2s", pictures=False, mu=0.2)
    >>> result.outcome, len(result["contact"].where(step=-1)) > 10
    ('reached', True)
    >>> "%.3g" % result.quantity("peak pressure")
    '76.4'

    parameters  values of a sketch's parameters: solve("pin.c2s", mu=0.3); `set`: the same as a dictionary, for parameters
                that are called as an argument here
    points      interior points: rows (x, y, body), or (x, y) in body 1; result["interior"]
    pictures    False: no pictures and no page are drawn, which takes most of the time of a small model
    stresses    True: result["stresses"], on the boundary and at the points at every recorded step, and result["ranges"]
    options     further options of `contact2d run` by name: {"threads": 2, "stepping": "deck", "estimate": True}
    progress    True: a line on standard error while it runs; a function: called with the text of this line, and what it raises
                ends the run; without it the line is shown on a terminal

    Faults are InputError and its neighbours (contact2d.errors). A load path that ends early is no fault: result.complete is
    False, result.why says why, and an IncompleteWarning is issued.
    """
    word, text = named(source)
    with room() as place:
        folder = pathlib.Path(place)
        words = ["run", "--listing", folder / "listing.txt", "--json", folder / "summary.json"]
        wanted = [name for name in TABLES if name not in ("interior", "stresses", "ranges")]
        wanted += ["stresses", "ranges"] if stresses else []
        if points is not None:
            (folder / "points.csv").write_text(points_text(points), encoding="utf-8")
            words += ["--points", folder / "points.csv"]
        wanted += ["interior"] if points is not None or has_points(word, text) else []
        for name in wanted:
            words += ["--" + TABLES[name], folder / (name + ".csv")]
        if pictures:
            words += ["--report", folder / "report.html", "--figures", folder / "figures"]
        words += option_words(options) + ["--", word] + settings(dict(parameters, **(set or {})))
        _, stderr, status = run_program(*words, text=text, legal=(0, 1, 5), progress=progress)
        if status == 1 and not (folder / "summary.json").exists():
            raise Error(messages_of(stderr) or [Message("error", "the program ended with status 1")], 1)
        result = Result(folder, stderr, status)
    if not result.complete:
        warnings.warn(result.why, IncompleteWarning, stacklevel=2)
    return result


def has_points(word: str, text: Optional[str]) -> bool:
    """Does a deck or sketch ask for interior points itself?"""
    if text is None:
        try:
            text = pathlib.Path(word).read_text(encoding="utf-8", errors="replace")
        except OSError:
            return False  # the message of the program is better
    return re.search(r"^(\*POINTS|\s*stress\s|\s*want\s[^!\n]*\bstress\b)", text, re.M | re.I) is not None


def points_text(points: Any) -> str:
    rows = []
    for point in points if arrays.is_list(points) else [points]:
        if not arrays.is_list(point) or len(point) not in (2, 3):
            raise TypeError("points: %r, expected (x, y) or (x, y, body)" % (point,))
        x, y, *body = point
        rows.append("%d,%r,%r\n" % (arrays.integer("points: 'body'", body[0], least=1) if body else 1,
                                    arrays.real("points: 'x'", x), arrays.real("points: 'y'", y)))
    return "body,x,y\n" + "".join(rows)


class Report(str):
    """The text of a command; `warnings` and `notes`: what it said besides."""

    warnings: List[Message]
    notes: List[Message]


def check(source: Source, **parameters: Any) -> Report:
    """What `contact2d check` says of a deck or sketch: its sizes and the memory that it needs, and its `warnings`. Faults are
    exceptions.

    >>> report = check("hertz.dat")
    >>> "pairs" in report, report.warnings[0].line
    (True, 99)
    """
    word, text = named(source)
    out, stderr, _ = run_program("check", "--", word, *settings(parameters), text=text)
    report, messages = Report(out), messages_of(stderr)
    report.warnings = [message for message in messages if message.severity == "warning"]
    report.notes = [message for message in messages if message.severity == "note"]
    return report


def rows_of(values: Any) -> Tuple[List[str], List[List[Any]]]:
    """(names, rows) of values of parameters: a table, a mapping of lists, or a list of mappings."""
    if isinstance(values, (Table, Mapping)):
        columns = {name: list(column) if arrays.is_list(column) else [column] for name, column in values.items()}
        most = max([len(column) for column in columns.values()] or [0])
        for name, column in columns.items():
            if len(column) not in (1, most):
                raise ValueError("sweep: %r has %d values, expected 1 or %d" % (name, len(column), most))
        return list(columns), [[column[i % len(column)] for column in columns.values()] for i in range(most)]
    rows = [dict(row) for row in values]
    names = list(rows[0]) if rows else []
    for row in rows:
        if list(row) != names:
            raise ValueError("sweep: a row has the parameters %s, expected %s" % (", ".join(row), ", ".join(names)))
    return names, [list(row.values()) for row in rows]


def sweep(source: Source, values: Any, responses: Union[str, Iterable[str]], options: Optional[Mapping[str, Any]] = None,
          progress: Progress = None, **parameters: Any) -> Table:
    """Solves a deck or a sketch once for every row of values; a table of parameters, requested numbers and outcomes.

    values      parameters by name: lists of equal length, {"mu": [0.1, 0.2], "P": [10, 20]} (one value stands for all rows);
                or a list of dictionaries, one for each row; or a Table
    responses   requested numbers, as for `contact2d sweep --response`: "peak pressure; contact edge 1 x", or a list of them
    options     of `contact2d sweep` by name: {"threads": 4}; without it all processors are used
    parameters  those that are the same in all rows

    >>> table = sweep("roller.c2s", {"P": [10, 20, 40]}, "peak pressure; max gap", mu=0.2)
    >>> table.columns
    ['row', 'P', 'peak pressure', 'max gap', 'outcome']
    >>> [row["outcome"] for row in table if row["P"] > 10]
    ['ok', 'ok']

    A number that does not exist is nan. A row whose run fails has none, and its outcome begins with FAIL and says why.
    """
    names, rows = rows_of(values)
    if not rows:
        raise ValueError("sweep: there are no values, expected at least one row")
    rows = [[word.split("=", 1)[1] for word in settings(dict(zip(names, row)))] for row in rows]
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([names] + rows)
    word, deck = named(source)
    with room() as place:
        table, results = pathlib.Path(place) / "values.csv", pathlib.Path(place) / "results.csv"
        table.write_text(text.getvalue(), encoding="utf-8")
        words = ["sweep", "--response=" + (responses if isinstance(responses, str) else "; ".join(responses)),
                 "--results", results] + option_words(options)
        try:
            run_program(*words, "--", table, word, *settings(parameters), text=deck, legal=(0, 1, 5), progress=progress)
        except InputError as fault:
            if any(message.name == str(table) for message in fault.messages):  # of the values, whose file is not the caller's
                source_name = None if word == "-" else word
                raise UsageError([Message("error", message.text, name=source_name) for message in fault.messages]) from None
            raise
        text_of_rows = results.read_text(encoding="utf-8")
        heading = next(csv.reader(io.StringIO(text_of_rows)))
        return Table.of_csv(text_of_rows, numbers=heading[1 + len(names):-1])


def mesh(source: Source, **parameters: Any) -> str:
    """The deck that is made of a sketch."""
    word, text = named(source)
    return run_program("mesh", "--", word, *settings(parameters), text=text)[0]


def make(family: str, **values: Any) -> str:
    """The deck of a problem that is known by name (families()).

    >>> make("hertz", n=20).startswith("*FREE")
    True
    """
    return run_program("make", family, *settings(values))[0]


def families() -> str:
    """Names and keys of the known problems, as text."""
    return run_program("make", "--list")[0]


def main() -> None:
    """The command `contact2d` of the installed package: the program itself."""
    path = library.program()
    os.execv(path, [path] + sys.argv[1:])
