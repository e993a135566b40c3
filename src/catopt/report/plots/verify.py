"""Figures of a verification: both shapes, both tensions, and what is between them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from catopt.quantities import QUANTITIES
from catopt.report.plots.common import (
    BED,
    BED_EDGE,
    BLUE,
    GREEN,
    ORANGE,
    SIZE,
    STYLE,
    folded,
    label_axes,
)
from catopt.verify.shape import closed_form_at, flat

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from catopt.verify.result import LinePair, StaticComparison, Verification

__all__ = ["comparison", "figures"]

_MARKERS = 40
"""How many nodes of a mesh are drawn, so that the line below them stays in sight."""

_MESHES = ((GREEN, (1.0, 1.5)), (BLUE, (4.0, 1.5)), (ORANGE, (1.0, 0.0)))
"""Colour and dash of each mesh, from the coarsest."""

_DECADES = 1e-5
"""Lower end of a logarithmic axis, over the largest value on it."""


def figures(found: Verification) -> dict[str, Figure]:
    """Draw every load case, by the name of its file; of a system the most loaded line."""
    several = len(found.parts) > 1
    return {
        f"comparison_{number}" if several else "comparison": comparison(part, _title(found, part))
        for number, part in enumerate(found.parts, start=1)
    }


def _title(found: Verification, part: StaticComparison) -> str:
    parts = [found.case.title, part.name if found.case.load_cases else ""]
    if part.kind == "system":
        parts.append(f"line {_most_loaded(part) + 1}, the most loaded")
    return ", ".join(each for each in parts if each)


def _most_loaded(part: StaticComparison) -> int:
    tensions = [pair.finest.fairlead.tension for pair in part.lines]
    return tensions.index(max(tensions))


def comparison(part: StaticComparison, title: str) -> Figure:
    """Draw shape and tension by both models, and beside them the differences, magnified.

    Parameters
    ----------
    part : StaticComparison
        One load case.
    title : str
        Above the figure.
    """
    pair = part.lines[_most_loaded(part)]
    with rc_context(STYLE):
        figure = Figure(figsize=(SIZE[0], 6.3), layout="constrained")
        FigureCanvasAgg(figure)
        axes = figure.subplots(2, 2)
    _shapes(axes[0, 0], pair)
    _tensions(axes[0, 1], pair)
    _differences(axes[1, 0], axes[1, 1], pair)
    figure.suptitle(folded(title), fontsize=11, parse_math=False)
    handles, labels = figure.axes[0].get_legend_handles_labels()
    more = axes[1, 0].get_legend_handles_labels()
    figure.legend(
        [*handles, *more[0]], [*labels, *more[1]], loc="outside lower center", ncols=3,
        handlelength=2.6, frameon=False,
    )  # fmt: skip
    return figure


def _shapes(axes: Axes, pair: LinePair) -> None:
    label_axes(axes, QUANTITIES["x"], QUANTITIES["z"])
    profile = pair.closed.profile(401)
    axes.plot(profile.x, profile.z, color="black", label="Closed form")
    shape = flat(pair.finest)
    axes.plot(
        shape[:, 0], shape[:, 1], "o",
        markersize=3.5, markerfacecolor="white", markeredgecolor=ORANGE,
        markevery=max(1, len(shape) // _MARKERS), label="Truss model",
    )  # fmt: skip
    low, high = float(shape[:, 1].min()), float(shape[:, 1].max())
    room = 0.06 * max(high - low, 1e-9)
    axes.set_ylim(low - room, high + room)
    if low <= room:
        axes.axhspan(low - room, 0.0, color=BED, linewidth=0.0, zorder=0.5)
        axes.axhline(0.0, color=BED_EDGE, linewidth=1.0, zorder=1.0)


def _tensions(axes: Axes, pair: LinePair) -> None:
    quantity = QUANTITIES["tension"]
    label_axes(axes, QUANTITIES["s"], quantity)
    profile = pair.closed.profile(401)
    axes.plot(profile.s, [quantity.to_field(T) for T in profile.tension], color="black")
    middles = 0.5 * (pair.finest.arc[1:] + pair.finest.arc[:-1])
    tensions = quantity.to_field(1.0) * pair.finest.tension
    axes.plot(
        middles, tensions, "o",
        markersize=3.5, markerfacecolor="white", markeredgecolor=ORANGE,
        markevery=max(1, len(middles) // _MARKERS),
    )  # fmt: skip
    axes.ticklabel_format(useOffset=False)


def _differences(shapes: Axes, tensions: Axes, pair: LinePair) -> None:
    """Draw over the arc length how far nodes and bar tensions are off, for each mesh."""
    closed = pair.closed
    first = pair.trusses[0].mesh.elements
    tops = [0.0, 0.0]
    for number, truss in enumerate(pair.trusses):
        exact = closed_form_at(closed, truss.arc)
        distance = 1e3 * np.linalg.norm(flat(truss) - exact[:, :2], axis=1)
        middles = 0.5 * (truss.arc[1:] + truss.arc[:-1])
        off = np.abs(truss.tension - closed_form_at(closed, middles)[:, 2])
        colour, dash = _MESHES[number % len(_MESHES)]
        label = f"Difference, {first * 2**number} bars"
        for axes, s, values in ((shapes, truss.arc, distance), (tensions, middles, off)):
            shown = np.where(values > 0.0, values, np.nan)
            axes.plot(s, shown, color=colour, dashes=dash, linewidth=1.2, label=label)
        tops = [max(tops[0], float(distance.max())), max(tops[1], float(off.max()))]
    words = ("Distance of the shapes (mm)", "Difference of the tensions (N)")
    for axes, top, what in zip((shapes, tensions), tops, words, strict=True):
        axes.set_xlabel(QUANTITIES["s"].heading)
        axes.set_ylabel(what)
        axes.set_xlim(0.0, closed.line.length)
        if top > 0.0:
            axes.set_yscale("log")
            axes.set_ylim(_DECADES * top, 3.0 * top)
