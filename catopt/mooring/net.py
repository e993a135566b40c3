"""Lines between points as the kernel takes them: what they pull with, and how stiffly.

Freedoms are numbers: a joint moves along x, y and z, a body along x and y and, where it turns, in
yaw, counted as the way of its longest arm; a point moves by the freedoms of its body, or by its
own. What lies on the bed or is pinned is a freedom that is held. So one method finds every rest.

With the span s and the heights a and b of a line's ends the kernel of one line says H and V at the
upper end and their derivatives by s and b, the other end held. What it lacks follows from the
regime: a line that hangs clear of the bed feels b - a alone; of one that lies on the bed without
friction either end feels the height of the other through H alone.

Plain functions of lists, or of arrays in compiled code.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

from catopt.catenary.equilibrium import given_force, hung_state
from catopt.catenary.pieces import LineProblem, Pieces, is_plain, reversed_pieces, total_length
from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import (
    CONVERGED,
    GROUNDED_BETWEEN,
    GROUNDED_IN_PARTS,
    State,
)
from catopt.catenary.suspended import FIRST_TOUCHDOWN
from catopt.compiled import inlined, packed

_NEAREST: Final = 1e-9
"""Of a line's length: ends nearer than that in plan are taken to be so far from each other."""

_SHORTEST: Final = 1e-12
"""Of a line's length, or of its tension, that is rounding."""

_EXACT, _TANGENTS = 2e-15, 8
"""Part of the length by which a span may be missed; tangents that are followed to it."""

_NEARLY: Final = 3e-3
"""Last relative step of a line that need not be exact."""

FREE, OVER_THE_BED, TURNS, PINNED = range(4)
"""What a freedom is: none of the others, the height of a joint, the yaw of a body, one held."""

STATE, GUESS, FORCES, STIFFNESS = len(State._fields), 8, 6, 36
"""Numbers of each line: those of a State; H, V, span and rise with the derivatives of H and V at
the second end by span and height; forces on both points; and stiffness of both, row by row."""

SPAN, GROUNDED = map(State._fields.index, ("span", "grounded"))
"""Which number of a State is the span, and the length on the bed."""


@packed
class Net(NamedTuple):
    """Lines between points, and what may move of them.

    The pieces of line k (as in catenary.pieces.Pieces, line after line) are those from `piece[k]`
    to `piece[k + 1]`; `load` begins at twice `piece[k] + k`. Three numbers of each point say where
    it is with its freedoms at 0 (`base`, m), four which freedom moves it along x, y and z and which
    turns it (-1: none), two how far it is off the origin of its body before the turn (`arm`, m).
    `pull` loads a freedom (N), `scale` is the arm of a yaw (m; else 1), `kind` one of the above;
    `group` has the first freedom of each joint and body, and their number. A float that has come up
    to the `surface` (m) has lost `buoyancy` of its pull (N; 0: it is none), and no part of it at
    `height` below that (m; 0: it is flat, and loses any part of it at the surface). Of the lines
    the first `used[0]` are there.
    """

    used: Any
    first: Any
    second: Any
    piece: Any
    length: Any
    weight: Any
    compliance: Any
    load: Any
    friction: Any
    base: Any
    freedom: Any
    arm: Any
    pull: Any
    scale: Any
    kind: Any
    group: Any
    surface: Any
    buoyancy: Any
    height: Any


WHOLE: Final = (
    "used",
    "first",
    "second",
    "piece",
    "freedom",
    "kind",
    "group",
    "held",
    "plan",
    "codes",
    "table",
)
"""Fields that are whole numbers."""


@packed
class Known(NamedTuple):
    """Where the freedoms are (`q`, m), and what is known there; written to.

    Of points their places and levers (m), of lines what STATE to STIFFNESS count; of freedoms
    what is left over, what the bed or a pin carries and what is lost of buoyancy (N), which are
    held, the stiffness (N/m), and room for a step. How all else follows a body that is turned, and
    where it last did; what was loaded, and how far off balance that was at the start (N). `plan` is
    1 of lines from a fixed point to one that moves in plan alone. `most` has the largest force left
    over at a joint or a body, the largest end force of a line, and that in plan (N).
    """

    q: Any
    place: Any
    lever: Any
    state: Any
    guess: Any
    force: Any
    block: Any
    left: Any
    laid: Any
    lost: Any
    held: Any
    stiffness: Any
    pivots: Any
    way: Any
    before: Any
    pulled: Any
    begun: Any
    follow: Any
    kept: Any
    asked: Any
    off: Any
    plan: Any
    most: Any


def room_for(net: Net) -> Known:
    """Make lists for what the kernel says, every line unknown."""
    lines, points, n = len(net.first), len(net.base) // 3, len(net.pull)
    sizes = {
        "place": 3 * points,
        "lever": 2 * points,
        "state": STATE * lines,
        "force": FORCES * lines,
        "block": STIFFNESS,
        "stiffness": n * n,
        "pivots": n * n,
        "most": 3,
    }
    made = {name: [0.0] * sizes.get(name, n) for name in Known._fields}
    plan = [int(_is_in_plan(k, net)) for k in range(lines)]
    return Known(**made | {"guess": [math.nan] * (GUESS * lines), "held": [0] * n, "plan": plan})


def _is_in_plan(k: int, net: Net) -> bool:
    a, b = 4 * net.first[k], 4 * net.second[k]
    return bool(max(net.freedom[a : a + 4]) < 0 and net.freedom[b + 2] < 0)


def hang(net: Net, known: Known, is_rough: bool) -> tuple[int, int]:
    """Place the points, and solve every line there, from its guess; status and line.

    `is_rough`: a few digits will do, in half the time, of lines whose upper ends move in plan.
    """
    place_points(net, known)
    for k in range(net.used[0]):
        status = _hang_one(k, net, known, is_rough and known.plan[k] == 1)
        if status != CONVERGED:
            return status, k
    return CONVERGED, -1


def place_points(net: Net, known: Known) -> None:
    """Place the points by the freedoms."""
    turned, cosine, sine = -1, 1.0, 0.0
    for p in range(len(net.base) // 3):
        at = 3 * p
        place_x, place_y, height = net.base[at], net.base[at + 1], net.base[at + 2]
        along, across, up = net.freedom[4 * p], net.freedom[4 * p + 1], net.freedom[4 * p + 2]
        if along < 0 and up < 0:
            known.place[at], known.place[at + 1], known.place[at + 2] = place_x, place_y, height
            continue
        x, y, turn = net.arm[2 * p], net.arm[2 * p + 1], net.freedom[4 * p + 3]
        if turn >= 0:
            if turn != turned:
                yaw = known.q[turn] / net.scale[turn]
                turned, cosine, sine = turn, math.cos(yaw), math.sin(yaw)
            x, y = cosine * x - sine * y, sine * x + cosine * y
        known.lever[2 * p], known.lever[2 * p + 1] = x, y
        place_x += known.q[along] if along >= 0 else 0.0
        place_y += known.q[across] if across >= 0 else 0.0
        known.place[at], known.place[at + 1] = place_x + x, place_y + y
        known.place[at + 2] = height + (known.q[up] if up >= 0 else 0.0)


def problem_of(k: int, net: Net, known: Known) -> LineProblem:
    """Say what a line is between its points: from its first end, towards which friction acts."""
    return problem_at(k, known.place[3 * net.first[k] + 2], known.place[3 * net.second[k] + 2], net)


@inlined
def problem_at(k: int, low: float, high: float, net: Net) -> LineProblem:
    """Say what a line is between two heights, m."""
    start, end = net.piece[k], net.piece[k + 1]
    pieces = Pieces(
        net.length[start:end],
        net.weight[start:end],
        net.compliance[start:end],
        net.load[2 * (start + k) : 2 * (end + k + 1)],
    )
    return LineProblem(pieces, low, high, net.friction[k])


@inlined
def chord_of(k: int, net: Net, known: Known) -> tuple[float, float, float]:
    """From the second point of a line to its first, in plan: x, y and how far, m."""
    a, b = 3 * net.first[k], 3 * net.second[k]
    x, y = known.place[a] - known.place[b], known.place[a + 1] - known.place[b + 1]
    return x, y, math.sqrt(x * x + y * y)


def _hang_one(k: int, net: Net, known: Known, is_rough: bool) -> int:
    """Solve a line between its points, and write what it pulls with; its status."""
    problem = problem_of(k, net, known)
    x, y, span = chord_of(k, net, known)
    clear = max(span, _NEAREST * total_length(problem.pieces))
    rise = problem.fairlead_height - problem.anchor_height
    at = GUESS * k
    H, V = known.guess[at], known.guess[at + 1]
    move, climb = clear - known.guess[at + 2], rise - known.guess[at + 3]
    ahead = H + known.guess[at + 4] * move + known.guess[at + 5] * climb
    aloft = V + known.guess[at + 6] * move + known.guess[at + 7] * climb
    # After a long way back the tangent says nothing.
    if not (H > 0.0 and ahead > 0.2 * H and aloft > 0.2 * V):
        ahead = aloft = math.nan
    if is_rough and ahead > 0.0 and problem.fairlead_height > 0.0 and is_plain(problem):
        state = _nearly(clear, problem, ahead, aloft)
    else:
        state = _solved(clear, problem, ahead, aloft)
    _write_state(k, state, known)
    if state.status != CONVERGED:
        return state.status
    at = FORCES * k
    x, y = x / clear, y / clear
    known.force[at], known.force[at + 1] = -state.H_anchor * x, -state.H_anchor * y
    known.force[at + 2] = state.V_anchor
    known.force[at + 3], known.force[at + 4] = state.H * x, state.H * y
    known.force[at + 5] = -state.V
    return CONVERGED


@inlined
def _write_state(k: int, state: State, known: Known) -> None:
    at = STATE * k
    known.state[at], known.state[at + 1] = state.status, state.regime
    known.state[at + 2], known.state[at + 3] = state.touchdown, state.H
    known.state[at + 4], known.state[at + 5] = state.V, state.span
    known.state[at + 6], known.state[at + 7] = state.height_error, state.grounded
    known.state[at + 8], known.state[at + 9] = state.H_anchor, state.V_anchor
    known.state[at + 10], known.state[at + 11] = state.x_H, state.x_V
    known.state[at + 12], known.state[at + 13] = state.z_H, state.z_V


def state_of(k: int, known: Known) -> State:
    """Read what is known of a line."""
    at = STATE * k
    return State(
        int(known.state[at]),
        int(known.state[at + 1]),
        int(known.state[at + 2]),
        known.state[at + 3],
        known.state[at + 4],
        known.state[at + 5],
        known.state[at + 6],
        known.state[at + 7],
        known.state[at + 8],
        known.state[at + 9],
        known.state[at + 10],
        known.state[at + 11],
        known.state[at + 12],
        known.state[at + 13],
    )


def _solved(span: float, problem: LineProblem, H: float, V: float) -> State:
    """Solve a line from near by, where that leads there, or as `given_span` does.

    A line of many parts has no Newton of its own there: its bracket is wide, a tangent is not.
    """
    if H > 0.0 and not is_plain(problem):
        limit = _EXACT * max(span, total_length(problem.pieces))
        for _ in range(_TANGENTS):
            state = given_force(H, problem)
            error = state.span - span
            if state.status != CONVERGED:
                break
            if abs(error) <= limit:
                return state
            slope = state.x_H - state.x_V * state.z_H / state.z_V if state.z_V > 0.0 else 0.0
            if not slope > 0.0:
                break
            H = max(H - error / slope, 0.2 * H)
    return given_span(span, problem, H, V)


def _nearly(span: float, problem: LineProblem, H: float, V: float) -> State:
    """Newton's method on (span, height) as in catenary.equilibrium, left as soon as it is close.

    The last step is taken and not looked at again: its error is the square of _NEARLY.
    """
    start_H, start_V = H, V
    for _ in range(6):
        state = hung_state(
            H, V, problem.pieces, problem.fairlead_height, problem.friction, FIRST_TOUCHDOWN
        )
        determinant = state.x_H * state.z_V - state.x_V * state.z_H
        if not determinant > 0.0:
            break
        error = state.span - span
        dH = (state.x_V * state.height_error - state.z_V * error) / determinant
        dV = (state.z_H * error - state.x_H * state.height_error) / determinant
        steps = max(abs(dH) / H, abs(dV) / max(V, H))
        H = min(max(H + dH, 0.1 * H), 10.0 * H)
        V = max(V + dV, 0.1 * V)
        if steps <= _NEARLY:
            return State(
                state.status,
                state.regime,
                state.touchdown,
                H,
                V,
                span,
                0.0,
                state.grounded,
                state.H_anchor,
                state.V_anchor,
                state.x_H,
                state.x_V,
                state.z_H,
                state.z_V,
            )
    return given_span(span, problem, start_H, start_V)


def by_end(state: State, problem: LineProblem) -> tuple[float, float, float, float]:
    """Derive H and V at the second end by the span and by its height, N/m."""
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
    """Derive the tension of a slack line at its second end by that end's height, N/m.

    It takes up what lies at the touchdown, and stretches above it; where a point load there is
    being lifted, it stretches alone. What hangs there is what that tension carries: the other end
    may be off the bed, too.
    """
    carried, stretch, rounding = state.V, 0.0, _SHORTEST * state.V
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


@inlined
def slopes_of(k: int, net: Net, known: Known) -> tuple[float, float, float, float]:
    """Derive H and V of a line as it hangs, as `by_end`."""
    at = STATE * k
    H, x_H, x_V = known.state[at + 3], known.state[at + 10], known.state[at + 11]
    z_H, z_V = known.state[at + 12], known.state[at + 13]
    determinant = x_H * z_V - x_V * z_H
    if H == 0.0 or determinant == 0.0:
        return by_end(state_of(k, known), problem_of(k, net, known))
    return z_V / determinant, -x_V / determinant, -z_H / determinant, x_H / determinant


class Slopes(NamedTuple):
    """Derivatives of H and V at the second end, and of those at the first (pulling up), N/m.

    By the span, by the height of the first end (_a) and by that of the second (_b).
    """

    H: float
    H_a: float
    H_b: float
    V: float
    V_a: float
    V_b: float
    anchor_H: float
    anchor_H_a: float
    anchor_H_b: float
    anchor_V: float
    anchor_V_a: float
    anchor_V_b: float


def _slopes(state: State, span: float, problem: LineProblem) -> Slopes:
    """Derive the forces at both ends of a line."""
    H, H_b, V, V_b = by_end(state, problem)
    # A point load alone may touch the bed, over no length, and carries part of the line there.
    rests = state.regime == GROUNDED_BETWEEN or state.regime == GROUNDED_IN_PARTS
    if state.grounded == 0.0 and not rests:
        return Slopes(H, -H_b, H_b, V, -V_b, V_b, H, -H_b, H_b, V, -V_b, V_b)
    if problem.friction > 0.0 or problem.anchor_height == 0.0:
        return Slopes(H, 0.0, H_b, V, 0.0, V_b, H, 0.0, H_b, 0.0, 0.0, 0.0)
    other = LineProblem(
        reversed_pieces(problem.pieces),
        problem.fairlead_height,
        problem.anchor_height,
        problem.friction,
    )
    back = _solved(span, other, state.H, max(-state.V_anchor, 0.0))
    if back.status != CONVERGED:
        return Slopes(H, 0.0, H_b, V, 0.0, V_b, H, 0.0, H_b, 0.0, 0.0, 0.0)
    # Counted from the other end the line lifts a with V upwards: the sign of V at a is turned.
    _, H_a, up, up_a = by_end(back, other)
    slope = 1.0 / H if H > 0.0 else 0.0
    V_a, up_b = V * slope * H_a, up * slope * H_b
    return Slopes(H, H_a, H_b, V, V_a, V_b, H, H_a, H_b, -up, -up_a, -up_b)


def stiffen(k: int, net: Net, known: Known) -> None:
    """Write the stiffness of both ends of a line in space to the block, row by row.

    It is minus the derivatives of the forces on both points by the places of both.
    """
    state, problem = state_of(k, known), problem_of(k, net, known)
    x, y, span = chord_of(k, net, known)
    clear = max(span, _NEAREST * total_length(problem.pieces))
    of = _slopes(state, clear, problem)
    ux, uy = (x / span, y / span) if span > 0.0 else (1.0, 0.0)
    _fill(0, -1.0, of.anchor_H, of.anchor_H_a, of.anchor_H_b, state.H_anchor / clear, ux, uy, known)
    _fill(3, 1.0, of.H, of.H_a, of.H_b, state.H / clear, ux, uy, known)
    _level(12, -1.0, of.anchor_V, of.anchor_V_a, of.anchor_V_b, ux, uy, known)
    _level(30, 1.0, of.V, of.V_a, of.V_b, ux, uy, known)


@inlined
def _fill(
    row: int,
    sign: float,
    H_s: float,
    H_a: float,
    H_b: float,
    across: float,
    x: float,
    y: float,
    known: Known,
) -> None:
    """Write the two rows of an end's force in plan.

    The force is sign (H u, -V), the span grows by u (da - db), u itself turns by its part across.
    """
    xx = sign * (H_s * x * x + across * y * y)
    xy = sign * ((H_s - across) * x * y)
    yy = sign * (H_s * y * y + across * x * x)
    at = 6 * row
    known.block[at], known.block[at + 1], known.block[at + 2] = -xx, -xy, -sign * H_a * x
    known.block[at + 3], known.block[at + 4], known.block[at + 5] = xx, xy, -sign * H_b * x
    known.block[at + 6], known.block[at + 7], known.block[at + 8] = -xy, -yy, -sign * H_a * y
    known.block[at + 9], known.block[at + 10], known.block[at + 11] = xy, yy, -sign * H_b * y


@inlined
def _level(
    at: int, sign: float, V_s: float, V_a: float, V_b: float, x: float, y: float, known: Known
) -> None:
    """Write the row of an end's vertical force."""
    x, y = sign * V_s * x, sign * V_s * y
    known.block[at], known.block[at + 1], known.block[at + 2] = x, y, sign * V_a
    known.block[at + 3], known.block[at + 4], known.block[at + 5] = -x, -y, sign * V_b
