"""The description of a drawing: values in SI, roles and words."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any, NamedTuple

from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Measure, Message, quantity_name

Place = tuple[float, float]
"""x and y, SI."""


@dataclass(frozen=True)
class Scale:
    """Another reading of an axis, in its own unit, from where it is 0 (SI)."""

    label: str
    quantity: Quantity
    zero: float = 0.0


IN_TONNES = Scale("", QUANTITIES["tension"].in_units("tf"))
"""A force in tf, beside kN."""


@dataclass(frozen=True)
class Axis:
    """What is drawn along a direction: its name without unit, and its ends; all in SI."""

    label: str
    quantity: Quantity
    low: float
    high: float
    foot: float | None = None
    """Makes the axis logarithmic; the value at which an exact 0 is drawn, 0 where there is none."""
    ticks: tuple[float, ...] = ()
    """Values that are written; round ones when empty."""
    within: tuple[float, float] | None = None
    """Where round values are written when not from end to end."""
    second: Scale | None = None

    def place(self, value: float) -> float:
        """Return how far along the axis a value is: 0 at its low end, 1 at its high end."""
        if self.foot is None:
            return (value - self.low) / (self.high - self.low)
        low, high = math.log10(self.low), math.log10(self.high)
        return (math.log10(value if value > 0.0 else self.foot) - low) / (high - low)

    def clip(self, value: float) -> float:
        """Return a value, or the end that it is beyond."""
        return min(max(value, self.low), self.high)


class Series(NamedTuple):
    """A line through places, or signs at them; where y is nan there is a gap."""

    role: str
    x: Sequence[float]
    y: Sequence[float]
    label: str = ""


class Mark(NamedTuple):
    """A sign, or words, at a place."""

    role: str
    x: float
    y: float
    label: str = ""
    words: str = ""


class Level(NamedTuple):
    """A straight line at a value of the axis ``"x"`` or ``"y"``.

    It goes from `start` to `end` along the other axis, and has words at its middle; where `share`
    is given, in a circle at that part of the way.
    """

    role: str
    axis: str
    at: float
    label: str = ""
    start: float = -math.inf
    end: float = math.inf
    words: str = ""
    share: float | None = None

    def ends(self, x: Axis, y: Axis) -> tuple[Place, Place]:
        """Find where it begins and ends between the ends of two axes."""
        if self.axis == "x":
            return (self.at, y.low), (self.at, y.high)
        return (x.clip(self.start), self.at), (x.clip(self.end), self.at)


class Area(NamedTuple):
    """What is between two lines, or between two levels from end to end where x is empty."""

    role: str
    low: Sequence[float]
    high: Sequence[float]
    x: Sequence[float] = ()
    label: str = ""


class Arrow(NamedTuple):
    """An arrow."""

    role: str
    start: Place
    end: Place
    label: str = ""


class Dimension(NamedTuple):
    """A distance, across or upright; thin lines lead to the places that it is measured between."""

    start: Place
    end: Place
    words: str
    measured: tuple[Place, ...] = ()


class Point(NamedTuple):
    """A place with what is known there, for readers who point at it."""

    x: float
    y: float
    said: str


def pointed(
    key: str, x: Sequence[float], y: Sequence[float], /, **known: tuple[str, Iterable[object]]
) -> tuple[Point, ...]:
    """Say a text at places, with what is known there: each time a quantity and its values in SI.

    Where no quantity is named, values are said as they are.
    """
    values = [
        [(name, Measure(quantity, each) if quantity else each) for each in of]  # type: ignore[arg-type]
        for name, (quantity, of) in known.items()
    ]
    said = (Message(key, **dict(each)) for each in zip(*values, strict=True))
    return tuple(map(Point, x, y, said))


@dataclass(frozen=True)
class Chart:
    """A drawing, by its key within a page or of a file, with what else is to be said of it.

    What is in it has a role, of which a renderer knows the look, and a label for the legend if it
    is to be there; all values are in SI.
    """

    name: str
    title: str
    x: Axis
    y: Axis
    series: tuple[Series, ...] = ()
    marks: tuple[Mark, ...] = ()
    levels: tuple[Level, ...] = ()
    areas: tuple[Area, ...] = ()
    arrows: tuple[Arrow, ...] = ()
    dimensions: tuple[Dimension, ...] = ()
    points: tuple[Point, ...] = ()
    notes: tuple[str, ...] = ()
    to_scale: float | None = None
    """A metre up over a metre along, on paper; None: each axis fills the frame."""

    @property
    def share(self) -> float:
        """Height over width of a frame that is to scale, 0 of any other."""
        return (self.to_scale or 0.0) * (self.y.high - self.y.low) / (self.x.high - self.x.low)


class Film(NamedTuple):
    """Moments of a scene as numbers to be drawn to scale, m, kN and s, rounded to what is seen."""

    title: str
    left: float  # least x, m
    wide: float  # m
    top: float  # height of the drawing above the bed, m
    worst: int  # moment that is shown first
    values: dict[str, list[Any]]


def legend(chart: Chart) -> Iterator[tuple[str, str]]:
    """Yield role and label of what is named in a chart, each once."""
    named: Iterable[Series | Level | Area | Mark | Arrow] = chain(
        chart.series, chart.levels, chart.areas, chart.marks, chart.arrows
    )
    yield from dict.fromkeys((each.role, each.label) for each in named if each.label)


def span_of(values: Iterable[float], below: float = 0.06, above: float = 0.06) -> Place:
    """Find ends of an axis that hold values with room around them, as parts of their range.

    Values that are not finite do not count.
    """
    known = [each for each in values if math.isfinite(each)]
    low, high = min(known, default=0.0), max(known, default=0.0)
    size = high - low or 0.8 * abs(high) or 1.0
    return low - below * size, high + above * size


def axis(key: str, ends: Place, label: str = "", **more: Any) -> Axis:
    """Make an axis of a quantity of the table; its name and symbol when no label is given."""
    quantity = QUANTITIES[key]
    if not label and quantity.symbol:
        label = Message("figures.label", name=quantity_name(key), symbol=quantity.symbol)
    return Axis(label or quantity_name(key), quantity, *ends, **more)
