"""Wind, current and waves on a ship: weathervaning, or at headings that are given."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from catopt.constants import SEA_WATER_DENSITY
from catopt.loads.blendermann import blendermann_loads
from catopt.loads.component import LoadComponent, Loads
from catopt.loads.environment import SeaState, SurfaceCurrent, Wind
from catopt.loads.ship import Ship
from catopt.loads.ufc_current import FASTEST_SHALLOW, longitudinal_loads, transverse_load
from catopt.loads.ufc_wind import UfcWind, ufc_wind_loads
from catopt.loads.wave_drift import DriftWave, ship_drift
from catopt.model.validity import Findings
from catopt.words import Message

__all__ = ["AIR_DENSITY", "HEAD_ON", "Headings", "ship_loads"]

AIR_DENSITY: Final = 1.221
"""kg/m3, of UFC 4-159-03, table 4-2 (A)."""

_ALONG: Final = 1e-9


@dataclass(frozen=True)
class Headings:
    """Angles from the bow to where wind, current and waves come from, rad: 0 from ahead.

    Attributes
    ----------
    wind, current, waves : float
        From -pi to pi; positive to one side, negative to the other.
    """

    wind: float = 0.0
    current: float = 0.0
    waves: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("Headings")
        for key in ("wind", "current", "waves"):
            found.number(key, getattr(self, key), "rad", at_least=-math.pi, at_most=math.pi)
        found.raise_if_any()

    @property
    def head_on(self) -> bool:
        """Whether everything comes from ahead."""
        return max(abs(self.wind), abs(self.current), abs(self.waves)) < _ALONG


HEAD_ON: Final = Headings()
"""The collinear case of a weathervaning ship."""


def ship_loads(
    ship: Ship,
    wind: Wind,
    current: SurfaceCurrent,
    sea: SeaState,
    depth: float,
    *,
    wind_on: str | UfcWind,
    headings: Headings = HEAD_ON,
    reflection: float = 1.0,
    drift: DriftWave = "sea state",
    water_density: float = SEA_WATER_DENSITY,
    allow_recalled: bool = False,
) -> Loads:
    """Add up the steady forces of wind, current and wave drift on a ship.

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
        A kind of ship after Blendermann such as ``"tanker loaded"``, or coefficients after UFC.
    headings : Headings
        When left out, the collinear case: a weathervaning ship head to wind, current and waves.
    reflection, drift
        As of `catopt.loads.wave_drift.flat_side_drift`.
    water_density : float
        kg/m3.
    allow_recalled : bool
        Whether recalled figures (R) may be used; UFC's transverse wind is one.

    Returns
    -------
    Loads
        Along (surge) and across (sway) the ship. Static means: slow drift and wave-frequency
        motions come on top.

    Raises
    ------
    InputError
        A draught deeper than the water, an unknown kind of ship, recalled figures not allowed.
    """
    ship.check_afloat(depth)
    stream = {"angle": headings.current, "water_density": water_density}
    components = (
        *_wind(ship, wind, wind_on, headings.wind, allow_recalled),
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
    return Loads(
        Message(
            "loads.ship_in", ship=ship.name, wind=wind.speed, current=current.speed, height=sea.hs
        ),
        tuple(each for each in components if _counts(each, headings)),
        _assumptions(headings),
        _warnings(current, sea, depth, headings, drift),
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


def _assumptions(headings: Headings) -> tuple[str, ...]:
    if headings.head_on:
        lie = Message("loads.collinear")
    else:
        lie = Message(
            "loads.heading_given",
            wind=math.degrees(headings.wind),
            current=math.degrees(headings.current),
            waves=math.degrees(headings.waves),
        )
    return lie, Message("loads.steady"), Message("loads.box_drift")


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
