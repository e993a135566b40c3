"""Wind on ships after UFC 4-159-03: the shape functions that were read, and what was recalled."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, Literal

from catopt.loads.component import LoadComponent
from catopt.loads.drag import wind_on_ship
from catopt.loads.environment import Wind
from catopt.loads.ship import Ship
from catopt.loads.source import UFC, LoadSource, refuse_recalled
from catopt.model.validity import Findings
from catopt.words import Message

Superstructure = Literal["single", "distributed"]
"""Case I, a single distinct superstructure or a ship dominated by its hull; case II."""

RECALLED_LONGITUDINAL: Final = 0.70
"""Cxw of a ship that is not dominated by its hull, recalled (R)."""

_ALONG: Final = 1e-9
_LONGITUDINAL = LoadSource(UFC, "eq. 6 and 7, page 77; the coefficient is the user's", "A")
_RECALLED = LoadSource(UFC, "eq. 2, page 65; Cyw and fyw on pages that were not read", "R")
_GIVE = "give the coefficient of your edition, or take Blendermann's"


@dataclass(frozen=True)
class UfcWind:
    """Coefficients of a ship: Cyw on the lateral area, Cxw from ahead and astern on the frontal."""

    transverse: float
    from_ahead: float
    from_astern: float
    zero_angle: float
    """theta_x, wind angle without a longitudinal force, rad, counted as UFC counts: 180 deg is
    bow-on."""
    superstructure: Superstructure
    """Which shape function the longitudinal force has."""
    recalled: bool = False
    """Whether a coefficient is recalled rather than the user's own."""

    def __post_init__(self) -> None:
        found = Findings("UfcWind")
        for key in ("transverse", "from_ahead", "from_astern"):
            found.number(key, getattr(self, key), "", above=0.0, at_most=3.0)
        found.number("zero_angle", self.zero_angle, "rad", above=0.0)
        if not found.problems and not self.zero_angle < math.pi:
            found.add("zero_angle", f"{self.zero_angle:g} rad", Message("refused_motion.below_pi"))
        if self.superstructure not in ("single", "distributed"):
            found.add(
                "superstructure",
                repr(self.superstructure),
                Message("refused.one_of", words="single, distributed"),
            )
        found.raise_if_any()


def longitudinal_shape(angle: float, zero_angle: float, superstructure: Superstructure) -> float:
    """fxw: 1 at 0, 0 at theta_x, -1 at 180 deg (UFC eq. 6 and 7, page 77, A).

    Case I, single: cos(phi), phi = 90 deg theta/theta_x below theta_x and 90 deg (theta - theta_x)/
    (180 deg - theta_x) + 90 deg above. Case II, distributed: [sin(gamma) - sin(5 gamma)/10]/0.9
    with gamma = phi + 90 deg. The angle theta, rad, is counted as UFC counts, and theta_x is the
    zero angle, rad; it is symmetrical about the ship's axis.
    """
    theta = math.acos(max(-1.0, min(1.0, math.cos(angle))))
    quarter = 0.5 * math.pi
    if theta < zero_angle:
        phi = quarter * theta / zero_angle
    else:
        phi = quarter * (theta - zero_angle) / (math.pi - zero_angle) + quarter
    if superstructure == "single":
        return math.cos(phi)
    gamma = phi + quarter
    return (math.sin(gamma) - 0.1 * math.sin(5.0 * gamma)) / 0.9


def transverse_shape(angle: float, *, allow_recalled: bool = False) -> float:
    """Shape of the transverse force, [sin(theta) - sin(5 theta)/20]/0.95, recalled (R).

    The angle in rad is the same counted from the bow or from the stern.
    """
    refuse_recalled("transverse_shape", "fyw", "the shape function", _GIVE, allowed=allow_recalled)
    return (math.sin(angle) - 0.05 * math.sin(5.0 * angle)) / 0.95


def ufc_wind_loads(
    ship: Ship,
    wind: Wind,
    of: UfcWind,
    *,
    angle: float,
    air_density: float,
    allow_recalled: bool = False,
) -> tuple[LoadComponent, LoadComponent]:
    """Wind along and across a ship: 1/2 rho V^2 A C f.

    The wind is the mean of 30 s at 10 m (UFC 3-8.1, page 42), its angle from the bow to where it
    comes from, rad: 0 from ahead; the density, kg/m3, is 1.221 in UFC. Off the ship's axis recalled
    figures must be allowed, for the transverse shape function is one (R).
    """
    along_axis = abs(math.sin(angle)) < _ALONG
    across = 0.0 if along_axis else transverse_shape(angle, allow_recalled=allow_recalled)
    if of.recalled:
        what = "the coefficients"
        refuse_recalled("ufc_wind_loads", "of", what, _GIVE, allowed=allow_recalled)
    shape = longitudinal_shape(math.pi - angle, of.zero_angle, of.superstructure)
    along = of.from_ahead if shape < 0.0 else of.from_astern
    values = {"angle": math.degrees(angle), "along": shape, "across": across}
    source = _RECALLED if of.recalled else _LONGITUDINAL
    return wind_on_ship(
        ship,
        wind,
        air_density,
        ("Ax", "Cxw fxw", along * shape, source),
        ("Ay", "Cyw fyw", of.transverse * across, _RECALLED),
        Message("loads.ufc_wind_note", **values),
    )
