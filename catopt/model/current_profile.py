"""The current of a case over the depth: a power law, driven by wind, or a table."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType
from typing import Annotated, Literal, get_args

from catopt.model.kinds import Angle, File, Height, Length, Positive, SomeSpeed, Speed
from catopt.model.validity import Checked, Findings
from catopt.words import Message

ProfileKind = Literal["power", "wind", "table"]
CURRENT_PROFILES: tuple[str, ...] = get_args(ProfileKind)

_NEEDS = MappingProxyType(
    {"power": ("speed",), "wind": ("speed", "depth"), "table": ("depths", "speeds")}
)
_TAKES = MappingProxyType(
    {**_NEEDS, "power": ("speed", "exponent"), "table": ("depths", "speeds", "directions")}
)
_TURN = 0.5 * math.pi * (1.0 + 1e-12)
"""Most by which a current may turn from row to row: its speeds along x and y are interpolated."""


@dataclass(frozen=True)
class CurrentProfile(Checked):
    """A current over the depth, steady or over time; docs/waves.md has the formulas."""

    profile: ProfileKind
    """How the speed depends on the depth."""
    speed: SomeSpeed | None = None
    """At the surface, m/s; of a power law or of a current that is driven by wind. None where a file
    gives it."""
    exponent: Positive | None = None
    """Of a power law; None: 1/7."""
    depth: Length | None = None
    """Below still water, where a current that is driven by wind ends, m."""
    depths: tuple[Height, ...] = ()
    """Of a table: below still water, m, each greater than the one before."""
    speeds: tuple[Speed, ...] = ()
    """Of a table, m/s."""
    direction: Angle = 0.0
    """Where it flows to, rad from the x axis, which points from the anchor to the fairlead."""
    directions: tuple[Angle, ...] = ()
    """Of a table that turns with depth, one for each of the depths, in place of `direction`."""
    series_file: Annotated[str, File(example='"current.csv"')] = ""
    """Path of a CSV file of the current at the surface over time, by which the profile is scaled
    and turned; empty for a steady one."""

    def flow(self, water_depth: float) -> Callable[[float], tuple[float, float]]:
        """Return the velocity of the water along x and y, m/s, by the height above the bed, m.

        There is none above the water; that of a steady profile.
        """
        rows = [(water_depth - depth, *self._row(k)) for k, depth in enumerate(self.depths)][::-1]
        way = (math.cos(self.direction), math.sin(self.direction))
        exponent = 1.0 / 7.0 if self.exponent is None else self.exponent
        speed, reach = self.speed or 0.0, self.depth or water_depth

        def of_table(z: float) -> tuple[float, float]:
            if not rows[0][0] < z < rows[-1][0]:
                return rows[0][1:] if z <= rows[0][0] else rows[-1][1:]
            k = next(k for k in range(1, len(rows)) if z <= rows[k][0])
            (low, u, v), (high, *upper) = rows[k - 1 : k + 1]
            part = (z - low) / (high - low)
            return u + part * (upper[0] - u), v + part * (upper[1] - v)

        def velocity(z: float) -> tuple[float, float]:
            if z > water_depth * (1.0 + 1e-12):
                return 0.0, 0.0
            if rows:
                return of_table(z)
            if self.profile == "wind":
                share = min(max((reach - water_depth + z) / reach, 0.0), 1.0)
            else:
                share = min(max(z / water_depth, 0.0), 1.0) ** exponent
            return share * speed * way[0], share * speed * way[1]

        return velocity

    def _row(self, k: int) -> tuple[float, float]:
        """Velocity of a row of the table along x and y, m/s."""
        direction = self.directions[k] if self.directions else self.direction
        return self.speeds[k] * math.cos(direction), self.speeds[k] * math.sin(direction)

    def _check(self, found: Findings) -> None:
        found.check("profile")
        found.raise_if_any()
        found.check("depths")
        found.each("speeds", "m/s", at_least=0.0 if self.directions else None)
        found.check("directions")
        self._check_keys(found)
        found.check("speed", "exponent", "depth", "direction")
        self._check_table(found)

    def _check_keys(self, found: Findings) -> None:
        """Find what is missing for the profile, and what goes with another."""
        for key in ("speed", "exponent", "depth", "depths", "speeds", "directions"):
            given = getattr(self, key)
            is_given = given is not None and given != ()
            if key == "speed" and self.series_file and self.profile != "table":
                if is_given:
                    found.add(
                        key, repr(given), Message("refused_case.stands_series_file_leave_out")
                    )
            elif is_given and key not in _TAKES[self.profile]:
                allowed: str = Message("refused.not_with_profile", profile=self.profile)
                found.add(key, repr(given), allowed)
            elif not is_given and key in _NEEDS[self.profile]:
                found.add(key, "", Message("refused.profile_needs", profile=self.profile))
        if self.directions and self.direction != 0.0:
            allowed = Message("refused_case.goes_with_one_all_depths")
            found.add("direction", repr(self.direction), allowed)
        if self.series_file and self.speeds and self.speeds[0] <= 0.0:
            allowed = Message("refused_case.must_be_above_0_m")
            found.add("speeds[0]", f"{self.speeds[0]:g} m/s", allowed)

    def _check_table(self, found: Findings) -> None:
        self._check_length("speeds", found)
        for index, (above, depth) in enumerate(pairwise(self.depths), start=1):
            if depth <= above:
                allowed: str = Message("refused.more_than_before", above=above)
                found.add(f"depths[{index}]", f"{depth:g} m", allowed)
        self._check_length("directions", found)
        for index, turn in enumerate(turns(self.directions), start=1):
            if turn > _TURN:
                allowed = Message("refused_case.more_than_right_angle_from")
                shown = f"a turn of {math.degrees(turn):.4g} deg"
                found.add(f"directions[{index}]", shown, allowed)

    def _check_length(self, key: str, found: Findings) -> None:
        depths, others = len(self.depths), len(getattr(self, key))
        if depths and others and depths != others:
            allowed = Message("refused.as_many_as_depths", what=key)
            found.add(key, f"{depths} depths, {others} {key}", allowed)


def turns(directions: tuple[float, ...]) -> list[float]:
    """List by how much each direction differs from the one before, rad, up to half a turn."""
    return [abs(math.remainder(b - a, 2.0 * math.pi)) for a, b in pairwise(directions)]
