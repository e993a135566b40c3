"""A line in motion, drawn: its tension around the largest value, and the envelope along it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES
from catopt.report.page.figure import (
    Figure,
    Frame,
    Legend,
    Point,
    Shape,
    axes,
    breadth,
    frame_in,
    line,
    number,
    path,
    shape,
    text,
)
from catopt.report.page.tension_figure import FAR
from catopt.report.texts import Words

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.report.page.in_motion import SegmentUse
    from catopt.verify.dynamic_result import DynamicPart, DynamicRun

__all__ = ["around_the_largest", "envelope", "envelope_figure", "history_figure"]

_TENSION = QUANTITIES["tension"]
_HEIGHT = 376.0
_CYCLES = 12.0
"""Cycles of the tension that are drawn around its largest value."""
_MOST = 600
"""Samples that are drawn."""


def around_the_largest(run: DynamicRun, most: int = _MOST) -> list[int]:
    """Choose the samples around the largest fairlead tension: a dozen cycles, the peak among them.

    Parameters
    ----------
    run : DynamicRun
        Cycles are those between upward crossings of its mean; without any all samples are taken.
    most : int
        Samples, about.

    Returns
    -------
    list of int
        Indices of samples, rising.
    """
    import numpy as np

    history = run.history
    found = run.statistics("fairlead_tension")
    counted = np.flatnonzero(run.counted)
    first, last = int(counted[0]), int(counted[-1])
    peak = first + int(history.fairlead_tension[counted, 0].argmax())
    if found.peaks:
        half = 0.5 * _CYCLES * found.duration / found.peaks
        at = history.time[peak]
        inside = np.flatnonzero((history.time >= at - half) & (history.time <= at + half))
        first, last = max(first, int(inside[0])), min(last, int(inside[-1]))
    step = max(1, math.ceil((last - first + 1) / most))
    return sorted({*range(first, last + 1, step), peak, last})


def history_figure(part: DynamicPart, at_rest: float, words: Words) -> Figure:
    """Draw the fairlead tension of the governing run around its largest value.

    Parameters
    ----------
    part : DynamicPart
        One load case.
    at_rest : float
        Tension at the fairlead at rest, N.
    words : Words
        Language.
    """
    run = part.governing
    history = run.history
    chosen = around_the_largest(run)
    times = [float(history.time[k]) for k in chosen]
    tensions = [float(history.fairlead_tension[k, 0]) for k in chosen]
    still = [float(run.quasi_static[k]) for k in chosen]
    frame = _frame((times[0], times[-1]), [*tensions, *still, at_rest])
    label = f"{words.name('Fairlead tension')} T ({_TENSION.field_unit})"
    shapes = axes(frame, words("in_motion.time"), label)
    level = frame.up(_TENSION.to_field(at_rest))
    shapes.append(line("rest", frame.left, level, frame.right, level))
    known = [(t, v) for t, v in zip(times, still, strict=True) if v == v]
    for style, places in (
        ("curve second", known), ("curve first", list(zip(times, tensions, strict=True)))
    ):  # fmt: skip
        if places:
            shapes.append(path(style, [frame.at(t, _TENSION.to_field(v)) for t, v in places]))
    largest = max(tensions)
    t_max = times[tensions.index(largest)]
    x, y = frame.at(t_max, _TENSION.to_field(largest))
    shapes.append(shape("circle", "reference", cx=x, cy=y, r=5.0))
    shown = _TENSION.format(largest, unit=True)
    points = tuple(
        Point(*frame.at(t, _TENSION.to_field(v)), _told(words, t, v, q))
        for t, v, q in zip(times, tensions, still, strict=True)
    )
    legend = [Legend("curve first", words("in_motion.dynamic"))]
    if known:
        legend.append(Legend("curve second", words("in_motion.quasi_static")))
    legend += [
        Legend("rest", words("in_motion.at_rest", T=_TENSION.format(at_rest, unit=True))),
        Legend("reference", words("in_motion.largest", T=shown, t=f"{t_max:.2f}")),
    ]
    title = words("in_motion.history_alt", T=shown, t=f"{t_max:.2f}")
    notes = (words(
        "in_motion.window", a=f"{times[0]:.1f}", b=f"{times[-1]:.1f}",
        run=part.runs.index(run) + 1, runs=len(part.runs),
    ),)  # fmt: skip
    return Figure("motion", title, _HEIGHT, tuple(shapes), points, tuple(legend), notes)


def _told(words: Words, t: float, tension: float, still: float) -> str:
    told = words("in_motion.point", t=f"{t:.2f}", T=_TENSION.format(tension, unit=True))
    if still == still:
        told += words("in_motion.point_still", T=_TENSION.format(still, unit=True))
    return told


def envelope(part: DynamicPart) -> tuple[list[float], list[float], list[float]]:
    """Find arc lengths, and the largest and the smallest tension of each bar over all runs, N."""
    import numpy as np

    histories = [run.history for run in part.runs]
    high = np.fmax.reduce([each.max_tension for each in histories])
    low = np.fmin.reduce([each.min_tension for each in histories])
    return histories[0].arc.tolist(), high.tolist(), low.tolist()


def envelope_figure(
    part: DynamicPart, solution: Solution, uses: Sequence[SegmentUse], words: Words
) -> Figure:
    """Draw the largest and the smallest tension along the line beside that at rest.

    Parameters
    ----------
    part : DynamicPart
        One load case.
    solution : Solution
        The line at rest.
    uses : sequence of SegmentUse
        What the segments may carry.
    words : Words
        Language.
    """
    arc, high, low = envelope(part)
    profile = solution.profile(161)
    drawn = [
        use.capacity for use in uses if use.capacity is not None and use.capacity <= FAR * max(high)
    ]
    frame = _frame((0.0, solution.line.length), [*high, *low, *profile.tension, *drawn])
    label = f"{words.name('Tension')} T ({_TENSION.field_unit})"
    shapes = axes(frame, f"{words.name('Arc length')} s (m)", label)
    upper = [frame.at(s, _TENSION.to_field(v)) for s, v in zip(arc, high, strict=True)]
    lower = [frame.at(s, _TENSION.to_field(v)) for s, v in zip(arc, low, strict=True)]
    around = " ".join(f"{number(x)},{number(y)}" for x, y in (*upper, *reversed(lower)))
    shapes.append(shape("polygon", "between", points=around))
    shapes += _allowed(frame, solution, uses, FAR * max(high))
    still = zip(profile.s, profile.tension, strict=True)
    shapes.append(path("curve third", [frame.at(s, _TENSION.to_field(v)) for s, v in still]))
    shapes.append(path("curve second", lower))
    shapes.append(path("curve first", upper))
    points = tuple(_along(frame, arc, high, low, profile.s, profile.tension, words))
    shown = _TENSION.format(max(high), unit=True)
    legend = [
        Legend("curve first", words("in_motion.high")),
        Legend("curve second", words("in_motion.low")),
        Legend("curve third", words("in_motion.still")),
    ]
    if drawn:
        legend.append(Legend("capacity", words("tension.capacity")))
    notes = tuple(
        words("tension.off_scale", number=use.number,
              capacity=_TENSION.format(use.capacity, unit=True))
        for use in uses
        if use.capacity is not None and use.capacity > FAR * max(high)
    )  # fmt: skip
    return Figure(
        "envelope", words("in_motion.envelope_alt", T=shown), _HEIGHT, tuple(shapes), points,
        tuple(legend), notes,
    )  # fmt: skip


def _allowed(
    frame: Frame, solution: Solution, uses: Sequence[SegmentUse], most: float
) -> Iterator[Shape]:
    start = 0.0
    for segment, use in zip(solution.segments, uses, strict=True):
        end = start + segment.length
        if use.capacity is not None and use.capacity <= most:
            left, right = frame.across(start), frame.across(end)
            level = frame.up(_TENSION.to_field(use.capacity))
            yield line("capacity", left, level, right, level)
            shown = _TENSION.format(use.capacity, unit=True)
            if right - left > breadth(shown):
                yield text(shown, (left + right) / 2, level + 17, style="tick")
        start = end


def _along(
    frame: Frame,
    arc: Sequence[float],
    high: Sequence[float],
    low: Sequence[float],
    s_rest: Sequence[float],
    T_rest: Sequence[float],
    words: Words,
) -> Iterator[Point]:
    import numpy as np

    step = max(1, math.ceil(len(arc) / _MOST))
    rest = np.interp(arc, s_rest, T_rest)
    for k in range(0, len(arc), step):
        told = words(
            "in_motion.along_point",
            s=QUANTITIES["s"].format(arc[k], unit=True),
            high=_TENSION.format(high[k], unit=True),
            low=_TENSION.format(low[k], unit=True),
            still=_TENSION.format(float(rest[k]), unit=True),
        )
        yield Point(*frame.at(arc[k], _TENSION.to_field(high[k])), told)


def _frame(x: tuple[float, float], tensions: Sequence[float]) -> Frame:
    known = [each for each in tensions if each == each]
    top = 1.08 * _TENSION.to_field(max(known)) or 1.0
    low = min(0.0, 1.08 * _TENSION.to_field(min(known)))
    return frame_in(_HEIGHT, x, (low, top))
