"""Wind, current and waves on ships after 22TCN 222-95, the Vietnamese text of SNiP 2.06.04-82.

Section 5 of the standard was not read: every formula here is recalled (R). Current and wind on
S3's tanker, 330 and 108 kN, come within 3 % of the 450 kN that are printed without a derivation.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Final, Literal

from catopt.constants import STANDARD_GRAVITY
from catopt.loads.component import TCN_222_95, Axis, LoadComponent, LoadSource, Number
from catopt.loads.environment import ALONG, Headings, SeaState, SurfaceCurrent, Wind
from catopt.loads.ship import Ship
from catopt.model.kinds import Findings
from catopt.words import Message

WIND_ACROSS: Final = 0.736
WIND_ALONG: Final = 0.490
"""N s2/m4: 73.6e-5 and 49.0e-5 of the standard, which counts in kN (5.2, R)."""

CURRENT: Final = 590.0
"""N s2/m4: 0.59 of the standard, in kN; across and along the ship alike (5.3, R)."""

_SILHOUETTE: Final = ((25.0, 1.0), (50.0, 0.80), (100.0, 0.65), (200.0, 0.50))
_WAVE_LENGTH: Final = ((0.5, 1.0), (1.0, 0.73), (2.0, 0.50), (3.0, 0.42), (4.0, 0.40))

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
    """Return the height that 5 % of the waves exceed, m: Hs sqrt(ln 20/2), of Rayleigh's law."""
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

    The wind is one that 2 % of the season exceeds; speeds count by their components along and
    across, and the areas under water are B T and LwL T. The depth, m, is for the wave length, the
    water's density in kg/m3. The wave load is the maximum of an oscillating force, not a mean; the
    wave coefficient is chi of the standard's curve over draught and wave length, which was not
    found: the user's. None leaves the waves out. A negative one is refused, and so are waves
    neither along nor across the ship, which 5.4 has not.
    """
    ahead, abeam = ship.breadth * ship.draught, ship.length_waterline * ship.draught
    seen_ahead = Number("An", ship.frontal_area, "m2", Message("loads.frontal_area"))
    seen_abeam = Number("Aq", ship.lateral_area, "m2", Message("loads.lateral_area"))
    hull_ahead = Number("At", ahead, "m2", Message("loads.breadth_draught"))
    hull_abeam = Number("Al", abeam, "m2", Message("loads.length_times_draught"))
    of_breadth, of_length = (
        Number("xi", silhouette_factor(size), "", Message("loads.silhouette", size=size))
        for size in (ship.breadth, ship.length_overall)
    )
    blows, flows = wind.speed, current.speed
    along, across = -blows * math.cos(headings.wind), blows * math.sin(headings.wind)
    astern, aside = -flows * math.cos(headings.current), flows * math.sin(headings.current)
    components = (
        _stream("loads.wind_along", along, WIND_ALONG, seen_ahead, _WIND, of_breadth),
        _stream("loads.wind_across", across, WIND_ACROSS, seen_abeam, _WIND, of_length),
        _stream("loads.current_along", astern, CURRENT, hull_ahead, _CURRENT),
        _stream("loads.current_across", aside, CURRENT, hull_abeam, _CURRENT),
    )
    if wave_coefficient is None:
        return components
    sine, cosine = _on_an_axis(headings.waves, wave_coefficient)
    chi = Number("chi", wave_coefficient, "", Message("loads.wave_coefficient"))
    rho = Number("rho", water_density, "kg/m3", Message("loads.water_density"))
    ratio = ship.length_waterline * sea.wave_number(depth) / (2.0 * math.pi)
    reduced = Message("loads.wave_length_factor", ratio=ratio)
    gamma = Number("gamma1", wave_length_factor(ratio), "", reduced)
    height = Number("h", wave_height(sea), "m", Message("loads.height_5_percent"))
    return (
        *components,
        _wave("loads.wave_along", -cosine, (chi,), (rho, height, hull_ahead)),
        _wave("loads.wave_across", sine, (chi, gamma), (rho, height, hull_abeam)),
    )


def _stream(
    key: str, speed: float, factor: float, area: Number, source: LoadSource, *more: Number
) -> LoadComponent:
    """Make the load of wind or current along or across: k A V^2, and xi for the wind."""
    numbers = (
        Number("k", factor, "N s2/m4", Message("loads.in_kn", value=factor * 1e-3)),
        area,
        Number("V", abs(speed), "m/s", Message("loads.speed_component")),
        *more,
    )
    factors = ("{k}", *_symbols(area), "{V:2}", *_symbols(*more))
    force = factor * area.value * speed * abs(speed) * math.prod(each.value for each in more)
    kind: Literal["wind", "current"] = "wind" if source is _WIND else "current"
    return LoadComponent(Message(key), kind, _axis(key), factors, numbers, force, source)


def _wave(
    key: str, share: float, by: tuple[Number, ...], of: tuple[Number, Number, Number]
) -> LoadComponent:
    """Make the largest load of the waves by their factors, of density, height and area."""
    (chi, *reduced), (rho, height, area) = by, of
    weight = rho.value * STANDARD_GRAVITY * height.value * chi.value
    force = weight * math.prod(each.value for each in reduced) * area.value * share
    factors = (*_symbols(*by), "{rho}", "{g}", "{h}", *_symbols(area))
    note = Message("loads.oscillating")
    return LoadComponent(Message(key), "wave", _axis(key), factors, (*by, *of), force, _WAVE, note)


def _axis(key: str) -> Axis:
    return "surge" if key.endswith("along") else "sway"


def _symbols(*numbers: Number) -> tuple[str, ...]:
    """Write symbols as factors."""
    return tuple(f"{{{each.symbol}}}" for each in numbers)


def _on_an_axis(angle: float, chi: float) -> tuple[float, float]:
    """Sine and cosine of an angle along or across the ship; for another, 0, if chi allows it."""
    sine, cosine = math.sin(angle), math.cos(angle)
    is_along, is_across = abs(sine) < ALONG, abs(cosine) < ALONG
    found = Findings("22TCN 222-95")
    found.number("wave_coefficient", chi, "", at_least=0.0, at_most=1.0)
    if chi > 0.0 and not (is_along or is_across):
        allowed = Message("refused_sizing.wave_load_waves_from_ahead")
        off = Message("refused_sizing.off_the_bow", angle=math.degrees(angle))
        found.add("waves", off, allowed)
    found.raise_if_any()
    return sine if is_across else 0.0, cosine if is_along else 0.0


def _between(table: tuple[tuple[float, float], ...], at: float) -> float:
    """Interpolate; beyond its ends a table keeps its last value."""
    if at <= table[0][0]:
        return table[0][1]
    for (low, first), (high, last) in pairwise(table):
        if at <= high:
            return first + (last - first) * (at - low) / (high - low)
    return table[-1][1]
