"""Pictures as SVG that a notebook shows; `plot` draws curves without any other package, or on axes of matplotlib."""

from __future__ import annotations

import base64
import html
import math
import os
import pathlib
from typing import Any, Union

from . import arrays
from .errors import offer

COLOURS = ["#1b6ca8", "#c2452d", "#3a7d44", "#7a4fa3", "#b8860b", "#444444"]
LEFT, RIGHT, TOP, BOTTOM = 76, 20, 44, 56


def is_as_written(path: pathlib.Path) -> bool:
    """Does a file end as pictures of a run do, with its name and the checksum of what is before (Fowler, Noll and Vo's)?"""
    if path.is_symlink() or not path.is_file():
        return False
    text, begin, mark = path.read_bytes().rpartition(b"<!-- contact2d ")
    total = 14695981039346656037
    for byte in text if begin else b"":
        total = ((total ^ byte) * 1099511628211) & 0xffffffffffffffff
    return bool(begin) and mark == b"%s %016x -->\n" % (os.fsencode(path.name), total)


class Picture:
    """An SVG picture: `name`, `svg` (its text); save(FILE)."""

    def __init__(self, name: str, svg: str) -> None:
        self.name, self.svg = name, svg

    def _repr_svg_(self) -> str:
        return self.svg

    def as_image(self) -> str:
        """An element of HTML in which styles of this picture do not meet those of another."""
        data = base64.b64encode(self.svg.encode("utf-8")).decode("ascii")
        return '<img alt="%s" style="max-width:100%%" src="data:image/svg+xml;base64,%s">' % (html.escape(self.name), data)

    def save(self, file: Union[str, os.PathLike[str]]) -> None:
        with open(file, "w", encoding="utf-8") as out:
            out.write(self.svg)

    def __repr__(self) -> str:
        return "<Picture %s>" % self.name


class Pictures(dict):  # type: ignore[type-arg]
    """Pictures by name; a name that is not there gets a suggestion."""

    def __missing__(self, name: str) -> Any:
        raise KeyError("there is no picture %r%s" % (name, offer(name, self)))


def ticks(low, high, about=6):
    """Round numbers from low to high."""
    span = high - low
    step = 10.0 ** math.floor(math.log10(span / about))
    step *= next(factor for factor in (1, 2, 5, 10) if span / (step * factor) <= about)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [i * step for i in range(first, last + 1)]


class Axis:
    """From numbers to places of the picture."""

    def __init__(self, values, begin, end):
        finite = [value for value in values if math.isfinite(value)] or [0.0]
        self.low, self.high = min(finite), max(finite)
        if self.high - self.low <= 1e-12 * max(abs(self.high), abs(self.low)):
            margin = abs(self.high) or 1.0
            self.low, self.high = self.low - margin, self.high + margin
        self.begin, self.end = begin, end
        self.ticks = ticks(self.low, self.high)

    def place(self, value):
        return self.begin + (self.end - self.begin) * (value - self.low) / (self.high - self.low)


def lines(curves, across, up):
    """Polylines; where a number is not finite a curve is interrupted."""
    out = []
    for i, (x, y, _) in enumerate(curves):
        pieces, piece = [], []
        for a, b in zip(x, y):
            if math.isfinite(a) and math.isfinite(b):
                piece.append("%.2f,%.2f" % (across.place(a), up.place(b)))
            elif piece:
                pieces, piece = pieces + [piece], []
        for points in pieces + ([piece] if piece else []):
            out.append('<polyline fill="none" stroke="%s" stroke-width="1.8" stroke-linejoin="round" points="%s"/>' %
                       (COLOURS[i % len(COLOURS)], " ".join(points)))
    return out


def frame(across, up, width, height):
    out = []
    for value in across.ticks:
        x = across.place(value)
        out.append('<path d="M%.1f %d V%d" stroke="#8884"/>' % (x, TOP, height - BOTTOM))
        out.append('<text x="%.1f" y="%d" text-anchor="middle">%g</text>' % (x, height - BOTTOM + 18, value))
    for value in up.ticks:
        y = up.place(value)
        out.append('<path d="M%d %.1f H%d" stroke="#8884"/>' % (LEFT, y, width - RIGHT))
        out.append('<text x="%d" y="%.1f" text-anchor="end">%g</text>' % (LEFT - 8, y + 4, value))
    out.append('<rect x="%d" y="%d" width="%d" height="%d" fill="none" stroke="#888"/>' %
               (LEFT, TOP, width - LEFT - RIGHT, height - TOP - BOTTOM))
    return out


def on_axes(ax: Any, curves: Any, title: str, x: str, y: str) -> Any:
    """The curves on axes of matplotlib, which are returned; True: on new ones."""
    if ax is True:
        try:
            import matplotlib.pyplot
        except ImportError:
            raise ImportError("plot: ax=True needs matplotlib, which is not installed; without ax= it is not needed") from None
        ax = matplotlib.pyplot.figure().add_subplot()
    for across, up, name in curves:
        ax.plot(across, up, label=name or None)
    if any(name for _, _, name in curves):
        ax.legend()
    for say, text in ((ax.set_title, title), (ax.set_xlabel, x), (ax.set_ylabel, y)):
        if text:
            say(text)
    return ax


def plot(*curves: Any, title: str = "", x: str = "", y: str = "", width: int = 640, height: int = 400, ax: Any = None) -> Any:
    """A picture of curves, each (x values, y values) or (x values, y values, name).

    >>> plot(([0, 1, 2], [0, 3, 5], "mu 0.3"), title="Fretting loop", x="displacement", y="force")
    <Picture Fretting loop>

    `ax`: axes of matplotlib, on which the curves are drawn instead; True: new ones. The axes are returned.
    """
    if not curves:
        raise ValueError("plot: expected at least one curve, (x values, y values) or (x values, y values, name)")
    drawn = []
    for curve in curves:
        across, up = arrays.flat(curve[0]), arrays.flat(curve[1])
        if len(across) != len(up):
            raise ValueError("plot: a curve has %d x values and %d y values" % (len(across), len(up)))
        drawn.append((across, up, curve[2] if len(curve) > 2 else ""))
    if ax is not None:
        return on_axes(ax, drawn, title, x, y)
    across = Axis([value for curve in drawn for value in curve[0]], LEFT, width - RIGHT)
    up = Axis([value for curve in drawn for value in curve[1]], height - BOTTOM, TOP)
    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d" height="%d" role="img" '
           'font-family="sans-serif" font-size="13" fill="#333">' % (width, height, width, height),
           "<title>%s</title>" % html.escape(title or y),
           '<rect width="%d" height="%d" fill="#fff"/>' % (width, height)]
    out += frame(across, up, width, height) + lines(drawn, across, up)
    out.append('<text x="%d" y="20" font-size="15" font-weight="bold">%s</text>' % (LEFT, html.escape(title)))
    out.append('<text x="%d" y="%d" text-anchor="middle">%s</text>' %
               ((LEFT + width - RIGHT) // 2, height - 14, html.escape(x)))
    middle = (TOP + height - BOTTOM) // 2
    out.append('<text x="18" y="%d" text-anchor="middle" transform="rotate(-90 18 %d)">%s</text>' %
               (middle, middle, html.escape(y)))
    place = LEFT
    for i, (_, _, name) in enumerate(drawn):
        if name:
            out.append('<path d="M%d 33 h18" stroke="%s" stroke-width="2.5"/><text x="%d" y="37">%s</text>' %
                       (place, COLOURS[i % len(COLOURS)], place + 23, html.escape(name)))
            place += 40 + 7 * len(name)
    return Picture(title or "plot", "\n".join(out + ["</svg>", ""]))
