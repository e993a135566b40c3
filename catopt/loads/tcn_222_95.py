"""Wind, current and waves on ships after 22TCN 222-95, the Vietnamese text of SNiP 2.06.04-82.

Section 5 of the standard was not read: every formula here is recalled (R). Current and wind on
S3's tanker, 330 and 108 kN, come within 3 % of the 450 kN that are printed without a derivation.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Final, Literal

from catopt.constants import STANDARD_GRAVITY
from catopt.loads.component import Axis, LoadComponent, Number
from catopt.loads.environment import SeaState, SurfaceCurrent, Wind
from catopt.loads.heading import Headings
from catopt.loads.ship import Ship
from catopt.loads.source import TCN_222_95, LoadSource
from catopt.model.validity import Findings
from catopt.words import Message

WIND_ACROSS: Final = 0.736
WIND_ALONG: Final = 0.490
"""N s2/m4: 73.6e-5 and 49.0e-5 of the standard, which counts in kN (5.2, R)."""

CURRENT: Final = 590.0
"""N s2/m4: 0.59 of the standard, in kN; across and along the ship alike (5.3, R)."""

_SILHOUETTE: Final = ((25.0, 1.0), (50.0, 0.80), (100.0, 0.65), (200.0, 0.50))
_WAVE_LENGTH: Final = ((0.5, 1.0), (1.0, 0.73), (2.0, 0.50), (3.0, 0.42), (4.0, 0.40))
_ON_AXIS: Final = 1e-9

_WIND = LoadSource(TCN_222_95, "5.2", "R")
_CURRENT = LoadSource(TCN_222_95, "5.3", "R")
_WAVE = LoadSource(TCN_222_95, "5.4", "R")


def silhouette_factor(size: float) -> float:
    """Return xi by the largest horizontal size of what the wind sees, m (5.2, R).

    1.0 up to 25 m, 0.80 at 50, 0.65 at 100, 0.50 from 200 m, linear between. The size is the
    breadth for wind along the ship, the length for wind across it.
    """
    return _between(_SILHOUETTE, size)


def wave_length_factor(length_over_wave: float) -> float:
    """Return gamma1 by ship's length over wave length, a_l/lambda (5.4, R).

    1 up to 0.5, 0.73 at 1, 0.50 at 2, 0.42 at 3, 0.40 from 4, linear between.
    """
    return _between(_WAVE_LENGTH, length_over_wave)


def wave_height(sea: SeaState) -> float:
    """Return the height that 5 % of the waves exceed, m: Hs sqrt(ln 20/2), of Rayleigh's law.

    Parameters
    ----------
    sea : SeaState
        Its significant height counts.
    """
    return sea.hs * math.sqrt(0.5 * math.log(20.0))


def tcn_loads(
    ship: Ship,
    wind: Wind,
    current: SurfaceCurrent,
    sea: SeaState,
    depth: float,
    *,
    headings: Headings,
    wave_coefficient: float | None,
    water_density: float,
) -> tuple[LoadComponent, ...]:
    """Compute wind, current and waves on a ship after 22TCN 222-95 (R).

    Parameters
    ----------
    ship : Ship
        Under water its areas are B T and LwL T.
    wind, current, sea : Wind, SurfaceCurrent, SeaState
        Wind that 2 % of the season exceeds.
    depth : float
        Of the water, m; for the wave length.
    headings : Headings
        Angles from the bow. Speeds count by their components along and across.
    wave_coefficient : float or None
        chi of the standard's curve over draught and wave length, which was not found: the user's.
        None leaves the waves out.
    water_density : float
        kg/m3.

    Returns
    -------
    tuple of LoadComponent
        The wave load is the maximum of an oscillating force, not a mean.

    Raises
    ------
    InputError
        A negative coefficient; waves neither along nor across the ship, which 5.4 has not.
    """
    seen_ahead = Number("An", ship.frontal_area, "m2", Message("loads.frontal_area"))
    seen_abeam = Number("Aq", ship.lateral_area, "m2", Message("loads.lateral_area"))
    hull_ahead = Number("At", ship.breadth * ship.draught, "m2", Message("loads.breadth_draught"))
    hull_abeam = Number(
        "Al", ship.length_waterline * ship.draught, "m2", Message("loads.length_times_draught")
    )
    of_breadth, of_length = (
        Number("xi", silhouette_factor(size), "", Message("loads.silhouette", size=size))
        for size in (ship.breadth, ship.length_overall)
    )
    ahead, abeam = math.cos(headings.wind), math.sin(headings.wind)
    along, across = math.cos(headings.current), math.sin(headings.current)
    return (
        _stream("wind_along", -wind.speed * ahead, WIND_ALONG, seen_ahead, _WIND, of_breadth),
        _stream("wind_across", wind.speed * abeam, WIND_ACROSS, seen_abeam, _WIND, of_length),
        _stream("current_along", -current.speed * along, CURRENT, hull_ahead, _CURRENT),
        _stream("current_across", current.speed * across, CURRENT, hull_abeam, _CURRENT),
        *_waves(
            ship,
            sea,
            depth,
            headings.waves,
            wave_coefficient,
            water_density,
            (hull_ahead, hull_abeam),
        ),
    )


def _stream(
    key: str, speed: float, factor: float, area: Number, source: LoadSource, *more: Number
) -> LoadComponent:
    """Make the load of wind or current along or across: k A V^2, and xi for the wind."""
    axis: Axis = "surge" if key.endswith("along") else "sway"
    unit = Message("loads.in_kn", value=factor * 1e-3)
    numbers = (
        Number("k", factor, "N s2/m4", unit),
        area,
        Number("V", abs(speed), "m/s", Message("loads.speed_component")),
        *more,
    )
    factors = ("{k}", f"{{{area.symbol}}}", "{V:2}", *(f"{{{each.symbol}}}" for each in more))
    force = factor * area.value * speed * abs(speed) * math.prod(each.value for each in more)
    kind: Literal["wind", "current"] = "wind" if source is _WIND else "current"
    return LoadComponent(Message(f"loads.{key}"), kind, axis, factors, numbers, force, source)


def _waves(
    ship: Ship,
    sea: SeaState,
    depth: float,
    angle: float,
    chi: float | None,
    water_density: float,
    areas: tuple[Number, Number],
) -> tuple[LoadComponent, ...]:
    """Make the largest load of the waves, along or across the ship."""
    if chi is None:
        return ()
    sine, cosine = math.sin(angle), math.cos(angle)
    is_along, is_across = abs(sine) < _ON_AXIS, abs(cosine) < _ON_AXIS
    found = Findings("22TCN 222-95")
    found.number("wave_coefficient", chi, "", at_least=0.0, at_most=1.0)
    if chi > 0.0 and not (is_along or is_across):
        allowed = "its wave load is for waves from ahead, from astern or from the beam"
        found.add("waves", f"{math.degrees(angle):g} deg off the bow", allowed)
    found.raise_if_any()
    height = Number("h", wave_height(sea), "m", Message("loads.height_5_percent"))
    water = Number("rho", water_density, "kg/m3", Message("loads.water_density"))
    coefficient = Number("chi", chi, "", Message("loads.wave_coefficient"))
    weight = water_density * STANDARD_GRAVITY * height.value * chi
    ratio = ship.length_waterline * sea.wave_number(depth) / (2.0 * math.pi)
    reduced = wave_length_factor(ratio)
    gamma = Number("gamma1", reduced, "", Message("loads.wave_length_factor", ratio=ratio))
    ahead, abeam = areas
    note = Message("loads.oscillating")
    return (
        LoadComponent(
            Message("loads.wave_along"),
            "wave",
            "surge",
            ("{chi}", "{rho}", "{g}", "{h}", "{At}"),
            (coefficient, water, height, ahead),
            -weight * ahead.value * (cosine if is_along else 0.0),
            _WAVE,
            note,
        ),
        LoadComponent(
            Message("loads.wave_across"),
            "wave",
            "sway",
            ("{chi}", "{gamma1}", "{rho}", "{g}", "{h}", "{Al}"),
            (coefficient, gamma, water, height, abeam),
            weight * reduced * abeam.value * (sine if is_across else 0.0),
            _WAVE,
            note,
        ),
    )


def _between(table: tuple[tuple[float, float], ...], at: float) -> float:
    """Interpolate; beyond its ends a table keeps its last value."""
    if at <= table[0][0]:
        return table[0][1]
    for (low, first), (high, last) in pairwise(table):
        if at <= high:
            return first + (last - first) * (at - low) / (high - low)
    return table[-1][1]
