"""The current of a case over the depth: a power law, driven by wind, or a table."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType
from typing import Literal, get_args

from catopt.model.validity import Findings

ProfileKind = Literal["power", "wind", "table"]
CURRENT_PROFILES: tuple[str, ...] = get_args(ProfileKind)

_NEEDS = MappingProxyType(
    {"power": ("speed",), "wind": ("speed", "depth"), "table": ("depths", "speeds")}
)
_TAKES = MappingProxyType(
    {
        "power": ("speed", "exponent"),
        "wind": ("speed", "depth"),
        "table": ("depths", "speeds", "directions"),
    }
)
_TURN = 0.5 * math.pi * (1.0 + 1e-12)
"""Most by which a current may turn from row to row: its speeds along x and y are interpolated."""


@dataclass(frozen=True)
class CurrentProfile:
    """A current over the depth, steady or over time; docs/waves.md has the formulas.

    Attributes
    ----------
    profile : {"power", "wind", "table"}
        How the speed depends on the depth.
    speed : float or None
        At the surface, m/s; of a power law or of a current that is driven by wind. None where a
        file gives it.
    exponent : float or None
        Of a power law, above 0; None: 1/7.
    depth : float or None
        Below still water, where a current that is driven by wind ends, m.
    depths, speeds : tuple of float
        Of a table: below still water, m, each greater than the one before; and m/s.
    direction : float
        Where it flows to, rad from the x axis, which points from the anchor to the fairlead.
    directions : tuple of float
        Of a table that turns with depth, one for each of the depths, in place of `direction`.
    series_file : str
        Path of a CSV file of the current at the surface over time, by which the profile is scaled
        and turned; empty for a steady one.
    """

    profile: ProfileKind
    speed: float | None = None
    exponent: float | None = None
    depth: float | None = None
    depths: tuple[float, ...] = ()
    speeds: tuple[float, ...] = ()
    direction: float = 0.0
    directions: tuple[float, ...] = ()
    series_file: str = ""

    def __post_init__(self) -> None:
        found = Findings("CurrentProfile", self)
        found.word("profile", self.profile, CURRENT_PROFILES)
        found.raise_if_any()
        found.each("depths", "m", at_least=0.0)
        found.each("speeds", "m/s", at_least=0.0 if self.directions else None)
        found.each("directions", "rad")
        self._check_keys(found)
        found.numbers(self, "m/s", "speed", at_least=0.0)
        found.numbers(self, "", "exponent", above=0.0)
        found.numbers(self, "m", "depth", above=0.0)
        found.number("direction", self.direction, "rad")
        self._check_table(found)
        found.raise_if_any()

    def _check_keys(self, found: Findings) -> None:
        """Find what is missing for the profile, and what goes with another."""
        for key in ("speed", "exponent", "depth", "depths", "speeds", "directions"):
            given = getattr(self, key)
            is_given = given is not None and given != ()
            if key == "speed" and self.series_file and self.profile != "table":
                if is_given:
                    found.add(key, repr(given), "stands in the series_file; leave it out")
            elif is_given and key not in _TAKES[self.profile]:
                allowed = f"does not go with the profile {self.profile}; leave it out"
                found.add(key, repr(given), allowed)
            elif not is_given and key in _NEEDS[self.profile]:
                found.add(key, "", f"missing; the profile {self.profile} needs it")
        if self.directions and self.direction != 0.0:
            found.add(
                "direction", repr(self.direction), "goes with one of all depths; leave it out"
            )
        if self.series_file and self.speeds and self.speeds[0] <= 0.0:
            allowed = "must be above 0 m/s: the series_file scales the table by its first speed"
            found.add("speeds[0]", f"{self.speeds[0]:g} m/s", allowed)

    def _check_table(self, found: Findings) -> None:
        if self.depths and self.speeds and len(self.depths) != len(self.speeds):
            sizes = f"{len(self.depths)} depths, {len(self.speeds)} speeds"
            found.add("speeds", sizes, "as many speeds as depths are wanted")
        for index, depth in enumerate(self.depths):
            if index and depth <= self.depths[index - 1]:
                above = f"must be more than {self.depths[index - 1]:g} m, the one before"
                found.add(f"depths[{index}]", f"{depth:g} m", above)
        if self.directions and self.depths and len(self.depths) != len(self.directions):
            sizes = f"{len(self.depths)} depths, {len(self.directions)} directions"
            found.add("directions", sizes, "as many directions as depths are wanted")
        for index, turn in enumerate(turns(self.directions), start=1):
            if turn > _TURN:
                allowed = "more than a right angle from the row before: give a row between them"
                found.add(
                    f"directions[{index}]", f"a turn of {math.degrees(turn):.4g} deg", allowed
                )


def turns(directions: tuple[float, ...]) -> list[float]:
    """List by how much each direction differs from the one before, rad, up to half a turn."""
    return [abs(math.remainder(b - a, 2.0 * math.pi)) for a, b in pairwise(directions)]
