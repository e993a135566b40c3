"""The front of a design search, and three of its lines drawn to scale."""

from __future__ import annotations

from textwrap import shorten
from typing import TYPE_CHECKING, Any

from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from catopt.quantities import QUANTITIES
from catopt.report.plots.common import (
    BLUE,
    GREEN,
    LEFT,
    ORANGE,
    RIGHT,
    SIZE,
    STYLE,
    folded,
    label_axes,
    set_title,
    water_and_bed,
)
from catopt.report.wording.design import OBJECTIVES, clump_weight_words, segment_words
from catopt.ties import largest

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from catopt.catenary.solution import Solution
    from catopt.design.result import DesignPoint, DesignResult

__all__ = ["chosen_three", "design_front"]

_FRONT, _BETWEEN, _UNDER = 3.6, 1.5, 1.65
"""Inches: height of the front, room below it, room below the lines."""

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

    The lines are drawn in the load case that takes the recommended design farthest from its
    anchor. A third objective is told by the shade of the points.
    """
    state = _farthest(result.front[result.recommended])
    chosen = {i: dict(result.front[i].checks.solutions)[state] for i in chosen_three(result)}
    depth = result.case.site.water_depth + _water_level(result, state)
    widest = 1.06 * max(solution.span for solution in chosen.values())
    highest = 1.2 * max(depth, *(solution.fairlead_height for solution in chosen.values()))
    width = SIZE[0] - LEFT - RIGHT
    low = min(max(width * highest / widest, 1.0), 4.0)
    # In inches from the top: title, front, its labels and legend, lines, their labels and legend.
    full = 0.35 + _FRONT + _BETWEEN + low + _UNDER
    with rc_context(STYLE):
        figure = Figure(figsize=(SIZE[0], full))
        FigureCanvasAgg(figure)
        above = figure.add_axes(
            (LEFT / SIZE[0], 1.0 - (0.35 + _FRONT) / full, width / SIZE[0], _FRONT / full)
        )
        below = figure.add_axes((LEFT / SIZE[0], _UNDER / full, width / SIZE[0], low / full))
        _front(figure, above, result)
        _lines(below, result, chosen)
    scale = max(widest / width, highest / low)
    below.set_xlim(-0.03 * widest, scale * width - 0.03 * widest)
    below.set_ylim(-0.07 * highest, scale * low - 0.07 * highest)
    water_and_bed(below, depth)
    set_title(above, folded(result.case.title))
    set_title(below, folded(f"To scale, {state}"))
    _legend(above, 2, -0.55 / _FRONT)
    _legend(below, 1, -0.5 / low)
    return figure


def _legend(axes: Axes, columns: int, top: float) -> None:
    place: dict[str, Any] = {
        "loc": "upper center",
        "bbox_to_anchor": (0.5, top),
        "borderaxespad": 0.0,
    }
    axes.legend(ncols=columns, frameon=False, handlelength=3.2, fontsize=9, **place)


def _water_level(result: DesignResult, name: str) -> float:
    levels = {state.name: state.water_level for state in result.case.load_cases}
    return levels.get(name, 0.0)


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


def _lines(axes: Axes, result: DesignResult, chosen: dict[int, Solution]) -> None:
    label_axes(axes, QUANTITIES["x"], QUANTITIES["z"])
    axes.set_ylabel("z (m)")
    axes.grid(visible=False)
    for look, (index, solution) in zip(_LOOKS, chosen.items(), strict=False):
        shape = solution.profile(201)
        line = result.front[index].line
        words = "; ".join([*segment_words(line), *clump_weight_words(line)])
        label = shorten(f"Design {index + 1}: {words}", 82, placeholder=" ...")
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


def _farthest(point: DesignPoint) -> str:
    """Name the load case with the largest span."""
    return largest(point.checks.solutions, lambda state: state[1].span)[0]
