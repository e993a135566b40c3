"""The lines of a published calculation in one figure, to scale."""

from __future__ import annotations

from itertools import cycle
from typing import TYPE_CHECKING

from catopt.report.plots.common import (
    BLUE,
    GREEN,
    ORANGE,
    PURPLE,
    folded,
    legend_below,
    water_and_bed,
)
from catopt.report.plots.line import blank_to_scale

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from catopt.reproduce.items import Study

__all__ = ["lines_to_scale"]

_LOOKS = (
    ("black", (1.0, 0.0)),
    (ORANGE, (6.0, 1.5)),
    (BLUE, (3.0, 1.2)),
    (GREEN, (1.2, 1.0)),
    (PURPLE, (6.0, 1.2, 1.2, 1.2)),
)
"""Colour and dash of each line."""

_SHORT = 30
"""Letters: three names below it stand beside each other."""


def lines_to_scale(study: Study) -> Figure:
    """Draw the lines of a study from their anchor to their fairleads, in water up to these.

    Parameters
    ----------
    study : Study
        With lines to be drawn.
    """
    depth = max(each.solution.fairlead_height for each in study.drawn)
    right = max(each.solution.span for each in study.drawn)
    figure, axes = blank_to_scale(0.0, right, depth, folded(study.title))
    water_and_bed(axes, depth)
    for each, (colour, dashes) in zip(study.drawn, cycle(_LOOKS), strict=False):
        shape = each.solution.profile(401)
        axes.plot(shape.x, shape.z, color=colour, dashes=dashes, label=each.name)
        axes.plot(
            each.solution.span, each.solution.fairlead_height, "o",
            markerfacecolor="white", markeredgecolor=colour, clip_on=False, zorder=5,
        )  # fmt: skip
        for load in each.solution.point_loads:
            axes.plot(load.x, load.z, "s", color=colour, markeredgecolor="black", zorder=5)
    axes.plot(0.0, 0.0, "v", color="black", markersize=8, clip_on=False, zorder=5)
    longest = max(len(each.name) for each in study.drawn)
    legend_below(figure, 3 if longest < _SHORT else 2)
    return figure
