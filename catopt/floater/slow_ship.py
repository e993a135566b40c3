"""The slow motion of a ship in wind, current and waves on her lines, stepped in time.

Axes of the ship: x forwards, y to port, moments counter-clockwise, about the origin of the system.
The state is x, y and yaw of the origin, and its speeds along and across the ship and of the turn.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import CONVERGED
from catopt.floater.line_tables import LineTables, tabulated
from catopt.mooring.net import Known, Net, hang, problem_at
from catopt.mooring.rest import add_up, remember

HEADINGS: Final = 72
"""Of the ship, all round, between which drift and response are interpolated."""
BEYOND: Final = -2
"""What stands for a line at fault where the ship turns beyond the headings of her drift."""


class SlowShip(NamedTuple):
    """What drives a ship; arrays in compiled code. Axes as in `catopt.floater.slow_ship`.

    `inverse` (3, 3): of the inertia; `lever`: of the centre of gravity, m ahead of the origin;
    `added`: masses of the water in surge and sway; `damping` (3,): about midships; `turn_sway` and
    `turn_yaw`: force and moment of a turn over its rate and the speed through the water;
    `crossflow`: drag across over a strip's length and the square of its speed; `half`: of the
    length; tables (n + 1, 3) over the square of the speed; `turns`: whether the lines turn with
    the ship; `wind` (n, 2), `drift` (n, headings, 3): over time, of headings from the `first` on,
    of `HEADINGS` evenly all round from 0.
    """

    inverse: Any
    mass: float
    added: tuple[float, float]
    lever: float
    damping: Any
    turn_sway: float
    turn_yaw: float
    crossflow: float
    half: float
    wind_table: Any
    current_table: Any
    current_x: float
    current_y: float
    turns: bool
    wind: Any
    drift: Any
    first: int


def blow(table: Any, across: float, along: float, out: Any) -> None:
    """Add the force of a stream that goes along and across the ship, m/s, to `out` (3,)."""
    square = along * along + across * across
    if square == 0.0:
        return
    count = table.shape[0] - 1
    place = (math.atan2(-across, -along) + math.pi) / (2.0 * math.pi) * count
    below = min(int(place), count - 1)
    part = place - below
    for i in range(3):
        out[i] += square * (table[below, i] + part * (table[below + 1, i] - table[below, i]))


STRIPS: Final = 10
"""Of a turning hull, over whose length the drag across is summed."""


def turn(ship: SlowShip, along: float, across: float, r: float, out: Any) -> None:
    """Add what a turn of rate r, rad/s, adds to a stream past the ship to `out` (3,).

    `along` and `across`: of the ship through the water amidships, m/s. Linear derivatives, which
    on a hull alike fore and aft are of sway odd and of yaw even in the speed ahead; beyond them the
    drag of each strip at its own speed across, less that of all at the speed amidships.
    """
    middle = out[1]
    out[1] = middle + ship.turn_sway * along * r
    out[2] += out[1] * ship.lever - middle * ship.lever + ship.turn_yaw * abs(along) * r
    strip = 2.0 * ship.half / STRIPS
    same = across * abs(across)
    for i in range(STRIPS):
        x = -ship.half + (i + 0.5) * strip
        local = across + x * r
        push = -ship.crossflow * strip * (local * abs(local) - same)
        out[1] += push
        out[2] += (x + ship.lever) * push


def restore(
    x: float,
    y: float,
    yaw: float,
    net: Net,
    tables: LineTables,
    known: Known,
    out: Any,
) -> int:
    """Put force and moment of the lines at a position into `out` (3,); the one that fails, or -1.

    By closed form, or out of their tables where there are any.
    """
    if tables.table[0] < 0:
        known.q[0], known.q[1], known.q[2] = x, y, yaw * net.scale[2]
        status, line = hang(net, known, False)
        if status != CONVERGED:
            return line
        add_up(net, known)
        remember(net, known)
        out[0], out[1], out[2] = known.left[0], known.left[1], known.left[2] * net.scale[2]
        return -1
    cosine, sine = math.cos(yaw), math.sin(yaw)
    out[0] = out[1] = out[2] = 0.0
    for k in range(net.used[0]):
        ahead, aside = net.arm[4 * k + 2], net.arm[4 * k + 3]
        arm_x, arm_y = cosine * ahead - sine * aside, sine * ahead + cosine * aside
        to_x, to_y = net.base[6 * k] - x - arm_x, net.base[6 * k + 1] - y - arm_y
        span = max(math.sqrt(to_x * to_x + to_y * to_y), 1e-9)
        found = tabulated(k, span, net.base[6 * k + 5], tables)
        if not found.held:
            return k
        along, across = found.H * to_x / span, found.H * to_y / span
        out[0] += along
        out[1] += across
        out[2] += across * arm_x - along * arm_y
    return -1


def rates(
    at: float,
    state: Any,
    ship: SlowShip,
    net: Net,
    tables: LineTables,
    known: Known,
    out: Any,
) -> int:
    """Put the rates of the state into `out` (6,), `at` a place between samples; a line's status."""
    force = out[3:6]
    yaw, u, v, r = state[2], state[3], state[4], state[5]
    cosine, sine = math.cos(yaw), math.sin(yaw)
    turned = yaw if ship.turns else 0.0
    wrong = restore(state[0], state[1], turned, net, tables, known, force)
    if wrong >= 0:
        return wrong
    force_x, force_y = force[0], force[1]
    force[0] = force_x * cosine + force_y * sine
    force[1] = force_y * cosine - force_x * sine
    force[2] = force[2] if ship.turns else 0.0
    # Speeds of midships, where wind and current are met.
    middle = v + r * ship.lever
    first = min(int(at), ship.wind.shape[0] - 2)
    part = at - first
    wind_x = ship.wind[first, 0] + part * (ship.wind[first + 1, 0] - ship.wind[first, 0])
    wind_y = ship.wind[first, 1] + part * (ship.wind[first + 1, 1] - ship.wind[first, 1])
    blow(
        ship.wind_table,
        wind_y * cosine - wind_x * sine - middle,
        wind_x * cosine + wind_y * sine - u,
        force,
    )
    stream_x = ship.current_x * cosine + ship.current_y * sine
    stream_y = ship.current_y * cosine - ship.current_x * sine
    blow(ship.current_table, stream_y - middle, stream_x - u, force)
    turn(ship, u - stream_x, middle - stream_y, r, force)
    place = (yaw / (2.0 * math.pi) % 1.0) * HEADINGS
    left = (int(place) - ship.first) % HEADINGS
    right, aside = (left + 1) % HEADINGS, place - int(place)
    if max(left, right) >= ship.drift.shape[1]:
        return BEYOND
    for i in range(3):
        now = ship.drift[first, left, i] * (1.0 - aside) + ship.drift[first, right, i] * aside
        then = ship.drift[first + 1, left, i] * (1.0 - aside)
        then += ship.drift[first + 1, right, i] * aside
        force[i] += now + part * (then - now)
    across = -ship.damping[1] * middle
    force[0] -= ship.damping[0] * u
    force[1] += across
    force[2] += across * ship.lever - ship.damping[2] * r
    # What turning axes add: of the ship's own mass, and of the water's, which the current carries.
    # The derivatives have the rest of it.
    force[0] += ship.mass * (v * r + ship.lever * r * r)
    force[0] += (ship.added[1] * (middle - stream_y) + ship.added[0] * stream_y) * r
    turned_across = -(ship.mass * u + ship.added[1] * stream_x) * r
    force[1] += turned_across
    force[2] += turned_across * ship.lever
    a, b, c = force[0], force[1], force[2]
    out[0], out[1], out[2] = u * cosine - v * sine, u * sine + v * cosine, r
    for i in range(3):
        force[i] = ship.inverse[i, 0] * a + ship.inverse[i, 1] * b + ship.inverse[i, 2] * c
    return -1


def step_slowly(
    h: float,
    ship: SlowShip,
    net: Net,
    tables: LineTables,
    known: Known,
    room: Any,
    path: Any,
) -> tuple[int, int]:
    """Step from `path[0]` on by Runge and Kutta's fourth order; samples done, and a line at fault.

    `path` (n, 6) is written to, `room` (5, 6) is work space; h in s.
    """
    for n in range(path.shape[0] - 1):
        for i in range(6):
            room[4, i] = path[n, i]
        for stage in range(4):
            late = 0.0 if stage == 0 else (1.0 if stage == 3 else 0.5)
            wrong = rates(n + late, room[4], ship, net, tables, known, room[stage])
            if wrong != -1:
                return n, wrong
            if stage < 3:
                ahead = h if stage == 2 else 0.5 * h
                for i in range(6):
                    room[4, i] = path[n, i] + ahead * room[stage, i]
        for i in range(6):
            slope = room[0, i] + 2.0 * room[1, i] + 2.0 * room[2, i] + room[3, i]
            path[n + 1, i] = path[n, i] + h / 6.0 * slope
    return path.shape[0] - 1, -1


def hang_lines(
    path: Any, ways: Any, turns: bool, net: Net, tables: LineTables, out: Any
) -> tuple[int, int]:
    """Find every line at every place of its fairlead; samples done, and a line at fault.

    By closed form, or out of its table. `path` (n, 3): x, y and yaw of the origin; `ways` (n,
    lines, 3): how far the fairlead is off that, along x, y and upwards, m; `out` (n, lines, 2):
    tension at fairlead and anchor, N.
    """
    for k in range(out.shape[1]):
        low, high = net.base[6 * k + 2], net.base[6 * k + 5]
        H = V = math.nan
        for n in range(out.shape[0]):
            yaw = path[n, 2] if turns else 0.0
            cosine, sine = math.cos(yaw), math.sin(yaw)
            arm_x, arm_y = net.arm[4 * k + 2], net.arm[4 * k + 3]
            x = path[n, 0] + cosine * arm_x - sine * arm_y + ways[n, k, 0]
            y = path[n, 1] + sine * arm_x + cosine * arm_y + ways[n, k, 1]
            to_x, to_y = net.base[6 * k] - x, net.base[6 * k + 1] - y
            span = math.sqrt(to_x * to_x + to_y * to_y)
            if tables.table[0] >= 0:
                found = tabulated(k, span, high + ways[n, k, 2], tables)
                if not found.held:
                    return n, k
                out[n, k, 0], out[n, k, 1] = found.fairlead, found.anchor
                continue
            problem = problem_at(k, low, high + ways[n, k, 2], net)
            state = given_span(max(span, 1e-9), problem, H, V)
            if state.status != CONVERGED:
                state = given_span(max(span, 1e-9), problem, math.nan, math.nan)
            if state.status != CONVERGED:
                return n, k
            H, V = (state.H, state.V) if state.H > 0.0 else (math.nan, math.nan)
            out[n, k, 0] = math.sqrt(state.H * state.H + state.V * state.V)
            H_anchor, V_anchor = state.H_anchor, state.V_anchor
            out[n, k, 1] = math.sqrt(H_anchor * H_anchor + V_anchor * V_anchor)
    return out.shape[0], -1
