"""Water levels and weather that a mooring is sized for, all from one side."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Final

from catopt.constants import SEA_WATER_DENSITY
from catopt.loads.environment import SeaState, SurfaceCurrent, WaterLevels, Wind
from catopt.model.validity import Findings
from catopt.sizing.kinds import usual

_PERIOD_OF_HEIGHT: Final = 3.6
"""s per root of m: 2 pi Hs/(g T^2) is then 1/20, the steepness of a growing sea; catopt's own."""


LONGEST_MEAN: Final = 3600.0
"""s: the mean that the profile starts from."""

_TURBULENCE, _WITH_SPEED, _GUST = 0.06, 0.043, 0.41
"""Of Iu = 0.06 (1 + 0.043 U0) at 10 m and U(t) = U0 (1 - 0.41 Iu ln(t/3600)), in m and s."""


def usual_period(significant_height: float) -> float:
    """Period of a sea that is still growing: 3.6 sqrt(Hs), s; catopt's own rule. Hs in m."""
    return max(1.0, round(_PERIOD_OF_HEIGHT * math.sqrt(significant_height), 1))


WIND_MEAN: Final = 30.0
"""s: the wind that loads on a ship are computed for is a mean over this (UFC 3-8.1, page 42)."""


@dataclass(frozen=True)
class Environment:
    """Depths and weather."""

    levels: WaterLevels  # depth of the still water at low and at high water
    # wind, current and waves come all at once and from one side
    wind: Wind = field(default_factory=lambda: Wind(usual("wind")))
    current: SurfaceCurrent = field(default_factory=lambda: SurfaceCurrent(usual("current")))
    sea: SeaState = field(default_factory=lambda: SeaState(usual_period(usual("hs")), usual("hs")))
    water_density: float = SEA_WATER_DENSITY  # kg/m3

    @property
    def is_calm(self) -> bool:
        """Whether nothing pushes."""
        return self.wind.speed == self.current.speed == self.sea.hmax == 0.0

    @property
    def crest(self) -> float:
        """Height of the largest crest over the still water at high water, Hmax/2, m (CALMAR)."""
        return self.levels.deepest(self.sea) - self.levels.high


def mean_over(speed: float, given: float, wanted: float) -> float:
    """Convert a wind speed at 10 m from one averaging time to another.

    U(t) = U0 [1 - 0.41 Iu ln(t/3600)] with Iu = 0.06 (1 + 0.043 U0), U0 the mean of an hour
    (NPD/ISO 19901-1, B: read in two programs). U0 is the root of a quadratic equation. Speeds are
    in m/s; InputError for averaging times `given` or `wanted` that are not of 1 s to an hour.

    Examples
    --------
    >>> round(mean_over(25.0, 600.0, 30.0), 2)
    28.5
    """
    found = Findings("wind mean")
    for key, time in (("given", given), ("wanted", wanted)):
        found.number(key, time, "s", at_least=1.0, at_most=LONGEST_MEAN)
    found.raise_if_any()
    if given == wanted:
        return speed
    gust = _gust(given)
    a, b = gust * _WITH_SPEED, 1.0 + gust
    hourly = 2.0 * speed / (b + math.sqrt(b * b + 4.0 * a * speed))
    gust = _gust(wanted)
    return hourly * (1.0 + gust * (1.0 + _WITH_SPEED * hourly))


def _gust(time: float) -> float:
    return -_GUST * _TURBULENCE * math.log(time / LONGEST_MEAN)
