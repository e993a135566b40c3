"""A drawing as plain values: shapes for the template, and points that answer to the pointer."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

__all__ = [
    "WIDTH",
    "Figure",
    "Frame",
    "Legend",
    "Point",
    "Shape",
    "axes",
    "axis_titles",
    "breadth",
    "frame_in",
    "line",
    "path",
    "text",
    "ticks",
]

WIDTH = 640.0
"""Of every figure, in its own units."""

_TYPE = 19.0
"""Largest type in a figure (style.css, on phones), in its units."""
_LETTER = 0.66
"""Mean width of a letter over the type, in the widest fonts that pages are read in."""
_TITLE = 22.0
"""From the top of a frame up to the title of its upright axis, clear of the topmost number."""
_ROW = _TITLE + 24.0
"""Room above a frame for that title, in type of any height."""


@dataclass(frozen=True)
class Shape:
    """One SVG element: its tag, its attributes and the text in it."""

    tag: str
    attributes: tuple[tuple[str, str], ...]
    text: str = ""


@dataclass(frozen=True)
class Point:
    """A place in a figure with what is known there, in words; in the figure's units."""

    x: float
    y: float
    text: str


@dataclass(frozen=True)
class Legend:
    """An entry below a figure: the class that its sample is drawn with, and what it is."""

    style: str
    text: str


@dataclass(frozen=True)
class Figure:
    """A drawing.

    Attributes
    ----------
    key : str
        Name within the page.
    title : str
        What it shows, for readers who do not see it.
    height : float
        In its own units; the width is `WIDTH`.
    shapes : tuple of Shape
        From the back to the front.
    points : tuple of Point
        Places that answer to the pointer and the arrow keys.
    legend : tuple of Legend
        What the shapes are.
    notes : tuple of str
        What else is to be said below it.
    """

    key: str
    title: str
    height: float
    shapes: tuple[Shape, ...]
    points: tuple[Point, ...] = ()
    legend: tuple[Legend, ...] = ()
    notes: tuple[str, ...] = field(default=())

    @property
    def width(self) -> float:
        """In its own units."""
        return WIDTH


def number(value: float) -> str:
    """Write a coordinate: a hundredth of a unit is finer than any screen."""
    return f"{round(value, 2) + 0.0:g}" if abs(value) < 1e6 else f"{value:.0f}"


def shape(tag: str, style: str, words: str = "", **attributes: float | str) -> Shape:
    """Make a shape of a class; coordinates may be numbers."""
    given = [("class", style)]
    for key, value in attributes.items():
        written = value if isinstance(value, str) else number(value)
        given.append((key.replace("_", "-"), written))
    return Shape(tag, tuple(given), words)


def path(style: str, places: Iterable[tuple[float, float]]) -> Shape:
    """Make an open line through places."""
    return shape("polyline", style, points=" ".join(f"{number(x)},{number(y)}" for x, y in places))


def line(style: str, x1: float, y1: float, x2: float, y2: float) -> Shape:
    """Make a straight line."""
    return shape("line", style, x1=x1, y1=y1, x2=x2, y2=y2)


def text(
    words: str, x: float, y: float, *, anchor: str = "middle", style: str = "", turn: float = 0.0
) -> Shape:
    """Write words at a place, turned by some degrees."""
    turned = {"transform": f"rotate({number(turn)} {number(x)} {number(y)})"} if turn else {}
    return shape("text", style, words, x=x, y=y, text_anchor=anchor, **turned)


@dataclass(frozen=True)
class Frame:
    """Where a range of values lies in a figure.

    Attributes
    ----------
    left, right, top, bottom : float
        In units of the figure.
    x, y : tuple of float
        The values at the edges: left and right, bottom and top.
    """

    left: float
    right: float
    top: float
    bottom: float
    x: tuple[float, float]
    y: tuple[float, float]

    def across(self, value: float) -> float:
        """Place a value of x."""
        low, high = self.x
        return self.left + (self.right - self.left) * (value - low) / (high - low)

    def up(self, value: float) -> float:
        """Place a value of y."""
        low, high = self.y
        return self.bottom - (self.bottom - self.top) * (value - low) / (high - low)

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Place a point."""
        return self.across(x), self.up(y)


def frame_in(
    height: float,
    x: tuple[float, float],
    y: tuple[float, float],
    *,
    left: float = 74.0,
    top: float = _ROW,
) -> Frame:
    """Place a frame in a figure so that numbers and titles have room around it in any font.

    Parameters
    ----------
    height : float
        Of the figure.
    x, y : tuple of float
        The values at the edges.
    left : float
        Room for the numbers of the upright axis; they have five digits when left out.
    top : float
        Room above.
    """
    return Frame(left, WIDTH - 30.0, top, height - 56.0, x, y)


def breadth(words: str) -> float:
    """Return the room that words in a row need in any font, in units of the figure."""
    return _TYPE * _LETTER * len(words)


def ticks(low: float, high: float, most: int = 6) -> list[float]:
    """List round values in a range, at most so many: multiples of 1, 2 or 5 times a power of ten.

    Parameters
    ----------
    low, high : float
        The range.
    most : int
        At least 2.
    """
    if not high > low:
        return [low]
    raw = (high - low) / most
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(each * power for each in (1, 2, 5, 10, 20) if each * power >= raw * (1 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [step * index for index in range(first, last + 1)]


def axes(
    frame: Frame,
    x_label: str,
    y_label: str,
    across: Sequence[float] = (),
    *,
    above: float = 0.0,
) -> list[Shape]:
    """Draw the grid, the values along two edges and what they are.

    Parameters
    ----------
    frame : Frame
        Where.
    x_label, y_label : str
        What the values are.
    across : sequence of float
        Those of x; round ones when left out.
    above : float
        What else stands between the frame and the title of y.
    """
    shapes = [
        shape(
            "rect",
            "frame",
            x=frame.left,
            y=frame.top,
            width=frame.right - frame.left,
            height=frame.bottom - frame.top,
        )
    ]
    for values, label in ((across or ticks(*frame.x), "x"), (ticks(*frame.y), "y")):
        for value, words in zip(values, tick_words(values), strict=True):
            if label == "x":
                at = frame.across(value)
                shapes.append(line("grid", at, frame.top, at, frame.bottom))
                shapes.append(text(words, at, frame.bottom + 20, style="tick"))
            else:
                at = frame.up(value)
                shapes.append(line("grid", frame.left, at, frame.right, at))
                shapes.append(text(words, frame.left - 7, at + 5, anchor="end", style="tick"))
    return [*shapes, *axis_titles(frame, x_label, y_label, above=above)]


def axis_titles(
    frame: Frame, x_label: str, y_label: str, *, above: float = 0.0, below: float = 0.0
) -> Iterator[Shape]:
    """Write what the values are, in rows of their own: turned words would want room by their font.

    Parameters
    ----------
    frame : Frame
        Where.
    x_label, y_label : str
        What the values are.
    above, below : float
        What else stands between the frame and its titles.
    """
    middle = (frame.left + frame.right) / 2
    yield text(x_label, middle, frame.bottom + below + 44, style="axis")
    yield text(y_label, 2, frame.top - above - _TITLE, anchor="start", style="axis")


def tick_words(values: Sequence[float]) -> list[str]:
    """Write round values, all with the digits that the finest step needs."""
    step = values[1] - values[0] if len(values) > 1 else abs(values[0]) or 1.0
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    return [f"{round(value, digits) + 0.0:.{digits}f}" for value in values]
