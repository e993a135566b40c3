"""Wind on merchant ships after Blendermann (1994), whose coefficients are open."""

from __future__ import annotations

import math
from types import MappingProxyType
from typing import NamedTuple

from catopt.loads.component import LoadComponent
from catopt.loads.environment import Wind, wind_on_ship
from catopt.loads.ship import Ship
from catopt.loads.source import BLENDERMANN, LoadSource
from catopt.model.kinds import Findings
from catopt.words import Message, term


class WindType(NamedTuple):
    """Coefficients of a kind of ship.

    Of beam wind (CDt, on the lateral area), of wind from ahead and from astern (CDlAF, on the
    frontal area), and the cross-force parameter delta.
    """

    transverse: float
    bow: float
    stern: float
    delta: float


TYPES = MappingProxyType(
    {
        "car carrier": WindType(0.95, 0.55, 0.60, 0.80),
        "cargo loaded": WindType(0.85, 0.65, 0.55, 0.40),
        "cargo containers on deck": WindType(0.85, 0.55, 0.50, 0.40),
        "container ship loaded": WindType(0.90, 0.55, 0.55, 0.40),
        "destroyer": WindType(0.85, 0.60, 0.65, 0.65),
        "diving support vessel": WindType(0.90, 0.60, 0.80, 0.55),
        "ferry": WindType(0.90, 0.45, 0.50, 0.80),
        "fishing vessel": WindType(0.95, 0.70, 0.70, 0.40),
        "LNG tanker": WindType(0.70, 0.60, 0.65, 0.50),
        "offshore supply vessel": WindType(0.90, 0.55, 0.80, 0.55),
        "passenger liner": WindType(0.90, 0.40, 0.40, 0.80),
        "research vessel": WindType(0.85, 0.55, 0.65, 0.60),
        "tanker loaded": WindType(0.70, 0.90, 0.55, 0.40),
        "tanker ballast": WindType(0.70, 0.75, 0.55, 0.40),
        "tender": WindType(0.85, 0.55, 0.55, 0.65),
    }
)
"""Kinds of ship, as the MSS toolbox lists them (C)."""

_SOURCE = LoadSource(BLENDERMANN, "CX and CY", "C")


def coefficients(kind: WindType, angle: float, frontal_over_lateral: float) -> tuple[float, float]:
    """CX on the frontal and CY on the lateral area; CX is negative from ahead.

    D = 1 - (delta/2) (1 - CDl/CDt) sin^2(2 gamma) with CDl = CDlAF AF/AL;
    CX = -CDlAF cos(gamma)/D; CY = CDt sin(gamma)/D. The angle gamma is from the bow to where the
    wind comes from, rad: 0 from ahead.
    """
    along = kind.bow if math.cos(angle) >= 0.0 else kind.stern
    ratio = along * frontal_over_lateral / kind.transverse
    divisor = 1.0 - 0.5 * kind.delta * (1.0 - ratio) * math.sin(2.0 * angle) ** 2
    return -along * math.cos(angle) / divisor, kind.transverse * math.sin(angle) / divisor


def pressure_centre(angle: float, length: float, lateral_centre: float) -> float:
    """Return where the wind across the ship acts, m forward of midships: Loa CN/CY.

    CN = (sL/Loa - 0.18 (gamma - 90 deg)) CY with gamma in rad, from the bow, either side: 0.28 Loa
    forward of the centre of the lateral area, sL, in a head wind, at that centre on the beam.
    """
    return lateral_centre - 0.18 * (abs(angle) - 0.5 * math.pi) * length


def wind_type(kind: str) -> WindType:
    """Look a kind of ship up by its key in `TYPES`; an unknown one is refused."""
    found = Findings("wind after Blendermann")
    found.word("kind", kind, tuple(TYPES))
    found.raise_if_any()
    return TYPES[kind]


def blendermann_loads(
    ship: Ship, wind: Wind, kind: str, *, angle: float, air_density: float
) -> tuple[LoadComponent, LoadComponent]:
    """Wind at 10 m along and across a ship of a kind, a key of `TYPES`; another is refused.

    The angle is from the bow to where the wind comes from, rad; the density in kg/m3.
    """
    cx, cy = coefficients(wind_type(kind), angle, ship.frontal_area / ship.lateral_area)
    note = Message("loads.wind_note", kind=term(kind), angle=math.degrees(angle))
    along, across = ("AF", "CX", cx, _SOURCE), ("AL", "CY", cy, _SOURCE)
    return wind_on_ship(ship, wind, air_density, along, across, note)
