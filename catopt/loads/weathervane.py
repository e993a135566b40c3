"""The heading of a ship on one point under wind, current and waves from different directions."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product
from types import MappingProxyType
from typing import Any, Final, Literal, NamedTuple, TypeAlias

from catopt.constants import SEA_WATER_DENSITY
from catopt.display import Tabled
from catopt.errors import NoAnswerError
from catopt.loads.component import LoadComponent, Loads
from catopt.loads.environment import Headings, SeaState, SurfaceCurrent, Wind, drag
from catopt.loads.hull_derivatives import hull_derivatives
from catopt.loads.ship import Ship
from catopt.loads.ship_coefficients import ShipCoefficients, pressure_centre, wind_type
from catopt.loads.ship_coefficients import coefficients as coefficients_of
from catopt.loads.ship_loads import (
    AIR_DENSITY,
    DriftWave,
    current_components,
    flat_side_drift,
    governing_loads,
    width_across,
    wind_components,
)
from catopt.loads.ufc import transverse_load, yaw_moment
from catopt.model.kinds import Angle, Findings, Length
from catopt.records import Record
from catopt.words import Message


@dataclass(frozen=True)
class ComparedLoads(Record):
    """Horizontal forces of wind, current and waves on a buoy or a ship, each with its formula.

    Its source stands beside it.
    """

    SCHEMA = "catopt.loads/1"
    DOCUMENT = (
        "loads.title loads.horizontal_force loads.all_along=along_N loads.all_surge=surge_N "
        "loads.all_sway=sway_N loads.components loads.assumptions loads.recalled loads.warnings "
        "loads.method others headings?"
    )

    loads: Loads
    others: tuple[ComparedLoads, ...] = ()
    """The same by every other method that applies, for comparison; of a buoy, none."""
    headings: tuple[ShipHeading, ...] | None = None
    """Conditions, directions and headings that were computed, of which the largest force is laid
    out; absent where there is one."""


def loads_document(of: Loads, *others: Loads, lyings: Sequence[ShipHeading] = ()) -> dict[str, Any]:
    """Lay loads out for JSON, in SI: others are by other methods, of the lyings it is the worst."""
    return ComparedLoads(of, tuple(map(ComparedLoads, others)), tuple(lyings) or None).to_dict()


_STEPS: Final = 720
_HALVINGS: Final = 60


class CurrentYaw(NamedTuple):
    """Where the current across a ship acts: ec/LwL = a + b theta (UFC eq. 25, A).

    The intercept a, and the slope b per degree; theta is 180 deg bow-on. ec is forward of midships.
    """

    intercept: float
    slope: float
    recalled: bool = False
    """Whether they are of table 4-10, which was not read."""

    @property
    def at_the_bow(self) -> float:
        """Lever of a current from ahead, over the length, forward of midships."""
        return self.intercept + 180.0 * self.slope


YAW_TYPES: Final = MappingProxyType(
    {
        "series-60": CurrentYaw(-0.291, 0.00353, recalled=True),
        "FFG": CurrentYaw(-0.201, 0.00221, recalled=True),
    }
)
"""Hulls of UFC's table 4-10, recalled (R): cargo ships and tankers, and a frigate."""

CLARKE_LEVER: Final = "Clarke-lever"
"""Likewise of the hull's own dimensions: `lever_of`."""


def lever_of(ship: Ship) -> CurrentYaw:
    """Take where the current acts from the hull: before midships from ahead, amidships abeam.

    From ahead it is the lever of the linear derivatives of Clarke, Gedling and Hine (1983, C);
    between that and the beam it falls evenly with the angle, as UFC's eq. 25 has it: catopt's own.

    Examples
    --------
    >>> from catopt.loads.tanker_20m import tanker
    >>> from catopt.loads.weathervane import lever_of
    >>> [round(each, 4) for each in lever_of(tanker())[:2]]
    [-0.3491, 0.0039]
    """
    hull = (ship.length_waterline, ship.breadth, ship.draught, ship.block)
    lever = hull_derivatives(*hull).lever
    return CurrentYaw(-lever, lever / 90.0)


@dataclass(frozen=True)
class Turning:
    """What a ship turns about, and what turns it."""

    yaw: CurrentYaw | Literal["Clarke-lever"] | None
    """`CLARKE_LEVER`: by the ship's dimensions; None: the moment of the current is that of a table
    of the ship's own."""
    mooring_point: float | None = None
    """m forward of midships; None: the bow, half the waterline."""

    def yaw_of(self, ship: Ship) -> CurrentYaw | None:
        """Return where the current acts on a ship; None: her own tables have its moment."""
        return lever_of(ship) if self.yaw == CLARKE_LEVER else self.yaw

    def lever(self, ship: Ship) -> float:
        """Return how far forward of midships the mooring holds a ship, m."""
        return 0.5 * ship.length_waterline if self.mooring_point is None else self.mooring_point


class Afloat(NamedTuple):
    """A ship in one condition."""

    condition: str
    """Of the ship: loaded or ballast; empty where there is one."""
    ship: Ship
    wind_on: str
    """Its kind for the wind, after Blendermann."""
    coefficients: ShipCoefficients | None = None
    """Tables of its own, in place of Blendermann's wind and UFC's current."""


@dataclass(frozen=True)
class ShipHeading(Tabled, Record):
    """How a ship lies in water of a depth, m, and what the mooring holds at that heading."""

    DOCUMENT = (
        "afloat.condition directions.wind=wind_from_rad directions.current=current_from_rad "
        "directions.waves=waves_from_rad heading depth loads.horizontal_force loads.method"
    )

    afloat: Afloat
    directions: Headings
    """That wind, current and waves come from, counted from any one line."""
    heading: Angle
    """Of the bow, counted as the directions are."""
    loads: Loads
    depth: Length
    """Of the water."""

    @property
    def headings(self) -> Headings:
        """Angles from the bow."""
        return self.directions.seen_at(self.heading)


def equilibrium_headings(
    ship: Ship,
    wind: Wind,
    current: SurfaceCurrent,
    sea: SeaState,
    depth: float,
    directions: Headings,
    turning: Turning,
    *,
    wind_on: str,
    reflection: float = 1.0,
    drift: DriftWave = "sea state",
    water_density: float = SEA_WATER_DENSITY,
    coefficients: ShipCoefficients | None = None,
) -> tuple[float, ...]:
    """Find the headings at which a ship on one point stays, rad.

    The forces across the ship turn it about the mooring point: wind at Blendermann's CN/CY, current
    at UFC's ec, the drift of the box amidships. A heading is one of equilibrium where their moments
    cancel, and stable where a small turn is turned back. Roots are sought between headings half a
    degree apart. They are from -pi to pi and, as the directions, counted from any one line. The
    rest is as of `catopt.loads.ship_loads`.

    Raises
    ------
    InputError
        A mooring point off the ship; nothing that pushes; no moment of the current.
    NoAnswerError
        No heading is stable: the mooring point lies too near midships.

    Examples
    --------
    >>> from catopt.loads import SeaState, SurfaceCurrent, Wind
    >>> from catopt.loads.tanker_20m import tanker
    >>> calm, across = SeaState(1.0, 0.0), Headings(current=0.5)
    >>> by = Turning(CurrentYaw(-0.3, 0.0035))
    >>> (heading,) = equilibrium_headings(
    ...     tanker(), Wind(0.0), SurfaceCurrent(1.0), calm, 20.0, across, by,
    ...     wind_on="tanker loaded")
    >>> round(heading, 6)
    0.5
    """
    lever = turning.lever(ship)
    found = Findings("weathervaning")
    half = 0.5 * ship.length_overall
    found.number("mooring_point", lever, "m", at_least=-half, at_most=half)
    if turning.yaw is None and (coefficients is None or not coefficients.turns):
        allowed = Message("refused_sizing.missing_neither_coefficients_nor_table")
        found.add("current_yaw", "", allowed)
    found.raise_if_any()
    per_metre = flat_side_drift(
        sea, depth, reflection=reflection, of=drift, water_density=water_density
    )
    on = ShipStreams(ship, depth, water_density, wind_on, coefficients, turning.yaw_of(ship))
    by_wind, by_current = on.wind_push(wind.speed), on.current_push(current.speed)

    def by_waves(angle: float) -> float:
        width = width_across(ship.length_waterline, ship.breadth, angle)
        return -per_metre * width * math.sin(angle) * lever

    def turned(heading: float) -> float:
        """Moment about the mooring point, N m: positive turns the heading down."""
        seen = directions.seen_at(heading)
        pushes = by_wind(seen.wind), by_current(seen.current)
        return sum(moment - force * lever for force, moment in pushes) + by_waves(seen.waves)

    if wind.speed == current.speed == sea.hmax == 0.0:
        nothing = Message("refused_sizing.nothing_pushes")
        found.add("wind", nothing, Message("refused_sizing.something_has_push_ship"))
        found.raise_if_any()
    return _stable(turned)


Push: TypeAlias = Callable[[float], tuple[float, float]]
"""Force across, N, and its moment about midships, N m, by the angle off the bow, rad."""


@dataclass(frozen=True)
class ShipStreams:
    """What wind and current do to a ship by the angle off her bow, at rest as in motion.

    `depth` of the water, m; `water_density`, kg/m3; `wind_on`: her kind for the wind, after
    Blendermann; `yaw`: where the current acts, unless her own tables have its moment.
    """

    ship: Ship
    depth: float
    water_density: float
    wind_on: str
    coefficients: ShipCoefficients | None = None
    yaw: CurrentYaw | None = None

    def wind_push(self, speed: float) -> Push:
        """Make the push of a wind across her, m/s: by her own tables or by Blendermann."""
        ship, own = self.ship, self.coefficients
        has_own = own is not None and bool(own.wind)
        kind = None if has_own else wind_type(self.wind_on)
        ratio = ship.frontal_area / ship.lateral_area

        def push(angle: float) -> tuple[float, float]:
            moment = None
            if kind is None:
                assert own is not None
                force, moment = own.push("wind", ship, speed, AIR_DENSITY, angle, self.depth)
            else:
                _, cy = coefficients_of(kind, angle, ratio)
                force = drag(AIR_DENSITY, speed, ship.lateral_area, cy)
            if moment is None:
                moment = force * pressure_centre(angle, ship.length_overall, ship.lateral_centre)
            return force, moment

        return push

    def current_push(self, speed: float) -> Push:
        """Make the push of a current across her, m/s: by her own tables or by UFC."""
        ship, own, yaw = self.ship, self.coefficients, self.yaw
        beam, water = self.beam_force(speed), self.water_density

        def push(angle: float) -> tuple[float, float]:
            force, moment = beam * math.sin(angle), None
            if own is not None and own.current:
                of = own.push("current", ship, speed, water, angle, self.depth)
                if not own.is_least_ufc or abs(of[0]) >= abs(force):
                    force, moment = of
            if moment is None:
                assert yaw is not None
                theta = 180.0 - abs(math.degrees(angle))
                moment = yaw_moment(force, ship.length_waterline, *yaw[:2], theta)
            return force, moment

        return push

    def beam_force(self, speed: float) -> float:
        """Give UFC's force of a current on the beam, m/s; N."""
        how = {"angle": 0.5 * math.pi, "water_density": self.water_density}
        return transverse_load(self.ship, speed, self.depth, **how).force

    def wind_along(self, speed: float, angle: float) -> float:
        """Add up the wind along her at an angle off the bow, rad; N, forwards positive."""
        return _along(
            wind_components(self.ship, Wind(speed), self.wind_on, angle, self.depth, self.own)
        )

    def current_along(self, speed: float, angle: float) -> float:
        """Add up the current along her at an angle off the bow, rad; N, forwards positive."""
        water = {"angle": angle, "water_density": self.water_density}
        return _along(current_components(self.ship, speed, self.depth, self.own, **water))

    @property
    def own(self) -> ShipCoefficients | None:
        """Her own tables, where she has any."""
        own = self.coefficients
        return own if own is not None and (own.wind or own.current) else None


def _along(components: Sequence[LoadComponent]) -> float:
    return math.fsum(each.force for each in components if each.axis == "surge")


def _stable(turned: Callable[[float], float]) -> tuple[float, ...]:
    """Find where a moment rises through zero, all round."""
    step = 2.0 * math.pi / _STEPS
    # Off the round degrees: a root on a sample would be one of rounding.
    at = [-math.pi + (index - 0.3819660113) * step for index in range(_STEPS + 1)]
    moments = [turned(each) for each in at]
    stable = [
        math.remainder(_root(turned, low, low + step), 2.0 * math.pi)
        for low, first, last in zip(at, moments, moments[1:], strict=False)
        if first < 0.0 <= last
    ]
    if not stable:
        raise NoAnswerError(Message("loads.no_heading"))
    return tuple(sorted(stable))


def _root(turned: Callable[[float], float], low: float, high: float) -> float:
    """Halve to double precision between a heading that is turned up and one that is turned down."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if turned(middle) < 0.0 else (low, middle)
    return 0.5 * (low + high)


def every_lying(
    ships: Sequence[Afloat],
    wind: Wind,
    current: SurfaceCurrent,
    sea: SeaState,
    depths: Sequence[float],
    directions: Sequence[Headings],
    *,
    methods: Sequence[str],
    turning: Turning | None = None,
    wave_coefficient: float | None = None,
    **how: Any,
) -> tuple[ShipHeading, ...]:
    """Find how a ship lies in each condition and depth (m) under each set of directions.

    The loads at a heading are by one of the methods, or by several the largest. A ship that turns
    weathervanes: then every stable heading counts. Otherwise the directions are angles from the
    bow. The rest is as of `catopt.loads.ship_loads`.
    """
    found = []
    for each, depth, case in product(ships, depths, directions):
        on = (each.ship, wind, current, sea, depth)
        how |= {"wind_on": each.wind_on, "coefficients": each.coefficients}
        stay = (0.0,) if turning is None else equilibrium_headings(*on, case, turning, **how)
        for heading in stay:
            loads = governing_loads(
                methods,
                *on,
                headings=case.seen_at(heading),
                is_balanced=turning is not None,
                wave_coefficient=wave_coefficient,
                **how,
            )
            found.append(ShipHeading(each, case, heading, loads, depth))
    return tuple(found)
