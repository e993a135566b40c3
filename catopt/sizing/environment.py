"""Water levels and weather that a mooring is sized for, all from one side."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Final

from catopt.constants import SEA_WATER_DENSITY
from catopt.loads.environment import SeaState, SurfaceCurrent, WaterLevels, Wind
from catopt.sizing.kinds import usual

_PERIOD_OF_HEIGHT: Final = 3.6
"""s per root of m: 2 pi Hs/(g T^2) is then 1/20, the steepness of a growing sea; catopt's own."""


def usual_period(significant_height: float) -> float:
    """Period of a sea that is still growing: 3.6 sqrt(Hs), s; catopt's own rule. Hs in m."""
    return max(1.0, round(_PERIOD_OF_HEIGHT * math.sqrt(significant_height), 1))


@dataclass(frozen=True)
class Environment:
    """Depths and weather.

    Attributes
    ----------
    levels : WaterLevels
        Depth of the still water at low and at high water.
    wind, current, sea : Wind, SurfaceCurrent, SeaState
        All at once and from one side.
    water_density : float
        kg/m3.
    """

    levels: WaterLevels
    wind: Wind = field(default_factory=lambda: Wind(usual("wind")))
    current: SurfaceCurrent = field(default_factory=lambda: SurfaceCurrent(usual("current")))
    sea: SeaState = field(default_factory=lambda: SeaState(usual_period(usual("hs")), usual("hs")))
    water_density: float = SEA_WATER_DENSITY

    @property
    def is_calm(self) -> bool:
        """Whether nothing pushes."""
        return self.wind.speed == self.current.speed == self.sea.hmax == 0.0

    @property
    def crest(self) -> float:
        """Height of the largest crest over the still water at high water, Hmax/2, m (CALMAR)."""
        return self.levels.deepest(self.sea) - self.levels.high
