"""Wind and current on a ship by UFC 4-159-03."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, Literal

from catopt.loads.component import UFC, LoadComponent, LoadSource, Number, refuse_recalled
from catopt.loads.environment import ALONG, Wind, drag_component, wind_on_ship
from catopt.loads.ship import PROPELLER_AREA_RATIOS, Ship
from catopt.model.kinds import Findings
from catopt.words import Message, term

Superstructure = Literal["single", "distributed"]
"""Case I, a single distinct superstructure or a ship dominated by its hull; case II."""

RECALLED_LONGITUDINAL: Final = 0.70
"""Cxw of a ship that is not dominated by its hull, recalled (R)."""

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
            allowed = Message("refused.one_of", words="single, distributed")
            found.add("superstructure", repr(self.superstructure), allowed)
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
    along_axis = abs(math.sin(angle)) < ALONG
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


SHALLOW_COEFFICIENT: Final = 3.2
"""C1, at T/d = 1, for currents up to 1.5 m/s (page 85, A)."""

FASTEST_SHALLOW: Final = 1.5
"""m/s: up to which C1 = 3.2 is recommended (page 85, A)."""

EXPONENT: Final = 2.0
"""K: fits most tests; 3 in a few, on a cargo ship, CVE-55 and SS-212 (page 85, A)."""

VISCOSITY: Final = 1.19e-6
"""m2/s, of sea water at 15 deg C: between the 1.354e-6 of 10 and the 1.054e-6 of 20 deg C (C)."""

_FORM_COEFFICIENT: Final = 0.1
_PROPELLER_COEFFICIENT: Final = 1.0
_LEAST_REYNOLDS: Final = 1.0e5

_ACROSS = LoadSource(
    UFC, "eq. 11 to 13, page 85, by a form (eq. 9 and 10) that gives table 4-6 again", "B"
)
_FORM = LoadSource(UFC, "eq. 16, page 89", "A")
_FRICTION = LoadSource(UFC, "eq. 17 to 20, page 90", "A")
_PROPELLER = LoadSource(UFC, "eq. 21 to 23, pages 90 to 92", "A")


def ship_parameter(length: float, midship_area: float, breadth: float, volume: float) -> float:
    """Dimensionless chi = LwL^2 Am/(B V), in m, m2 and m3 (eq. 13, page 85, A)."""
    return length * length * midship_area / (breadth * volume)


def deep_coefficient(parameter: float) -> float:
    """C0 = 0.22 sqrt(chi), chi of `ship_parameter` (eq. 12, page 85, B).

    The root is lost in the copy that was read; without it C0 of the FFG-7 would be 3.3, above C1,
    and table 4-6 asks for 0.849, which is that of chi = 14.9.
    """
    return 0.22 * math.sqrt(parameter)


def transverse_coefficient(
    draught_over_depth: float,
    deep: float,
    *,
    shallow: float = SHALLOW_COEFFICIENT,
    exponent: float = EXPONENT,
) -> float:
    """Cyc = C0 + (C1 - C0) (T/d)^K (B: the form is recalled, and gives table 4-6 again).

    `deep` and `shallow` are C0 and C1. Refused for T/d outside 0 to 1, or C0 above C1.
    """
    found = Findings("transverse current")
    found.number("T/d", draught_over_depth, "", at_least=0.0, at_most=1.0)
    found.number("C0", deep, "", above=0.0, at_most=shallow)
    found.number("K", exponent, "", above=0.0)
    found.raise_if_any()
    return float(deep + (shallow - deep) * draught_over_depth**exponent)


def transverse_load(
    ship: Ship,
    speed: float,
    depth: float,
    *,
    angle: float,
    water_density: float,
    exponent: float = EXPONENT,
) -> LoadComponent:
    """Compute the current across a ship: 1/2 rho V^2 LwL T Cyc sin(theta).

    Speed in m/s, depth in m, density in kg/m3; the angle is from the bow to where the current comes
    from, rad; the exponent K is 2 or 3.
    """
    ship.check_afloat(depth)
    length, ratio = ship.length_waterline, ship.draught / depth
    chi = ship_parameter(length, ship.midship_area, ship.breadth, ship.displacement)
    deep = deep_coefficient(chi)
    coefficient = transverse_coefficient(ratio, deep, exponent=exponent)
    note = Message(
        "loads.transverse_note",
        chi=chi,
        deep=deep,
        shallow=SHALLOW_COEFFICIENT,
        exponent=exponent,
        ratio=ratio,
        coefficient=coefficient,
        factor=coefficient / deep,
    )
    return drag_component(
        Message("loads.current_across"),
        "current",
        (water_density, speed),
        Number("LwL T", length * ship.draught, "m2", Message("loads.length_times_draught")),
        Number("Cyc sin", coefficient * math.sin(angle), "", Message("loads.coefficient_here")),
        _ACROSS,
        axis="sway",
        note=note,
    )


def wetted_surface(draught: float, length: float, volume: float) -> float:
    """S = 1.7 T LwL + V/T, m2; V is the volume displaced, m3 (eq. 18, page 90, A)."""
    return 1.7 * draught * length + volume / draught


def friction_coefficient(reynolds: float) -> float:
    """Cxca = 0.075/(log10 Rn - 2)^2 (eq. 19, page 90, A); 0 below Rn = 1e5, where it ends.

    Rn is nearly 0 for a current on the beam, where the formula has its pole.
    """
    if reynolds < _LEAST_REYNOLDS:
        return 0.0
    return 0.075 / (math.log10(reynolds) - 2.0) ** 2


def propeller_area(length: float, breadth: float, ratio: float, pitch: float = 1.0) -> float:
    """Give the expanded blade area of a ship's propellers, m2 (eq. 22 and 23, A).

    Ap = ATpp/(1.067 - 0.229 p/d) with ATpp = LwL B/AR: length and breadth at the waterline, m; AR,
    the ratio, of `PROPELLER_AREA_RATIOS`; p/d the pitch over the diameter.
    """
    return length * breadth / ratio / (1.067 - 0.229 * pitch)


def longitudinal_loads(
    ship: Ship,
    speed: float,
    *,
    angle: float,
    water_density: float,
    viscosity: float = VISCOSITY,
) -> tuple[LoadComponent, ...]:
    """Compute the current along a ship: form, friction and locked propeller (eq. 15 to 23, A).

    Speed in m/s, density in kg/m3, kinematic viscosity in m2/s; the angle is from the bow to where
    the current comes from, rad.
    """
    length, cosine = ship.length_waterline, math.cos(angle)

    def part(
        name: str, of: tuple[str, float], by: tuple[str, float], source: LoadSource, note: str = ""
    ) -> LoadComponent:
        """Make a part of an area, m2, and a coefficient, each behind its symbol."""
        letter, coefficient = by
        return drag_component(
            Message(name),
            "current",
            (water_density, speed),
            Number(*of, "m2", Message("loads.area")),
            Number(f"{letter} cos", coefficient * cosine, "", Message("loads.coefficient_here")),
            source,
            axis="surge",
            sign=-1.0,
            note=note,
        )

    reynolds = speed * length * abs(cosine) / viscosity
    section = ("B T", ship.breadth * ship.draught)
    surface = ("S", wetted_surface(ship.draught, length, ship.displacement))
    by_friction = ("Cxca", friction_coefficient(reynolds))
    said = Message("loads.reynolds", number=reynolds)
    parts = [
        part("loads.current_form", section, ("Cxcb", _FORM_COEFFICIENT), _FORM),
        part("loads.current_friction", surface, by_friction, _FRICTION, said),
    ]
    if ship.propeller is not None:
        ratio = PROPELLER_AREA_RATIOS[ship.propeller]
        blades = ("Ap", propeller_area(length, ship.breadth, ratio))
        said = Message("loads.propeller_note", kind=term(ship.propeller), ratio=ratio)
        by_blades = ("Cprop", _PROPELLER_COEFFICIENT)
        parts.append(part("loads.current_propeller", blades, by_blades, _PROPELLER, said))
    return tuple(parts)


def yaw_moment(
    transverse_force: float, length: float, intercept: float, slope: float, angle: float
) -> float:
    """Moment of the current about the vertical, N m: Fyc (a + b theta) LwL (eq. 24 and 25, A).

    The intercept a and the slope b per degree are of table 4-10, which was not read: they are the
    user's. The angle theta is in degrees, 0 to 360, as UFC counts it.
    """
    theta = angle if angle <= 180.0 else 360.0 - angle
    return transverse_force * (intercept + slope * theta) * length
