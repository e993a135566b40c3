"""Load cases of a moored body: from where, how hard, at which water level, and with which lines."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from catopt.model.validity import Findings

if TYPE_CHECKING:
    from catopt.model.design import Design
    from catopt.model.system import System


@dataclass(frozen=True)
class DesignLoad:
    """A force on a moored body that every design has to meet.

    Attributes
    ----------
    name : str
        As tables show it; no two of a design are the same. Empty: the force of the case's system.
    force : float
        Its size, N.
    direction : float
        Towards which it acts, counter-clockwise from x, rad.
    headings : int
        From how many sides it comes, evenly, `direction` the first.
    water_level, fairlead_rise : float
        As of `LoadCase`, m.
    line_out : bool
        Whether each line is gone in turn under it, beside all being there.
    """

    name: str
    force: float
    direction: float = 0.0
    headings: int = 1
    water_level: float = 0.0
    fairlead_rise: float = 0.0
    line_out: bool = False

    def __post_init__(self) -> None:
        found = Findings("DesignLoad", self)
        found.number("force", self.force, "N", above=0.0)
        found.numbers(self, "m", "water_level", "fairlead_rise")
        found.number("direction", self.direction, "rad")
        found.count("headings", self.headings)
        found.raise_if_any()

    @property
    def lift(self) -> float:
        """How much higher the fairleads are than in the case: by the water and by its rise, m."""
        return self.water_level + self.fairlead_rise

    @property
    def directions(self) -> tuple[float, ...]:
        """Towards which the force acts in turn, counter-clockwise from its own, rad."""
        return tuple(
            self.direction + 2.0 * math.pi * k / self.headings for k in range(self.headings)
        )

    def towards(self, direction: float) -> tuple[float, float]:
        """Force along x and y in one of its directions, N."""
        return self.force * math.cos(direction), self.force * math.sin(direction)


def loads_of(design: Design, system: System) -> tuple[DesignLoad, ...]:
    """List the loads of a design: its own, or the force of the system it is for."""
    if design.loads:
        return design.loads
    x, y = system.force
    return (
        DesignLoad(
            "",
            math.hypot(x, y),
            math.atan2(y, x),
            headings=design.headings,
            line_out=design.line_out,
        ),
    )
