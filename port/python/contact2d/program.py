"""Decks and sketches solved by the program: tables, pictures and messages of a run.

A run is a process of its own, so that nothing of it can harm the one that asked, any number of them go on at once in threads,
and Ctrl-C ends one in order. The outputs are the program's files (src/report/OUTPUT.md), with the program's digits.
"""

import html
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import warnings

from . import arrays, library
from .errors import Cancelled, Error, IncompleteWarning, InputError, Message, StoreError, UsageError, WorkspaceError
from .pictures import Picture, is_as_written
from .tables import Table

TABLES = {"contact": "csv", "boundary": "boundary", "interior": "interior", "summary": "summary", "bodies": "bodies",
          "trace": "trace", "stresses": "stresses", "ranges": "ranges"}
FAILURES = {2: InputError, 3: StoreError, 4: WorkspaceError, 64: UsageError, 75: StoreError, 130: Cancelled, 143: Cancelled}
MESSAGE = re.compile(r"^contact2d: (?:(?P<name>.*?)(?::(?P<line>\d+)(?::(?P<column>\d+))?)?: )?"
                     r"(?P<severity>error|warning|note): (?P<text>.*)$")
PATIENCE = 10  # seconds for a run that was interrupted to end in order


def messages_of(text):
    """The messages on the program's standard error; cards that it quotes, and marks below them, are left out."""
    out = []
    for line in text.splitlines():
        match = MESSAGE.match(line)
        if match:
            out.append(Message(match["severity"], match["text"], int(match["line"] or 0), int(match["column"] or 0),
                               name=match["name"]))
    return out


def end(process):
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


def run_program(*words, text=None, legal=(0,)):
    """(standard output, standard error, exit status) of `contact2d WORDS`; exit statuses that are not `legal` are
    exceptions. `text`: what it reads from its standard input."""
    arguments = [library.program()] + [os.fspath(word) for word in words]
    process = subprocess.Popen(arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        out, stderr = process.communicate(None if text is None else text.encode("utf-8"))
    except BaseException:
        end(process)
        raise
    out, stderr = out.decode("utf-8", "replace"), stderr.decode("utf-8", "replace")
    if process.returncode in legal:
        return out, stderr, process.returncode
    faults = [message for message in messages_of(stderr) if message.severity == "error"]
    if not faults:
        said = " / ".join(line.replace("contact2d: ", "", 1) for line in stderr.splitlines()[:1])
        faults = [Message("error", said or "the program ended with status %d" % process.returncode)]
    raise FAILURES.get(process.returncode, Error)(faults, process.returncode)


def named(source):
    """(word for the command line, standard input) of a file's name, or of the text of a deck or sketch itself. Words stand
    behind `--`, where a dash begins a name; `-` alone is a file of that name, too."""
    if isinstance(source, str) and "\n" in source:
        return "-", source
    name = os.fsdecode(source)
    return os.path.join(os.curdir, name) if name == "-" else name, None


def settings(parameters):
    """Words NAME=VALUE."""
    for name, value in parameters.items():
        if not isinstance(name, str) or "=" in name:
            raise ValueError("%r is no name of a parameter" % (name,))
        if not isinstance(value, str):
            arrays.real("parameter '%s'" % name, value)
    return ["%s=%s" % (name, repr(float(value)) if isinstance(value, float) else value)
            for name, value in parameters.items()]


def room():
    """A folder for the outputs: in memory if there is such a place with room, since they are read at once."""
    shared = "/dev/shm"
    if os.access(shared, os.W_OK) and shutil.disk_usage(shared).free > 1 << 28:
        return tempfile.TemporaryDirectory(prefix="contact2d-", dir=shared)
    return tempfile.TemporaryDirectory(prefix="contact2d-")


class Result:
    """What a run gave.

    Tables by name, result["contact"] (OUTPUT.md describes their columns): "contact", "boundary", "summary", "bodies",
    "trace", "interior" if points were asked for, and, if they were, "stresses" and "ranges". `summary`: the program's JSON; `listing`, `report` (a page of HTML):
    texts; `pictures`: by name; `warnings`, `notes`: messages; `complete`, `outcome`, `why`: did the path reach its end?
    """

    def __init__(self, folder, stderr, status):
        self.files = {path.name: path.read_text(encoding="utf-8") for path in folder.iterdir() if path.is_file()}
        self.tables = {name: Table.of_csv(self.files[name + ".csv"]) for name in TABLES if name + ".csv" in self.files}
        self.summary = json.loads(self.files["summary.json"])
        self.listing = self.files["listing.txt"]
        self.report = self.files.get("report.html")
        figures = sorted((folder / "figures").glob("*.svg"))
        self.pictures = {path.stem: Picture(path.stem, path.read_text(encoding="utf-8")) for path in figures}
        messages = messages_of(stderr)
        self.warnings = [message for message in messages if message.severity == "warning"]
        self.notes = [message for message in messages if message.severity == "note"]
        self.complete, self.outcome = status == 0, self.summary["outcome"]
        self.why = "" if self.complete else self.summary.get("incomplete", {}).get("why", self.outcome)

    def __getitem__(self, name):
        if name not in self.tables:
            raise KeyError("there is no table %r; there are %s" % (name, ", ".join(self.tables)))
        return self.tables[name]

    def quantity(self, name, zone=None, item=None, mu=None):
        """A number that sums up the contact at the last step, "peak pressure" for instance (OUTPUT.md, contact in numbers)."""
        found = [each for run in self.summary["runs"] if mu is None or run["mu"] == mu for each in run.get("quantities", [])
                 if each["quantity"] == name and zone in (None, each["zone"]) and item in (None, each["item"])]
        if not found:
            raise KeyError("there is no quantity %r at the last step" % name)
        return found[-1]["value"]

    def save(self, folder):
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

    def __repr__(self):
        return "<Result of %r: %s; %s>" % (self.summary["title"], self.outcome, ", ".join(self.tables))

    def _repr_html_(self):
        out = ["<h3>%s</h3><p>%s</p>" % (html.escape(self.summary["title"]), html.escape(self.why or self.outcome))]
        out += ["<p>Warning: %s</p>" % html.escape(str(message)) for message in self.warnings]
        rows = [each for run in self.summary["runs"] for each in [dict(mu=run["mu"], **quantity)
                                                                  for quantity in run.get("quantities", [])]]
        columns = ["mu", "zone", "quantity", "item", "value", "error"]
        table = Table((name, [row.get(name, "") for row in rows]) for name in columns)
        shown = [picture for name, picture in self.pictures.items() if re.match("tractions|deformed|stress$", name)]
        return "".join(out) + table._repr_html_(most=40) + "".join(picture.as_image() for picture in shown)


def solve(source, points=None, pictures=True, stresses=False, options=None, set=None, **parameters):
    """Solves a deck or a sketch: the name of its file, or its text (which has more than one line).

    parameters  values of a sketch's parameters: solve("pin.c2s", mu=0.3); `set`: the same as a dictionary, for parameters
                that are called as an argument here
    points      interior points: rows (x, y, body), or (x, y) in body 1; result["interior"]
    pictures    False: no pictures and no page are drawn, which takes most of the time of a small model
    stresses    True: result["stresses"], on the boundary and at the points at every recorded step, and result["ranges"]
    options     further options of `contact2d run` by name: {"threads": 2, "stepping": "deck", "estimate": True}

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
        for name, value in (options or {}).items():
            words += ["--" + name.replace("_", "-") + ("" if value is True else "=%s" % value)]
        words += ["--", word] + settings(dict(parameters, **(set or {})))
        _, stderr, status = run_program(*words, text=text, legal=(0, 1, 5))
        if status == 1 and not (folder / "summary.json").exists():
            raise Error(messages_of(stderr) or [Message("error", "the program ended with status 1")], 1)
        result = Result(folder, stderr, status)
    if not result.complete:
        warnings.warn(result.why, IncompleteWarning, stacklevel=2)
    return result


def has_points(word, text):
    """Does a deck or sketch ask for interior points itself?"""
    if text is None:
        try:
            text = pathlib.Path(word).read_text(encoding="utf-8", errors="replace")
        except OSError:
            return False  # the message of the program is better
    return re.search(r"^(\*POINTS|\s*stress\s|\s*want\s[^!\n]*\bstress\b)", text, re.M | re.I) is not None


def points_text(points):
    rows = []
    for point in points if arrays.is_list(points) else [points]:
        if not arrays.is_list(point) or len(point) not in (2, 3):
            raise TypeError("points: %r, expected (x, y) or (x, y, body)" % (point,))
        x, y, *body = point
        rows.append("%d,%r,%r\n" % (arrays.integer("points: 'body'", body[0], least=1) if body else 1,
                                    arrays.real("points: 'x'", x), arrays.real("points: 'y'", y)))
    return "body,x,y\n" + "".join(rows)


def check(source, **parameters):
    """What `contact2d check` says of a deck or sketch: its sizes and the memory that it needs. Faults are exceptions."""
    word, text = named(source)
    return run_program("check", "--", word, *settings(parameters), text=text)[0]


def mesh(source, **parameters):
    """The deck that is made of a sketch."""
    word, text = named(source)
    return run_program("mesh", "--", word, *settings(parameters), text=text)[0]


def make(family, **values):
    """The deck of a problem that is known by name (families())."""
    return run_program("make", family, *settings(values))[0]


def families():
    """Names and keys of the known problems, as text."""
    return run_program("make", "--list")[0]


def main():
    """The command `contact2d` of the installed package: the program itself."""
    import sys

    path = library.program()
    os.execv(path, [path] + sys.argv[1:])
