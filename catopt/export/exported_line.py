"""Lines of a case where they hang, between points; what other programs and drawings take."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.catenary.layout import end_of
from catopt.catenary.solution import Solution
from catopt.decks.deck import End
from catopt.model import Case, System
from catopt.model.network import Network, Point

Place = tuple[float, float, float]


@dataclass(frozen=True)
class ExportedPoint:
    """Where a line ends, or several meet.

    `label`: its name in a table; `words`: beside it on a drawing; `place`: x, y and height above
    the bed, m; `joint`: what hangs there, where it is free, `key`: where that stands in the case;
    `bed_reaction`: with which the bed carries it, N.
    """

    name: str
    label: str
    end: End
    place: Place
    words: str = ""
    joint: Point | None = None
    key: str = ""
    bed_reaction: float = 0.0

    @property
    def force(self) -> tuple[float, float, float]:
        """What pulls at a joint beside its lines and its weight, N."""
        along, across, up = (0.0, 0.0, 0.0) if self.joint is None else self.joint.force
        return along, across, up


@dataclass(frozen=True)
class ExportedBody:
    """A moored body where its lines balance the force on it; m, rad, N and N m.

    `height`: of its first fairlead above the bed; `neutral`: x and y of its place without load,
    None where that is nowhere; `fairleads`: their places, one for each line.
    """

    name: str
    x: float
    y: float
    yaw: float
    height: float
    force: tuple[float, float]
    moment: float
    neutral: tuple[float, float] | None
    fairleads: tuple[Place, ...]


@dataclass(frozen=True)
class ExportedLine:
    """One line between its two ends.

    `name`: ``line 1``, or that of its leg; `solution`: its equilibrium in its own vertical plane;
    `at_rest`: the same between the same ends on a bed without friction, None where that is no
    other; `own_tension`: at the fairlead, N, of the line as the case has it, where `solution` has
    another EA; `ends`: the numbers of its points, from 0; `anchor`: x and y of the first, m;
    `heading`: from there to the other, counter-clockwise from x, rad; `key`: of the line in the
    case; `is_turned`: whether it runs the other way there.
    """

    name: str
    solution: Solution
    at_rest: Solution | None
    own_tension: float
    ends: tuple[int, int]
    anchor: tuple[float, float] = (0.0, 0.0)
    heading: float = 0.0
    key: str = "line"
    is_turned: bool = False

    def key_of(self, segment: int) -> str:
        """Key of a segment in the case, counted from 0 from the first end."""
        number = len(self.solution.line.segments) - 1 - segment if self.is_turned else segment
        return f"{self.key}.segments[{number}]"

    @property
    def expected(self) -> Solution:
        """What a program that knows no friction at rest should find."""
        return self.solution if self.at_rest is None else self.at_rest

    def in_space(self, distance: float, height: float) -> tuple[float, float, float]:
        """Place a point of the line's plane: x, y and height above the bed, m.

        `distance`, `height`: horizontally from the anchor, and above the bed, m.
        """
        x, y = self.anchor
        cosine, sine = math.cos(self.heading), math.sin(self.heading)
        return x + distance * cosine, y + distance * sine, height

    def in_plane(self, arc: float) -> tuple[float, float]:
        """Distance and height of the point `arc` (m, unstretched) from the anchor, m."""
        stretch = [each for each in self.solution.stretches if each.start <= arc][-1]
        return end_of(stretch, min(arc - stretch.start, stretch.length))

    def at(self, arc: float) -> tuple[float, float, float]:
        """Place of the point `arc` (m, unstretched) from the anchor: x, y, height above the bed."""
        return self.in_space(*self.in_plane(arc))


@dataclass(frozen=True)
class ExportedLines:
    """A case with its lines where they hang.

    `case`: under the load that was taken; `lines`: one, or those of a mooring, between `points`;
    `bodies`: that they moor; `EA`: of the segments that do not stretch in the case, N; None: they
    were left as they are; `warnings`: what an engineer should know before using the answer;
    `mooring`: all of it, None where it is one line, drawn in its plane.
    """

    case: Case | Network
    lines: tuple[ExportedLine, ...]
    points: tuple[ExportedPoint, ...]
    bodies: tuple[ExportedBody, ...] = ()
    EA: float | None = None
    warnings: tuple[str, ...] = ()
    mooring: System | Network | None = None

    @property
    def highest(self) -> float:
        """Largest height of any line above the bed, m."""
        return max(max(line.solution.profile().z) for line in self.lines)
