"""Tables with rows in order and columns by name."""

from __future__ import annotations

import csv
import html
import io
from typing import Any, Dict, ItemsView, Iterable, Iterator, KeysView, List, Mapping, Sequence, Tuple, Union, ValuesView

from . import arrays
from .errors import offer

COUNTS = {"step", "event", "pair", "zone", "body", "body1", "body2", "element", "node", "item", "row"}


def parsed(name: str, words: List[str]) -> Sequence[Any]:
    """A column of a CSV file: whole numbers (COUNTS), numbers, or text; an empty field among numbers is nan."""
    try:
        if name in COUNTS:
            return [int(word or 0) for word in words]
        numbers: Sequence[Any] = [float(word) if word else float("nan") for word in words]
    except ValueError:
        return words
    return words if all(word == "" for word in words) else numbers


def is_mask(values: Any) -> bool:
    """True and False for every row?"""
    if arrays.numpy is not None and isinstance(values, arrays.numpy.ndarray):
        return bool(values.dtype == bool)
    truths = (bool,) if arrays.numpy is None else (bool, arrays.numpy.bool_)
    return len(values) > 0 and all(isinstance(value, truths) for value in values)


class Table:
    """Rows in order, columns by name.

    >>> table = Table({"x": [0.0, 0.5, 1.0], "status": ["stick", "slip", "open"]})
    >>> len(table), table.columns
    (3, ['x', 'status'])
    >>> [row["status"] for row in table if row["x"] > 0]      # rows are dictionaries
    ['slip', 'open']
    >>> list(table["status"])                                 # a column: an array of numpy if it is installed, else a list
    ['stick', 'slip', 'open']
    >>> table[-1]["status"], len(table[1:]), len(table[[True, False, True]]), len(table[[0, 2]])
    ('open', 2, 2, 2)
    >>> len(table.where(status="slip"))
    1

    With numpy a mask is written as table[table["x"] > 0]. `keys`, `values` and `items` are those of the columns, so that
    dict(table) is a dictionary of columns.
    """

    def __init__(self, columns: Union[Mapping[str, Any], Iterable[Tuple[str, Any]]]) -> None:
        self._columns: Dict[str, Any] = dict(columns)
        lengths = {name: len(values) for name, values in self._columns.items()}
        if len(set(lengths.values())) > 1:
            raise ValueError("the columns of a table differ in length: %s" % lengths)
        self._rows = next(iter(lengths.values()), 0)

    @classmethod
    def of_csv(cls, text: str, numbers: Sequence[str] = ()) -> Table:
        """Of the text of a CSV file. Columns of `numbers` are numbers even if all of their fields are empty."""
        rows = list(csv.reader(io.StringIO(text)))
        names, rows = (rows[0], rows[1:]) if rows else ([], [])
        columns = [(name, [row[i] for row in rows]) for i, name in enumerate(names)]
        return cls((name, arrays.column(parsed(name, [word or "nan" for word in words] if name in numbers else words)))
                   for name, words in columns)

    def __getitem__(self, key: Any) -> Any:
        """A column by its name; a row, a dictionary, by its number from 0; rows by a slice, a mask or a list of numbers."""
        if isinstance(key, str):
            if key not in self._columns:
                raise KeyError("there is no column %r%s" % (key, offer(key, self._columns)))
            return self._columns[key]
        if isinstance(key, slice):
            return self.take(range(len(self))[key])
        if not arrays.is_list(key):
            row = arrays.integer("the number of a row", key)
            if not -len(self) <= row < len(self):
                raise IndexError("there is no row %d; there are %d" % (row, len(self)))
            return {name: values[row] for name, values in self._columns.items()}
        key = key if hasattr(key, "dtype") else list(key)
        if not is_mask(key):
            return self.take(key)
        if len(key) != len(self):
            raise ValueError("the mask has %d entries, the table %d rows" % (len(key), len(self)))
        return self.take(i for i, wanted in enumerate(key) if wanted)

    def __iter__(self) -> Iterator[Dict[str, Any]]:
        """The rows, each a dictionary."""
        names = list(self._columns)
        return (dict(zip(names, row)) for row in zip(*self._columns.values()))

    def __len__(self) -> int:
        return self._rows

    def __contains__(self, name: object) -> bool:
        """Is there a column of this name?"""
        return name in self._columns

    def __repr__(self) -> str:
        return "<Table of %d rows: %s>" % (len(self), ", ".join(self._columns))

    @property
    def columns(self) -> List[str]:
        return list(self._columns)

    def keys(self) -> KeysView[str]:
        return self._columns.keys()

    def values(self) -> ValuesView[Any]:
        return self._columns.values()

    def items(self) -> ItemsView[str, Any]:
        return self._columns.items()

    def get(self, name: str, otherwise: Any = None) -> Any:
        return self._columns.get(name, otherwise)

    def take(self, rows: Iterable[int]) -> Table:
        """A table of these rows, counted from 0."""
        rows = [arrays.integer("the number of a row", row) for row in rows]
        return Table((name, values[rows] if arrays.numpy is not None and hasattr(values, "dtype") else [values[i] for i in rows])
                     for name, values in self._columns.items())

    def where(self, **wanted: Any) -> Table:
        """The rows in which columns have these values: where(mu=0.3, step=10); step=-1 is the last step there is."""
        if wanted.get("step") == -1:
            rest = self.where(**{name: value for name, value in wanted.items() if name != "step"})
            return rest.where(step=max(rest["step"])) if len(rest) else rest
        pairs = [(self[name], value) for name, value in wanted.items()]
        return self.take(i for i in range(len(self)) if all(column[i] == value for column, value in pairs))

    def rows(self) -> List[Dict[str, Any]]:
        """Every row as a dictionary."""
        return list(self)

    def plot(self, x: str, *columns: str, **options: Any) -> Any:
        """Columns over column `x`, as contact2d.plot draws curves: table.plot("x", "tn", "tt", ax=axes)."""
        from .pictures import plot

        options.setdefault("x", x)
        return plot(*[(self[x], self[name], name) for name in columns], **options)

    def to_pandas(self) -> Any:
        """As a pandas.DataFrame; pandas has to be installed."""
        import pandas

        return pandas.DataFrame(self._columns)

    def to_csv(self) -> str:
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(self._columns)
        writer.writerows(zip(*self._columns.values()))
        return out.getvalue()

    def _repr_html_(self, most: int = 20) -> str:
        def cell(value: Any) -> str:
            return "%.6g" % value if isinstance(value, float) else html.escape(str(value))

        shown = [values[:most] for values in self._columns.values()]
        head = "".join("<th>%s</th>" % html.escape(name) for name in self._columns)
        body = "".join("<tr>%s</tr>" % "".join("<td>%s</td>" % cell(value) for value in row) for row in zip(*shown))
        more = "<p>%d rows, the first %d are shown</p>" % (len(self), most) if len(self) > most else ""
        return "<table><thead><tr>%s</tr></thead><tbody>%s</tbody></table>%s" % (head, body, more)
