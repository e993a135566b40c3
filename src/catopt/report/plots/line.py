"""Figures for print: black on white, told apart by shape and dash as well as by colour.

Nothing here touches pyplot, so that no window, backend or global figure list is involved.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from textwrap import wrap
from typing import TYPE_CHECKING

from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.plots.common import (
    BELOW,
    BLUE,
    GREEN,
    LEFT,
    ORANGE,
    PURPLE,
    RIGHT,
    SIZE,
    STYLE,
    blank,
    folded,
    label_axes,
    legend_below,
    second_force_axis,
    set_title,
    water_and_bed,
)
from catopt.report.tables.load_curve import FAIRLEAD_TENSION, FORCE, OFFSET, SPAN
from catopt.report.tables.summary import named

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.curve import Mark
    from catopt.catenary.solution import Solution, SwarmReport
    from catopt.catenary.stretch import Stretch

__all__ = [
    "blank_to_scale",
    "fitness",
    "line_in_water",
    "load_curve",
    "swarm_tension",
    "tension",
]

_FAR_OFF_SCALE = 2.5
"""A capacity above this many tensions is named, not drawn: it would flatten the curve."""

_CONVERGED = 1e-9
"""m: a run that ends with f below it counts as converged."""


# ------------------------------------------------------------------ the line in the water


def line_in_water(solution: Solution, water_depth: float) -> Figure:
    """Draw the line to scale between seabed and still water.

    Parameters
    ----------
    solution : Solution
        The answer.
    water_depth : float
        m.
    """
    shape = solution.profile(401)
    left, right, top = min(shape.x), max(shape.x), max(water_depth, *shape.z)
    figure, axes = blank_to_scale(left, right, top, folded(solution.title))
    water_and_bed(axes, water_depth)
    axes.plot(shape.x, shape.z, color="black", label="Line")
    _grounded_parts(axes, solution)
    _marks(axes, solution)
    legend_below(figure, 4)
    return figure


def blank_to_scale(left: float, right: float, top: float, title: str) -> tuple[Figure, Axes]:
    """Make axes of one scale both ways that hold the line with room around it.

    The frame is laid out in inches, so that neither a flat line nor a steep one squeezes the
    labels, the title or the legend.
    """
    width = SIZE[0] - LEFT - RIGHT
    share = 1.25 * top / (1.12 * (right - left)) if right > left else math.inf
    height = min(max(width * share, 2.1), 5.5)
    above = 0.15 + 0.2 * (title.count("\n") + 1)
    full = height + BELOW + above
    scale = max(1.12 * (right - left) / width, 1.25 * top / height)
    spare_x, spare_z = 0.5 * (scale * width - (right - left)), scale * height - top
    with rc_context(STYLE):
        figure = Figure(figsize=(SIZE[0], full))
        FigureCanvasAgg(figure)
        axes = figure.add_axes((LEFT / SIZE[0], BELOW / full, width / SIZE[0], height / full))
    label_axes(axes, QUANTITIES["x"], QUANTITIES["z"])
    axes.set_xlim(left - spare_x, right + spare_x)
    axes.set_ylim(-0.4 * spare_z, top + 0.6 * spare_z)
    set_title(axes, title)
    return figure, axes


def _ends(solution: Solution) -> list[tuple[Stretch, float]]:
    """Pair each stretch with the x of its upper end."""
    starts = [stretch.x for stretch in solution.stretches]
    return list(zip(solution.stretches, [*starts[1:], solution.span], strict=True))


def _grounded_parts(axes: Axes, solution: Solution) -> None:
    label = "On the bed"
    for stretch, end in _ends(solution):
        if stretch.on_bed and stretch.length > 0.0:
            axes.plot([stretch.x, end], [0.0, 0.0], color=ORANGE, linewidth=3.6, label=label)
            label = "_"


def _touchdowns(solution: Solution) -> list[tuple[float, float]]:
    """Find where the line leaves the bed: x and s."""
    real = [stretch for stretch in solution.stretches if stretch.length > 0.0]
    return [
        (upper.x, upper.start) for lower, upper in pairwise(real) if lower.on_bed != upper.on_bed
    ]


def _marks(axes: Axes, solution: Solution) -> None:
    def mark(places: Sequence[tuple[float, float]], marker: str, colour: str, label: str) -> None:
        if places:
            axes.plot(
                [x for x, _ in places],
                [z for _, z in places],
                linestyle="none",
                marker=marker,
                markersize=8,
                markerfacecolor=colour,
                markeredgecolor="black",
                clip_on=False,
                zorder=5,
                label=label,
            )

    weights = {load.position: load.submerged_weight for load in solution.line.point_loads}
    heavy = [load for load in solution.point_loads if weights[load.position] >= 0.0]
    light = [load for load in solution.point_loads if weights[load.position] < 0.0]
    mark([(x, 0.0) for x, _ in _touchdowns(solution)], "|", "black", "Touchdown")
    mark([(0.0, solution.anchor_height)], "v", "black", "Anchor")
    mark([(solution.span, solution.fairlead_height)], "o", "white", "Fairlead")
    mark([(load.x, load.z) for load in heavy], "s", PURPLE, "Clump weight")
    mark([(load.x, load.z) for load in light], "D", GREEN, "Buoy")


# ------------------------------------------------------------------ tension along the line


def tension(solution: Solution) -> Figure:
    """Draw the effective tension over the arc length, with what the segments may carry."""
    quantity, along = QUANTITIES["tension"], QUANTITIES["s"]
    shape = solution.profile(401)
    figure, axes = blank(SIZE, along, quantity)
    axes.plot(
        [along.to_field(s) for s in shape.s],
        [quantity.to_field(value) for value in shape.tension],
        color="black",
        label="Tension T",
    )
    _capacities(axes, solution, max(shape.tension))
    for label, dashes, places in (
        ("Joint of segments", (1, 2), _joints(solution)),
        ("Touchdown", (4, 2), [s for _, s in _touchdowns(solution)]),
        ("Point load", (6, 1, 1, 1), [load.position for load in solution.point_loads]),
    ):
        for index, place in enumerate(places):
            axes.axvline(
                place, color="#606060", linewidth=1.0, dashes=dashes, label="_" if index else label
            )
    axes.set_xlim(0.0, along.to_field(solution.line.length))
    axes.set_ylim(bottom=0.0)
    axes.margins(y=0.1)
    axes.set_ylim(0.0, axes.get_ylim()[1] * 1.05)
    second_force_axis(axes, quantity)
    set_title(axes, folded(solution.title))
    legend_below(figure, 3)
    return figure


def _joints(solution: Solution) -> list[float]:
    """Arc lengths at which one segment ends and the next begins."""
    lengths = [segment.length for segment in solution.segments]
    return [math.fsum(lengths[: index + 1]) for index in range(len(lengths) - 1)]


def _capacities(axes: Axes, solution: Solution, largest: float) -> None:
    """Draw MBL / SF of every segment that has one, or name it where it is far above the curve."""
    quantity, factor = QUANTITIES["tension"], solution.safety_factor
    what = "MBL" if factor == 1.0 else f"MBL / {factor:g}"
    start, drawn = 0.0, False
    for number, segment in enumerate(solution.segments, start=1):
        end = start + segment.length
        if segment.MBL is not None:
            capacity = segment.MBL / factor
            level = quantity.to_field(capacity)
            if capacity <= _FAR_OFF_SCALE * largest:
                label = "_" if drawn else what
                axes.plot([start, end], [level] * 2, color=ORANGE, dashes=(5, 1.5), label=label)
                drawn = True
            else:
                of = "" if len(solution.segments) == 1 else f" of segment {number}"
                text = f"{what}{of}: {level:.4g} {quantity.field_unit}, off the scale"
                axes.plot([], [], linestyle="none", label=text)
        start = end


# ------------------------------------------------------------------ the load curve


def load_curve(result: CaseCurve) -> Figure:
    """Draw horizontal force and fairlead tension over the span, or the offset, with the marks."""
    x = OFFSET if result.over == "offset" else SPAN
    zero = result.reference.span if result.over == "offset" else 0.0
    marks = result.curve.marks
    # Each mark takes a line of the legend.
    figure, axes = blank((SIZE[0], SIZE[1] + 0.21 * len(marks)), x, named("tension", "Force", ""))
    spans, forces, tensions = result.outline()
    places = [x.to_field(span - zero) for span in spans]
    for quantity, values, colour, dashes in (
        (FORCE, forces, BLUE, (1, 0)),
        (FAIRLEAD_TENSION, tensions, ORANGE, (5, 1.5)),
    ):
        levels = [quantity.to_field(value) for value in values]
        axes.plot(places, levels, color=colour, dashes=dashes, label=quantity.label)
    _the_case(axes, result, x.to_field(result.reference.span - zero))
    axes.margins(x=0.03)
    axes.set_ylim(0.0, 1.08 * FORCE.to_field(max(tensions)))
    highest = max(tensions)
    for number, (mark, level) in enumerate(zip(marks, _levels(marks, highest), strict=True), 1):
        force = FORCE.format(mark.horizontal_force, unit=True)
        label = f"{wrap(mark.event, 64, max_lines=1, placeholder=' ...')[0]}: H {force}"
        _numbered(axes, number, (x.to_field(mark.span - zero), level), label)
    second_force_axis(axes, named("tension", "Force", ""))
    set_title(axes, folded(result.case.title))
    legend_below(figure, 1)
    return figure


def _the_case(axes: Axes, result: CaseCurve, x: float) -> None:
    """Show where the case itself is, if that is in the range."""
    reference = result.reference
    if not result.curve.span[0] <= reference.span <= result.curve.span[-1]:
        return
    axes.plot(
        [x, x],
        [FORCE.to_field(reference.horizontal_force), FORCE.to_field(reference.fairlead.tension)],
        linestyle="none",
        marker="o",
        markersize=7,
        markerfacecolor="white",
        markeredgecolor="black",
        clip_on=False,
        zorder=5,
        label=f"The case: H {FORCE.format(reference.horizontal_force, unit=True)}",
    )


def _levels(marks: Sequence[Mark], highest: float) -> Iterator[float]:
    """Where in the frame the numbers of marks go, 0 to 1: staggered, and clear of the curves.

    Those on the steep part of the curves go to the bottom, the others to the top.
    """
    above, below = 0, 0
    for mark in marks:
        if mark.fairlead_tension > 0.35 * highest:
            yield 0.05 + 0.06 * (below % 6)
            below += 1
        else:
            yield 0.96 - 0.06 * (above % 6)
            above += 1


def _numbered(axes: Axes, number: int, place: tuple[float, float], label: str) -> None:
    """Mark a place by a line with a number in the frame, which the legend explains."""
    x, level = place
    axes.axvline(x, color="#606060", linewidth=0.9, dashes=(1, 2), zorder=1)
    axes.plot(
        [x],
        [level],
        linestyle="none",
        marker="s",
        markersize=12,
        markerfacecolor="white",
        markeredgecolor="#606060",
        transform=axes.get_xaxis_transform(),
        zorder=6,
    )
    axes.plot(
        [x],
        [level],
        linestyle="none",
        marker=f"${number}$",
        markersize=7,
        color="black",
        transform=axes.get_xaxis_transform(),
        zorder=7,
        label=label,
    )


# ------------------------------------------------------------------ the swarm


def fitness(swarm: SwarmReport) -> Figure:
    """Draw the best objective over the iterations of the best run (figure 3 of S1).

    The axis is logarithmic, and f may be exactly 0: such iterations stand on a line of their own
    at the foot of the axis, which is labelled 0.
    """
    quantity = named("objective", "Best objective")
    history = swarm.best_objective_history
    figure, axes = _blank_over_iterations(quantity, swarm)
    axes.set_yscale("log")
    numbers = range(1, len(history) + 1)
    zeros = [number for number, value in zip(numbers, history, strict=True) if value == 0.0]
    levels = [value for value in history if value > 0.0]
    shows_limit = bool(zeros) or min(levels) < _CONVERGED
    if shows_limit:
        levels.append(_CONVERGED)
    axes.set_ylim(min(levels) / 3.0, max(levels) * 3.0)
    if shows_limit:
        axes.axhline(
            _CONVERGED, color=GREEN, linewidth=1.2, dashes=(5, 2), label="Converged: f < 1e-9 m"
        )
    above = [value if value > 0.0 else math.nan for value in history]
    axes.plot(numbers, above, color=BLUE, label=f"f of run {swarm.best_run}, the best")
    if zeros:
        _foot(axes, zeros, min(levels), max(levels) * 3.0)
    legend_below(figure, 2)
    return figure


def _foot(axes: Axes, zeros: Sequence[int], least: float, top: float) -> None:
    """Set the iterations at which f is 0 on a line of their own below the logarithmic axis."""
    foot = 10.0 ** (math.floor(math.log10(least)) - 2)
    axes.axhspan(foot / 10.0, foot * 10.0, color="#EEEEEE", linewidth=0.0, zorder=0.5)
    axes.plot(
        zeros,
        [foot] * len(zeros),
        linestyle="none",
        marker="o",
        markersize=4 if len(zeros) > 10 else 7,
        markerfacecolor="white",
        markeredgecolor=ORANGE,
        clip_on=False,
        markevery=max(1, len(zeros) // 40),
        label="f = 0 exactly",
    )
    axes.set_ylim(foot / 10.0, top)
    ticks = _decades(foot * 10.0, top)
    axes.set_yticks([foot, *ticks])
    axes.set_yticklabels(["0", *(f"$10^{{{round(math.log10(tick))}}}$" for tick in ticks)])
    axes.minorticks_off()


def _decades(low: float, high: float) -> list[float]:
    """Powers of ten between two values, every one, second, third ... so that they are few."""
    first, last = math.ceil(math.log10(low) + 1e-9), math.floor(math.log10(high))
    step = max(1, math.ceil((last - first + 1) / 8))
    return [10.0**power for power in range(last, first - 1, -step)][::-1]


def swarm_tension(swarm: SwarmReport, closed_form: float) -> Figure:
    """Draw the fairlead tension over the iterations of the best run (figure 4 of S1).

    Parameters
    ----------
    swarm : SwarmReport
        With its history.
    closed_form : float
        Fairlead tension of the closed form, N.
    """
    quantity = named("tension", "Fairlead tension")
    history = swarm.tension_history
    figure, axes = _blank_over_iterations(quantity, swarm)
    axes.axhline(
        quantity.to_field(closed_form),
        color=ORANGE,
        linewidth=1.2,
        dashes=(5, 4),
        zorder=3,
        label="Closed form",
    )
    axes.plot(
        range(1, len(history) + 1),
        [quantity.to_field(value) for value in history],
        color=BLUE,
        label=f"Best particle of run {swarm.best_run}",
    )
    axes.ticklabel_format(axis="y", useOffset=False)
    axes.margins(y=0.15)
    second_force_axis(axes, quantity)
    legend_below(figure, 2)
    return figure


def _blank_over_iterations(y: Quantity, swarm: SwarmReport) -> tuple[Figure, Axes]:
    """Make axes over all iterations of a run and mark where it stopped before the last."""
    figure, axes = blank(SIZE, QUANTITIES["s"], y)
    flown = len(swarm.best_objective_history)
    axes.set_xlabel("Iteration")
    axes.set_xlim(0, max(swarm.iterations, 2))
    if flown < swarm.iterations:
        label = "Stopped: f cannot fall further"
        axes.axvline(flown, color="#606060", linewidth=1.0, dashes=(1, 2), label=label)
    return figure, axes
