"""Charts as shapes for a page, and how what has a role looks."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from typing import Any, NamedTuple

from catopt.figures.chart import (
    Area,
    Arrow,
    Axis,
    Chart,
    Dimension,
    Level,
    Mark,
    Point,
    Scale,
    Series,
    legend,
)
from catopt.quantities import Quantity


class Look(NamedTuple):
    """How a role looks; what the fields are is said in the table."""

    stroke: str = ""
    width: float = 1.0
    dash: tuple[float, ...] = ()
    fill: str = ""
    opacity: float = 1.0
    sign: str = ""
    size: float = 6.0


_TABLE = tomllib.loads(files(__package__).joinpath("looks.toml").read_text("utf-8"))

COLOURS: Mapping[str, tuple[str, str]] = {
    name: (light, dark) for name, (light, dark) in _TABLE["colours"].items()
}
"""Each colour on light paper and on dark."""
SIGNS: Mapping[str, Mapping[str, Any]] = _TABLE["signs"]
"""Each sign, as every renderer draws it."""
LOOKS: Mapping[str, Look] = {role: Look(**look) for role, look in _TABLE["looks"].items()}
"""The look of each role."""


def stylesheet() -> str:
    """Write the looks as CSS, in light and in dark colours."""
    light, dark = (
        "".join(f"--{name}:{pair[index]};" for name, pair in COLOURS.items()) for index in (0, 1)
    )
    rules = f":root{{{light}}}\n@media screen and (prefers-color-scheme: dark){{:root{{{dark}}}}}\n"
    for role, look in LOOKS.items():
        rule = f"fill:var(--{look.fill});" if look.fill else "fill:none;"
        if look.opacity < 1.0:
            rule += f"fill-opacity:{look.opacity:g};"
        if look.stroke:
            rule += f"stroke:var(--{look.stroke});stroke-width:{look.width:g};"
        if look.dash:
            rule += f"stroke-dasharray:{' '.join(f'{each:g}' for each in look.dash)};"
        rules += f"svg .{role}{{{rule}}}\n"
    return rules


Tick = tuple[float, str]
"""A value in SI, and how it is written."""

_POWERS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def axis_title(of: Axis | Scale) -> str:
    """Say what is along an axis, with its unit."""
    unit = of.quantity.field_unit
    return of.label if unit == "-" else f"{of.label} ({unit})".strip()


def tick_marks(axis: Axis, most: int = 6) -> list[Tick]:
    """List the values that are written along an axis, about so many at most."""
    if axis.foot is not None:
        field = axis.quantity.to_field
        return [(value, _power(field(value))) for value in axis.ticks or _decades(axis, most)]
    if axis.ticks:
        return _written(axis.quantity, [axis.quantity.to_field(value) for value in axis.ticks])
    return _round(axis.quantity, *(axis.within or (axis.low, axis.high)), most)


def scale_ticks(axis: Axis, most: int = 6) -> list[Tick]:
    """List the same of the other reading of an axis; values are those of the axis."""
    second = axis.second
    if second is None:
        return []
    marks = _round(second.quantity, axis.low - second.zero, axis.high - second.zero, most)
    return [(value + second.zero, words) for value, words in marks]


def _round(quantity: Quantity, low: float, high: float, most: int) -> list[Tick]:
    return _written(quantity, ticks(quantity.to_field(low), quantity.to_field(high), most))


def _written(quantity: Quantity, values: Sequence[float]) -> list[Tick]:
    words = tick_words(values)
    return [(quantity.to_si(value), said) for value, said in zip(values, words, strict=True)]


def _decades(axis: Axis, most: int) -> list[float]:
    """List powers of ten in the unit of the field: all of a few, each second, third ... of many."""
    low, high = (math.log10(axis.quantity.to_field(end)) for end in (axis.low, axis.high))
    first, last = math.ceil(low - 1e-9), math.floor(high + 1e-9)
    step = max(1, math.ceil((last - first + 1) / most))
    return [axis.quantity.to_si(10.0**power) for power in range(last, first - 1, -step)]


def _power(value: float) -> str:
    if value <= 0.0:
        return "0"
    power = round(math.log10(value))
    return "1" if power == 0 else f"10{str(power).translate(_POWERS)}"


def ticks(low: float, high: float, most: int = 6) -> list[float]:
    """List round values in a range, at most so many: multiples of 1, 2 or 5 times a power of ten.

    `most` is at least 2.
    """
    if not high > low:
        return [low]
    raw = (high - low) / most
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(each * power for each in (1, 2, 5, 10, 20) if each * power >= raw * (1 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [step * index for index in range(first, last + 1)]


def tick_words(values: Sequence[float]) -> list[str]:
    """Write round values, all with the digits that the finest step needs."""
    step = values[1] - values[0] if len(values) > 1 else abs(values[0]) if values else 1.0
    digits = max(0, -math.floor(math.log10(step or 1.0) + 1e-9))
    return [f"{round(value, digits) + 0.0:.{digits}f}" for value in values]


WIDTH = 640.0
"""Of every figure, in its own units."""
_TYPE = 19.0
"""Largest type in a figure (style.css, on phones), in its units."""
_LETTER = 0.66
"""Mean width of a letter over the type, in the widest fonts that pages are read in."""
_TALL, _TALLEST = 300.0, 440.0
"""Height of a frame, and the greatest of one that is to scale."""
_ROW = 46.0
"""Room above a frame for the title of its upright axis."""
_SECOND = 44.0
"""Room above that for another reading of the axis across."""
_FOOT = 64.0
"""Room below a frame for the values along it and their title."""
_ARROW, _HEAD = 7.0, 11.0
"""Length of the heads of a dimension and of an arrow."""


class Shape(NamedTuple):
    """One SVG element: its tag, its attributes and the text in it."""

    tag: str
    attributes: tuple[tuple[str, str], ...]
    text: str = ""


@dataclass(frozen=True)
class Figure:
    """A drawing: shapes from the back to the front; points answer to the pointer and the keys."""

    key: str
    title: str
    height: float
    shapes: tuple[Shape, ...]
    points: tuple[Point, ...]
    """Places in the figure's units."""
    legend: tuple[tuple[Shape, str], ...]
    """Samples of 30 by 20 units, and what they are."""
    notes: tuple[str, ...]
    width: float = WIDTH


class Frame(NamedTuple):
    """Where the axes of a chart are in a figure: its edges, in units of the figure."""

    x: Axis
    y: Axis
    left: float
    right: float
    top: float
    bottom: float

    def across(self, x: float) -> float:
        """Place a value of x."""
        return self.left + (self.right - self.left) * self.x.place(x)

    def up(self, y: float) -> float:
        """Place a value of y."""
        return self.bottom - (self.bottom - self.top) * self.y.place(y)

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Place a point."""
        return self.across(x), self.up(y)


def svg(chart: Chart) -> Figure:
    """Draw a chart; room for words is that of the widest font that a reader may have."""
    frame, values = _frame(chart)
    shapes = [
        *(_area(area, frame) for area in chart.areas),
        *_axes(chart, frame, values),
        *(each for level in chart.levels for each in _level(level, frame)),
        *(each for series in chart.series for each in _series(series, frame)),
        *(each for dimension in chart.dimensions for each in _dimension(dimension, frame)),
        *(each for arrow in chart.arrows for each in _arrow(arrow, frame)),
        *(_mark(mark, frame) for mark in chart.marks),
    ]
    return Figure(
        chart.name,
        chart.title,
        frame.bottom + _FOOT,
        tuple(shapes),
        tuple(Point(*frame.at(x, y), said) for x, y, said in chart.points),
        tuple((_sample(role), label) for role, label in legend(chart)),
        chart.notes,
    )


def breadth(words: str) -> float:
    """Return the room that words in a row need in any font, in units of the figure."""
    return _TYPE * _LETTER * len(words)


# ------------------------------------------------------------------ the frame and its axes


def _frame(chart: Chart) -> tuple[Frame, dict[str, list[Tick]]]:
    """Find a frame with room around it for the values along its edges; return both."""
    x, y = chart.x, chart.y
    low, high = y.within or (y.low, y.high)
    room = (min(chart.share * WIDTH, _TALLEST) or _TALL) * (high - low) / (y.high - y.low)
    most = max(2, min(6, int(room / 36.0)))
    beside = tick_marks(y, most), scale_ticks(y, most)
    left, right = (12.0 + max((breadth(said) for _, said in side), default=18.0) for side in beside)
    wide, tall = WIDTH - left - right, _TALL
    if chart.share:
        tall = min(wide * chart.share, _TALLEST)
        left, wide = left + 0.5 * (wide - tall / chart.share), tall / chart.share
    top = _ROW + (_SECOND if x.second else 0.0)
    along = max(2, min(6, int(wide / 80.0)))
    frame = Frame(x, y, left, left + wide, top, top + tall)
    values = {"below": tick_marks(x, along), "left": beside[0]}
    return frame, values | {"above": scale_ticks(x, along), "right": beside[1]}


def _axes(chart: Chart, frame: Frame, values: dict[str, list[Tick]]) -> Iterator[Shape]:
    _, _, left, right, top, bottom = frame
    has_grid = chart.to_scale is None
    for value, words in values["below"]:
        x = frame.across(value)
        if has_grid:
            yield line("grid", x, top, x, bottom)
        yield line("thin", x, bottom, x, bottom + 5)
        yield text(words, x, bottom + 27, style="tick")
    for value, words in values["left"]:
        y = frame.up(value)
        if has_grid:
            yield line("grid", left, y, right, y)
        yield line("thin", left - 5, y, left, y)
        yield text(words, left - 8, y + 5, anchor="end", style="tick")
    for value, words in values["right"]:
        y = frame.up(value)
        yield line("thin", right, y, right + 5, y)
        yield text(words, right + 8, y + 5, anchor="start", style="tick")
    for value, words in values["above"]:
        x = frame.across(value)
        yield line("thin", x, top - 5, x, top)
        yield text(words, x, top - 10, style="tick")
    yield shape("rect", "frame", x=left, y=top, width=right - left, height=bottom - top)
    yield from _titles(chart, frame)


def _titles(chart: Chart, frame: Frame) -> Iterator[Shape]:
    """Write what the values are, in rows of their own: turned words may be too long."""
    middle = (frame.left + frame.right) / 2
    below = axis_title(chart.x)
    yield text(below, _inside(middle, below), frame.bottom + 52, style="axis")
    row = frame.top - (_SECOND if chart.x.second else 0.0) - 22.0
    yield text(axis_title(chart.y), 2, row, anchor="start", style="axis")
    if chart.y.second:
        right = axis_title(chart.y.second)
        yield text(right, WIDTH - 2, row, anchor="end", style="axis")
    if chart.x.second:
        above = axis_title(chart.x.second)
        yield text(above, _inside(middle, above), frame.top - 36.0, style="axis")


def _inside(x: float, words: str) -> float:
    """Move the middle of words so that they are on the paper."""
    half = breadth(words) / 2
    return min(max(x, half), max(WIDTH - half, half))


# ------------------------------------------------------------------ what is drawn


def _area(area: Area, frame: Frame) -> Shape:
    def up(value: float) -> float:
        return frame.up(frame.y.clip(value))

    if area.x:
        around = zip((*area.x, *area.x[::-1]), (*area.high, *area.low[::-1]), strict=True)
        return path(area.role, [(frame.across(x), up(z)) for x, z in around], tag="polygon")
    low, high, wide = up(area.low[0]), up(area.high[0]), frame.right - frame.left
    return shape("rect", area.role, x=frame.left, y=high, width=wide, height=low - high)


def _level(level: Level, frame: Frame) -> Iterator[Shape]:
    (left, low), (right, high) = (frame.at(*end) for end in level.ends(frame.x, frame.y))
    yield line(level.role, left, high, right, low)
    if level.share is not None:
        y = low + level.share * (high - low)
        yield _sign("event", left, y)
        yield text(level.words, left, y + 5, style="tick")
    elif level.words and right - left > breadth(level.words):
        yield text(level.words, (left + right) / 2, low + 17, style="tick halo")


def _series(series: Series, frame: Frame) -> Iterator[Shape]:
    """Draw a line, or signs at its places; nothing where a value is not known."""
    places: list[tuple[float, float]] = []
    sign = LOOKS[series.role].sign
    for x, y in zip(series.x, series.y, strict=True):
        if math.isnan(y):
            if places:
                yield path(series.role, places)
            places = []
        elif sign:
            yield _sign(series.role, *frame.at(x, y))
        else:
            places.append(frame.at(x, y))
    if places:
        yield path(series.role, places)


def _mark(mark: Mark, frame: Frame) -> Shape:
    x, y = frame.at(mark.x, mark.y)
    if LOOKS[mark.role].sign == "words":
        style = mark.role if mark.role == "beside" else f"{mark.role} beside"
        return text(mark.words, _inside(x, mark.words), y + 5, style=style)
    return _sign(mark.role, x, y)


def _sign(role: str, x: float, y: float, most: float = math.inf) -> Shape:
    """Draw the sign of a role at a place, no larger than is said."""
    look = LOOKS[role]
    size = min(look.size, most)
    if look.sign == "circle":
        return shape("circle", role, cx=x, cy=y, r=size)
    places = [(x + size * across, y + size * up) for across, up in SIGNS[look.sign]["corners"]]
    return path(role, places, tag="polygon")


def _sample(role: str) -> Shape:
    """Draw what a role looks like, in 30 by 20 units."""
    look = LOOKS[role]
    if look.sign:
        return _sign(role, 15.0, 10.0, 8.0)
    if look.stroke:
        return line(role, 1.0, 10.0, 29.0, 10.0)
    return shape("rect", role, x=1.0, y=3.0, width=28.0, height=14.0)


def _dimension(dimension: Dimension, frame: Frame) -> Iterator[Shape]:
    (x1, y1), (x2, y2) = frame.at(*dimension.start), frame.at(*dimension.end)
    for place in dimension.measured:
        x, y = frame.at(*place)
        if x1 == x2:
            yield line("thin", x, y, x1 + math.copysign(5.0, x1 - x), y)
        else:
            yield line("thin", x, y, x, y1 + 5.0)
    yield line("dimension", x1, y1, x2, y2)
    length = math.hypot(x2 - x1, y2 - y1)
    if length > 3 * _ARROW:
        for (x, y), (ox, oy) in (((x1, y1), (x2, y2)), ((x2, y2), (x1, y1))):
            yield _head("arrow-head", (x, y), (x - ox, y - oy), _ARROW)
    words = dimension.words
    if x1 != x2:
        yield text(words, _inside((x1 + x2) / 2, words), y1 - 6, style="measure")
    elif length > breadth(words):
        beside = x1 - 6 if x1 - 6 - _TYPE > frame.left else x1 + _TYPE
        yield text(words, beside, (y1 + y2) / 2, style="measure", turn=-90)
    elif x1 > (frame.left + frame.right) / 2:
        # From the edge of the frame inwards, so that large type stays inside.
        yield text(words, frame.right - 4, min(y1, y2) - 14, anchor="end", style="measure")
    else:
        left = x1 - 14 if dimension.measured else frame.left + 4
        yield text(words, left, min(y1, y2) - 14, anchor="start", style="measure")


def _arrow(arrow: Arrow, frame: Frame) -> Iterator[Shape]:
    (x1, y1), (x2, y2) = frame.at(*arrow.start), frame.at(*arrow.end)
    length = math.hypot(x2 - x1, y2 - y1)
    if length == 0.0:
        return
    head = min(_HEAD, length)
    share = 1.0 - head / length
    yield line(arrow.role, x1, y1, x1 + share * (x2 - x1), y1 + share * (y2 - y1))
    yield _head(f"{arrow.role}-head", (x2, y2), (x2 - x1, y2 - y1), head)


def _head(role: str, tip: tuple[float, float], towards: tuple[float, float], size: float) -> Shape:
    length = math.hypot(*towards)
    ux, uy = towards[0] / length, towards[1] / length
    x, y = tip[0] - size * ux, tip[1] - size * uy
    side = 0.45 * size
    places = [tip, (x - side * uy, y + side * ux), (x + side * uy, y - side * ux)]
    return path(role, places, tag="polygon")


# ------------------------------------------------------------------ elements


def number(value: float) -> str:
    """Write a coordinate: a hundredth of a unit is finer than any screen."""
    return f"{round(value, 2) + 0.0:g}" if abs(value) < 1e4 else f"{value:.0f}"


def shape(tag: str, style: str, words: str = "", **attributes: float | str) -> Shape:
    """Make a shape of a class; coordinates may be numbers."""
    given = (
        (key.replace("_", "-"), value if isinstance(value, str) else number(value))
        for key, value in attributes.items()
    )
    return Shape(tag, (("class", style), *given), words)


def path(style: str, places: Iterable[tuple[float, float]], *, tag: str = "polyline") -> Shape:
    """Make a line through places, or a polygon."""
    return shape(tag, style, points=" ".join(f"{number(x)},{number(y)}" for x, y in places))


def line(style: str, x1: float, y1: float, x2: float, y2: float) -> Shape:
    """Make a straight line."""
    return shape("line", style, x1=x1, y1=y1, x2=x2, y2=y2)


def text(
    words: str, x: float, y: float, *, anchor: str = "middle", style: str = "", turn: float = 0.0
) -> Shape:
    """Write words at a place, turned by some degrees."""
    turned = {"transform": f"rotate({number(turn)} {number(x)} {number(y)})"} if turn else {}
    return shape("text", style, words, x=x, y=y, text_anchor=anchor, **turned)
