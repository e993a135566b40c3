"""A sizing put as a case: the line that is assumed, its loads, and the case that they make."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from catopt.loads.component import Loads
from catopt.loads.document import ComparedLoads
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.weathervane import ShipHeading
from catopt.model import Case
from catopt.model.kinds import Force, Height, Length, SomeForce
from catopt.records import Record

Water = Literal["high", "low"]
"""At which level of the still water."""

_ROUNDING = 1e-9


@dataclass(frozen=True)
class LoadsAt(Record):
    """The loads of one load case."""

    DOCUMENT = "load_case depth horizontal_force given lying=heading laid_out=parts"

    load_case: str
    """Its name."""
    depth: Length
    """Of the still water."""
    water: Water = "high"
    condition: str = ""  # of a ship: ``"loaded"`` or ``"ballast"``
    parts: tuple[Loads, ...] = ()  # on the ship, on the buoy; empty where the force was given
    given: SomeForce = 0.0
    """Force that was given instead of weather; 0 otherwise."""
    lying: ShipHeading | None = None
    """Of a ship: how it lies under the largest force of all directions and stable headings; None
    for a buoy."""

    @property
    def laid_out(self) -> tuple[ComparedLoads, ...]:
        """On the ship, on the buoy: each as catopt loads has it."""
        return tuple(map(ComparedLoads, self.parts))

    @property
    def horizontal_force(self) -> SomeForce:
        """Sum of all parts and of what was given, along one direction."""
        return math.fsum([self.given, *(part.horizontal_force for part in self.parts)])


@dataclass(frozen=True)
class SizingCase:
    """What goes to the design search."""

    case: Case  # with load cases, checks and design
    loads: tuple[LoadsAt, ...]
    """The forces of each extreme load case, in the order of the case: of all lines together where
    there are several."""
    drag_anchor: DragAnchorSize | None = None  # that the case is held by, where it is one


@dataclass(frozen=True)
class Assumed:
    """The line that the loads were computed for."""

    diameter: Height = 0.0
    """Nominal, of the chain that the water moves; 0 where it is not counted."""
    pull: SomeForce = 0.0
    """Of the line, or of all lines, downwards on the buoy."""
    forces: tuple[Force, ...] = ()
    """Least horizontal force of one of several lines in each load case; empty where it is that of
    the loads."""

    def covers(self, other: Assumed) -> bool:
        """Whether the loads for this are on the safe side of those for another."""
        own, others = self._values(other), other._values(self)
        return all(a >= b * (1.0 - _ROUNDING) for a, b in zip(own, others, strict=True))

    def raised_to(self, other: Assumed) -> Assumed:
        """Return the larger of each."""
        diameter, pull, *forces = map(max, self._values(other), other._values(self))
        return Assumed(diameter, pull, tuple(forces))

    def _values(self, other: Assumed) -> tuple[float, ...]:
        forces = self.forces or (0.0,) * len(other.forces)
        return self.diameter, self.pull, *forces


def rounded_up(value: float, digits: int = 2) -> float:
    """Round a positive number up to so many digits: 4231 becomes 4300."""
    if value <= 0.0:
        return 0.0
    unit = 10.0 ** (math.floor(math.log10(value)) - digits + 1)
    return float(unit * math.ceil(value / unit * (1.0 - _ROUNDING)))
