"""Wind, current and waves on a ship: weathervaning, or at headings that are given."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final

from catopt.constants import SEA_WATER_DENSITY
from catopt.loads.blendermann import blendermann_loads
from catopt.loads.component import LoadComponent, Loads
from catopt.loads.environment import SeaState, SurfaceCurrent, Wind
from catopt.loads.heading import HEAD_ON, Headings
from catopt.loads.ship import Ship
from catopt.loads.tcn_222_95 import tcn_loads
from catopt.loads.ufc_current import FASTEST_SHALLOW, longitudinal_loads, transverse_load
from catopt.loads.ufc_wind import RECALLED_LONGITUDINAL, UfcWind, ufc_wind_loads
from catopt.loads.wave_drift import DriftWave, ship_drift
from catopt.model.validity import Findings
from catopt.ties import largest
from catopt.words import Measure, Message, Several

UFC_BLENDERMANN: Final = "UFC-Blendermann"
UFC_ALONE: Final = "UFC-4-159-03"
TCN: Final = "22TCN-222-95"

METHODS: Final = (UFC_BLENDERMANN, UFC_ALONE, TCN)
"""Current after UFC and wind after Blendermann; both after UFC, whose wind coefficients are
recalled (R); 22TCN 222-95, all of it recalled (R)."""

AIR_DENSITY: Final = 1.221
"""kg/m3, of UFC 4-159-03, table 4-2 (A)."""

_ALONG: Final = 1e-9


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
) -> Loads:
    """Add up the forces of wind, current and waves on a ship, by one method.

    Parameters
    ----------
    ship : Ship
        Afloat.
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
        As of `catopt.loads.wave_drift.flat_side_drift`; 22TCN has no drift.
    wave_coefficient : float, optional
        chi of 22TCN 222-95; without it that method leaves the waves out, and warns.
    water_density : float
        kg/m3.
    allow_recalled : bool
        Whether recalled figures (R) may be used beside coefficients of one's own; UFC's transverse
        wind is one.

    Returns
    -------
    Loads
        Along (surge) and across (sway) the ship. Static means: slow drift and wave-frequency
        motions come on top.

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
    if method == TCN:
        components = tcn_loads(
            ship,
            wind,
            current,
            sea,
            depth,
            headings=headings,
            wave_coefficient=wave_coefficient,
            water_density=water_density,
        )
        notes = (Message("loads.tcn_basis"), Message("loads.tcn_current"))
        warnings = _tcn_warnings(sea, wave_coefficient)
    else:
        is_recalled = method == UFC_ALONE and not isinstance(wind_on, UfcWind)
        blow = _RECALLED_WIND if is_recalled else wind_on
        components = (
            *_wind(ship, wind, blow, headings.wind, allow_recalled or is_recalled),
            *_ufc(ship, current, sea, depth, headings, reflection, drift, water_density),
        )
        notes = (Message("loads.steady"), Message("loads.box_drift"))
        warnings = _warnings(current, sea, depth, headings, drift)
    return Loads(
        Message(
            "loads.ship_in", ship=ship.name, wind=wind.speed, current=current.speed, height=sea.hs
        ),
        tuple(each for each in components if _counts(each, headings)),
        (_lie(headings, is_balanced), *notes),
        warnings,
        method,
    )


def every_method(*on: Any, headings: Headings = HEAD_ON, **how: Any) -> tuple[Loads, ...]:
    """Compute the loads by every method that applies, in the order of `METHODS`.

    UFC alone is left out where the wind is off the bow: its coefficients there were not read. The
    last of the methods says so.

    Parameters
    ----------
    *on, headings, **how
        As of `ship_loads`, but for the method.
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
    """Compute the loads by one method, or the largest of several.

    Parameters
    ----------
    methods : sequence of str
        Of `METHODS`, one at least.
    *on, **how
        As of `ship_loads`.
    """
    every = [ship_loads(*on, method=method, **how) for method in methods]
    governs = largest(every, lambda each: each.horizontal_force)
    if len(every) == 1:
        return governs
    forces = Several(
        (
            Message(
                "loads.by_method",
                method=each.method,
                force=Measure("horizontal_force", each.horizontal_force),
            )
            for each in every
        ),
        ", ",
    )
    said = Message("loads.largest_of", forces=forces)
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
    if method not in METHODS:
        found.add("method", repr(method), "one of " + ", ".join(METHODS))
    if method == UFC_ALONE and isinstance(wind_on, str) and _is_off_the_bow(headings):
        found.add(
            "Headings.wind",
            f"{math.degrees(headings.wind):g} deg off the bow",
            f"{UFC_ALONE} has coefficients here for wind along the ship only: take "
            f"{UFC_BLENDERMANN}, or give the coefficients of your edition (UfcWind)",
        )
    found.raise_if_any()


def _is_off_the_bow(headings: Headings) -> bool:
    """Whether the wind is neither from ahead nor from astern."""
    return abs(math.sin(headings.wind)) > _ALONG


def _ufc(
    ship: Ship,
    current: SurfaceCurrent,
    sea: SeaState,
    depth: float,
    headings: Headings,
    reflection: float,
    drift: DriftWave,
    water_density: float,
) -> tuple[LoadComponent, ...]:
    """Compute current after UFC and the mean drift of the waves."""
    stream = {"angle": headings.current, "water_density": water_density}
    return (
        *longitudinal_loads(ship, current.speed, **stream),
        transverse_load(ship, current.speed, depth, **stream),
        *ship_drift(
            sea,
            ship.length_waterline,
            ship.breadth,
            depth,
            angle=headings.waves,
            reflection=reflection,
            of=drift,
            water_density=water_density,
        ),
    )


def _wind(
    ship: Ship, wind: Wind, wind_on: str | UfcWind, angle: float, allow_recalled: bool
) -> tuple[LoadComponent, ...]:
    if isinstance(wind_on, UfcWind):
        return ufc_wind_loads(
            ship,
            wind,
            wind_on,
            angle=angle,
            air_density=AIR_DENSITY,
            allow_recalled=allow_recalled,
        )
    return blendermann_loads(ship, wind, wind_on, angle=angle, air_density=AIR_DENSITY)


def _counts(component: LoadComponent, headings: Headings) -> bool:
    """Whether a component is shown: across a ship that lies head on there is nothing."""
    return not (headings.head_on and component.axis == "sway")


def _lie(headings: Headings, is_balanced: bool) -> Message:
    if headings.head_on:
        return Message("loads.collinear")
    return Message(
        "loads.heading_found" if is_balanced else "loads.heading_given",
        wind=math.degrees(headings.wind),
        current=math.degrees(headings.current),
        waves=math.degrees(headings.waves),
    )


def _tcn_warnings(sea: SeaState, wave_coefficient: float | None) -> tuple[str, ...]:
    if wave_coefficient is None and sea.hmax > 0.0:
        return (Message("loads.tcn_no_waves"),)
    return ()


def _warnings(
    current: SurfaceCurrent, sea: SeaState, depth: float, headings: Headings, drift: DriftWave
) -> tuple[str, ...]:
    warnings = []
    if current.speed > FASTEST_SHALLOW and abs(math.sin(headings.current)) > _ALONG:
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
