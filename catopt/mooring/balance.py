"""All lines of a body as the kernel takes them, and what they do to it at one position."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from catopt.catenary.equilibrium import hang_slack, hung_state
from catopt.catenary.pieces import LineProblem, Pieces, cut, is_plain
from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_SHORT, State, failed
from catopt.catenary.suspended import FIRST_TOUCHDOWN
from catopt.model.line import Line
from catopt.model.system import Leg, System


class Arrangement(NamedTuple):
    """Where the ends of the lines are and what the lines are made of.

    Lists in plain code, arrays in compiled code. Anchors and heights (above the seabed) in m, arms
    are the fairleads in the body's axes (m), friction the Coulomb coefficient of the bed. The
    pieces of line k (as in catenary.pieces.Pieces, line after line) are those from `first[k]` to
    `first[k + 1]`; `load` begins at twice `first[k] + k`. slack_span is the longest span at which a
    line pulls to no side (m; below 0 when there is none), with its vertical forces (N) and length
    on the bed (m) there.
    """

    anchor_x: Any
    anchor_y: Any
    anchor_height: Any
    arm_x: Any
    arm_y: Any
    fairlead_height: Any
    friction: float
    first: Any
    length: Any
    weight: Any
    compliance: Any
    load: Any
    slack_span: Any
    slack_V: Any
    slack_V_anchor: Any
    slack_grounded: Any


class Lines(NamedTuple):
    """What is known of each line at a position of the body; written to by the kernel.

    H and V at the fairlead (N; nan before the first position), span and grounded length (m), forces
    on the anchor (N); H_S and V_S are derivatives of H and V by the span, the height held (N/m).
    """

    H: Any
    V: Any
    span: Any
    grounded: Any
    H_anchor: Any
    V_anchor: Any
    H_S: Any
    V_S: Any


def arrange(system: System) -> Arrangement:
    """Lay out a system as lists of plain numbers."""
    first, length, weight, compliance, load = [0], [], [], [], []
    slack = []
    known: dict[tuple[Line, float, float], tuple[float, float, float, float]] = {}
    for leg in system.legs:
        pieces, _ = cut(leg.line)
        key = (leg.line, leg.anchor_height, leg.fairlead_height)
        if key not in known:
            known[key] = _slack(pieces, leg, system.seabed_friction)
        slack.append(known[key])
        length += pieces.length
        weight += pieces.weight
        compliance += pieces.compliance
        load += pieces.load
        first.append(len(length))
    legs = system.legs
    return Arrangement(
        anchor_x=[leg.anchor[0] for leg in legs],
        anchor_y=[leg.anchor[1] for leg in legs],
        anchor_height=[float(leg.anchor_height) for leg in legs],
        arm_x=[leg.fairlead[0] for leg in legs],
        arm_y=[leg.fairlead[1] for leg in legs],
        fairlead_height=[float(leg.fairlead_height) for leg in legs],
        friction=float(system.seabed_friction),
        first=first,
        length=length,
        weight=weight,
        compliance=compliance,
        load=load,
        slack_span=[each[0] for each in slack],
        slack_V=[each[1] for each in slack],
        slack_V_anchor=[each[2] for each in slack],
        slack_grounded=[each[3] for each in slack],
    )


def _slack(pieces: Pieces, leg: Leg, friction: float) -> tuple[float, float, float, float]:
    """Span, V, V at the anchor and grounded length of a line that just hangs slack."""
    problem = LineProblem(pieces, float(leg.anchor_height), float(leg.fairlead_height), friction)
    drop = leg.fairlead_height + leg.anchor_height
    state = hang_slack(problem) if drop < leg.line.length else failed(TOO_SHORT)
    if state.status != CONVERGED:
        return -1.0, 0.0, 0.0, 0.0
    return state.span, state.V, state.V_anchor, state.grounded


def room_for(lines: int) -> Lines:
    """Make lists for what the kernel says of each line."""
    return Lines(*([float("nan")] * lines for _ in Lines._fields))


NEARLY = 3e-3
"""Last relative step of a line that need not be exact."""

ROUNDING = 1e-12
"""How far a span, as a part of itself, may be beyond that of a slack line by rounding."""


class RestoringForce(NamedTuple):
    """Force of all lines on the body (N, N, N m), and how it falls as the body moves.

    status is CONVERGED, or that of the `line` that has no answer there (catenary.state). xx to mm
    are the stiffness: minus the derivatives by x, y (N/m) and yaw (N, N m). `total` is the sum of
    the horizontal forces of the lines, N.
    """

    status: int
    line: int
    x: float
    y: float
    moment: float
    xx: float
    xy: float
    yy: float
    xm: float
    ym: float
    mm: float
    total: float


def pull_at(
    x: float, y: float, yaw: float, arrangement: Arrangement, lines: Lines, is_exact: bool
) -> RestoringForce:
    """Solve every line with the body at a position (m, m, rad); `lines` is written to.

    A line with horizontal force H along the unit vector u towards its anchor, its span S, pulls
    with H u. Its stiffness is dH/dS along u and H/S across it; a fairlead at r off the origin
    adds H u.r in yaw. Each line is sought from what was known of it at the last position; where it
    is not to be exact, a few digits will do, in half the time.
    """
    cosine, sine = math.cos(yaw), math.sin(yaw)
    force_x = force_y = moment = 0.0
    xx = xy = yy = xm = ym = mm = 0.0
    total = 0.0
    for k in range(len(arrangement.anchor_x)):
        arm_x = cosine * arrangement.arm_x[k] - sine * arrangement.arm_y[k]
        arm_y = sine * arrangement.arm_x[k] + cosine * arrangement.arm_y[k]
        along_x = arrangement.anchor_x[k] - x - arm_x
        along_y = arrangement.anchor_y[k] - y - arm_y
        span = math.sqrt(along_x * along_x + along_y * along_y)
        if span > 0.0:
            along_x /= span
            along_y /= span
        else:
            # Straight above its anchor a line pulls to no side; any direction will do.
            span, along_x, along_y = 1e-9, 1.0, 0.0
        status = _hang(k, span, arrangement, lines, is_exact)
        if status != CONVERGED:
            return _no_pull(status, k)
        H = lines.H[k]
        stiff, across = lines.H_S[k], H / span
        # The line's stiffness at its fairlead, and the way the fairlead goes as the body turns.
        line_xx = stiff * along_x * along_x + across * along_y * along_y
        line_xy = (stiff - across) * along_x * along_y
        line_yy = stiff * along_y * along_y + across * along_x * along_x
        turn_x, turn_y = -arm_y, arm_x
        line_xm = line_xx * turn_x + line_xy * turn_y
        line_ym = line_xy * turn_x + line_yy * turn_y
        force_x += H * along_x
        force_y += H * along_y
        moment += H * (along_x * turn_x + along_y * turn_y)
        xx += line_xx
        xy += line_xy
        yy += line_yy
        xm += line_xm
        ym += line_ym
        mm += line_xm * turn_x + line_ym * turn_y + H * (along_x * arm_x + along_y * arm_y)
        total += H
    return RestoringForce(CONVERGED, -1, force_x, force_y, moment, xx, xy, yy, xm, ym, mm, total)


def _hang(k: int, span: float, arrangement: Arrangement, lines: Lines, is_exact: bool) -> int:
    """Solve line k for its span, from where it was; its status."""
    if span <= (1.0 + ROUNDING) * arrangement.slack_span[k]:
        lines.H[k] = lines.H_anchor[k] = lines.H_S[k] = lines.V_S[k] = 0.0
        lines.V[k], lines.V_anchor[k] = arrangement.slack_V[k], arrangement.slack_V_anchor[k]
        lines.span[k], lines.grounded[k] = span, arrangement.slack_grounded[k]
        return CONVERGED
    start, end = arrangement.first[k], arrangement.first[k + 1]
    pieces = Pieces(
        arrangement.length[start:end],
        arrangement.weight[start:end],
        arrangement.compliance[start:end],
        arrangement.load[2 * (start + k) : 2 * (end + k + 1)],
    )
    problem = LineProblem(
        pieces, arrangement.anchor_height[k], arrangement.fairlead_height[k], arrangement.friction
    )
    # Along the tangent from where it was; after a long way back that says nothing.
    move = span - lines.span[k]
    H = lines.H[k] + lines.H_S[k] * move
    V = lines.V[k] + lines.V_S[k] * move
    if not (H > 0.2 * lines.H[k] and V > 0.2 * lines.V[k]):
        H = V = math.nan
    state = failed(NOT_CONVERGED)
    if not is_exact and H > 0.0 and problem.fairlead_height > 0.0 and is_plain(problem):
        state = _nearly(span, problem, H, V)
    if state.status != CONVERGED:
        state = given_span(span, problem, H, V)
    if state.status != CONVERGED:
        return state.status
    lines.H[k] = state.H
    lines.V[k] = state.V
    lines.span[k] = span
    lines.grounded[k] = state.grounded
    lines.H_anchor[k] = state.H_anchor
    lines.V_anchor[k] = state.V_anchor
    determinant = state.x_H * state.z_V - state.x_V * state.z_H
    if state.H > 0.0 and determinant > 0.0:
        lines.H_S[k] = state.z_V / determinant
        lines.V_S[k] = -state.z_H / determinant
    elif state.H > 0.0 and state.z_V == 0.0 and state.x_H > 0.0:
        # Its fairlead lies on the bed: it is as stiff along it as its span grows with the force.
        lines.H_S[k], lines.V_S[k] = 1.0 / state.x_H, 0.0
    else:
        lines.H_S[k] = lines.V_S[k] = 0.0
    return CONVERGED


def _nearly(span: float, problem: LineProblem, H: float, V: float) -> State:
    """Newton's method on (span, height) as in catenary.root_search, left as soon as it is close.

    The last step is taken and not looked at again: its error is the square of NEARLY.
    """
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
        if steps <= NEARLY:
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
    return failed(NOT_CONVERGED)


def _no_pull(status: int, line: int) -> RestoringForce:
    nan = math.nan
    return RestoringForce(status, line, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan)
