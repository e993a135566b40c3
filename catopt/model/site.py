"""The place: water and seabed."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import InputError, Problem
from catopt.model.validity import Findings

STEEPEST = math.radians(45.0)
"""Slope of a bed, either way, rad."""


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
    seabed_slope : float
        Angle by which the bed, a plane, rises from the anchor towards the fairlead, rad. Depth and
        heights are then those above the bed at the anchor, x = 0.
    """

    water_depth: float
    seabed_friction: float = 0.0
    water_density: float = SEA_WATER_DENSITY
    seabed_slope: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("Site")
        found.number("water_depth", self.water_depth, "m", above=0.0)
        found.number("seabed_friction", self.seabed_friction, "", at_least=0.0)
        found.number("water_density", self.water_density, "kg/m3", above=0.0)
        slope = self.seabed_slope
        found.number("seabed_slope", slope, "rad", at_least=-STEEPEST, at_most=STEEPEST)
        found.raise_if_any()

    def check_level(self) -> None:
        """Refuse a bed that slopes, for what takes it to be level.

        Raises
        ------
        InputError
            By the key of the case file.
        """
        if self.seabed_slope != 0.0:
            allowed = "must be 0 or left out: only catopt verify --dynamic has a bed that slopes"
            found = f"{math.degrees(self.seabed_slope):g} deg"
            raise InputError([Problem("site.seabed_slope", found, allowed)])
