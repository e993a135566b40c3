"""Several lines, or several models of a moored body, in one drawing; the members of a study."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import cycle
from typing import TYPE_CHECKING

import numpy as np

from catopt.figures.chart import Area, Axis, Chart, Level, Mark, Place, Series, axis, span_of
from catopt.figures.line import room_around, surface_and_bed, water
from catopt.figures.mooring import beyond, from_above, numbered, size_of
from catopt.quantities import Quantity
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.reproduce.items import Mooring
    from catopt.study.result import Statistic, StudyResult

_LINES = ("mooring", "second", "first", "third", "fourth")
_MODELS = (("second", "model-a"), ("first", "model-b"))
"""Role of the lines and of the body of each model."""
_ZOOM = 1.6
"""How far the view round the body reaches, over its largest offset."""


def lines_to_scale(lines: Sequence[tuple[str, Solution]], depth: float, title: str = "") -> Chart:
    """Draw lines by their names from one anchor, to scale, in water of a depth (m)."""
    right = max(solution.span for _, solution in lines)
    top = max(depth, *(solution.fairlead_height for _, solution in lines))
    unit = room_around(right, top)
    series, marks = [], []
    for (name, solution), role in zip(lines, cycle(_LINES), strict=False):
        profile = solution.profile(401)
        series.append(Series(role, profile.x, profile.z, name))
        marks.append(Mark("anchor", 0.0, profile.z[0]))
        marks.append(Mark("fairlead", solution.span, solution.fairlead_height))
        marks += [Mark("clump", load.x, load.z) for load in solution.point_loads]
    return Chart(
        "lines",
        title or Message("figures.lines"),
        axis("x", (-30.0 * unit, right + 30.0 * unit), within=(0.0, right)),
        axis("z", (-24.0 * unit, top + 30.0 * unit), within=(0.0, top)),
        series=tuple(series),
        marks=tuple(dict.fromkeys(marks)),
        levels=surface_and_bed(depth),
        areas=water(depth, math.inf),
        to_scale=1.0,
    )


def models_from_above(moorings: Sequence[Mooring]) -> Chart:
    """Draw the lines of a body by several models from above, to scale."""
    places = [(line.x[k], line.y[k]) for one in moorings for line in one.lines for k in (0, -1)]
    size = size_of(places)
    anchors = [(line.x[0], line.y[0]) for line in moorings[0].lines]
    numbers = numbered(beyond(anchors, 1.6 * size))
    axes = from_above(places, 0.15 * size)
    return _models("models", Message("figures.models"), axes, moorings, numbers)


def models_near(moorings: Sequence[Mooring]) -> Chart:
    """Draw the surroundings of the body larger."""
    ends = [(line.x[-1], line.y[-1]) for each in moorings for line in each.lines]
    reach = _ZOOM * max(math.hypot(*end) for end in ends)
    corners: list[Place] = [(-reach, -0.75 * reach), (0.5 * reach, 0.75 * reach)]
    axes = from_above(corners, 0.0)
    return _models("models_near", Message("figures.round_body"), axes, moorings)


def _models(
    name: str,
    title: str,
    axes: tuple[Axis, Axis],
    moorings: Sequence[Mooring],
    numbers: Sequence[Mark] = (),
) -> Chart:
    """Draw the lines and the body of each model from above."""
    series, marks = [], [Mark("neutral", 0.0, 0.0, Message("figures.neutral"))]
    for mooring, (role, body) in zip(moorings, cycle(_MODELS), strict=False):
        series += [Series(role, line.x, line.y, mooring.name) for line in mooring.lines]
        marks.append(Mark(body, mooring.lines[0].x[-1], mooring.lines[0].y[-1]))
    return Chart(name, title, *axes, tuple(series), (*marks, *numbers), to_scale=1.0)


def models_from_the_side(moorings: Sequence[Mooring], number: int) -> Chart:
    """Draw one line (counted from 0) from the side by every model, heights magnified."""
    series, marks = [], []
    for mooring, (role, body) in zip(moorings, cycle(_MODELS), strict=False):
        line = mooring.lines[number]
        # Horizontal distances of a line's points from its anchor, m.
        x = [math.hypot(a - line.x[0], b - line.y[0]) for a, b in zip(line.x, line.y, strict=True)]
        series.append(Series(role, x, line.z, mooring.name))
        last = max(k for k, lies in enumerate(line.on_bed) if lies)
        marks.append(Mark(body, x[last], line.z[last], Message("figures.last_at_bed")))
    top = max(max(one.y) for one in series)
    return Chart(
        "elevation",
        Message("figures.elevation", line=number + 1),
        axis("x", span_of([x for one in series for x in one.x], 0.02, 0.02)),
        axis("z", (-0.08 * top, 1.05 * top)),
        series=tuple(series),
        marks=tuple(marks),
        levels=(Level("bed-edge", "y", 0.0, Message("figures.bed")),),
        areas=(Area("bed", (-math.inf,), (0.0,)),),
    )


_SHARE = Quantity("share", "Share", "", "-", "-", 1.0, 4)
_MOST = 400
"""Places of a curve, at equal shares and closer at its rare end."""


def share_worse(result: StudyResult, of: Statistic) -> Chart:
    """Draw the share of the members that are worse than each value of a quantity."""
    values, shares = result.values(of.kept.name), result.study.shares()
    there = np.isfinite(values) & (shares > 0.0)
    order = np.argsort(values[there] if of.kept.high_is_worse else -values[there], kind="stable")
    sorted_values, weights = values[there][order], shares[there][order]
    worse = 1.0 - np.cumsum(weights) / weights.sum() + weights / weights.sum()
    rare = float(worse.min())
    wanted = np.geomspace(1.0, rare, _MOST)
    at = np.unique(np.searchsorted(-worse, -wanted, side="right") - 1)
    x, y = sorted_values[at].tolist(), worse[at].tolist()
    key = "worse_above" if of.kept.high_is_worse else "worse_below"
    limits = [] if of.limit is None else [of.limit]
    return Chart(
        "study",
        Message("study.exceedance"),
        Axis(of.kept.words, replace(of.kept.measure, symbol=""), *span_of([*x, *limits])),
        Axis(Message(f"study.{key}"), _SHARE, 0.6 * rare, 1.4, foot=0.6 * rare),
        series=(Series("first", x, y, Message(f"study.{key}")),),
        levels=tuple(Level("capacity", "x", each, Message("study.limit")) for each in limits),
    )
