"""The same moored body by several models: a plan, and an elevation of its loaded line."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from catopt.quantities import QUANTITIES
from catopt.report.plots.common import (
    BED,
    BED_EDGE,
    BLUE,
    ORANGE,
    SIZE,
    STYLE,
    blank,
    folded,
    legend_below,
    set_title,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from catopt.reproduce.items import Mooring, Study

__all__ = ["elevation", "plan"]

_LOOKS = ((ORANGE, (5.0, 1.8), "s"), (BLUE, (1.0, 0.0), "o"))
"""Colour, dash and the body's marker of each model."""

_ZOOM = 1.6
"""How far the view round the body reaches, over its largest offset."""


def plan(study: Study) -> Figure:
    """Draw the lines from above, and beside them the surroundings of the body, larger."""
    with rc_context(STYLE):
        figure = Figure(figsize=(SIZE[0], 4.7), layout="constrained")
        FigureCanvasAgg(figure)
        whole, near = figure.subplots(1, 2)
    for axes in (whole, near):
        axes.set_xlabel("x (m)")
        axes.set_ylabel("y (m)")
        for index, mooring in enumerate(study.moorings):
            _from_above(axes, mooring, index)
        axes.plot(0.0, 0.0, "+", color="black", markersize=11, label="Body without load")
        axes.set_aspect("equal", adjustable="datalim" if axes is whole else "box")
    for number, line in enumerate(study.moorings[0].lines, start=1):
        away = math.atan2(line.y[0], line.x[0])
        whole.annotate(
            str(number), (line.x[0], line.y[0]),
            xytext=(10.0 * math.cos(away), 10.0 * math.sin(away)),
            textcoords="offset points", ha="center", va="center", fontsize=7,
        )  # fmt: skip
    whole.margins(0.1)
    reach = _ZOOM * max(
        math.hypot(line.x[-1], line.y[-1]) for each in study.moorings for line in each.lines
    )
    near.set_xlim(-reach, 0.5 * reach)
    near.set_ylim(-0.75 * reach, 0.75 * reach)
    near.set_title("Round the body", fontsize=10)
    figure.suptitle(folded(study.title), fontsize=11, parse_math=False)
    legend_below(figure, 2)
    return figure


def _from_above(axes: Axes, mooring: Mooring, index: int) -> None:
    colour, dash, marker = _LOOKS[index % len(_LOOKS)]
    for number, line in enumerate(mooring.lines):
        label = "_" if number else mooring.name
        axes.plot(line.x, line.y, color=colour, dashes=dash, linewidth=1.2, label=label)
    body = mooring.lines[0]
    axes.plot(
        body.x[-1], body.y[-1], marker,
        markerfacecolor="white", markeredgecolor=colour, markersize=8, zorder=5,
    )  # fmt: skip


def elevation(study: Study) -> Figure:
    """Draw the loaded line from the side by every model, heights magnified."""
    figure, axes = blank(SIZE, QUANTITIES["x"], QUANTITIES["z"])
    for index, mooring in enumerate(study.moorings):
        colour, dash, marker = _LOOKS[index % len(_LOOKS)]
        line = mooring.lines[study.loaded_line]
        x = [math.hypot(a - line.x[0], b - line.y[0]) for a, b in zip(line.x, line.y, strict=True)]
        axes.plot(x, line.z, color=colour, dashes=dash, label=mooring.name)
        last = max(number for number, lies in enumerate(line.on_bed) if lies)
        axes.plot(
            x[last], line.z[last], marker,
            markerfacecolor="white", markeredgecolor=colour, markersize=7, zorder=5,
            label="Last place at the bed",
        )  # fmt: skip
    low = -0.08 * max(max(line.z) for each in study.moorings for line in each.lines)
    axes.axhspan(low, 0.0, color=BED, linewidth=0.0, zorder=0.5)
    axes.axhline(0.0, color=BED_EDGE, linewidth=1.0, zorder=1.0)
    axes.set_ylim(bottom=low)
    axes.margins(x=0.02)
    set_title(axes, folded(f"{study.title}; line {study.loaded_line + 1}, heights magnified"))
    legend_below(figure, 2)
    return figure
