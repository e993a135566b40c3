"""Current over the depth, S4 [2.77]-[2.79]: power law, wind-driven, table; a sea takes their sum.

Profiles are horizontal and steady. Speeds hold their surface value above still water, where a wave
crest lifts water there.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal, TypeAlias, get_args

import numpy as np
import numpy.typing as npt

from catopt.model.validity import Findings

__all__ = [
    "WIND_SHARE",
    "Current",
    "PowerLawCurrent",
    "TableCurrent",
    "WindCurrent",
    "WindRule",
    "wind_driven_speed",
]

Array = npt.NDArray[np.float64]

WindRule = Literal["S4", "CALMAR"]

WIND_SHARE = MappingProxyType({"S4": 0.01, "CALMAR": 0.015})
"""Surface current over wind speed where nothing was measured: 1 % of the hourly mean at 10 m (S4);
1.5 % (IALA's CALMAR)."""


def wind_driven_speed(wind_speed: float, rule: WindRule = "S4") -> float:
    """Speed of the wind-driven current at the surface, m/s, where it was not measured.

    Parameters
    ----------
    wind_speed : float
        Hourly mean at 10 m, m/s, 0 or more.
    rule : {"S4", "CALMAR"}
        1 % or 1.5 % of it.

    Raises
    ------
    InputError
        For a negative wind speed or an unknown rule.
    """
    found = Findings("wind_driven_speed")
    found.number("wind_speed", wind_speed, "m/s", at_least=0.0)
    if rule not in get_args(WindRule):
        found.add("rule", repr(rule), f"must be one of {', '.join(get_args(WindRule))}")
    found.raise_if_any()
    return WIND_SHARE[rule] * wind_speed


@dataclass(frozen=True)
class PowerLawCurrent:
    """Tidal current V0 (z/d)^n at the height z above the bed in water of the depth d, S4 [2.77].

    Attributes
    ----------
    surface_speed : float
        V0, m/s, 0 or more.
    direction : float
        Where it flows to, rad from the x axis.
    exponent : float
        n, above 0; 1/7 in S4.
    """

    surface_speed: float
    direction: float = 0.0
    exponent: float = 1.0 / 7.0

    def __post_init__(self) -> None:
        found = _check_flow("PowerLawCurrent", self.surface_speed, self.direction)
        found.number("exponent", self.exponent, "", above=0.0)
        found.raise_if_any()


@dataclass(frozen=True)
class WindCurrent:
    """Wind-driven current, which falls linearly from V0 at still water to 0 at d0 below it, [2.78].

    Attributes
    ----------
    surface_speed : float
        V0, m/s, 0 or more; see `wind_driven_speed`.
    depth : float
        d0, m, above 0; may exceed the water's depth.
    direction : float
        Where it flows to, rad from the x axis.
    """

    surface_speed: float
    depth: float
    direction: float = 0.0

    def __post_init__(self) -> None:
        found = _check_flow("WindCurrent", self.surface_speed, self.direction)
        found.number("depth", self.depth, "m", above=0.0)
        found.raise_if_any()


@dataclass(frozen=True)
class TableCurrent:
    """Current by depth, linear between the rows and constant beyond the first and the last.

    Attributes
    ----------
    depths : sequence of float
        Below still water, m, from 0 up, each greater than the one before.
    speeds : sequence of float
        m/s; negative where the water flows against `direction`.
    direction : float
        Where it flows to, rad from the x axis.
    """

    depths: Sequence[float]
    speeds: Sequence[float]
    direction: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "depths", tuple(self.depths))
        object.__setattr__(self, "speeds", tuple(self.speeds))
        found = Findings("TableCurrent")
        found.number("direction", self.direction, "rad")
        if not self.depths or len(self.depths) != len(self.speeds):
            sizes = f"{len(self.depths)} depths, {len(self.speeds)} speeds"
            found.add("speeds", sizes, "as many speeds as depths are wanted, one or more")
        for i, (depth, speed) in enumerate(zip(self.depths, self.speeds, strict=False)):
            found.number(f"depths[{i}]", depth, "m", at_least=0.0)
            found.number(f"speeds[{i}]", speed, "m/s")
        found.raise_if_any()
        for i in range(1, len(self.depths)):
            if self.depths[i] <= self.depths[i - 1]:
                above = f"must be below the row before, more than {self.depths[i - 1]:g} m"
                found.add(f"depths[{i}]", repr(self.depths[i]), above)
        found.raise_if_any()


Current: TypeAlias = PowerLawCurrent | WindCurrent | TableCurrent


def power_rows(profiles: Sequence[Current]) -> Array:
    """Rows of V0 along x and y (m/s) and exponent, one for each power law."""
    rows = [
        (*_along(profile.direction, profile.surface_speed), profile.exponent)
        for profile in profiles
        if isinstance(profile, PowerLawCurrent)
    ]
    return np.array(rows, dtype=float).reshape(-1, 3)


def table_rows(profiles: Sequence[Current], water_depth: float) -> Array:
    """Rows of height above the bed (m), speed along x and y (m/s), from the bed up.

    All profiles of straight pieces make one such table: their sum is straight between all their
    breaks.
    """
    straight = [_table(p, water_depth) for p in profiles if not isinstance(p, PowerLawCurrent)]
    heights = {0.0, water_depth}.union(*(table[0] for table in straight))
    z = np.array(sorted(h for h in heights if 0.0 <= h <= water_depth))
    rows = np.zeros((z.size, 3))
    rows[:, 0] = z
    for height, speed, direction in straight:
        rows[:, 1:] += np.outer(np.interp(z, height, speed), _along(direction, 1.0))
    return rows


def _table(
    profile: WindCurrent | TableCurrent, water_depth: float
) -> tuple[list[float], list[float], float]:
    """Heights above the bed, rising, with their speeds; and the direction."""
    if isinstance(profile, WindCurrent):
        heights = [water_depth - profile.depth, water_depth]
        return heights, [0.0, profile.surface_speed], profile.direction
    heights = [water_depth - depth for depth in reversed(profile.depths)]
    return heights, list(reversed(profile.speeds)), profile.direction


def _along(direction: float, speed: float) -> tuple[float, float]:
    return speed * math.cos(direction), speed * math.sin(direction)


def _check_flow(source: str, surface_speed: float, direction: float) -> Findings:
    found = Findings(source)
    found.number("surface_speed", surface_speed, "m/s", at_least=0.0)
    found.number("direction", direction, "rad")
    return found
