"""Figures of a line in motion: tension over time, its spectrum, and its envelope."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from catopt.quantities import QUANTITIES
from catopt.report.plots.common import BLUE, GREEN, ORANGE, SIZE, STYLE, folded

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from catopt.verify.dynamic_result import DynamicPart, DynamicRun, DynamicVerification

__all__ = ["figures", "in_motion"]

_TENSION = QUANTITIES["tension"]
_FEW = 64
"""Samples below which there is no spectrum."""

_SHOWN = 0.999
"""Part of the energy up to which a spectrum is drawn."""


def figures(found: DynamicVerification) -> dict[str, Figure]:
    """Draw every load case, by the name of its file."""
    several = len(found.parts) > 1
    return {
        f"dynamic_{number}" if several else "dynamic": in_motion(
            part, ", ".join(t for t in (found.case.title, part.name if several else "") if t)
        )
        for number, part in enumerate(found.parts, start=1)
    }


def in_motion(part: DynamicPart, title: str) -> Figure:
    """Draw the run with the largest tension: its series, its spectrum, and the line's envelope.

    Parameters
    ----------
    part : DynamicPart
        One load case.
    title : str
        Above the figure.
    """
    run = part.governing
    with rc_context(STYLE):
        figure = Figure(figsize=(SIZE[0], 6.2), layout="constrained")
        FigureCanvasAgg(figure)
        grid = figure.add_gridspec(2, 2)
        series = figure.add_subplot(grid[0, :])
        spectrum, envelope = figure.add_subplot(grid[1, 0]), figure.add_subplot(grid[1, 1])
    _series(series, run)
    _spectrum(spectrum, run)
    _envelope(envelope, part)
    more = f", run {part.runs.index(run) + 1} of {len(part.runs)}" if len(part.runs) > 1 else ""
    figure.suptitle(folded(title + more), fontsize=11, parse_math=False)
    figure.legend(*series.get_legend_handles_labels(), loc="outside lower center", ncols=3,
                  handlelength=2.6, frameon=False)  # fmt: skip
    return figure


def _series(axes: Axes, run: DynamicRun) -> None:
    history = run.history
    kN = _TENSION.to_field(1.0)
    axes.plot(
        history.time, kN * history.anchor_tension[:, 0], color=GREEN, linewidth=0.8,
        dashes=(2.0, 1.0), label="At the anchor",
    )  # fmt: skip
    axes.plot(
        history.time, kN * history.fairlead_tension[:, 0], color=BLUE, linewidth=1.0,
        label="At the fairlead",
    )  # fmt: skip
    axes.plot(
        history.time, kN * run.quasi_static, color=ORANGE, linewidth=0.9, dashes=(5.0, 1.5),
        label="At the fairlead, quasi-static",
    )  # fmt: skip
    axes.axvline(history.since, color="black", linewidth=0.8, dashes=(1.0, 2.0))
    axes.set_xlim(0.0, float(history.time[-1]))
    axes.set_xlabel("Time (s)")
    axes.set_ylabel(_TENSION.heading)
    axes.ticklabel_format(useOffset=False)


def _spectrum(axes: Axes, run: DynamicRun) -> None:
    axes.set_xlabel("Frequency (Hz)")
    axes.set_ylabel("Spectrum of T (kN^2/Hz)", parse_math=False)
    if run.counted.sum() < _FEW:
        axes.text(0.5, 0.5, "too short for a spectrum", ha="center", transform=axes.transAxes)
        return
    omega, density = run.tension_spectrum()
    density = density * _TENSION.to_field(1.0) ** 2
    energy = np.cumsum(density)
    last = int(np.searchsorted(energy, _SHOWN * energy[-1])) + 2
    axes.plot(omega[:last] / (2.0 * math.pi), 2.0 * math.pi * density[:last], color=BLUE)
    axes.set_xlim(left=0.0)
    axes.set_ylim(bottom=0.0)


def _envelope(axes: Axes, part: DynamicPart) -> None:
    histories = [run.history for run in part.runs]
    s, kN = histories[0].arc, _TENSION.to_field(1.0)
    high = kN * np.fmax.reduce([each.max_tension for each in histories])
    low = kN * np.fmin.reduce([each.min_tension for each in histories])
    axes.fill_between(s, low, high, color=BLUE, alpha=0.15, linewidth=0.0)
    axes.plot(s, high, color=BLUE)
    axes.plot(s, low, color=BLUE, dashes=(4.0, 1.5))
    axes.set_xlabel(QUANTITIES["s"].heading)
    axes.set_ylabel("Largest and smallest T (kN)")
    axes.set_ylim(bottom=float(np.fmin.reduce(low, initial=0.0)))
