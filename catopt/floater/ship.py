"""A ship in wind, current and waves, as what its slow motion is stepped by.

Axes of the ship: x forwards, y to port, moments counter-clockwise, about the origin of the system.
The state is x, y and yaw of the origin, and its speeds along and across the ship and of the turn.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Final, NamedTuple

import numpy as np

from catopt.arrays import Array
from catopt.catenary.pieces import LineProblem, Pieces
from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import CONVERGED
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError
from catopt.floater.line_tables import LineTables, tabulated
from catopt.hydro.coefficient_files import read_wamit
from catopt.hydro.coefficients import Coefficients
from catopt.hydro.drift import HullForm
from catopt.loads.hull_derivatives import HullDerivatives, hull_derivatives
from catopt.loads.ship import BARGE, SHORTEST, TAKEN_FOR, Ship, estimated_tanker
from catopt.loads.ship_coefficients import (
    SQUARE_ENDED,
    ShipCoefficients,
    read_ship_coefficients,
)
from catopt.loads.ship_loads import depth_factor, width_across
from catopt.loads.weathervane import (
    CLARKE_LEVER,
    YAW_TYPES,
    CurrentYaw,
    Push,
    ShipStreams,
    lever_of,
)
from catopt.model import ShipAfloat
from catopt.mooring.balance import Arrangement, Lines, pull_at
from catopt.waves import Waves
from catopt.words import Message


class SlowShip(NamedTuple):
    """What drives a ship; arrays in compiled code. Axes as in `catopt.floater.ship`.

    `inverse` (3, 3): of the inertia; `lever`: of the centre of gravity, m ahead of the origin;
    `added`: masses of the water in surge and sway; `damping` (3,): about midships; `turn_sway` and
    `turn_yaw`: force and moment of a turn over its rate and the speed through the water;
    `crossflow`: drag across over a strip's length and the square of its speed; `half`: of the
    length; tables (n + 1, 3) over the square of the speed; `turns`: whether the lines turn with
    the ship; `wind` (n, 2), `drift` (n, headings, 3): over time, of headings evenly all round
    from 0.
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
    arrangement: Arrangement,
    tables: LineTables,
    lines: Lines,
    out: Any,
) -> int:
    """Put force and moment of the lines at a position into `out` (3,); the one that fails, or -1.

    By closed form, or out of their tables where there are any.
    """
    if tables.table[0] < 0:
        pull = pull_at(x, y, yaw, arrangement, lines, True)
        out[0], out[1], out[2] = pull.x, pull.y, pull.moment
        return -1 if pull.status == CONVERGED else pull.line
    cosine, sine = math.cos(yaw), math.sin(yaw)
    out[0] = out[1] = out[2] = 0.0
    for k in range(len(arrangement.anchor_x)):
        arm_x = cosine * arrangement.arm_x[k] - sine * arrangement.arm_y[k]
        arm_y = sine * arrangement.arm_x[k] + cosine * arrangement.arm_y[k]
        to_x, to_y = arrangement.anchor_x[k] - x - arm_x, arrangement.anchor_y[k] - y - arm_y
        span = max(math.sqrt(to_x * to_x + to_y * to_y), 1e-9)
        found = tabulated(k, span, arrangement.fairlead_height[k], tables)
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
    arrangement: Arrangement,
    tables: LineTables,
    lines: Lines,
    out: Any,
) -> int:
    """Put the rates of the state into `out` (6,), `at` a place between samples; a line's status."""
    force = out[3:6]
    yaw, u, v, r = state[2], state[3], state[4], state[5]
    cosine, sine = math.cos(yaw), math.sin(yaw)
    turned = yaw if ship.turns else 0.0
    wrong = restore(state[0], state[1], turned, arrangement, tables, lines, force)
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
    headings = ship.drift.shape[1]
    place = (yaw / (2.0 * math.pi) % 1.0) * headings
    left = int(place) % headings
    right, aside = (left + 1) % headings, place - int(place)
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
    arrangement: Arrangement,
    tables: LineTables,
    lines: Lines,
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
            wrong = rates(n + late, room[4], ship, arrangement, tables, lines, room[stage])
            if wrong >= 0:
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
    path: Any, ways: Any, turns: bool, arrangement: Arrangement, tables: LineTables, out: Any
) -> tuple[int, int]:
    """Find every line at every place of its fairlead; samples done, and a line at fault.

    By closed form, or out of its table. `path` (n, 3): x, y and yaw of the origin; `ways` (n,
    lines, 3): how far the fairlead is off that, along x, y and upwards, m; `out` (n, lines, 2):
    tension at fairlead and anchor, N.
    """
    for k in range(out.shape[1]):
        start, end = arrangement.first[k], arrangement.first[k + 1]
        pieces = Pieces(
            arrangement.length[start:end],
            arrangement.weight[start:end],
            arrangement.compliance[start:end],
            arrangement.load[2 * (start + k) : 2 * (end + k + 1)],
        )
        H = V = math.nan
        for n in range(out.shape[0]):
            yaw = path[n, 2] if turns else 0.0
            cosine, sine = math.cos(yaw), math.sin(yaw)
            arm_x, arm_y = arrangement.arm_x[k], arrangement.arm_y[k]
            x = path[n, 0] + cosine * arm_x - sine * arm_y + ways[n, k, 0]
            y = path[n, 1] + sine * arm_x + cosine * arm_y + ways[n, k, 1]
            to_x, to_y = arrangement.anchor_x[k] - x, arrangement.anchor_y[k] - y
            span = math.sqrt(to_x * to_x + to_y * to_y)
            if tables.table[0] >= 0:
                height = arrangement.fairlead_height[k] + ways[n, k, 2]
                found = tabulated(k, span, height, tables)
                if not found.held:
                    return n, k
                out[n, k, 0], out[n, k, 1] = found.fairlead, found.anchor
                continue
            problem = LineProblem(
                pieces,
                arrangement.anchor_height[k],
                arrangement.fairlead_height[k] + ways[n, k, 2],
                arrangement.friction,
            )
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


ANGLES: Final = 720
"""Of wind and current off the bow, all round, between which forces are interpolated."""
_GYRATION: Final = 0.25
"""Radius of gyration in yaw over the length of the waterline; tankers have up to 0.27."""
_ENDS: Final = 0.875
"""Length of either end of the waterline over the breadth, as full ships have it: catopt's own. So
the bow of a tanker in ballast takes in short waves some half of what a flat one does, between the
0.42 and 0.60 of panel calculations."""
_TURN: Final = 2.0 * math.pi


@dataclass(frozen=True, eq=False)
class ShipInWeather:
    """A ship and what blows and flows on it.

    `depth` of the water, m; `density`, kg/m3; `wind` and `current`: means of where they go, along x
    and y of the system, m/s; the current is that over the draught.
    """

    of: ShipAfloat
    depth: float
    density: float
    wind: tuple[float, float] = (0.0, 0.0)
    current: tuple[float, float] = (0.0, 0.0)

    @cached_property
    def ship(self) -> Ship:
        """Main dimensions, areas and displacement; InputError for what no hull can be."""
        of = self.of
        try:
            ship = estimated_tanker(
                "",
                of.length,
                of.breadth,
                of.draught,
                moulded_depth=of.moulded_depth,
                condition=of.condition,
                frontal_area=of.frontal_area,
                lateral_area=of.lateral_area,
                propeller=of.propeller or None,
                lateral_centre=of.lateral_centre or 0.0,
                is_square_ended=of.kind == BARGE,
                length_waterline=of.length_waterline,
            )
            if of.displacement is not None:
                ship = replace(ship, displacement=of.displacement / self.density)
            if of.midship_area is not None:
                ship = replace(ship, midship_area=of.midship_area)
            ship.check_afloat(self.depth)
        except InputError as error:
            reported = [replace(each, key=f"floater.ship.{each.key}") for each in error.problems]
            raise InputError(reported, "--dynamic") from None
        return ship

    @property
    def scaled(self) -> tuple[Message, ...]:
        """Say that the areas above water of a small ship are scaled down from those of others."""
        of = self.of
        is_known = None not in (of.frontal_area, of.lateral_area) or of.kind == BARGE
        if is_known or of.length >= SHORTEST:
            return ()
        return (Message("sizing.small_craft", length=of.length, shortest=SHORTEST),)

    @cached_property
    def streams(self) -> ShipStreams:
        """Wind and current by the angle off the bow; InputError for a file of coefficients."""
        of, own = self.of, self._own
        wind_on, _ = TAKEN_FOR[of.kind]
        return ShipStreams(
            self.ship,
            self.depth,
            self.density,
            wind_on.format(of.condition),
            own,
            self._yaw,
        )

    @cached_property
    def _own(self) -> ShipCoefficients | None:
        """Read her own tables of coefficients, or take those of square ends."""
        of = self.of
        if not of.coefficients:
            return SQUARE_ENDED if of.kind == BARGE else None
        return read_ship_coefficients(of.coefficients).in_condition(of.condition)

    @property
    def turned_by(self) -> str:
        """What the current turns her by: as `ShipAfloat.current_yaw`, empty for her own tables."""
        own = self._own
        is_own = own is not None and own.turns
        return self.of.current_yaw or ("" if is_own else CLARKE_LEVER)

    @property
    def _yaw(self) -> CurrentYaw | None:
        """Say where the current acts; `lever_factor` does not move her own tables' moment."""
        if not self.turned_by:
            return None
        own = self.turned_by == CLARKE_LEVER
        yaw = lever_of(self.ship) if own else YAW_TYPES[self.turned_by]
        part = self.of.lever_factor
        return yaw._replace(intercept=part * yaw.intercept, slope=part * yaw.slope)

    @property
    def block(self) -> float:
        """Block coefficient."""
        return self.ship.block

    @property
    def mass(self) -> float:
        """Of the ship, kg."""
        return self.density * self.ship.displacement

    @cached_property
    def derivatives(self) -> HullDerivatives:
        """Linear derivatives of the hull in deep water."""
        ship = self.ship
        return hull_derivatives(ship.length_waterline, ship.breadth, ship.draught, self.block)

    @property
    def added(self) -> tuple[float, float]:
        """Mass of the water in surge, a tenth of the ship's (C), and in sway, in deep water, kg."""
        unit = 0.5 * self.density * self.ship.length_waterline**3
        return 0.1 * self.mass, -self.derivatives.Yv_dot * unit

    @cached_property
    def inertia(self) -> Array:
        """Mass with the water's, (3, 3), about the origin: surge, sway, yaw.

        Added mass of sway and yaw after Clarke, Gedling and Hine (1983), in deep water.
        """
        m, L = self.mass, self.ship.length_waterline
        surge, sway = self.added
        yaw = -self.derivatives.Nr_dot * 0.5 * self.density * L**5
        lever = -self.of.mooring_point
        across, about = m + sway, m * (_GYRATION * L) ** 2 + yaw
        both = across * lever
        return np.array(
            [[m + surge, 0.0, 0.0], [0.0, across, both], [0.0, both, about + both * lever]]
        )

    @property
    def turning(self) -> tuple[float, float]:
        """Force across and moment of a turn, over its rate and the speed, about midships.

        After Clarke, Gedling and Hine (1983), in deep water: what shallow water adds to the moment,
        which slows the turn, is left out.
        """
        of, unit, L = self.derivatives, 0.5 * self.density, self.ship.length_waterline
        return of.Yr * unit * L**3, of.Nr * unit * L**4 * self.of.turn_factor

    @cached_property
    def wind_table(self) -> Array:
        """Force and moment of a wind of 1 m/s, (ANGLES + 1, 3), by the angle that it comes from."""
        streams = self.streams
        push = streams.wind_push(1.0)
        return self._table(push, lambda angle: streams.wind_along(1.0, angle))

    @cached_property
    def current_table(self) -> Array:
        """Force and moment of a current of 1 m/s, likewise: that at the mean speed."""
        streams, speed = self.streams, math.hypot(*self.current) or 1.0
        push = streams.current_push(speed)
        return self._table(push, lambda angle: streams.current_along(speed, angle)) / speed**2

    def _table(self, push: Push, along: Callable[[float], float]) -> Array:
        rows = []
        for angle in _angles():
            across, moment = push(angle)
            rows.append(self._about_origin(along(angle), -across, -moment))
        return np.array(rows)

    @property
    def crossflow(self) -> float:
        """Drag across over a strip's length and the square of its speed, N s2/m3: UFC's abeam."""
        return self.streams.beam_force(1.0) / self.ship.length_waterline

    def _about_origin(self, along: float, across: float, moment: float) -> tuple[float, ...]:
        """Turn a moment about midships into that about the origin."""
        return along, across, moment - self.of.mooring_point * across

    @property
    def remarks(self) -> tuple[Message, ...]:
        """What is to be known of the file of the drift."""
        of = self._drift_file
        return () if of is None else of.remarks

    @cached_property
    def _drift_file(self) -> Coefficients | None:
        """Read the mean drift out of its file."""
        if not self.of.drift_file:
            return None
        assert self.of.ulen is not None
        return read_wamit(
            self.of.drift_file, ulen=self.of.ulen, density=self.density, gravity=STANDARD_GRAVITY
        )

    def drift(self, waves: Waves, wave_numbers: Array, headings: Array) -> Array:
        """Mean drift of each wave over the square of its amplitude: (headings, waves, 3).

        `headings`: of the ship, from the x axis of the system, rad; N/m2 and N/m, in the ship's
        axes about the origin. Out of the file, about midships; or of a side that reflects of each
        wave a given part, along them; or by the form of the hull (`catopt.hydro.drift`).
        """
        angle = waves.direction - headings[:, np.newaxis]
        of = self._drift_file
        if of is not None:
            found = of.at("mean_drift", waves.omega, angle)[..., [0, 1, 5]].real
        elif self.of.reflection is None:
            form = self.form.coefficients()
            found = form.at("mean_drift", waves.omega, angle)[..., [0, 1, 5]].real
            found = self.of.drift_factor * found
        else:
            ship, unit = self.ship, 0.5 * self.density * STANDARD_GRAVITY
            part = self.of.reflection**2
            factor = np.array([part * depth_factor(float(k), self.depth) for k in wave_numbers])
            size = (ship.length_waterline, ship.breadth)
            width = np.vectorize(lambda each: width_across(*size, each))(angle)
            push = unit * factor * width
            found = np.stack([push * np.cos(angle), push * np.sin(angle), 0.0 * push], axis=-1)
        found[..., 2] -= self.of.mooring_point * found[..., 1]
        return np.asarray(found)

    @cached_property
    def form(self) -> HullForm:
        """Her hull by its main dimensions, for the drift."""
        ship, of = self.ship, self.of
        entrance, waterplane = of.entrance, None
        if entrance is None and of.kind == BARGE:
            entrance = 0.5 * math.pi
        if entrance is None:
            ends = _ENDS * ship.breadth
            waterplane = 1.0 - (2.0 - 0.5 * math.pi) * ends / ship.length_waterline
        return HullForm(
            ship.length_waterline,
            ship.breadth,
            ship.draught,
            self.depth,
            block=self.block,
            waterplane=waterplane,
            entrance=entrance,
            roll_period=of.roll_period,
            roll_damping=of.roll_damping,
            density=self.density,
        )

    def steady(self, heading: float, drift: Array) -> Array:
        """Force and moment of the mean weather at a heading, rad, as `drift` has them.

        `drift` (3,): of the waves there.
        """
        wind, current = self.blown(heading)
        return np.asarray(drift + wind + current)

    def blown(self, heading: float) -> tuple[Array, Array]:
        """Force and moment of the mean wind and of the current at a heading, rad, likewise."""
        wind = _streamed(lambda: self.wind_table, self.wind, heading)
        return wind, _streamed(lambda: self.current_table, self.current, heading)


def _streamed(table: Callable[[], Array], flow: tuple[float, float], heading: float) -> Array:
    """Force and moment of a stream that goes along x and y of the system, m/s; none of none."""
    x, y = flow
    if not (x or y):
        return np.zeros(3)
    off = math.remainder(math.atan2(-y, -x) - heading, _TURN)
    return (x * x + y * y) * table_at(table(), off)


def table_at(table: Array, angle: float) -> Array:
    """Interpolate a table all round at an angle from -pi to pi, rad."""
    place = (angle + math.pi) / _TURN * ANGLES
    below = min(int(place), ANGLES - 1)
    return np.asarray(table[below] + (place - below) * (table[below + 1] - table[below]))


def _angles() -> list[float]:
    return [-math.pi + _TURN * k / ANGLES for k in range(ANGLES + 1)]
