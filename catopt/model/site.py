"""The place: water and seabed."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import InputError, Problem
from catopt.model.validity import Findings

STEEPEST = math.radians(45.0)
"""Slope of a bed, either way, rad."""
HIGHEST = 1.0
"""Contact offset, m: of a chain whose bar has 0.6 m."""
LEVEL_ONLY = "must be 0 or left out: seabed_slope is not 0"


@dataclass(frozen=True)
class Site:
    """Water and seabed at the mooring.

    Attributes
    ----------
    water_depth : float
        From the still water surface to the seabed, m; with a contact offset to what the line lies
        on.
    seabed_friction : float
        Coulomb coefficient of what lies on the bed, along the line.
    water_density : float
        kg/m3.
    seabed_slope : float
        Angle by which the bed, a plane, rises from the anchor towards the fairlead, rad. Depth and
        heights are then those above the bed at the anchor, x = 0.
    contact_offset : float
        Height of the axis of a line that lies above the seabed, m: a contact radius, less what it
        sinks in. Depth and heights of a case are less by it: they count from there.
    """

    water_depth: float
    seabed_friction: float = 0.0
    water_density: float = SEA_WATER_DENSITY
    seabed_slope: float = 0.0
    contact_offset: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("Site", self)
        found.number("water_depth", self.water_depth, "m", above=0.0)
        found.number("seabed_friction", self.seabed_friction, "", at_least=0.0)
        found.number("water_density", self.water_density, "kg/m3", above=0.0)
        slope = self.seabed_slope
        found.number("seabed_slope", slope, "rad", at_least=-STEEPEST, at_most=STEEPEST)
        found.number("contact_offset", self.contact_offset, "m", at_least=0.0, at_most=HIGHEST)
        if slope and self.contact_offset:
            found.add("contact_offset", f"{self.contact_offset:g} m", LEVEL_ONLY)
        found.raise_if_any()

    @property
    def depth_to_seabed(self) -> float:
        """From the still water surface to the seabed itself, m."""
        return self.water_depth + self.contact_offset

    def height_above_seabed(self, height: float) -> float:
        """Return a height of the case above the seabed itself, m; an end on the bed stays at 0."""
        return height + self.contact_offset if height > 0.0 else 0.0

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
