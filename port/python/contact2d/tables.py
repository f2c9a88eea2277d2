"""Tables with columns by name."""

import csv
import html
import io
from collections.abc import Mapping

from . import arrays


COUNTS = {"step", "event", "pair", "zone", "body", "body1", "body2", "element", "node", "item"}


def parsed(name, words):
    """A column of a CSV file: whole numbers (COUNTS), numbers, or text; an empty field among numbers is nan."""
    try:
        if name in COUNTS:
            return [int(word or 0) for word in words]
        numbers = [float(word) if word else float("nan") for word in words]
    except ValueError:
        return words
    return words if all(word == "" for word in words) else numbers


class Table(Mapping):
    """Columns by name, numpy's arrays if numpy is installed, else lists: table["tn"]. `len` is the number of rows; iteration
    is over the names of the columns, as in every mapping."""

    def __init__(self, columns):
        self._columns = dict(columns)
        self._rows = len(next(iter(self._columns.values()), ()))

    @classmethod
    def of_csv(cls, text):
        rows = list(csv.reader(io.StringIO(text)))
        names, rows = (rows[0], rows[1:]) if rows else ([], [])
        return cls((name, arrays.column(parsed(name, [row[i] for row in rows]))) for i, name in enumerate(names))

    def __getitem__(self, name):
        if name not in self._columns:
            raise KeyError("there is no column %r; there are %s" % (name, ", ".join(self)))
        return self._columns[name]

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return self._rows

    def __repr__(self):
        return "<Table of %d rows: %s>" % (len(self), ", ".join(self))

    @property
    def columns(self):
        return list(self._columns)

    def take(self, rows):
        """A table of these rows, counted from 0."""
        rows = list(rows)
        return Table((name, values[rows] if arrays.numpy is not None else [values[i] for i in rows])
                     for name, values in self._columns.items())

    def where(self, **wanted):
        """The rows in which columns have these values: where(mu=0.3, step=10); step=-1 is the last step there is."""
        if wanted.get("step") == -1:
            rest = self.where(**{name: value for name, value in wanted.items() if name != "step"})
            return rest.where(step=max(rest["step"])) if len(rest) else rest
        pairs = [(self[name], value) for name, value in wanted.items()]
        return self.take(i for i in range(len(self)) if all(column[i] == value for column, value in pairs))

    def rows(self):
        """Every row as a dictionary."""
        names, values = list(self._columns), list(self._columns.values())
        return [dict(zip(names, row)) for row in zip(*values)]

    def to_pandas(self):
        """As a pandas.DataFrame; pandas has to be installed."""
        import pandas

        return pandas.DataFrame(self._columns)

    def to_csv(self):
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(self._columns)
        writer.writerows(zip(*self._columns.values()))
        return out.getvalue()

    def _repr_html_(self, most=20):
        def cell(value):
            return "%.6g" % value if isinstance(value, float) else html.escape(str(value))

        shown = [values[:most] for values in self._columns.values()]
        head = "".join("<th>%s</th>" % html.escape(name) for name in self._columns)
        body = "".join("<tr>%s</tr>" % "".join("<td>%s</td>" % cell(value) for value in row) for row in zip(*shown))
        more = "<p>%d rows, the first %d are shown</p>" % (len(self), most) if len(self) > most else ""
        return "<table><thead><tr>%s</tr></thead><tbody>%s</tbody></table>%s" % (head, body, more)
