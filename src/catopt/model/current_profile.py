"""The current of a case over the depth: a power law, driven by wind, or a table."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal, get_args

from catopt.model.validity import Findings

__all__ = ["CURRENT_PROFILES", "CurrentProfile"]

ProfileKind = Literal["power", "wind", "table"]
CURRENT_PROFILES: tuple[str, ...] = get_args(ProfileKind)

_NEEDS = MappingProxyType(
    {"power": ("speed",), "wind": ("speed", "depth"), "table": ("depths", "speeds")}
)
_TAKES = MappingProxyType(
    {"power": ("speed", "exponent"), "wind": ("speed", "depth"), "table": ("depths", "speeds")}
)


@dataclass(frozen=True)
class CurrentProfile:
    """A steady current; docs/waves.md has the formulas.

    Attributes
    ----------
    profile : {"power", "wind", "table"}
        How the speed depends on the depth.
    speed : float or None
        At the surface, m/s; of a power law or of a current that is driven by wind.
    exponent : float or None
        Of a power law, above 0; None: 1/7.
    depth : float or None
        Below still water, where a current that is driven by wind ends, m.
    depths, speeds : tuple of float
        Of a table: below still water, m, each greater than the one before; and m/s.
    direction : float
        Where it flows to, rad from the x axis, which points from the anchor to the fairlead.
    """

    profile: ProfileKind
    speed: float | None = None
    exponent: float | None = None
    depth: float | None = None
    depths: tuple[float, ...] = ()
    speeds: tuple[float, ...] = ()
    direction: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("CurrentProfile")
        if self.profile not in CURRENT_PROFILES:
            found.add("profile", repr(self.profile), "one of " + ", ".join(CURRENT_PROFILES))
            found.raise_if_any()
        self._check_keys(found)
        if self.speed is not None:
            found.number("speed", self.speed, "m/s", at_least=0.0)
        if self.exponent is not None:
            found.number("exponent", self.exponent, "", above=0.0)
        if self.depth is not None:
            found.number("depth", self.depth, "m", above=0.0)
        found.number("direction", self.direction, "rad")
        self._check_table(found)
        found.raise_if_any()

    def _check_keys(self, found: Findings) -> None:
        """Find what is missing for the profile, and what goes with another."""
        for key in ("speed", "exponent", "depth", "depths", "speeds"):
            given = getattr(self, key)
            is_given = given is not None and given != ()
            if is_given and key not in _TAKES[self.profile]:
                allowed = f"does not go with the profile {self.profile}; leave it out"
                found.add(key, repr(given), allowed)
            elif not is_given and key in _NEEDS[self.profile]:
                found.add(key, "", f"missing; the profile {self.profile} needs it")

    def _check_table(self, found: Findings) -> None:
        if self.depths and self.speeds and len(self.depths) != len(self.speeds):
            sizes = f"{len(self.depths)} depths, {len(self.speeds)} speeds"
            found.add("speeds", sizes, "as many speeds as depths are wanted")
        for index, depth in enumerate(self.depths):
            found.number(f"depths[{index}]", depth, "m", at_least=0.0)
            if index and not depth > self.depths[index - 1]:
                above = f"must be more than {self.depths[index - 1]:g} m, the one before"
                found.add(f"depths[{index}]", f"{depth:g} m", above)
        for index, speed in enumerate(self.speeds):
            found.number(f"speeds[{index}]", speed, "m/s")
