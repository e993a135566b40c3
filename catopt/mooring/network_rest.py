"""What comes of a network: bodies held in six freedoms, and all that is at rest, as values."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated, Literal, NamedTuple

from catopt.catenary.in_current import CurrentEffect, SolutionInCurrent
from catopt.catenary.solution import PointLoadState, Solution
from catopt.display import Tabled
from catopt.model.kinds import Angle, Force, Height, Place, Size, SomeForce
from catopt.model.network import MooredBody, Network, Point
from catopt.mooring.joints import JointsAtRest, Run, Vector, is_anchored, laid_out
from catopt.mooring.zero_load import holds
from catopt.records import From, FromZero, OrNull, Record


@dataclass(frozen=True)
class Position(Record):
    """Where the body is."""

    DOCUMENT = "x y yaw"

    x: Place
    """Of its origin."""
    y: Place
    """Of its origin."""
    yaw: Angle = 0.0
    """Counter-clockwise."""


Six = Annotated[tuple[float, ...], Size(6, 6)]
Three = Annotated[tuple[float, ...], Size(3, 3)]

FREEDOMS = ("surge", "sway", "heave", "roll", "pitch", "yaw")
"""Along x, y and z (up), and about them in the sense of the right hand."""


@dataclass(frozen=True)
class HeldLine:
    """One line at that place."""

    fairlead: tuple[Place, Place, Place]
    """x, y, and height above the bed."""
    span: Height
    """From the anchor, in plan."""
    horizontal_force: SomeForce
    """On the body, towards the anchor."""
    vertical_force: Force
    """On the body, downwards."""
    grounded: Height
    """Unstretched, on the bed."""

    @property
    def tension(self) -> float:
        """Effective tension at the fairlead, N."""
        return math.hypot(self.horizontal_force, self.vertical_force)


@dataclass(frozen=True)
class HeldBody(Record):
    """What the lines do to a body that is held at a displacement, by FREEDOMS.

    Rotations are about axes through the origin that stay parallel to x, y and z. The stiffness is
    symmetric where the moment of the lines about the origin is zero and no line lies on a bed with
    friction.
    """

    DOCUMENT = (
        "displacement origin_height load stiffness "
        "lines(fairlead span horizontal_force vertical_force grounded=grounded_length_m)"
    )

    displacement: Six
    """m, m, m, rad, rad, rad: surge, sway, heave, roll, pitch, yaw of the body."""
    origin_height: Place
    """Of the body's origin above the bed when nothing is displaced, the waterline."""
    lines: tuple[HeldLine, ...]
    """Each line there, in the order of the case."""
    load: Six
    """N, N, N, N m, N m, N m: of the lines on the body, about its origin; its own weight and
    buoyancy are no part of it."""
    stiffness: Annotated[tuple[Six, ...], Size(6, 6)]
    """N/m, N/rad, N m/m, N m/rad: minus the derivatives of the load by a small further
    displacement, joints free to follow."""

    @property
    def by_freedom(self) -> dict[str, float]:
        """The displacement by the name of the freedom; m, rad."""
        return dict(zip(FREEDOMS, self.displacement, strict=True))


@dataclass(frozen=True)
class FloatingBody(Record):
    """What lines pull a free body down with, and how it floats under that."""

    DOCUMENT = "pull reserve left under draught freeboard bed_reaction"

    pull: Force
    """Downwards, of all its lines."""
    reserve: SomeForce | None
    """Pull that takes it under; None where it is not known."""
    draught: Place | None = None
    """None of a body that keeps its height, as the next; below 0 it is out of the water."""
    freeboard: Place | None = None
    """Below 0 it is under water."""
    bed_reaction: SomeForce = 0.0
    """With which the bed carries it."""

    @property
    def left(self) -> Force | None:
        """What its lines may still add before it goes under."""
        return None if self.reserve is None else self.reserve - self.pull

    @property
    def share(self) -> float | None:
        """Part of the reserve that its lines use."""
        return None if self.reserve is None else self.pull / self.reserve

    @property
    def under(self) -> bool | None:
        """Whether its lines take it under; None where its reserve is not known."""
        if self.freeboard is not None:
            return self.freeboard < 0.0
        return None if self.reserve is None else self.pull > self.reserve


@dataclass(frozen=True)
class BodyAtRest(Record):
    """A free body at rest under its load."""

    DOCUMENT = (
        "body.name body.force body.moment turns=yaw_is_free position zero_load_position "
        "offset stiffness floating"
    )

    body: MooredBody
    turns: bool
    """Whether it turns."""
    position: Position
    """Of its origin at rest."""
    neutral: Position
    """Without load on any body; nan where the mooring does not rest so."""
    stiffness: Annotated[tuple[Three, ...], Size(3, 3)]
    """N/m, N, N m/rad: minus the derivatives of the pull of its lines by x, y and yaw, joints and
    other bodies free to follow, and its height where it floats."""
    floating: FloatingBody
    """How it floats."""
    arm: Height
    """From its origin to its farthest fairlead."""

    @property
    def is_held(self) -> bool:
        """Whether the lines hold it against a push from any side, and a turn where it is free."""
        return holds(self.stiffness, self.arm if self.turns else None)

    @property
    def moved(self) -> tuple[float, ...]:
        """From where it is given, by FREEDOMS: m and rad."""
        x, y = self.position.x - self.body.x, self.position.y - self.body.y
        return (x, y, self.rise, 0.0, 0.0, self.position.yaw)

    @property
    def rise(self) -> float:
        """From the height at which it floats without lines, m; 0 of one that keeps its height."""
        if self.floating.draught is None:
            return 0.0
        return self.body.afloat[1] - self.floating.draught

    @property
    def zero_load_position(self) -> Position | None:
        """Without load on any body; None where the mooring does not rest so."""
        return None if math.isnan(self.neutral.x) else self.neutral

    @property
    def offset(self) -> Annotated[tuple[Place, Place], OrNull]:
        """Way of the body's origin from where it is without load; none where that is nowhere."""
        return self.position.x - self.neutral.x, self.position.y - self.neutral.y


class AtEnds(NamedTuple):
    """Tension at both ends of a line, pull up on the first (N), and length on the bed (m)."""

    first: float
    second: float
    uplift: float
    grounded: float


class PointAtRest(NamedTuple):
    """A point of a network, with all that is free at rest."""

    of: Point
    place: tuple[Place, Place, Place]
    """x, y, and height above the bed."""
    bed_reaction: Force
    """With which the bed carries it."""


@dataclass(frozen=True)
class FloatAtRest(Record):
    """A joint that floats up: what its lines use of its buoyancy."""

    DOCUMENT = "name buoyancy used=buoyancy_used_N left=buoyancy_left_N under draught freeboard"

    of: Point
    lost: float
    """What it loses of its pull upwards out of the water, N."""
    under: Height
    """How far its top is below the surface; 0 where it is afloat."""

    @property
    def name(self) -> str:
        """As the file has it."""
        return self.of.name

    @property
    def buoyancy(self) -> Force:
        """Its pull upwards under water, less its weight."""
        return -self.of.submerged_weight

    @property
    def used(self) -> Force:
        """What its lines and forces use of that; below 0 where they lift it."""
        return self.buoyancy - self.lost

    @property
    def left(self) -> Force:
        """What they may still add before it goes under."""
        return self.lost

    @property
    def draught(self) -> Height | None:
        """Of a float whose height is given."""
        height = self.of.float_height
        return None if height is None else height * (1.0 - self.lost / self.of.lost_above)

    @property
    def freeboard(self) -> Height | None:
        """What of its height is out of the water."""
        height, draught = self.of.float_height, self.draught
        return None if height is None or draught is None else height - draught


@dataclass(frozen=True)
class PlacedLoad(Record):
    """A clump weight or a buoy of a line: where it is at rest."""

    DOCUMENT = "state.name state.position place state.seabed_reaction"

    state: PointLoadState
    place: tuple[Place, Place, Place]
    """x, y, and height above the bed."""


@dataclass(frozen=True)
class LineAtRest(Record):
    """A line of a network, from its first end: an anchor where it has one."""

    DOCUMENT = (
        "name first=from second=to solution.span solution.horizontal_force "
        "solution.anchor.horizontal_force=from_horizontal_force_N "
        "solution.fairlead.horizontal_force=to_horizontal_force_N "
        "solution.anchor.vertical_force=from_vertical_force_N "
        "solution.fairlead.vertical_force=to_vertical_force_N "
        "solution.anchor.tension=from_tension_N solution.fairlead.tension=to_tension_N "
        "solution.anchor.angle=from_angle_rad solution.fairlead.angle=to_angle_rad "
        "solution.grounded_length solution.lowest_point solution.touchdowns solution.sag "
        "point_loads"
    )

    name: str
    """As the file has it, or its number."""
    first: str
    """Point at its first end: an anchor where it has one."""
    second: str
    """Point at its other end."""
    solution: Solution
    point_loads: tuple[PlacedLoad, ...]
    """Clump weights and buoys, by position from its first end."""


@dataclass(frozen=True)
class LinesAtRest(Tabled, Record):
    """Lines between points with all that is free at rest; `runs` from their anchors."""

    DOCUMENT = (
        "points(of.name of.kind place bed_reaction) floats named_lines=lines bodies residual steps"
    )

    network: Network
    runs: tuple[Run, ...]
    joints: JointsAtRest
    bodies: tuple[BodyAtRest, ...] = ()
    """Each body that is free, in the order of the file."""

    def place_of(self, name: str) -> Vector:
        """X, y and height of a point, m."""
        return self.joints.places[self.network.numbers[name]]

    @property
    def lines(self) -> tuple[Solution, ...]:
        """Every line laid out between its ends, the first of which is its `anchor`."""
        return tuple(map(laid_out, self.runs, self.joints.ends))

    def at(self, line: int, x: float, y: float = 0.0) -> tuple[float, float]:
        """X and y of a place of a line, counted from 0: so far from its first end, and across."""
        run = self.runs[line]
        first, second = self.joints.places[run.first], self.joints.places[run.second]
        span = math.hypot(second[0] - first[0], second[1] - first[1])
        along = (second[0] - first[0]) / span if span > 0.0 else 1.0
        aside = (second[1] - first[1]) / span if span > 0.0 else 0.0
        return first[0] + x * along - y * aside, first[1] + x * aside + y * along

    def placed_loads(self, line: int, solution: Solution) -> tuple[PlacedLoad, ...]:
        """Place the clump weights and buoys of a line, counted from 0."""
        return tuple(
            PlacedLoad(each, (*self.at(line, each.x, each.y or 0.0), each.z))
            for each in solution.point_loads
        )

    @property
    def at_ends(self) -> tuple[AtEnds, ...]:
        """What each line carries at its ends."""
        return tuple(
            AtEnds(
                math.hypot(*each.first),
                math.hypot(*each.second),
                each.first[2],
                each.state.grounded,
            )
            for each in self.joints.ends
        )

    @property
    def has_held_body(self) -> bool:
        """Whether lines end at fairleads of no free body, which are held in place."""
        return any(p.kind == "fairlead" and not p.body for p in self.network.points)

    def is_anchored(self, line: int) -> bool:
        """Whether a line, counted from 0, ends at an anchor: its first end then."""
        return is_anchored(self.network, self.runs[line])

    @property
    def residual(self) -> SomeForce:
        """Largest force left over at a joint or a body."""
        return self.joints.residual

    @property
    def steps(self) -> FromZero:
        """Of Newton's method."""
        return self.joints.steps

    @property
    def points(self) -> tuple[PointAtRest, ...]:
        """Each point, in the order of the file."""
        found = self.joints
        return tuple(map(PointAtRest, self.network.points, found.places, found.reactions))

    @property
    def floats(self) -> tuple[FloatAtRest, ...]:
        """Each joint that floats up, in the order of the file."""
        depth, found = self.network.site.water_depth, self.joints
        of = zip(self.network.points, found.places, found.lost, strict=True)
        return tuple(
            FloatAtRest(
                point,
                lost,
                0.0 if lost else max(depth - place[2] - (point.float_height or 0.0), 0.0),
            )
            for point, place, lost in of
            if point.is_float
        )

    def carrying_floats(self, network: Network) -> Network:
        """Give a network its floats that are afloat as the forces that hold their lines up."""
        points = list(network.points)
        for each in self.floats:
            if each.lost:
                along, across, up = each.of.force
                force = (along, across, up + each.used)
                points[network.numbers[each.name]] = replace(
                    each.of, submerged_weight=0.0, force=force, float_height=None
                )
        return replace(network, points=tuple(points))

    @property
    def named_lines(self) -> tuple[LineAtRest, ...]:
        """Each line, in the order of the file."""
        points = self.network.points
        return tuple(
            LineAtRest(
                run.name,
                points[run.first].name,
                points[run.second].name,
                line,
                self.placed_loads(number, line),
            )
            for number, (run, line) in enumerate(zip(self.runs, self.lines, strict=True))
        )


@dataclass(frozen=True, kw_only=True)
class NetworkAtRest(LinesAtRest):
    """The same, with what the lines do to the body that is held."""

    DOCUMENT = LinesAtRest.DOCUMENT + " body.displacement body.load body.stiffness"

    body: HeldBody


@dataclass(frozen=True, kw_only=True)
class LinesInCurrent(LinesAtRest):
    """All that is free at rest in a current."""

    DOCUMENT = LinesAtRest.DOCUMENT + " current still_places"

    solutions: tuple[SolutionInCurrent, ...]
    still: JointsAtRest
    """In still water."""

    @property
    def still_places(self) -> tuple[tuple[Place, Place, Place], ...]:
        """Of each point in still water: x, y, and height above the bed."""
        return self.still.places

    @property
    def lines(self) -> tuple[Solution, ...]:
        """Every line from its anchor up."""
        return self.solutions

    @property
    def at_ends(self) -> tuple[AtEnds, ...]:
        """What each line carries at its ends."""
        return tuple(
            AtEnds(
                each.anchor.tension,
                each.fairlead.tension,
                each.anchor.vertical_force,
                each.grounded_length,
            )
            for each in self.solutions
        )

    @property
    def current(self) -> tuple[CurrentEffect, ...]:
        """What it does to each line, x being the direction from its first end to its other."""
        return tuple(each.effect for each in self.solutions)


@dataclass(frozen=True, kw_only=True)
class FloatsInCurrent(LinesInCurrent):
    """Floats, each at the end of its own line, knocked down by a current."""

    DOCUMENT = LinesInCurrent.DOCUMENT + " heights=still_height_m"

    @property
    def heights(self) -> tuple[Height, ...]:
        """Of the float of each line in still water."""
        return tuple(self.still.places[run.second][2] for run in self.runs)


@dataclass(frozen=True)
class NetworkReport(Record):
    """Points, lines between them and bodies, at rest."""

    SCHEMA = "catopt.network/1"
    DOCUMENT = "title status states"

    states: Annotated[
        tuple[LinesAtRest | NetworkAtRest | LinesInCurrent | FloatsInCurrent, ...], From(1)
    ]
    """At rest, then where the body was asked to be held."""

    @property
    def title(self) -> str:
        """Of the file; empty when it has none."""
        return self.states[0].network.title

    @cached_property
    def status(self) -> Literal["converged"]:
        """What did not converge is never written."""
        return "converged"
