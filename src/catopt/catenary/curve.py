"""The load curve of one line: span, forces and grounded length over a range of force or span."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Literal

import numpy as np
import numpy.typing as npt

from catopt.catenary.batch import Solutions, solve_many
from catopt.errors import InputError, NoEquilibriumError, Problem
from catopt.model import Line

__all__ = ["Curve", "Mark", "load_curve"]

Array = npt.NDArray[np.float64]
Over = Literal["span", "horizontal_force"]


@dataclass(frozen=True)
class Mark:
    """A point of the curve at which something changes.

    Attributes
    ----------
    event : str
        What happens there, in words.
    horizontal_force, span, fairlead_tension : float
        Where: N, m, N.
    """

    event: str
    horizontal_force: float
    span: float
    fairlead_tension: float


@dataclass(frozen=True)
class Curve:
    """A load curve, by rising span; arrays of shape (points,).

    Attributes
    ----------
    over : str
        Which quantity was stepped evenly.
    span, horizontal_force, fairlead_tension, anchor_tension, grounded_length : ndarray
        m and N.
    anchor_angle : ndarray
        rad.
    stiffness : ndarray
        Horizontal end stiffness dH/dS at a fixed height, N/m.
    regime : tuple of str
        At each point.
    marks : tuple of Mark
        Changes of regime and limits reached, by rising span.
    """

    over: Over
    span: Array
    horizontal_force: Array
    fairlead_tension: Array
    anchor_tension: Array
    anchor_angle: Array
    grounded_length: Array
    stiffness: Array
    regime: tuple[str, ...]
    marks: tuple[Mark, ...]


def load_curve(
    line: Line,
    *,
    height: float,
    over: Over,
    start: float,
    stop: float,
    points: int = 50,
    seabed_friction: float = 0.0,
    anchor_height: float = 0.0,
    safety_factor: float = 1.0,
) -> Curve:
    """Compute a line's load curve in one compiled call.

    Parameters
    ----------
    line : Line
        The line.
    height, seabed_friction, anchor_height
        As for `solve`.
    over : {"span", "horizontal_force"}
        What is stepped.
    start, stop : float
        Its range: m or N.
    points : int
        At least 2.
    safety_factor : float
        For the limit MBL over safety factor.

    Raises
    ------
    InputError
        When the range is empty or there are too few points.
    NoEquilibriumError
        When a point of the range has no equilibrium.
    """
    _check(start, stop, points)
    values = np.linspace(start, stop, points)

    def at(many: Array) -> Solutions:
        force, span = (many, None) if over == "horizontal_force" else (None, many)
        return solve_many(
            line,
            height=height,
            horizontal_force=force,
            span=span,
            seabed_friction=seabed_friction,
            anchor_height=anchor_height,
        )

    found = at(values)
    if not found.converged.all():
        index = int(np.argmin(found.converged))
        unit = "m" if over == "span" else "N"
        raise NoEquilibriumError(
            f"at {over.replace('_', ' ')} {values[index]:.6g} {unit} the line has no equilibrium: "
            f"{found.reason(index)}. Choose a smaller range.",
            "length",
            math.nan,
        )
    marks = [*_regime_changes(at, values, found), *_limits(line, at, values, found, safety_factor)]
    flexibility = found.flexibility
    by_force = (
        flexibility[:, 0, 0] - flexibility[:, 0, 1] * flexibility[:, 1, 0] / flexibility[:, 1, 1]
    )
    return Curve(
        over=over,
        span=found.span,
        horizontal_force=found.horizontal_force,
        fairlead_tension=found.tension,
        anchor_tension=found.anchor_tension,
        anchor_angle=found.anchor_angle,
        grounded_length=found.grounded_length,
        stiffness=1.0 / by_force,
        regime=tuple(str(found.regime(index)) for index in range(points)),
        marks=tuple(sorted(marks, key=lambda mark: mark.span)),
    )


def _check(start: float, stop: float, points: int) -> None:
    problems = []
    if not (math.isfinite(start) and math.isfinite(stop) and 0.0 < start < stop):
        problems.append(
            Problem("range", f"from {start:g} to {stop:g}", "rising, above 0 and finite")
        )
    if points < 2:
        problems.append(Problem("points", str(points), "2 or more"))
    if problems:
        raise InputError(problems, "load_curve")


def _regime_changes(
    at: Callable[[Array], Solutions], values: Array, found: Solutions
) -> list[Mark]:
    """Bisect every pair of neighbours that differ in regime."""
    marks = []
    codes = found.regime_code
    for index in np.flatnonzero(codes[1:] != codes[:-1]):
        is_before = partial(_has_regime, code=int(codes[index]))
        place = _bisect(at, values[index], values[index + 1], is_before)
        before, after = found.regime(int(index)), found.regime(int(index) + 1)
        marks.append(_mark(at, place, f"{before} -> {after}"))
    return marks


def _has_regime(many: Solutions, code: int) -> npt.NDArray[np.bool_]:
    return np.equal(many.regime_code, code)


def _limits(
    line: Line,
    at: Callable[[Array], Solutions],
    values: Array,
    found: Solutions,
    safety_factor: float,
) -> list[Mark]:
    """Where the fairlead tension passes the strength of the uppermost segment."""
    MBL = line.segments[-1].MBL
    if MBL is None:
        return []
    limit = MBL / safety_factor
    over = np.flatnonzero((found.tension[1:] > limit) & (found.tension[:-1] <= limit))
    return [
        _mark(
            at,
            _bisect(at, values[index], values[index + 1], lambda s: s.tension <= limit),
            f"fairlead tension reaches MBL / {safety_factor:g}",
        )
        for index in over
    ]


def _bisect(
    at: Callable[[Array], Solutions],
    low: float,
    high: float,
    is_before: Callable[[Solutions], npt.NDArray[np.bool_]],
) -> float:
    """Last value before a change, by sections into 64 at once, to 1e-12 of the value."""
    while high - low > 1e-12 * high:
        parts = np.linspace(low, high, 65)
        after = np.flatnonzero(~is_before(at(parts)))
        first = int(after[0]) if after.size else 64
        if first == 0:
            return low
        low, high = float(parts[first - 1]), float(parts[first])
    return 0.5 * (low + high)


def _mark(at: Callable[[Array], Solutions], value: float, event: str) -> Mark:
    there = at(np.array([value]))
    return Mark(
        event, float(there.horizontal_force[0]), float(there.span[0]), float(there.tension[0])
    )
