"""The front of a design search, and three of its lines drawn to scale."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from catopt.quantities import QUANTITIES
from catopt.report.design_words import OBJECTIVES, segment_words
from catopt.report.figures import (
    BLUE,
    GREEN,
    ORANGE,
    SIZE,
    STYLE,
    folded,
    label_axes,
    set_title,
    water_and_bed,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from catopt.catenary.solution import Solution
    from catopt.design.result import DesignPoint, DesignResult

__all__ = ["chosen_three", "design_front"]

_LOOKS: tuple[dict[str, Any], ...] = (
    {"color": BLUE, "dashes": (1, 0)},
    {"color": ORANGE, "dashes": (6, 1.5)},
    {"color": GREEN, "dashes": (3, 1.2)},
)
"""Of the recommended design and of the two ends of the front."""


def chosen_three(result: DesignResult) -> list[int]:
    """List the recommended design and the two ends of the front by index, each once."""
    indices = [result.recommended, 0, len(result.front) - 1]
    return list(dict.fromkeys(indices))


def design_front(result: DesignResult) -> Figure:
    """Draw the front over its first two objectives, and three of its lines to scale.

    The lines are drawn in the load case that takes them farthest from their anchor. A third
    objective is told by the shade of the points.
    """
    with rc_context(STYLE):
        figure = Figure(figsize=(SIZE[0], 7.4), layout="constrained")
        FigureCanvasAgg(figure)
        above, below = figure.subplots(2, 1, height_ratios=(3, 2))
        _front(figure, above, result)
        _lines(below, result)
    set_title(above, folded(result.case.title))
    for axes, columns in ((above, 2), (below, 1)):
        axes.legend(
            loc="upper center", bbox_to_anchor=(0.5, -0.2), ncols=columns, frameon=False,
            handlelength=3.2, fontsize=9,
        )  # fmt: skip
    return figure


def _front(figure: Figure, axes: Axes, result: DesignResult) -> None:
    first, second, *third = result.objectives
    x, y = OBJECTIVES[first], OBJECTIVES[second]
    label_axes(axes, x, y)
    places = [
        (x.to_field(point.objectives[first]), y.to_field(point.objectives[second]))
        for point in result.front
    ]
    shades: dict[str, Any] = {"color": "#404040"}
    if third:
        shade = OBJECTIVES[third[0]]
        values = [shade.to_field(point.objectives[third[0]]) for point in result.front]
        shades = {"c": values, "cmap": "cividis"}
    across, up = [place[0] for place in places], [place[1] for place in places]
    drawn = axes.scatter(across, up, s=14, label=_front_label(result), **shades)
    if third:
        figure.colorbar(drawn, ax=axes, label=OBJECTIVES[third[0]].heading)
    for look, index in zip(_LOOKS, chosen_three(result), strict=False):
        axes.plot(
            *places[index],
            linestyle="none",
            marker="o",
            markersize=9,
            markerfacecolor="none",
            markeredgecolor=look["color"],
            markeredgewidth=2.0,
            zorder=5,
            label=_design_label(result, index),
        )
    axes.margins(0.06)


def _front_label(result: DesignResult) -> str:
    what = "exact front" if result.is_exact else f"front found by {result.method}"
    return f"{len(result.front)} designs, {what}"


def _design_label(result: DesignResult, index: int) -> str:
    note = ", recommended" if index == result.recommended else ""
    return f"Design {index + 1}{note}"


def _lines(axes: Axes, result: DesignResult) -> None:
    label_axes(axes, QUANTITIES["x"], QUANTITIES["z"])
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(visible=False)
    states = {index: _farthest(result.front[index]) for index in chosen_three(result)}
    for look, (index, (name, solution)) in zip(_LOOKS, states.items(), strict=False):
        shape = solution.profile(201)
        words = "; ".join(segment_words(result.front[index].line))
        label = f"Design {index + 1}: {words} ({name})"
        axes.plot(shape.x, shape.z, label=label, zorder=4, **look)
        axes.plot(
            [load.x for load in solution.point_loads],
            [load.z for load in solution.point_loads],
            linestyle="none",
            marker="s",
            markersize=7,
            markerfacecolor=look["color"],
            markeredgecolor="black",
            zorder=5,
        )
    top = max(solution.fairlead_height for _, solution in states.values())
    axes.set_ylim(-0.08 * top, 1.12 * top)
    water_and_bed(axes, result.case.site.water_depth)


def _farthest(point: DesignPoint) -> tuple[str, Solution]:
    """Return the load case with the largest span, by its name, and the line in it."""
    return max(point.checks.solutions, key=lambda state: state[1].span)
