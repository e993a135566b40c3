"""A sizing to scale: the line with what it holds, its swing from above, and the lines to choose."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.figures.chart import Area, Chart, Mark, Point, Series, axis, pointed, span_of
from catopt.figures.line import Failing, line_in_water
from catopt.words import Measure, Message, term

if TYPE_CHECKING:
    from catopt.loads.buoy_shape import BuoyShape
    from catopt.sizing import Sizing
    from catopt.sizing.in_motion import InMotion

__all__ = ["choices", "elevation", "swing_circle", "tension_by_length"]

_ROUND = 72
"""Places of a circle."""
_OF_SHIP = (-0.5, -0.5, 0.3, 0.42, 0.5), (0.42, 0.5, 0.5, 0.3, 0.0)
"""Half of a hull from above: along it over its length, and beside it over its breadth."""


def elevation(of: Sizing, failing: Sequence[Failing] = ()) -> Chart:
    """Draw the line of the largest tension, with the buoy or the bow of the ship that it holds."""
    name, solution = of.hardest
    state = next(each for each in of.case.load_cases if each.name == name)
    depth = of.case.site.water_depth + state.water_level
    drawn = line_in_water(solution, depth, failing)
    x, z = solution.span, solution.fairlead_height
    shape = of.shape
    body = tuple(_bow(of, x, z, drawn.x.high)) if shape is None else tuple(_hull(shape, x, z))
    top = max((*(each for area in body for each in area.high), drawn.y.high))
    return replace(drawn, areas=(*drawn.areas, *body), y=replace(drawn.y, high=top))


def swing_circle(of: Sizing) -> Chart:
    """Draw from above how far what is moored swings round its anchor, to scale."""
    total, (_, line) = of.swing.total, of.swing.parts[0]
    around = [2.0 * math.pi * each / _ROUND for each in range(_ROUND + 1)]
    edge = [(total * math.cos(each), total * math.sin(each)) for each in around]
    x, y = zip(*edge, strict=True)
    ends = (-1.12 * total, 1.12 * total)
    length, breadth = _size(of)
    middle = total - length / 2.0 if of.kind == "tanker" else total
    series = [
        Series("swing", x, y, Message("figures.swing_of", radius=Measure("length", total))),
        Series("leg", (0.0, min(line, total)), (0.0, 0.0), Message("figures.mooring_line")),
    ]
    if of.kind == "tanker" and len(of.swing.parts) > 2:
        series.append(Series("arm", (line, total - length), (0.0, 0.0), Message("sizing.hawser")))
    return Chart(
        "swing",
        Message("figures.swing", radius=Measure("length", total)),
        axis("x", ends, Message("figures.from_anchor_east")),
        axis("x", ends, Message("figures.from_anchor_north")),
        tuple(series),
        (Mark("anchor-spot", 0.0, 0.0, Message("figures.anchor_spot")),),
        areas=(_from_above(of, middle, length, breadth),),
        points=_said_round(edge, total),
        to_scale=1.0,
    )


def choices(of: Sizing) -> tuple[Chart, tuple[dict[str, str], ...]]:
    """Draw the lines between which one chooses, by swing radius and mass.

    Also what an input has to be for each of them, in the order of the points.
    """
    own = of.point
    said: list[Point] = []
    sets: list[dict[str, str]] = []
    marks: list[Mark] = []
    for prefer, settled, swing in (
        *((each.prefer, each.settled, each.swing) for each in of.alternatives),
        (of.settled.choice.looks_for, of.settled, of.swing.total),
    ):
        if settled is None:
            continue
        is_own = settled.point is own
        mass = settled.point.line.mass or 0.0
        role = "recommended" if is_own else "design"
        marks.append(Mark(role, swing, mass, Message(f"figures.choice_{role}")))
        words = Message(
            "figures.choice",
            prefer=term(prefer),
            chain=settled.point.line.segments[0].name,
            length=Measure("length", settled.point.line.length),
            swing=Measure("length", swing),
            mass=Measure("mass", mass),
        )
        said.append(Point(swing, mass, words))
        sets.append({"line.prefer": prefer})
    drawn = Chart(
        "choices",
        Message("figures.choices"),
        axis(
            "length",
            span_of([each.x for each in marks], 0.2, 0.2),
            term("Swing radius at low water"),
        ),
        axis("mass", span_of([each.y for each in marks], 0.2, 0.2), term("Mass in air")),
        marks=tuple(marks),
        points=tuple(said),
    )
    return drawn, tuple(sets)


def tension_by_length(of: InMotion) -> Chart:
    """Draw the tension in the storm, with its interval, and that at rest, by the line's length."""
    runs = [(each.tried.length, each.storm) for each in of.by_length if each.storm is not None]
    lengths = [length for length, _ in runs]
    storms = [storm for _, storm in runs]
    probable = [storm.tension for storm in storms]
    low = [storm.tension if storm.low is None else storm.low for storm in storms]
    high = [storm.tension if storm.high is None else storm.high for storm in storms]
    own = of.case.line.length
    return Chart(
        "by_length",
        Message("figures.by_length"),
        axis("length", span_of(lengths, 0.05, 0.05)),
        axis("tension", (0.0, 1.06 * max(high, default=1.0)), Message("figures.fairlead_tension")),
        series=(
            Series("first", lengths, probable, Message("figures.in_storm")),
            Series("peak", lengths, probable),
            Series("second", lengths, [each.at_rest for each in storms], Message("figures.steady")),
        ),
        marks=tuple(
            Mark("recommended", own, tension, Message("figures.choice_recommended"))
            for length, tension in zip(lengths, probable, strict=True)
            if length == own
        ),
        areas=(Area("between", low, high, lengths, Message("figures.storm_interval")),),
        points=pointed(
            "figures.at_length",
            lengths,
            probable,
            length=("length", lengths),
            tension=("tension", probable),
        ),
    )


def _read(of: Sizing) -> dict[str, object]:
    return {each.of.name: each.value for each in of.inputs}


def _size(of: Sizing) -> tuple[float, float]:
    """Length and breadth from above, m; a buoy of no shape is drawn as a tenth of its line."""
    read = _read(of)
    if of.kind == "tanker":
        length = of.swing.parts[-1][1]
        return length, float(str(read.get("breadth", 0.15 * length)))
    shape = of.shape
    width = 0.06 * of.swing.total if shape is None else shape.widest
    return width, width


def _hull(shape: BuoyShape, x: float, eye: float) -> Iterator[Area]:
    """Stand a buoy on the end of its line: truncated cones of the hull, then the tower."""
    label: str = Message("figures.moored_buoy")
    for foot, each in shape.parts:
        low, high = eye - shape.eye + foot, eye - shape.eye + foot + each.height
        narrow, wide = sorted((each.lower / 2.0, each.upper / 2.0))
        corners = (x - wide, x - narrow, x + narrow, x + wide)
        slope, flat = (high, low, low, high), (low, high, high, low)
        lows, highs = (slope, (high,) * 4) if each.upper > each.lower else ((low,) * 4, flat)
        yield Area("moored", lows, highs, corners, label)


def _bow(of: Sizing, x: float, deck: float, edge: float) -> Iterator[Area]:
    """Draw as much of a ship, or of the buoy that she lies to, as the drawing has room for."""
    read = _read(of)
    if of.kind != "tanker" or read.get("buoy") is not None:
        return
    moulded = float(str(read.get("moulded_depth") or 0.0))
    if not moulded:
        return
    end, low, high = min(edge, x + of.swing.parts[-1][1]), max(deck - moulded, 0.0), deck
    yield Area(
        "moored", (high, low, low), (high,) * 3, (x, x + min(0.4 * moulded, end - x), end),
        Message("figures.moored_ship"),
    )  # fmt: skip


def _from_above(of: Sizing, middle: float, length: float, breadth: float) -> Area:
    label = Message("figures.moored_ship" if of.kind == "tanker" else "figures.moored_buoy")
    if of.kind == "tanker":
        along, beside = _OF_SHIP
        # The bow points to the anchor.
        x = [middle - length * each for each in reversed(along)]
        half = [breadth * each for each in reversed(beside)]
    else:
        angles = [math.pi * each / 12 for each in range(13)]
        x = [middle - 0.5 * length * math.cos(each) for each in angles]
        half = [0.5 * breadth * math.sin(each) for each in angles]
    return Area("moored", [-each for each in half], half, x, label)


def _said_round(edge: Sequence[tuple[float, float]], total: float) -> tuple[Point, ...]:
    said = Message("figures.swing_at", radius=Measure("length", total))
    return tuple(Point(x, y, said) for x, y in edge)
