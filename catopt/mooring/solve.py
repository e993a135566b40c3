"""Solve a moored body in closed form."""

from __future__ import annotations

import math

from catopt.catenary.pieces import LineProblem, cut
from catopt.catenary.root_search import BY_SPAN
from catopt.catenary.solve import solution_of
from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import CONVERGED
from catopt.errors import NotConvergedError
from catopt.model.system import Leg, System
from catopt.mooring.balance import Lines
from catopt.mooring.descent import Rest
from catopt.mooring.position import Position
from catopt.mooring.solution import LegState, SystemResidual, SystemSolution
from catopt.mooring.static_equilibrium import ZeroLoadPosition, is_held, zero_load_position
from catopt.words import Message

_AGAINST_X = -math.pi + 1e-12
"""rad: up to here a direction is that against x, which is given as pi."""
LINE_LIMIT = 1e-9
"""How far a laid-out line may miss its fairlead, as a part of its length."""


def solve_system(system: System) -> SystemSolution:
    """Find where a moored body comes to rest under its load, and what each line carries.

    Newton's method on x, y and, where the body turns, yaw, with the stiffness of the lines, from
    the zero-load position (docs/system.md).

    Parameters
    ----------
    system : System
        Lines, force and moment.

    Returns
    -------
    SystemSolution
        With its residuals.

    Raises
    ------
    NoEquilibriumError
        When a line that does not stretch is too short, or the lines cannot carry the moment.
    NotConvergedError
        When the solver stopped short of its tolerance.

    Examples
    --------
    >>> from math import radians
    >>> from catopt import Line, Segment, System, solve_system
    >>> chain = Line([Segment(600.0, 1000.0, EA=8e8)])
    >>> four = System.around(chain, azimuths=[radians(90.0 * k) for k in range(4)],
    ...                      anchor_radius=560.0, fairlead_height=50.0, force=(1e6, 0.0))
    >>> solution = solve_system(four)
    >>> solution.most_loaded, round(solution.offset[0], 2)
    (2, 35.53)
    """
    zero_load = zero_load_position(system)
    return solution_at(zero_load, *zero_load.under(system.force, system.moment))


def solution_at(
    zero_load: ZeroLoadPosition, rest: Rest, lines: Lines, *, looks_round: bool = True
) -> SystemSolution:
    """Lay out every line with the body at a place of rest; `looks_round` for other headings."""
    system, neutral, pull = zero_load.system, zero_load.neutral, rest.pull
    others: tuple[Rest, ...] = ()
    if looks_round:
        others = zero_load.other_headings(rest, lines, system.force, system.moment)
    states = tuple(
        _leg_state(leg, rest, system.seabed_friction, (lines.H[k], lines.V[k]), k)
        for k, leg in enumerate(system.legs)
    )
    return SystemSolution(
        system=system,
        position=Position(rest.x, rest.y, rest.yaw),
        neutral=Position(neutral.x, neutral.y, neutral.yaw),
        lines=states,
        full_stiffness=(
            (pull.xx, pull.xy, pull.xm),
            (pull.xy, pull.yy, pull.ym),
            (pull.xm, pull.ym, pull.mm),
        ),
        residual=SystemResidual(rest.force_error, rest.moment_error),
        steps=rest.steps,
        warnings=_warnings(zero_load, rest, states, others),
    )


def _leg_state(
    leg: Leg, rest: Rest, friction: float, known: tuple[float, float], index: int
) -> LegState:
    cosine, sine = math.cos(rest.yaw), math.sin(rest.yaw)
    arm_x, arm_y = leg.fairlead
    x = rest.x + cosine * arm_x - sine * arm_y
    y = rest.y + sine * arm_x + cosine * arm_y
    to_x, to_y = leg.anchor[0] - x, leg.anchor[1] - y
    span = math.hypot(to_x, to_y)
    pieces, segment_of = cut(leg.line)
    problem = LineProblem(pieces, float(leg.anchor_height), float(leg.fairlead_height), friction)
    H, V = known if known[0] > 0.0 else (math.nan, math.nan)
    state = given_span(max(span, 1e-9), problem, H, V)
    if state.status != CONVERGED:
        raise NotConvergedError(Message("mooring.line_not_converged", number=index + 1))
    own = solution_of(
        state._replace(span=max(span, 1e-9)),
        leg.line,
        problem,
        segment_of,
        method="closed-form",
        known=BY_SPAN,
    )
    worst = max(abs(own.residual.height), abs(own.residual.span))
    if not worst <= LINE_LIMIT * max(leg.line.length, span):
        raise NotConvergedError(Message("mooring.misses_fairlead", number=index + 1, missing=worst))
    # Above -pi and up to pi, whichever side of both rounding leaves it on.
    angle = math.atan2(to_y, to_x)
    return LegState(leg, own, (x, y), angle if angle > _AGAINST_X else math.pi)


def _warnings(
    zero_load: ZeroLoadPosition, rest: Rest, states: tuple[LegState, ...], others: tuple[Rest, ...]
) -> tuple[str, ...]:
    found = [
        of_line(index + 1, warning)
        for index, state in enumerate(states)
        for warning in state.solution.warnings
    ]
    if not is_held(rest.pull, zero_load.freedom):
        found.insert(0, Message("mooring.drifts"))
    for other in others:
        x, y = (f"{round(each, 3) + 0.0:.3f}" for each in (other.x, other.y))
        found.append(Message("mooring.other_heading", yaw=math.degrees(other.yaw), x=x, y=y))
    return tuple(found)


def of_line(number: int, said: str) -> Message:
    """Say of which line something is said, counted from 1."""
    return Message("mooring.of_line", number=number, warning=said)
