"""The place: water and seabed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import InputError, Problem
from catopt.model.kinds import Density, Given, Length, Measured, NotNegative
from catopt.model.validity import Checked, Findings
from catopt.units import Dimension
from catopt.words import Message

STEEPEST = math.radians(45.0)
"""Slope of a bed, either way, rad."""
HIGHEST = 1.0
"""Contact offset, m: of a chain whose bar has 0.6 m."""
Slope = Annotated[
    float,
    Measured(Dimension.ANGLE, at_least=-STEEPEST, at_most=STEEPEST, example='"3 deg"'),
]
Offset = Annotated[
    float,
    Measured(Dimension.LENGTH, at_least=0.0, at_most=HIGHEST, example='"0.164 m"'),
]


@dataclass(frozen=True)
class Site(Checked):
    """Water and seabed at the mooring."""

    water_depth: Length
    """From the still water to the seabed, m; with a contact offset to what the line lies on."""
    seabed_friction: NotNegative = 0.0
    """Coulomb coefficient of what lies on the bed, along the line."""
    water_density: Density = SEA_WATER_DENSITY
    """kg/m3."""
    seabed_slope: Slope = 0.0
    """Angle by which the bed, a plane, rises from the anchor towards the fairlead, rad. Depth and
    heights are then those above the bed at the anchor, x = 0."""
    contact_offset: Offset = 0.0
    """Height of the axis of a line that lies above the seabed, m: a contact radius, less what it
    sinks in. Depth and heights of a case are less by it: they count from there."""

    if TYPE_CHECKING:  # numbers in SI or text with a unit; what is kept are numbers

        def __init__(
            self,
            water_depth: Given,
            seabed_friction: Given = 0.0,
            water_density: Given = SEA_WATER_DENSITY,
            seabed_slope: Given = 0.0,
            contact_offset: Given = 0.0,
        ) -> None: ...

    def _check(self, found: Findings) -> None:
        found.check()
        if self.seabed_slope and self.contact_offset:
            found.add(
                "contact_offset", f"{self.contact_offset:g} m", Message("refused_case.level_only")
            )

    @property
    def depth_to_seabed(self) -> float:
        """From the still water surface to the seabed itself, m."""
        return self.water_depth + self.contact_offset

    def height_above_seabed(self, height: float) -> float:
        """Return a height of the case above the seabed itself, m; an end on the bed stays at 0."""
        return height + self.contact_offset if height > 0.0 else 0.0

    def check_level(self) -> None:
        """Raise InputError where the bed slopes, for what takes it to be level."""
        if self.seabed_slope != 0.0:
            allowed = Message("refused_case.level_bed_unless")
            found = f"{math.degrees(self.seabed_slope):g} deg"
            raise InputError([Problem("site.seabed_slope", found, allowed)])
