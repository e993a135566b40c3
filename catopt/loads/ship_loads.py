"""Wind, current and waves on a ship, and their mean drift."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final, Literal, get_args

from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.largest import largest
from catopt.loads.component import DTOCEAN, LoadComponent, Loads, LoadSource, Number
from catopt.loads.environment import ALONG, HEAD_ON, Headings, SeaState, SurfaceCurrent, Wind
from catopt.loads.ship import Ship
from catopt.loads.ship_coefficients import ShipCoefficients, blendermann_loads
from catopt.loads.tcn_222_95 import tcn_loads
from catopt.loads.ufc import (
    FASTEST_SHALLOW,
    RECALLED_LONGITUDINAL,
    UfcWind,
    longitudinal_loads,
    transverse_load,
    ufc_wind_loads,
)
from catopt.model.kinds import Findings
from catopt.waves.random_surface import depth_factor as depth_factor
from catopt.words import Measure, Message, Several, term

DriftWave = Literal["sea state", "largest wave"]
"""The mean over an irregular sea of height Hs, or that under regular waves of the height Hmax."""

_SOURCE = LoadSource(DTOCEAN, "flat side, after Hermans and Remery 1970; depth, McIver 1987", "C")


def flat_side_drift(
    sea: SeaState,
    depth: float,
    *,
    reflection: float = 1.0,
    of: DriftWave = "sea state",
    water_density: float,
) -> float:
    """Mean force per metre on a side that reflects the waves, N/m.

    1/2 rho g (R a)^2 times `depth_factor`, a the amplitude. Over an irregular sea the mean of
    a^2/2 is m0 = Hs^2/16; for one regular wave a = Hmax/2 (not above breaking). The reflection R is
    from 0 to 1; 1, all of the wave, is the upper bound. Depth in m, density in kg/m3.
    """
    found = Findings("wave drift")
    found.number("depth", depth, "m", above=0.0)
    found.number("reflection", reflection, "", at_least=0.0, at_most=1.0)
    found.word("of", of, get_args(DriftWave))
    found.raise_if_any()
    factor = depth_factor(sea.wave_number(depth), depth)
    square = _half_mean_square(sea, depth, of)
    return water_density * STANDARD_GRAVITY * reflection**2 * square * factor


def _half_mean_square(sea: SeaState, depth: float, of: DriftWave) -> float:
    """Mean of a^2/2, m2."""
    if of == "sea state":
        return sea.hs**2 / 16.0
    return (0.5 * sea.height_in(depth)) ** 2 / 2.0


def width_across(length: float, breadth: float, angle: float) -> float:
    """Width of a box across the waves, L |sin| + B |cos|, m; the angle is from the bow, rad."""
    return length * abs(math.sin(angle)) + breadth * abs(math.cos(angle))


def ship_drift(
    sea: SeaState,
    length: float,
    breadth: float,
    depth: float,
    *,
    angle: float,
    reflection: float = 1.0,
    of: DriftWave = "sea state",
    water_density: float,
) -> tuple[LoadComponent, LoadComponent]:
    """Mean drift on a ship, taken for a box that reflects the waves.

    The width across the waves, L |sin| + B |cos|, m, times `flat_side_drift`, along the waves; the
    angle is from the bow to where they come from, rad. The rest is as of `flat_side_drift`.
    """
    per_metre = flat_side_drift(
        sea, depth, reflection=reflection, of=of, water_density=water_density
    )
    sine, cosine = math.sin(angle), math.cos(angle)
    width = width_across(length, breadth, angle)
    mean = "loads.mean_square_sea" if of == "sea state" else "loads.mean_square_wave"
    numbers = (
        Number("rho", water_density, "kg/m3", Message("loads.water_density")),
        Number("m", _half_mean_square(sea, depth, of), "m2", Message(mean)),
        Number("R", reflection, "", Message("loads.reflection")),
        Number("D", depth_factor(sea.wave_number(depth), depth), "", Message("loads.depth_factor")),
        Number("W", width, "m", Message("loads.width")),
    )
    factors = ("{rho}", "{g}", "{R:2}", "{m}", "{D}", "{W}")
    note = Message("loads.waves_note", kind=term(of), angle=math.degrees(angle))

    def component(name: str, axis: Literal["surge", "sway"], share: float) -> LoadComponent:
        force = per_metre * width * share
        return LoadComponent(name, "wave drift", axis, factors, numbers, force, _SOURCE, note)

    return (
        component(Message("loads.drift_along"), "surge", -cosine),
        component(Message("loads.drift_across"), "sway", sine),
    )


UFC_BLENDERMANN: Final = "UFC-Blendermann"
UFC_ALONE: Final = "UFC-4-159-03"
TCN: Final = "22TCN-222-95"

METHODS: Final = (UFC_BLENDERMANN, UFC_ALONE, TCN)
"""Current after UFC and wind after Blendermann; both after UFC, whose wind coefficients are
recalled (R); 22TCN 222-95, all of it recalled (R)."""

AIR_DENSITY: Final = 1.221
"""kg/m3, of UFC 4-159-03, table 4-2 (A)."""


def ship_loads(
    ship: Ship,
    wind: Wind,
    current: SurfaceCurrent,
    sea: SeaState,
    depth: float,
    *,
    wind_on: str | UfcWind,
    method: str = UFC_BLENDERMANN,
    headings: Headings = HEAD_ON,
    is_balanced: bool = False,
    reflection: float = 1.0,
    drift: DriftWave = "sea state",
    wave_coefficient: float | None = None,
    water_density: float = SEA_WATER_DENSITY,
    allow_recalled: bool = False,
    coefficients: ShipCoefficients | None = None,
) -> Loads:
    """Add up the forces of wind, current and waves on a ship, by one method.

    They are along (surge) and across (sway) the ship. Static means: slow drift and wave-frequency
    motions come on top.

    Parameters
    ----------
    wind : Wind
        Mean of 30 s at 10 m.
    current : SurfaceCurrent
        Taken over the whole draught, with nothing added for wind or waves.
    sea : SeaState
        For the mean drift.
    depth : float
        Of the water, m.
    wind_on : str or UfcWind
        A kind of ship after Blendermann such as ``"tanker loaded"``, or coefficients after UFC,
        which make the method UFC's alone.
    method : str
        One of `METHODS`. To name one that is recalled is to ask for it.
    headings : Headings
        When left out, the collinear case: a weathervaning ship head to wind, current and waves.
    is_balanced : bool
        Whether the ship stays at these headings by itself, for the assumptions:
        `catopt.loads.equilibrium_headings` finds them.
    reflection, drift
        As of `catopt.loads.ship_loads.flat_side_drift`; 22TCN has no drift.
    wave_coefficient : float, optional
        chi of 22TCN 222-95; without it that method leaves the waves out, and warns.
    water_density : float
        kg/m3.
    allow_recalled : bool
        Whether recalled figures (R) may be used beside coefficients of one's own; UFC's transverse
        wind is one.
    coefficients : ShipCoefficients, optional
        Tables in place of UFC's current and Blendermann's wind, as far as they go: of the first of
        `METHODS` alone, which is then called by their name.

    Raises
    ------
    InputError
        A draught deeper than the water, an unknown method or kind of ship, recalled figures not
        allowed, wind off the bow by UFC alone.
    """
    ship.check_afloat(depth)
    if isinstance(wind_on, UfcWind):
        method = UFC_ALONE
    _check_method(method, wind_on, headings)
    warnings: tuple[str, ...]
    if method == TCN:
        own: dict[str, Any] = {"headings": headings, "wave_coefficient": wave_coefficient}
        components = tcn_loads(ship, wind, current, sea, depth, **own, water_density=water_density)
        notes = (Message("loads.tcn_basis"), Message("loads.tcn_current"))
        without = wave_coefficient is None and sea.hmax > 0.0
        warnings = (Message("loads.tcn_no_waves"),) if without else ()
    else:
        is_recalled = method == UFC_ALONE and not isinstance(wind_on, UfcWind)
        blow = _RECALLED_WIND if is_recalled else wind_on
        stream = {"angle": headings.current, "water_density": water_density}
        waves: dict[str, Any] = {"reflection": reflection, "of": drift}
        size = (ship.length_waterline, ship.breadth)
        own_tables = coefficients if method == UFC_BLENDERMANN else None
        has_any = own_tables is not None and (own_tables.wind or own_tables.current)
        table = own_tables if has_any else None  # all of them may be of the other condition
        may = allow_recalled or is_recalled
        components = (
            *wind_components(ship, wind, blow, headings.wind, depth, table, allow_recalled=may),
            *current_components(ship, current.speed, depth, table, **stream),
            *ship_drift(
                sea, *size, depth, angle=headings.waves, **waves, water_density=water_density
            ),
        )
        notes = (Message("loads.steady"), Message("loads.box_drift"))
        is_ufc = table is None or not table.current
        warnings = (
            *_warnings(current, sea, depth, headings, drift, is_ufc=is_ufc),
            *(_of_the_sine(ship, depth, headings.current) if is_ufc and current.speed else ()),
        )
        method = method if table is None else table.name
    # Across a ship that lies head on there is nothing.
    shown = (each for each in components if not (headings.head_on and each.axis == "sway"))
    weather = {"wind": wind.speed, "current": current.speed, "height": sea.hs}
    return Loads(
        Message("loads.ship_in", ship=ship.name, **weather),
        tuple(shown),
        (_lie(headings, is_balanced), *notes),
        warnings,
        method,
    )


def every_method(*on: Any, headings: Headings = HEAD_ON, **how: Any) -> tuple[Loads, ...]:
    """Compute the loads by every method that applies, in the order of `METHODS`; as `ship_loads`.

    UFC alone is left out where the wind is off the bow: its coefficients there were not read. The
    last of the methods says so.
    """
    off_the_bow = _is_off_the_bow(headings)
    *first, last = (
        ship_loads(*on, method=method, headings=headings, **how)
        for method in METHODS
        if method != UFC_ALONE or not off_the_bow
    )
    left_out = (Message("loads.ufc_head_on"),) if off_the_bow else ()
    return (*first, replace(last, assumptions=(*last.assumptions, *left_out)))


def governing_loads(methods: Sequence[str], *on: Any, **how: Any) -> Loads:
    """Compute the loads by one of `METHODS`, or the largest of several; as `ship_loads`."""
    every = [ship_loads(*on, method=method, **how) for method in methods]
    governs = largest(every, lambda each: each.horizontal_force)
    if len(every) == 1:
        return governs
    measured = [(of.method, Measure("horizontal_force", of.horizontal_force)) for of in every]
    by_method = [Message("loads.by_method", method=name, force=force) for name, force in measured]
    said = Message("loads.largest_of", forces=Several(by_method, ", "))
    return replace(governs, assumptions=(said, *governs.assumptions))


_RECALLED_WIND: Final = UfcWind(
    transverse=0.92,
    from_ahead=RECALLED_LONGITUDINAL,
    from_astern=RECALLED_LONGITUDINAL,
    zero_angle=0.5 * math.pi,
    superstructure="distributed",
    recalled=True,
)
"""Of any ship that its hull does not dominate. For wind along the ship alone: there the transverse
coefficient and the zero angle, which were not read, do not count."""


def _check_method(method: str, wind_on: str | UfcWind, headings: Headings) -> None:
    found = Findings("loads on a ship")
    found.word("method", method, METHODS)
    if method == UFC_ALONE and isinstance(wind_on, str) and _is_off_the_bow(headings):
        values = {"ufc_alone": UFC_ALONE, "ufc_blendermann": UFC_BLENDERMANN}
        allowed = Message("refused_sizing.has_coefficients_here_wind_along", **values)
        off = Message("refused_sizing.off_the_bow", angle=math.degrees(headings.wind))
        found.add("Headings.wind", off, allowed)
    found.raise_if_any()


def _is_off_the_bow(headings: Headings) -> bool:
    """Whether the wind is neither from ahead nor from astern."""
    return abs(math.sin(headings.wind)) > ALONG


def wind_components(
    ship: Ship,
    wind: Wind,
    wind_on: str | UfcWind,
    angle: float,
    depth: float,
    own: ShipCoefficients | None = None,
    *,
    allow_recalled: bool = False,
) -> tuple[LoadComponent, ...]:
    """Compute the wind along and across at an angle off the bow, rad, by tables or by a method."""
    if own is not None and own.wind:
        return own.loads("wind", ship, wind.speed, AIR_DENSITY, angle, depth)
    air = {"angle": angle, "air_density": AIR_DENSITY}
    if isinstance(wind_on, UfcWind):
        return ufc_wind_loads(ship, wind, wind_on, **air, allow_recalled=allow_recalled)
    return blendermann_loads(ship, wind, wind_on, **air)


def current_components(
    ship: Ship, speed: float, depth: float, own: ShipCoefficients | None, **stream: float
) -> tuple[LoadComponent, ...]:
    """Compute the current along and across, by tables or by UFC."""
    across = transverse_load(ship, speed, depth, **stream)
    if own is None or not own.current:
        return (*longitudinal_loads(ship, speed, **stream), across)
    by_table = own.loads("current", ship, speed, stream["water_density"], stream["angle"], depth)
    is_larger = own.is_least_ufc and abs(across.force) > abs(by_table[1].force)
    return (by_table[0], across if is_larger else by_table[1])


_SINE_ANGLES: Final = (math.radians(5.0), math.radians(25.0))
_SINE_DEPTH: Final = 1.5
"""Off the bow, and in draughts: near OCIMF's example, which has 10 deg and a depth of 1.1."""


def _of_the_sine(ship: Ship, depth: float, angle: float) -> tuple[Message, ...]:
    """Say where a printed example has more current across than the sine law."""
    low, high = _SINE_ANGLES
    is_near = low <= abs(angle) <= high and depth < _SINE_DEPTH * ship.draught
    return (Message("loads.sine_law", angle=math.degrees(abs(angle))),) if is_near else ()


def _lie(headings: Headings, is_balanced: bool) -> Message:
    if headings.head_on:
        return Message("loads.collinear")
    key = "loads.heading_found" if is_balanced else "loads.heading_given"
    return Message(key, **{name: math.degrees(each) for name, each in vars(headings).items()})


def _warnings(
    current: SurfaceCurrent,
    sea: SeaState,
    depth: float,
    headings: Headings,
    drift: DriftWave,
    *,
    is_ufc: bool,
) -> tuple[str, ...]:
    warnings = []
    if is_ufc and current.speed > FASTEST_SHALLOW and abs(math.sin(headings.current)) > ALONG:
        values = {"limit": FASTEST_SHALLOW, "speed": current.speed}
        warnings.append(Message("loads.too_fast", **values))
    limit = sea.breaking_height(depth)
    if sea.hmax > limit:
        values = {"height": sea.hmax, "depth": depth, "limit": limit}
        if drift == "largest wave":
            warnings.append(Message("loads.breaks_above", taken=limit, **values))
        else:
            warnings.append(Message("loads.breaks_beyond_drift", **values))
    return tuple(warnings)
