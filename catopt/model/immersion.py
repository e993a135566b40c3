"""What a solid body weighs in water."""

from __future__ import annotations

from catopt.constants import STANDARD_GRAVITY


def weight_in_water(mass: float, density: float, water_density: float) -> float:
    """Submerged weight of a solid body, N, from kg and kg/m3; negative when it floats.

    S2, equation (24), with W = m g0.
    """
    return mass * STANDARD_GRAVITY * (1.0 - water_density / density)
