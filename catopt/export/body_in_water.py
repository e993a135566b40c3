"""What other programs take in the place of a weight in water: mass in air, and volume."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from catopt.constants import STANDARD_GRAVITY
from catopt.errors import refused
from catopt.model import PointLoad, Segment
from catopt.model.network import Point
from catopt.words import Message

STEEL_DENSITY = 7850.0
"""kg/m3: stands in for a segment whose mass is not known."""

LEAST_VOLUME = 1e-9
"""Of the mass over the water's density: less is rounding of a body that displaces nothing."""


@dataclass(frozen=True)
class BodyInWater:
    """Mass (kg, or kg/m) and volume (m3, or m2) that together have a submerged weight.

    Both are of the whole body, or per unstretched length. `is_known`: whether the mass is that of
    the case; otherwise it stands in, which changes nothing at rest; `drag_area`: of a point load,
    times its drag coefficient, m2; `added_mass`: its coefficient, on the displaced water.
    """

    mass: float
    volume: float
    is_known: bool = True
    drag_area: float = 0.0
    added_mass: float = 0.0

    @property
    def diameter(self) -> float:
        """Volume-equivalent diameter, m, where both are per length."""
        return math.sqrt(4.0 * self.volume / math.pi)


def of_segment(segment: Segment, water_density: float, key: str) -> BodyInWater:
    """Mass and volume of a segment, per length.

    `water_density`: kg/m3; `key`: where the segment stands in the case, for messages. Raises
    InputError when it does not sink and its mass is not known, or its mass is less than its weight
    in water.
    """
    weight = segment.submerged_weight / STANDARD_GRAVITY
    if segment.mass == 0.0:
        allowed = Message("refused_command.must_be_above_0_kg")
        raise refused(f"{key}.mass", "0 kg/m", allowed, "export")
    if segment.mass is not None:
        return _displacing(segment.mass, weight, water_density, f"{key}.mass", "kg/m")
    if weight <= 0.0:
        allowed = Message("refused_command.missing_segment_does_not_sink")
        raise refused(f"{key}.mass", "", allowed, "export")
    mass = weight / (1.0 - water_density / STEEL_DENSITY)
    return BodyInWater(mass, mass / STEEL_DENSITY, is_known=False)


def of_point_load(load: PointLoad | Point, water_density: float, key: str) -> BodyInWater:
    """Mass and volume of a clump weight, a buoy or a joint, with its drag and added mass.

    `water_density`: kg/m3; `key`: where the load stands in the case, for messages. Raises
    InputError when its mass in air is less than its weight in water.
    """
    weight = load.submerged_weight / STANDARD_GRAVITY
    if load.mass is None:
        body = BodyInWater(max(weight, 0.0), max(-weight, 0.0) / water_density, is_known=False)
    elif abs(load.mass - weight) <= LEAST_VOLUME * load.mass:
        body = BodyInWater(load.mass, 0.0)
    else:
        body = _displacing(load.mass, weight, water_density, f"{key}.mass", "kg")
    return replace(body, drag_area=load.drag_product, added_mass=load.added_mass_coefficient)


def _displacing(
    mass: float, weight: float, water_density: float, key: str, unit: str
) -> BodyInWater:
    volume = (mass - weight) / water_density
    if volume < LEAST_VOLUME * mass / water_density:
        allowed = Message("refused_command.must_be_above_what_weight", weight=weight, unit=unit)
        raise refused(key, f"{mass:.6g} {unit}", allowed, "export")
    return BodyInWater(mass, volume)
