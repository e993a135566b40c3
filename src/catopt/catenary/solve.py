"""Solve one line in closed form: the public calls, and the words for what cannot be."""

from __future__ import annotations

import math

from catopt.catenary.equilibrium import given_force
from catopt.catenary.inverse import given_span, given_tension, least_tension
from catopt.catenary.pieces import Pieces, cut
from catopt.catenary.result import solution_of
from catopt.catenary.solution import Solution
from catopt.catenary.state import (
    CONVERGED,
    NOT_CONVERGED,
    TOO_HEAVY,
    TOO_SHORT,
    TOUCHES_TWICE,
    State,
)
from catopt.errors import NoEquilibriumError, NotConvergedError, TouchesTwiceError
from catopt.model import Line, Load
from catopt.model.validity import Findings

__all__ = ["solve"]

LEAST_FORCE, GREATEST_FORCE = 1e-30, 1e30
"""N: beyond them products of forces leave the range of double precision."""

RESIDUAL_LIMIT = 1e-9
"""How far the laid-out line may miss the fairlead, as a part of its length."""


def solve(
    line: Line,
    *,
    height: float,
    horizontal_force: float | None = None,
    span: float | None = None,
    fairlead_tension: float | None = None,
    seabed_friction: float = 0.0,
    anchor_height: float = 0.0,
) -> Solution:
    """Solve one line in closed form.

    Exactly one of `horizontal_force`, `span` and `fairlead_tension` is given.

    Parameters
    ----------
    line : Line
        Segments from the anchor to the fairlead, with point loads.
    height : float
        Height of the fairlead above the seabed, m.
    horizontal_force : float, optional
        N.
    span : float, optional
        Horizontal distance from the anchor to the fairlead, m.
    fairlead_tension : float, optional
        Effective tension at the fairlead, N.
    seabed_friction : float
        Coulomb coefficient.
    anchor_height : float
        Height of the anchor above the seabed, m. Above 0 the line may hang below its anchor.

    Returns
    -------
    Solution
        With its residuals.

    Raises
    ------
    InputError
        When arguments are missing, contradictory or out of range; all of them at once.
    NoEquilibriumError
        When no line hangs so; it says how much length or force is missing.
    TouchesTwiceError
        When a buoyant part lifts the line off the bed between two stretches that lie there.
    NotConvergedError
        When the solver stopped short of its tolerance.

    Examples
    --------
    >>> from catopt import Line, Segment, solve
    >>> buoy = solve(Line([Segment(20.0, 93.163)]), height=9.5, horizontal_force=3363.68)
    >>> round(buoy.span, 2)
    17.43
    """
    load = Load(horizontal_force, span, fairlead_tension)
    _check(line, load, height, anchor_height, seabed_friction)
    pieces, segment_of = cut(line)
    state = _solve(load, pieces, anchor_height, height, seabed_friction)
    if state.status != CONVERGED:
        raise _failure(state.status, line, load, pieces, height, anchor_height, seabed_friction)
    return _solution(state, line, pieces, segment_of, load, height, anchor_height, seabed_friction)


def _check(
    line: Line, load: Load, height: float, anchor_height: float, seabed_friction: float
) -> None:
    found = Findings("solve")
    found.number("height", height, "m", at_least=0.0)
    found.number("anchor_height", anchor_height, "m", at_least=0.0)
    found.number("seabed_friction", seabed_friction, "", at_least=0.0)
    for value in (load.horizontal_force, load.fairlead_tension):
        if value is not None and not LEAST_FORCE <= value <= GREATEST_FORCE:
            found.add("load", f"{value:g} N", f"from {LEAST_FORCE:g} to {GREATEST_FORCE:g} N")
    weightless = all(segment.submerged_weight == 0.0 for segment in line.segments)
    if weightless and not line.point_loads and load.horizontal_force is None:
        found.add(
            "segments",
            "no submerged weight in any of them",
            "a line without weight needs load.horizontal_force: its shape does not tell the force",
        )
    found.raise_if_any()


def _solve(
    load: Load, pieces: Pieces, anchor_height: float, height: float, friction: float
) -> State:
    if load.horizontal_force is not None:
        return given_force(load.horizontal_force, pieces, anchor_height, height, friction)
    if load.span is not None:
        nan = math.nan
        return given_span(load.span, pieces, anchor_height, height, friction, nan, nan)
    assert load.fairlead_tension is not None
    return given_tension(load.fairlead_tension, pieces, anchor_height, height, friction)


def _solution(
    state: State,
    line: Line,
    pieces: Pieces,
    segment_of: tuple[int, ...],
    load: Load,
    height: float,
    anchor_height: float,
    friction: float,
) -> Solution:
    wanted = load.span if load.span is not None else state.span
    solution = solution_of(
        state._replace(span=wanted),
        line,
        pieces,
        segment_of,
        method="closed-form",
        height=height,
        anchor_height=anchor_height,
        friction=friction,
    )
    worst = max(abs(solution.residual.height), abs(solution.residual.span))
    if not worst <= RESIDUAL_LIMIT * max(line.length, wanted):
        raise NotConvergedError(
            f"the line misses its fairlead by {worst:.3g} m after the last step; "
            "please report this case"
        )
    return solution


def _failure(
    status: int,
    line: Line,
    load: Load,
    pieces: Pieces,
    height: float,
    anchor_height: float,
    friction: float,
) -> Exception:
    """Say what stops the line, and by how much."""
    rise = height - anchor_height
    if status == TOO_SHORT:
        distance = math.hypot(load.span or 0.0, rise)
        return NoEquilibriumError(
            _too_short(line.length, distance, load), "length", distance - line.length
        )
    if status == TOO_HEAVY:
        assert load.fairlead_tension is not None
        at_least, _ = least_tension(load.fairlead_tension, pieces, anchor_height, height, friction)
        least = math.hypot(at_least.H, at_least.V)
        missing = least - load.fairlead_tension
        return NoEquilibriumError(
            f"the fairlead tension of {load.fairlead_tension:.6g} N is {missing:.6g} N too small: "
            f"with this line it is never below {least:.6g} N, which the part that hangs from the "
            "fairlead weighs. Give at least that much, or a lighter line.",
            "force",
            missing,
        )
    if status == TOUCHES_TWICE:
        return TouchesTwiceError(
            f"{_first_buoyant(line)} lifts the line off the bed between two stretches that lie on "
            "it. The closed form holds for one stretch on the bed; move the buoyant part towards "
            "the fairlead, make it smaller, or pull harder."
        )
    assert status == NOT_CONVERGED
    return NotConvergedError("the closed form did not converge; please report this case")


def _too_short(length: float, distance: float, load: Load) -> str:
    missing = distance - length
    where = "up to the fairlead" if load.span is None else "from the anchor to the fairlead"
    head = f"the line is {length:.6g} m long and the straight way {where} is {distance:.6g} m"
    if missing > 0.0:
        return f"{head}: it is {missing:.6g} m too short. Give it more than that."
    return f"{head}: just as long, so that no finite force draws it straight. Give it some slack."


def _first_buoyant(line: Line) -> str:
    for index, load in enumerate(line.point_loads):
        if load.submerged_weight < 0.0:
            name = f" ({load.name})" if load.name else ""
            return f"the buoy line.point_loads[{index}]{name} at {load.position:g} m"
    for index, segment in enumerate(line.segments):
        if segment.submerged_weight < 0.0:
            name = f" ({segment.name})" if segment.name else ""
            return f"the buoyant segment line.segments[{index}]{name}"
    return "a buoyant part"
