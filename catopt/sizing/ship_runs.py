"""Runs of a ship on a line, and what they came to."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

from catopt.catenary.solution import Solution
from catopt.checks.result import CheckReport
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.environment import Headings
from catopt.loads.sinker import SinkerSize
from catopt.model import Anchor, Case, Line
from catopt.sizing.in_motion import LineTried, Sea, TightestSea
from catopt.sizing.pattern import Pattern
from catopt.sizing.settle import ConvergedSizing
from catopt.verify.ship_result import LineOfShip, ShipWithoutLine


class ShipState(NamedTuple):
    """A load case in a sea, in weather that is hardest on a line with all there, or without one.

    Its lines as they were laid, or worn; strengths are those that wear leaves in either.
    """

    load_case: str
    sea: Sea
    directions: Headings
    line_out: bool  # line 1 is out
    worn: bool = False  # lines weigh what wear leaves of them


class ShipRun(NamedTuple):
    """A load case of a line that was run with all there, and without those whose loss matters."""

    load_case: str
    case: Case
    lines: tuple[LineOfShip, ...]
    every: tuple[Solution, ...]  # line under the tension that it is judged by
    most_loaded: int
    at_rest: Solution  # the most loaded line under the steady load of that load case
    lost: ShipLost
    worn: bool = False  # whether its lines weigh what wear leaves of them

    @property
    def line(self) -> LineOfShip:
        """What the most loaded line carries."""
        return self.lines[self.most_loaded]

    @property
    def hanging(self) -> Solution:
        """The most loaded line under the tension that it is judged by."""
        return self.every[self.most_loaded]

    @property
    def factor(self) -> float:
        """What an allowance for motion would have to be.

        By what the runs reached, or what is most probable, where an interval of few peaks is wide.
        """
        own = asked_of(self.line, self.hanging) / self.at_rest.horizontal_force
        return max(own, self.lost.factor)


class ShipLost(NamedTuple):
    """A load case that was run without lines, one at a time."""

    load_case: str
    case: Case
    lost: tuple[ShipWithoutLine, ...]
    at_rest: float  # horizontal force of the most loaded line at rest, from its hardest side, N
    offset: float  # of the ship: the largest with one of them lost, or with all there, m

    @property
    def factor(self) -> float:
        """What an allowance for motion would have to be; infinite where one has no answer."""
        if any(each.refusal for each in self.lost):
            return math.inf
        pulls = (asked_of(e.lines[e.most_loaded], e.hanging[e.most_loaded]) for e in self.lost)
        return max((each / self.at_rest for each in pulls), default=0.0)


def asked_of(line: LineOfShip, hanging: Solution) -> float:
    """Horizontal force that a line is to be sized for, N."""
    reached = max(line.fairlead.seen, line.judged("most-probable"))
    return min(1.0, reached / hanging.fairlead.tension) * hanging.horizontal_force


@dataclass(frozen=True)
class JudgedLine:
    """What the runs of a line came to."""

    tried: LineTried
    line: Line
    settled: ConvergedSizing | None = None  # None: it fails at rest
    around: Pattern | None = None
    runs: tuple[ShipRun, ...] = ()
    lost: tuple[ShipLost, ...] = ()
    anchor: Anchor | None = None
    drag_anchor: DragAnchorSize | None = None
    sinker: SinkerSize | None = None
    checks: CheckReport | None = None
    seas: tuple[TightestSea, ...] = ()

    @property
    def factor(self) -> float:
        """The largest allowance for motion of its load cases; infinite where it has no run."""
        factors = (*(each.factor for each in self.runs), *(each.factor for each in self.lost))
        return max(factors, default=math.inf)
