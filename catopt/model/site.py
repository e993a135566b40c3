"""The place: water and seabed."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.constants import SEA_WATER_DENSITY
from catopt.model.validity import Findings

__all__ = ["Site"]


@dataclass(frozen=True)
class Site:
    """Water and seabed at the mooring.

    Attributes
    ----------
    water_depth : float
        From the still water surface to the seabed, m.
    seabed_friction : float
        Coulomb coefficient of what lies on the bed, along the line.
    water_density : float
        kg/m3.
    """

    water_depth: float
    seabed_friction: float = 0.0
    water_density: float = SEA_WATER_DENSITY

    def __post_init__(self) -> None:
        found = Findings("Site")
        found.number("water_depth", self.water_depth, "m", above=0.0)
        found.number("seabed_friction", self.seabed_friction, "", at_least=0.0)
        found.number("water_density", self.water_density, "kg/m3", above=0.0)
        found.raise_if_any()
