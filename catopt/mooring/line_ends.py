"""A line between two points at any height: what it pulls with at both ends, and how stiffly.

With the span s and the heights a and b of its ends the kernel says H and V at the upper end and
their derivatives by s and b, the other end held. What it lacks follows from the regime: a line that
hangs clear of the bed feels b - a alone; of one that lies on the bed without friction either end
feels the height of the other through H alone.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from catopt.catenary.equilibrium import given_force
from catopt.catenary.pieces import LineProblem, Pieces, is_plain, turned
from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import CONVERGED, GROUNDED_BETWEEN, GROUNDED_IN_PARTS, State

Vector = tuple[float, float, float]
Matrix = tuple[tuple[float, ...], ...]

NEAREST = 1e-9
"""Of a line's length: ends nearer than that in plan are taken to be so far from each other."""

SHORTEST = 1e-12
"""Of a line's length, or of its tension, that is rounding."""

EXACT, STEPS = 2e-15, 8
"""Part of the length by which a span may be missed; tangents that are followed to it."""


class Ends(NamedTuple):
    """A line between two points; empty but for state and problem where the kernel has no answer.

    `first` and `second` are the forces of the line on either point (N), `stiffness` (6 x 6) minus
    the derivatives of both by the places of both points, N/m.
    """

    state: State
    problem: LineProblem
    first: tuple[float, ...]
    second: tuple[float, ...]
    stiffness: Matrix


def ends_of(pieces: Pieces, a: Vector, b: Vector, friction: float, known: Ends | None) -> Ends:
    """Solve a line from point a, towards which friction takes off tension, to point b.

    `known`: the same line near by, or None.
    """
    span = math.hypot(a[0] - b[0], a[1] - b[1])
    clear = max(span, NEAREST * math.fsum(pieces.length))
    problem = LineProblem(pieces, a[2], b[2], friction)
    state = _solved(clear, problem, *_guess(clear, problem, known))
    if state.status != CONVERGED:
        return Ends(state, problem, (), (), ())
    u = ((a[0] - b[0]) / clear, (a[1] - b[1]) / clear)
    first = (-state.H_anchor * u[0], -state.H_anchor * u[1], state.V_anchor)
    second = (state.H * u[0], state.H * u[1], -state.V)
    unit = (u[0] * clear / span, u[1] * clear / span) if span > 0.0 else (1.0, 0.0)
    stiffness = _stiffness(state, _slopes(state, clear, problem), unit, clear)
    return Ends(state, problem, first, second, stiffness)


def _solved(span: float, problem: LineProblem, H: float, V: float) -> State:
    """Solve a line from near by, where that leads there, or as `given_span` does.

    A line of many parts has no Newton of its own there: its bracket is wide, a tangent is not.
    """
    if H > 0.0 and not is_plain(problem):
        limit = EXACT * max(span, math.fsum(problem.pieces.length))
        for _ in range(STEPS):
            state = given_force(H, problem)
            error = state.span - span
            if state.status != CONVERGED or abs(error) <= limit:
                break
            slope = state.x_H - state.x_V * state.z_H / state.z_V if state.z_V > 0.0 else 0.0
            if not slope > 0.0:
                break
            H = max(H - error / slope, 0.2 * H)
        if state.status == CONVERGED and abs(error) <= limit:
            return state
    return given_span(span, problem, H, V)


def _guess(span: float, problem: LineProblem, known: Ends | None) -> tuple[float, float]:
    """Follow H and V at the end b along the tangent from where they are known; nan for unknown."""
    if known is None or not known.state.H > 0.0:
        return math.nan, math.nan
    state, before = known.state, known.problem
    H_s, H_b, V_s, V_b = _by_end(state, before)
    move = span - state.span
    rise = problem.fairlead_height - problem.anchor_height
    rise -= before.fairlead_height - before.anchor_height
    H, V = state.H + H_s * move + H_b * rise, state.V + V_s * move + V_b * rise
    # After a long way back the tangent says nothing.
    is_near = H > 0.2 * state.H and V > 0.2 * state.V
    return (H, V) if is_near else (math.nan, math.nan)


def _slopes(state: State, span: float, problem: LineProblem) -> Matrix:
    """Derive H and V at b, H and V at a (pulling up), by the span and the heights a and b."""
    H_s, H_b, V_s, V_b = _by_end(state, problem)
    # A point load alone may touch the bed, over no length, and carries part of the line there.
    rests = state.regime in (GROUNDED_BETWEEN, GROUNDED_IN_PARTS)
    if state.grounded == 0.0 and not rests:
        row_H, row_V = (H_s, -H_b, H_b), (V_s, -V_b, V_b)
        return row_H, row_V, row_H, row_V
    alone = (H_s, 0.0, H_b), (V_s, 0.0, V_b), (H_s, 0.0, H_b), (0.0, 0.0, 0.0)
    if problem.friction > 0.0 or problem.anchor_height == 0.0:
        return alone
    other = LineProblem(
        turned(problem.pieces), problem.fairlead_height, problem.anchor_height, problem.friction
    )
    back = _solved(span, other, state.H, max(-state.V_anchor, 0.0))
    if back.status != CONVERGED:
        return alone
    # Counted from the other end the line lifts a with V upwards: the sign of V at a is turned.
    _, H_a, up_s, up_a = _by_end(back, other)
    slope = 1.0 / H_s if H_s > 0.0 else 0.0
    row_H = (H_s, H_a, H_b)
    return row_H, (V_s, V_s * slope * H_a, V_b), row_H, (-up_s, -up_a, -up_s * slope * H_b)


def _by_end(state: State, problem: LineProblem) -> tuple[float, float, float, float]:
    """Derive H and V at the end b by the span and by its height, N/m."""
    determinant = state.x_H * state.z_V - state.x_V * state.z_H
    if state.H == 0.0 or determinant == 0.0:
        # Slack: it hangs straight down to the bed, and lifts more of itself as it is raised. One
        # whose end lies on the bed is as stiff along it as its span grows with the force.
        along = 1.0 / state.x_H if state.H > 0.0 and state.x_H > 0.0 else 0.0
        return along, 0.0, 0.0, _lift_slope(state, problem.pieces)
    return (
        state.z_V / determinant,
        -state.x_V / determinant,
        -state.z_H / determinant,
        state.x_H / determinant,
    )


def _lift_slope(state: State, pieces: Pieces) -> float:
    """Derive the tension of a slack line at its end b by that end's height, N/m.

    It takes up what lies at the touchdown, and stretches above it; where a point load there is
    being lifted, it stretches alone. What hangs there is what that tension carries: the other end
    may be off the bed, too.
    """
    carried, stretch, rounding = state.V, 0.0, SHORTEST * state.V
    for k in range(len(pieces.length) - 1, -1, -1):
        w, length = pieces.weight[k], pieces.length[k]
        if carried < w * length - rounding:
            stretch += carried / w * pieces.compliance[k]
            return float(w / (1.0 + w * stretch))
        carried -= w * length
        stretch += length * pieces.compliance[k]
        if rounding < carried < pieces.load[k] - rounding and stretch > 0.0:
            return float(1.0 / stretch)
        carried = max(carried - pieces.load[k], 0.0)
    return float(max(pieces.weight[0], 0.0))


def _stiffness(state: State, slopes: Matrix, u: tuple[float, float], span: float) -> Matrix:
    """Turn slopes in the plane of the line into the stiffness of both ends in space."""
    (x, y), rows = u, []
    for (of_H, of_V), H, sign in ((slopes[2:], state.H_anchor, -1.0), (slopes[:2], state.H, 1.0)):
        across = H / span
        # The force is sign (H u, -V), the span grows by u (da - db), u itself turns by its part
        # across.
        xx = of_H[0] * x * x + across * y * y
        xy = (of_H[0] - across) * x * y
        yy = of_H[0] * y * y + across * x * x
        plan = ((xx, xy), (xy, yy))
        for i in (0, 1):
            by_a = (*(-sign * plan[i][j] for j in (0, 1)), -sign * of_H[1] * u[i])
            by_b = (*(sign * plan[i][j] for j in (0, 1)), -sign * of_H[2] * u[i])
            rows.append((*by_a, *by_b))
        level = (sign * of_V[0] * x, sign * of_V[0] * y)
        rows.append((*level, sign * of_V[1], -level[0], -level[1], sign * of_V[2]))
    return tuple(rows)
