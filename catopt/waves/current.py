"""Current over the depth, S4 [2.77]-[2.79]: power law, wind-driven, table; a sea takes their sum.

Profiles are horizontal. They are steady, or a `CurrentSeries` scales and turns their sum over time.
Speeds hold their surface value above still water, where a wave crest lifts water there.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal, TypeAlias, get_args

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array
from catopt.model.kinds import Findings
from catopt.words import Message

WindRule = Literal["S4", "CALMAR"]

WIND_SHARE = MappingProxyType({"S4": 0.01, "CALMAR": 0.015})
"""Surface current over wind speed where nothing was measured: 1 % of the hourly mean at 10 m (S4);
1.5 % (IALA's CALMAR)."""


def wind_driven_speed(wind_speed: float, rule: WindRule = "S4") -> float:
    """Speed of the wind-driven current at the surface, m/s, where it was not measured.

    Parameters
    ----------
    wind_speed : float
        Hourly mean at 10 m, m/s; InputError below 0.
    rule : {"S4", "CALMAR"}
        1 % or 1.5 % of it.
    """
    found = Findings("wind_driven_speed")
    found.number("wind_speed", wind_speed, "m/s", at_least=0.0)
    if rule not in get_args(WindRule):
        wanted = Message("refused.one_of", words=", ".join(get_args(WindRule)))
        found.add("rule", repr(rule), wanted)
    found.raise_if_any()
    return WIND_SHARE[rule] * wind_speed


@dataclass(frozen=True)
class PowerLawCurrent:
    """Tidal current V0 (z/d)^n at the height z above the bed in water of the depth d, S4 [2.77]."""

    surface_speed: float  # V0, m/s, 0 or more
    direction: float = 0.0  # where it flows to, rad from the x axis
    exponent: float = 1.0 / 7.0  # n, above 0; 1/7 in S4

    def __post_init__(self) -> None:
        found = _check_flow("PowerLawCurrent", self.surface_speed, self.direction)
        found.number("exponent", self.exponent, "", above=0.0)
        found.raise_if_any()


@dataclass(frozen=True)
class WindCurrent:
    """Wind-driven current, which falls linearly from V0 at still water to 0 at d0 below it, [2.78].

    d0 may exceed the water's depth.
    """

    surface_speed: float  # V0, m/s, 0 or more (`wind_driven_speed`)
    depth: float  # d0, m, above 0
    direction: float = 0.0  # where it flows to, rad from the x axis

    def __post_init__(self) -> None:
        found = _check_flow("WindCurrent", self.surface_speed, self.direction)
        found.number("depth", self.depth, "m", above=0.0)
        found.raise_if_any()


@dataclass(frozen=True)
class TableCurrent:
    """Current by depth, linear between the rows and constant beyond the first and the last."""

    depths: Sequence[float]  # below still water, m, from 0 up, each greater than the one before
    speeds: Sequence[float]  # m/s; negative where the water flows against `direction`
    direction: float = 0.0  # where it flows to, rad from the x axis
    directions: Sequence[float] = ()  # one for each of the depths, in place of `direction`, where
    # the current turns with depth; between the rows the speeds along x and y are linear

    def __post_init__(self) -> None:
        for key in ("depths", "speeds", "directions"):
            object.__setattr__(self, key, tuple(getattr(self, key)))
        found = Findings("TableCurrent")
        found.number("direction", self.direction, "rad")
        if not self.depths or len(self.depths) != len(self.speeds):
            sizes = f"{len(self.depths)} depths, {len(self.speeds)} speeds"
            found.add("speeds", sizes, Message("refused.speeds_and_depths"))
        for i, (depth, speed) in enumerate(zip(self.depths, self.speeds, strict=False)):
            found.number(f"depths[{i}]", depth, "m", at_least=0.0)
            found.number(f"speeds[{i}]", speed, "m/s")
        if self.directions and len(self.directions) != len(self.depths):
            sizes = f"{len(self.depths)} depths, {len(self.directions)} directions"
            found.add(
                "directions", sizes, Message("refused_motion.many_directions_depths_are_wanted")
            )
        for i, direction in enumerate(self.directions):
            found.number(f"directions[{i}]", direction, "rad")
        found.raise_if_any()
        for i in range(1, len(self.depths)):
            if self.depths[i] <= self.depths[i - 1]:
                above = Message("refused_motion.must_be_below_row_before", value=self.depths[i - 1])
                found.add(f"depths[{i}]", repr(self.depths[i]), above)
        found.raise_if_any()


@dataclass(frozen=True, eq=False)
class CurrentSeries:
    """Current at the surface over time, by which the profiles of a sea are scaled and turned.

    Between its times the speeds along x and y are linear, so that the water accelerates evenly;
    before the first and after the last they are held.
    """

    times: npt.ArrayLike  # (n,): s, rising, 0 being the start of the run
    speeds: npt.ArrayLike  # (n,): at the surface, m/s
    directions: npt.ArrayLike | None = None  # (n,): where it flows to at the surface, rad from the
    # x axis; None: as the profiles do

    def __post_init__(self) -> None:
        found = Findings("CurrentSeries")
        t = np.asarray(self.times, dtype=float)
        for key in ("times", "speeds", "directions"):
            if getattr(self, key) is None:
                continue
            values = np.asarray(getattr(self, key), dtype=float)
            if values.ndim != 1 or values.shape != t.shape or t.size == 0:
                shape = Message("refused_motion.shape", shape=values.shape)
                found.add(key, shape, Message("refused_motion.one_number_a_time"))
            elif not np.isfinite(values).all():
                found.add(
                    key,
                    Message("refused_motion.nan"),
                    Message("refused_motion.finite_numbers_are_wanted"),
                )
        if not found.problems and not (np.diff(t) > 0.0).all():
            at = int(np.argmax(np.diff(t) <= 0.0))
            found.add(
                "times", f"{t[at + 1]:g} s after {t[at]:g} s", Message("refused_motion.must_rise")
            )
        found.raise_if_any()

    def rows(self, surface: complex) -> Array:
        """Rows of time, s, and the factor on the profiles, as a complex number in two parts.

        `surface`: what the profiles flow with there, along x and y, m/s; not 0.
        """
        speeds = np.asarray(self.speeds, dtype=float)
        if self.directions is None:
            factor = speeds / abs(surface) + 0j
        else:
            factor = speeds * np.exp(1j * np.asarray(self.directions, dtype=float)) / surface
        return np.column_stack([np.asarray(self.times, dtype=float), factor.real, factor.imag])


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
    for height, *velocity in straight:
        for j, part in enumerate(velocity, start=1):
            rows[:, j] += np.interp(z, height, part)
    return rows


def _table(
    profile: WindCurrent | TableCurrent, water_depth: float
) -> tuple[list[float], list[float], list[float]]:
    """Heights above the bed, rising, with the speeds along x and y."""
    if isinstance(profile, WindCurrent):
        depths: Sequence[float] = (0.0, profile.depth)
        speeds: Sequence[float] = (profile.surface_speed, 0.0)
        directions: Sequence[float] = ()
    else:
        depths, speeds, directions = profile.depths, profile.speeds, profile.directions
    turned = directions or (profile.direction,) * len(depths)
    velocity = [_along(b, speed) for b, speed in zip(turned, speeds, strict=True)][::-1]
    heights = [water_depth - depth for depth in reversed(depths)]
    return heights, [x for x, _ in velocity], [y for _, y in velocity]


def _along(direction: float, speed: float) -> tuple[float, float]:
    return speed * math.cos(direction), speed * math.sin(direction)


def _check_flow(source: str, surface_speed: float, direction: float) -> Findings:
    found = Findings(source)
    found.number("surface_speed", surface_speed, "m/s", at_least=0.0)
    found.number("direction", direction, "rad")
    return found
