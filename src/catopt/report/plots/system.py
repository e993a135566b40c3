"""Figures of a moored body: plan, watch circle and restoring curves."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from catopt.quantities import QUANTITIES
from catopt.report.plots.common import (
    BLUE,
    GREEN,
    ORANGE,
    PURPLE,
    SIZE,
    STYLE,
    blank,
    folded,
    legend_below,
    set_title,
)
from catopt.report.tables.summary import named
from catopt.report.tables.system import LARGEST, OFFSET

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.projections.polar import PolarAxes

    from catopt.mooring.case import SystemReport
    from catopt.mooring.restoring import RestoringCurve
    from catopt.mooring.solution import LegState
    from catopt.mooring.watch_circle import WatchCircle

__all__ = ["plan", "restoring", "watch_circle"]

_DASHES: tuple[tuple[str, tuple[float, ...]], ...] = (
    (BLUE, ()),
    (ORANGE, (6, 2)),
    (GREEN, (2, 2)),
    (PURPLE, (6, 2, 2, 2)),
)


def plan(report: SystemReport) -> Figure:
    """Draw body, lines, touchdowns and anchors from above, to scale."""
    solution = report.solution
    places = [line.leg.anchor for line in solution.lines]
    places += [line.fairlead for line in solution.lines]
    width = max(x for x, _ in places) - min(x for x, _ in places)
    height = max(y for _, y in places) - min(y for _, y in places)
    share = min(max(height / max(width, 1e-9), 0.35), 1.1)
    with rc_context(STYLE):
        figure = Figure(figsize=(SIZE[0], 0.85 * SIZE[0] * share + 1.6), layout="constrained")
        FigureCanvasAgg(figure)
        axes = figure.add_subplot()
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.09)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    set_title(axes, folded(report.case.title))
    for index, line in enumerate(solution.lines):
        _line_from_above(axes, line, index)
    neutral, place = solution.neutral, solution.position
    axes.plot(neutral.x, neutral.y, "+", color=BLUE, markersize=11, label="Body without load")
    axes.plot(
        place.x,
        place.y,
        "o",
        markerfacecolor="white",
        markeredgecolor="black",
        markersize=9,
        zorder=5,
        label="Body under load",
    )
    _force_arrow(report, axes, max(width, height))
    legend_below(figure, 3)
    return figure


def _line_from_above(axes: Axes, line: LegState, index: int) -> None:
    """Draw a line with its touchdown, its anchor and its number; the first names them all."""
    anchor, fairlead, touchdown = line.leg.anchor, line.fairlead, line.touchdown
    axes.plot(*zip(anchor, fairlead, strict=True), color="black", label="_" if index else "Line")
    if touchdown is not None:
        axes.plot(
            *zip(anchor, touchdown, strict=True),
            color=ORANGE,
            linewidth=3.6,
            label="_" if index else "On the bed",
        )
        axes.plot(*touchdown, "o", color="black", markersize=4, label="_" if index else "Touchdown")
    axes.plot(*anchor, "v", color="black", markersize=8, label="_" if index else "Anchor")
    away = math.atan2(anchor[1], anchor[0])
    axes.annotate(
        str(index + 1),
        anchor,
        xytext=(13.0 * math.cos(away), 13.0 * math.sin(away)),
        textcoords="offset points",
        ha="center",
        va="center",
    )


def _force_arrow(report: SystemReport, axes: Axes, size: float) -> None:
    """Draw the direction of the force, from the body."""
    x, y = report.solution.system.force
    force = math.hypot(x, y)
    if force == 0.0:
        return
    place = report.solution.position
    reach = 0.17 * size / force
    axes.annotate(
        "",
        (place.x + reach * x, place.y + reach * y),
        xytext=(place.x, place.y),
        arrowprops={"arrowstyle": "-|>", "color": PURPLE, "linewidth": 2.2},
        zorder=4,
    )
    text = QUANTITIES["horizontal_force"].format(force, unit=True, digits=0)
    axes.annotate(
        text,
        (place.x + 1.1 * reach * x, place.y + 1.1 * reach * y),
        ha="right" if x < 0.0 else "left",
        va="center" if abs(x) > abs(y) else ("bottom" if y > 0.0 else "top"),
        color=PURPLE,
    )


def watch_circle(circle: WatchCircle, title: str) -> Figure:
    """Draw where a force from all sides takes the body, and the largest tension on the way."""
    with rc_context(STYLE):
        figure = Figure(figsize=(SIZE[0], 4.3), layout="constrained")
        FigureCanvasAgg(figure)
        offsets: PolarAxes = figure.add_subplot(1, 2, 1, projection="polar")  # type: ignore[assignment]
        tensions: PolarAxes = figure.add_subplot(1, 2, 2, projection="polar")  # type: ignore[assignment]
    force = QUANTITIES["horizontal_force"].format(circle.force, unit=True, digits=0)
    figure.suptitle(
        folded(
            f"{title}: a force of {force} from all sides" if title else f"{force} from all sides"
        ),
        fontsize=11,
        parse_math=False,
    )
    x, y = circle.neutral
    goes = [math.atan2(each.y - y, each.x - x) for each in circle.responses]
    _polar(offsets, goes, [OFFSET.to_field(r.offset) for r in circle.responses], BLUE)
    _polar(
        tensions,
        circle.directions,
        [LARGEST.to_field(r.largest_tension) for r in circle.responses],
        ORANGE,
    )
    offsets.set_title(OFFSET.heading, fontsize=10)
    tensions.set_title(LARGEST.heading, fontsize=10)
    for line in circle.system.legs:
        for axes in (offsets, tensions):
            top = axes.get_ylim()[1]
            axes.plot([line.azimuth], [top], "v", color="black", markersize=6, clip_on=False)
    figure.text(
        0.5,
        0.015,
        "Left: where the body goes. Right: over the direction in which the force acts. "
        "Triangles: the lines.",
        ha="center",
        fontsize=9,
    )
    figure.set_layout_engine("constrained", rect=(0.0, 0.06, 1.0, 0.94))
    return figure


def _polar(axes: PolarAxes, around: Sequence[float], values: Sequence[float], colour: str) -> None:
    closed = [*around, around[0]], [*values, values[0]]
    axes.plot(*closed, color=colour)
    axes.fill(*closed, color=colour, alpha=0.12)
    axes.set_ylim(0.0, 1.12 * max(values) if max(values) > 0.0 else 1.0)
    axes.set_rlabel_position(80.0)
    axes.tick_params(labelsize=8)
    axes.yaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 2.5, 5, 10], prune="lower"))
    for label in axes.get_yticklabels():
        label.set_bbox({"facecolor": "white", "alpha": 0.75, "edgecolor": "none", "pad": 0.6})


def restoring(curves: Sequence[RestoringCurve], title: str) -> Figure:
    """Draw the force that holds the body over its offset, a curve for each direction."""
    figure, axes = blank(SIZE, OFFSET, named("horizontal_force", "Force along the direction", ""))
    force = QUANTITIES["horizontal_force"]
    for number, curve in enumerate(curves):
        colour, dashes = _DASHES[number % len(_DASHES)]
        label = f"{QUANTITIES['angle'].format(curve.direction, digits=1)} deg"
        axes.plot(
            [OFFSET.to_field(value) for value in curve.offset],
            [force.to_field(value) for value in curve.force],
            color=colour,
            dashes=dashes or (None, None),
            label=label,
        )
    axes.axhline(0.0, color="black", linewidth=0.8)
    axes.axvline(0.0, color="black", linewidth=0.8)
    set_title(axes, folded(title))
    legend_below(figure, 4)
    return figure
