"""A ship and what blows and flows on her: main dimensions, tables, inertia, drift of each wave."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError
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
from catopt.loads.ship_ranges import in_the_middle
from catopt.loads.weathervane import (
    CLARKE_LEVER,
    YAW_TYPES,
    CurrentYaw,
    Push,
    ShipStreams,
    lever_of,
)
from catopt.model import ShipAfloat
from catopt.waves import Waves
from catopt.words import Message

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

    @cached_property
    def hull(self) -> ShipInWeather:
        """She without weather, all that has a range in its middle: what her tables hang on.

        Ships of one process share it, unless files that may change are read for it.
        """
        of = replace(in_the_middle(self.of), wind_direction=0.0)
        make = ShipInWeather if of.coefficients or of.drift_file else _hull_of
        return make(of, self.depth, self.density)

    @cached_property
    def _pushed(self) -> dict[tuple[str, float], list[float]]:
        return {}

    def pushed_along(self, by: str, speed: float) -> list[float]:
        """Say what wind or current of a speed, m/s, pushes along her at each angle, N."""
        if (by, speed) not in self._pushed:
            streams = self.streams
            along = streams.wind_along if by == "wind" else streams.current_along
            self._pushed[by, speed] = [along(speed, angle) for angle in _angles()]
        return self._pushed[by, speed]

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
        return self._table(self.streams.wind_push(1.0), self.hull.pushed_along("wind", 1.0))

    @cached_property
    def current_table(self) -> Array:
        """Force and moment of a current of 1 m/s, likewise: that at the mean speed."""
        speed = math.hypot(*self.current) or 1.0
        push, along = self.streams.current_push(speed), self.hull.pushed_along("current", speed)
        return self._table(push, along) / speed**2

    def _table(self, push: Push, along: Sequence[float]) -> Array:
        rows = []
        for angle, ahead in zip(_angles(), along, strict=True):
            across, moment = push(angle)
            rows.append(self._about_origin(ahead, -across, -moment))
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
            found = self.drift_factor * found
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

    @property
    def drift_factor(self) -> float:
        """That of a drift by the form of her hull."""
        is_by_form = not self.of.drift_file and self.of.reflection is None
        return self.of.drift_factor if is_by_form else 1.0

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


@lru_cache(maxsize=32)
def _hull_of(of: ShipAfloat, depth: float, density: float) -> ShipInWeather:
    return ShipInWeather(of, depth, density)


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
