"""Points, lines between them and bodies: crowfoot and bridle, a leg that splits, unequal lines."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated, ClassVar, Final, Literal

from catopt.constants import STANDARD_GRAVITY
from catopt.errors import Problem, refused
from catopt.model.anchor import Anchor
from catopt.model.case import Case, CatalogueChoice
from catopt.model.design import GroupDesign, group_misfits
from catopt.model.dynamics import (
    Dynamics,
    Fatigue,
    broken_line_misfits,
    fatigue_needs,
    network_motion_misfits,
    of_motion_misfits,
    strength_misfits,
)
from catopt.model.joined import network_misfits
from catopt.model.kinds import (
    Accepted,
    Area,
    Checked,
    Coefficient,
    Findings,
    Force,
    Height,
    Length,
    Moment,
    Place,
    Size,
    SomeArea,
    SomeMass,
    Strength,
    Text,
)
from catopt.model.line import Line, Segment, drag_missing, point_drag_misfits, weightless
from catopt.model.load import Checks, Site
from catopt.model.plausible_ranges import accepted_in
from catopt.model.sea import CurrentProfile, Motion, WaveState
from catopt.model.service import Service
from catopt.model.title_block import TitleBlock
from catopt.words import Message

PointKind = Literal["anchor", "fairlead", "joint"]
PointName = Annotated[str, Text(filled=True, example='"joint 1"')]

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Point(Checked):
    """Where lines end or meet."""

    name: PointName
    """By which lines name it."""
    kind: PointKind
    """Held in place, moved by the body, or free: where a joint comes to rest is found."""
    x: Place | None = None
    """m; of a fairlead with the body not displaced, as y and the height. None for a joint."""
    y: Place | None = None
    height: Height | None = None
    """Above the seabed, m; of an anchor 0 when left out."""
    submerged_weight: Force = 0.0
    """Of a joint: clump weight, or buoy below 0, N."""
    force: Annotated[tuple[Force, ...], Size(3, 3)] = (0.0, 0.0, 0.0)
    """On a joint, of what pulls there beside the lines, along x, y and up, N."""
    mass: SomeMass | None = None
    """Of a joint, in air, kg: for lines in motion, and of a float at the surface. None: not
    known."""
    float_height: Length | None = None
    """Of a float, m, up from where its lines end: it comes out of the water over that. None: all at
    once. With `mass`."""
    drag_area: Area | None = None
    """A of a joint, m2, for a current and in motion; with `drag_coefficient`. None: no drag."""
    drag_coefficient: Coefficient | None = None
    """Cd that goes with the area."""
    added_mass_coefficient: Coefficient = 0.0
    """Ca on the water that a joint displaces, for lines in motion."""
    body: Annotated[str, Text(example='"barge"')] = ""
    """Of a fairlead: name of the body that it moves with; empty: one that is held."""

    def _check(self, found: Findings) -> None:
        if not self.name:
            found.add("name", "", Message("refused_case.missing_lines_name_point_by"))
        found.check("kind")
        if self.kind == "anchor" and self.height is None:
            object.__setattr__(self, "height", 0.0)
        found.problems += point_misfits(vars(self))
        object.__setattr__(self, "force", tuple(self.force))
        found.check("x", "y", "height", "submerged_weight", "force")
        found.check("mass", "drag_area", "drag_coefficient", "added_mass_coefficient")
        found.check("float_height")
        given = [k for k in ("drag_area", "drag_coefficient") if getattr(self, k) is not None]
        found.problems += point_drag_misfits(given)

    @property
    def drag_product(self) -> float:
        """Cd A, m2."""
        return (self.drag_coefficient or 0.0) * (self.drag_area or 0.0)

    @property
    def is_float(self) -> bool:
        """Whether it is a joint that floats up."""
        return self.kind == "joint" and self.submerged_weight < 0.0

    @property
    def lost_above(self) -> float:
        """What a float loses of its lift out of the water, N: with its mass it weighs there."""
        return (self.mass or 0.0) * STANDARD_GRAVITY - self.submerged_weight

    @property
    def hung(self) -> Vector:
        """What is on a joint beside its lines: the force, and the weight in water; N."""
        along, across, up = self.force
        return (along, across, up - self.submerged_weight)

    @property
    def place(self) -> Vector:
        """X, y and height of an anchor or a fairlead, m."""
        assert self.x is not None
        assert self.y is not None
        assert self.height is not None
        return (self.x, self.y, self.height)


def point_misfits(given: dict[str, object]) -> list[Problem]:
    """List which keys a point of its kind lacks, and which it cannot have; None is not given."""
    is_joint = given.get("kind") == "joint"
    found = Findings()
    for key in ("x", "y", "height"):
        value = given.get(key)
        if is_joint and value is not None:
            found.add(key, f"{value}", Message("refused_case.leave_out_where_joint_comes"))
        elif value is None and given.get("kind") in ("anchor", "fairlead"):
            found.add(key, "", Message("refused_case.missing_s_have_x_y", value=given["kind"]))
    if not is_joint:
        allowed = Message("refused_case.leave_out_only_joint_feels")
        if given.get("submerged_weight"):
            found.add("submerged_weight", f"{given['submerged_weight']}", allowed)
        force = given.get("force")
        if isinstance(force, Iterable) and any(force):
            found.add("force", f"{force}", allowed)
        for key in ("mass", "drag_area", "drag_coefficient", "added_mass_coefficient"):
            if given.get(key) not in (None, 0.0):
                found.add(key, f"{given[key]}", allowed)
    _check_float(given, found)
    if given.get("body") and given.get("kind") in ("anchor", "joint"):
        allowed = Message("refused_case.leave_out_only_fairlead_has_body")
        found.add("body", f"{given['body']}", allowed)
    return found.problems


def _check_float(given: dict[str, object], found: Findings) -> None:
    """Find a height of what is no float, and one without a mass."""
    weight, height = given.get("submerged_weight"), given.get("float_height")
    if height is None:
        return
    if not (given.get("kind") == "joint" and isinstance(weight, float | int) and weight < 0.0):
        allowed = Message("refused_case.leave_out_only_float_has_height")
        found.add("float_height", f"{height}", allowed)
    elif given.get("mass") is None:
        found.add("mass", "", Message("refused_case.float_height_wants_mass"))


WATERPLANE: Final = ("waterplane_area", "draught", "freeboard")
"""Keys of a body that say how it floats."""


@dataclass(frozen=True)
class MooredBody(Checked):
    """A body under a load, free in x, y and, where it can, in yaw.

    Its own axes lie along x and y when its yaw is 0. It keeps its height, unless its waterplane is
    given: then it floats, deeper as its lines pull it down, and upright.
    """

    name: PointName
    """By which its fairleads name it."""
    x: Place = 0.0
    """Of its origin before it is moved, m, as y; the moment is about it."""
    y: Place = 0.0
    force: Annotated[tuple[Force, ...], Size(2, 2)] = (0.0, 0.0)
    """On its origin, along x and y, N."""
    moment: Moment = 0.0
    """About the vertical, counter-clockwise, N m."""
    yaw_free: bool | None = None
    """Whether it turns. None: it does where a fairlead lies off its origin."""
    reserve_buoyancy: Strength | None = None
    """Vertical pull that takes it under, N. None: that of its waterplane, or not known."""
    waterplane_area: SomeArea | None = None
    """Of a body with vertical sides, m2; with `draught` and `freeboard`, without its lines."""
    draught: Length | None = None
    freeboard: Length | None = None

    def _check(self, found: Findings) -> None:
        if not self.name:
            found.add("name", "", Message("refused_case.missing_lines_name_point_by"))
        object.__setattr__(self, "force", tuple(self.force) or (0.0, 0.0))
        found.check("x", "y", "force", "moment", "reserve_buoyancy", *WATERPLANE)
        missing = [key for key in WATERPLANE if getattr(self, key) is None]
        if 0 < len(missing) < len(WATERPLANE):
            for key in missing:
                found.add(key, "", Message("refused_case.waterplane_wants_three"))
        if len(missing) < len(WATERPLANE) and self.reserve_buoyancy is not None:
            allowed = Message("refused_case.reserve_is_of_waterplane")
            found.add("reserve_buoyancy", f"{self.reserve_buoyancy:g} N", allowed)

    @property
    def floats(self) -> bool:
        """Whether it floats deeper as its lines pull it down."""
        return self.waterplane_area is not None

    @property
    def afloat(self) -> tuple[float, float, float]:
        """Of one that floats: area of its waterplane, draught and freeboard; m2, m, m."""
        assert self.waterplane_area is not None
        assert self.draught is not None
        assert self.freeboard is not None
        return self.waterplane_area, self.draught, self.freeboard


@dataclass(frozen=True)
class LineBetween:
    """A line from one point to another, by their names; its segments run that way."""

    line: Line
    start: PointName
    end: PointName
    name: str = ""


@dataclass(frozen=True)
class Network(Checked):
    """Lines between points, of which some are free joints, and bodies: held, or free under a load.

    Any iterables of points, lines and bodies are taken; at least one point and one line.
    """

    site: Site
    points: tuple[Point, ...]
    lines: tuple[LineBetween, ...]
    title: str = ""
    source: str = ""
    checks: Checks = field(default_factory=Checks)
    service: Service | None = None
    anchor: Anchor | None = None
    """What holds each line that ends at an anchor."""
    bodies: tuple[MooredBody, ...] = ()
    """That are free; fairleads without one belong to a body that is held."""
    current: CurrentProfile | None = None
    """On lines at rest; with `dynamics` on lines in motion."""
    waves: WaveState | None = None
    """Of the sea, for lines in motion."""
    motion: Motion | None = None
    """Of every fairlead about its place at rest, harmonic or recorded."""
    dynamics: Dynamics | None = None
    """How the lines are run in time; needed by the two before it."""
    catalogue: CatalogueChoice = field(default_factory=CatalogueChoice)
    """Where components come from."""
    fatigue: Fatigue | None = None
    """What the damage of its lines in a year is found from."""
    design: GroupDesign | None = None
    """What of its lines may vary."""
    document: TitleBlock | None = None
    """For the title block of its note."""
    accept: tuple[Accepted, ...] = ()
    """Names of the plausible ranges that its values may go beyond."""

    # What a case may have beside these, and points and lines do not.
    system: ClassVar[None] = None
    body: ClassVar[None] = None
    floater: ClassVar[None] = None
    anchor_motion: ClassVar[None] = None
    buoy: ClassVar[None] = None
    load_cases: ClassVar[tuple[()]] = ()
    several_lines: ClassVar[bool] = True

    def _check(self, found: Findings) -> None:
        for key in ("points", "lines", "bodies"):
            object.__setattr__(self, key, tuple(getattr(self, key)))
            if key != "bodies":
                found.some(key, Message("refused_case.at_least_one_wanted"))
        object.__setattr__(self, "accept", accepted_in(self.accept, self))
        names = [point.name for point in self.points]
        joints = [point.name for point in self.points if point.kind == "joint"]
        ends = [(line.start, line.end) for line in self.lines]
        tied = [[p.name for p in self.points if p.body == body.name] for body in self.bodies]
        found.problems += network_misfits(names, joints, ends, tied)
        self._check_bodies(found)
        self._check_current(found)
        for k, each in enumerate(self.lines):
            segments = each.line.segments
            if not any(segment.submerged_weight for segment in segments):
                found.add(f"lines[{k}].segments", *weightless("network"))
            if {each.start, each.end} & {*joints}:
                allowed = Message("refused_case.missing_lines_meet_joints_have")
                for i in (i for i, segment in enumerate(segments) if segment.is_inextensible):
                    found.add(f"lines[{k}].segments[{i}].EA", "", allowed)
        self._check_site(found)
        for key in ("max_span", "max_offset"):
            if (limit := getattr(self.checks, key)) is not None:
                allowed = Message("refused_case.span_is_of_a_line")
                found.add(f"checks.{key}", f"{limit:g} m", allowed)
        self._check_motion(found)
        if self.anchor is not None:
            self._check_anchors(found, ends)
        counts = {name: len(each.line.segments) for name, each in self.named_lines}
        found.problems += group_misfits(self.design, counts)
        found.problems += fatigue_needs(self, max(counts.values(), default=0))

    def segment_for(self, choice: int) -> Segment:
        """Segment of the first line of a group of its design, as it is."""
        assert self.design is not None
        group = self.design.groups[choice]
        return dict(self.named_lines)[group.lines[0]].line.segments[group.segment - 1]

    @property
    def named_lines(self) -> tuple[tuple[str, LineBetween], ...]:
        """Its lines by their names, or their numbers where they have none."""
        return tuple((each.name or f"{k}", each) for k, each in enumerate(self.lines, start=1))

    def made_of(self, segments: Sequence[Segment]) -> Network:
        """Return it with other segments, one for each group of its design, which is settled."""
        assert self.design is not None
        lines = dict(self.named_lines)
        for group, segment in zip(self.design.groups, segments, strict=True):
            for name in group.lines:
                own = list(lines[name].line.segments)
                own[group.segment - 1] = segment
                line = replace(lines[name].line, segments=tuple(own))
                lines[name] = replace(lines[name], line=line)
        return replace(self, lines=tuple(lines.values()), design=None)

    @property
    def has_fairlead(self) -> bool:
        """Whether lines end at a body, held or free; else at anchors and joints alone."""
        return any(point.kind == "fairlead" for point in self.points)

    def _check_motion(self, found: Findings) -> None:
        """Find what does not go together of the parts for lines in motion."""
        present = [key for key in ("waves", "motion", "dynamics") if getattr(self, key) is not None]
        found.problems += network_motion_misfits(present, has_fairlead=self.has_fairlead)
        if self.motion is not None and (self.motion.rao_file or self.motion.of_a_body):
            given = Message("refused_case.raos_or_drift")
            found.add("motion", given, Message("refused_case.give_period_or_file"))
        if self.dynamics is None:
            found.problems += of_motion_misfits(self, Message("refused.with_dynamics"))
            return
        broken, lines = self.dynamics.broken_line, self.lines
        found.problems += broken_line_misfits(broken, len(lines))
        if broken is not None and broken <= len(lines):
            line = lines[broken - 1]
            strengths = [each.MBL for each in line.line.segments]
            found.problems += strength_misfits(self.dynamics, strengths)
            kinds = {p.kind for p in self.points if p.name in (line.start, line.end)}
            if self.dynamics.broken_end == "anchor" and "anchor" not in kinds:
                allowed = Message("refused_case.broken_end_wants_an_anchor")
                found.add("dynamics.broken_end", "anchor", allowed)
        if self.anchor is not None and self.anchor.max_slide is not None:
            allowed = Message("refused_case.of_lines_in_motion")
            found.add("anchor.max_slide", f"{self.anchor.max_slide:g} m", allowed)

    def per_metre(self, body: MooredBody) -> float:
        """Say how much more water carries of a body that floats a metre deeper, N/m."""
        area, *_ = body.afloat
        return self.site.water_density * STANDARD_GRAVITY * area

    def reserve_of(self, body: MooredBody) -> float | None:
        """Return the vertical pull that takes a body under, N; None where it is not known."""
        if not body.floats:
            return body.reserve_buoyancy
        return self.per_metre(body) * body.afloat[2]

    @property
    def current_at_rest(self) -> CurrentProfile | None:
        """The current on lines at rest; None where there is none, or it is for lines in motion."""
        return self.current if self.dynamics is None else None

    def _check_current(self, found: Findings) -> None:
        """Find what a current does not go with, what it lacks, and what lacks a current."""
        if self.dynamics is not None:
            return
        if self.current is None:
            allowed = Message("refused_case.goes_with_a_current")
            found.problems += (
                Problem(f"points[{k}].drag_area", f"{point.drag_area:g} m2", allowed)
                for k, point in enumerate(self.points)
                if point.drag_area is not None
            )
            return
        if self.current.series_file:
            allowed = Message("refused_case.current_series_is_for_motion")
            found.add("current.series_file", self.current.series_file, allowed)
        for k, line in enumerate(self.lines):
            found.problems += drag_missing(line.line, f"lines[{k}]")

    @property
    def has_lone_floats(self) -> bool:
        """Whether each line runs from an anchor to a float of its own."""
        points = {point.name: point for point in self.points}
        meeting = Counter(end for line in self.lines for end in (line.start, line.end))
        return all(
            {points[end].kind for end in (line.start, line.end)} == {"anchor", "joint"}
            and all(
                meeting[end] == 1 and points[end].hung[2] > 0.0
                for end in (line.start, line.end)
                if points[end].kind == "joint"
            )
            for line in self.lines
        )

    def _check_bodies(self, found: Findings) -> None:
        names = [body.name for body in self.bodies]
        for k, point in enumerate(self.points):
            if point.body and point.body not in names:
                known = ", ".join(names) or Message("refused.none")
                allowed = Message("refused_case.no_such_body_there_are", names=known)
                found.add(f"points[{k}].body", point.body, allowed)
        for k, body in enumerate(self.bodies):
            if body.name in names[:k]:
                allowed = Message("refused_case.another_has_this_name")
                found.add(f"bodies[{k}].name", body.name, allowed)
            elif not (arms := self.arms_of(body)):
                allowed = Message("refused_case.body_has_no_fairlead", name=body.name)
                found.add(f"bodies[{k}]", body.name, allowed)
            elif not any(arm[:2] != (0.0, 0.0) for arm in arms.values()):
                if body.yaw_free:
                    allowed = Message("refused_case.no_fairlead_lies_off_body")
                    found.add(f"bodies[{k}].yaw_free", "true", allowed)
                self._check_moment(k, body, found)
            elif body.yaw_free is False:
                self._check_moment(k, body, found)

    def _check_moment(self, number: int, body: MooredBody, found: Findings) -> None:
        """Refuse a moment on a body that does not turn."""
        if body.moment != 0.0:
            allowed = Message("refused_case.must_be_0_where_body")
            found.add(f"bodies[{number}].moment", f"{body.moment:g} N m", allowed)

    def _check_site(self, found: Findings) -> None:
        if self.site.seabed_slope != 0.0:
            slope = f"{math.degrees(self.site.seabed_slope):g} deg"
            found.add("site.seabed_slope", slope, Message("refused_case.lines_with_joints_lie_on"))
        if offset := self.site.contact_offset:
            allowed = Message("refused_case.leave_out_lines_with_joints")
            found.add("site.contact_offset", f"{offset:g} m", allowed)

    def _check_anchors(self, found: Findings, ends: list[tuple[str, str]]) -> None:
        """Refuse anchors of several lines, and lines of two, where what holds a line is checked."""
        anchors = [point.name for point in self.points if point.kind == "anchor"]
        for name in anchors:
            lines = [f"{k}" for k, pair in enumerate(ends, start=1) if name in pair]
            if len(lines) > 1:
                said = Message("refused_file.lines_at", lines=", ".join(lines), name=name)
                found.add("anchor", said, Message("refused_case.anchor_holds_one_line"))
        for k, (start, end) in enumerate(ends, start=1):
            if start != end and {start, end} <= set(anchors):
                said = Message("refused_file.line_between", line=k, start=start, end=end)
                found.add("anchor", said, Message("refused_case.anchor_holds_one_end"))

    @property
    def every_line(self) -> tuple[Line, ...]:
        """Its lines, as they are given."""
        return tuple(each.line for each in self.lines)

    @property
    def keyed_lines(self) -> Iterator[tuple[str, Line]]:
        """Its lines by their keys in the file."""
        return ((f"lines[{k}]", each.line) for k, each in enumerate(self.lines))

    def without_load_cases(self) -> Network:
        """Return it as it is: it has none."""
        return self

    @property
    def own_force(self) -> tuple[float, float]:
        """On its bodies together along x and y, N."""
        x, y = (math.fsum(body.force[k] for body in self.bodies) for k in (0, 1))
        return x, y

    @property
    def keyed_joints(self) -> tuple[tuple[str, Point], ...]:
        """The points that are free by their keys in the file."""
        keyed = ((f"points[{k}]", point) for k, point in enumerate(self.points))
        return tuple((key, point) for key, point in keyed if point.kind == "joint")

    @property
    def numbers(self) -> dict[str, int]:
        """Which point has which name, from 0."""
        return {point.name: k for k, point in enumerate(self.points)}

    def arms_of(self, body: MooredBody) -> dict[int, Vector]:
        """Return the fairleads of a body by number: x and y off its origin, and height; m."""
        return {
            k: (point.place[0] - body.x, point.place[1] - body.y, point.place[2])
            for k, point in enumerate(self.points)
            if point.kind == "fairlead" and point.body == body.name
        }

    def without_motion(self) -> Network:
        """Return the same network without what is for lines in motion alone."""
        if self.dynamics is None:
            return self
        points = tuple(replace(p, drag_area=None, drag_coefficient=None) for p in self.points)
        return replace(
            self,
            points=points,
            checks=replace(self.checks, motion_code=None),
            current=None,
            waves=None,
            motion=None,
            dynamics=None,
            fatigue=None,
        )

    @property
    def lowest_fairlead(self) -> float:
        """Height above the bed, m; inf without one."""
        heights = (p.place[2] for p in self.points if p.kind == "fairlead")
        return min(heights, default=math.inf)

    def raised(self, by: float) -> Network:
        """Return the network at another water level, what is afloat `by` metres higher."""
        points = tuple(
            replace(p, height=p.place[2] + by) if p.kind == "fairlead" else p for p in self.points
        )
        site = replace(self.site, water_depth=self.site.water_depth + by)
        return replace(self, site=site, points=points)

    def unloaded(self) -> Network:
        """Return the same network without the loads on its bodies."""
        bodies = tuple(replace(body, force=(0.0, 0.0), moment=0.0) for body in self.bodies)
        return replace(self, bodies=bodies) if bodies else self

    def turns(self, body: MooredBody) -> bool:
        """Whether a body is free in yaw."""
        if body.yaw_free is not None:
            return body.yaw_free
        return any(arm[:2] != (0.0, 0.0) for arm in self.arms_of(body).values())


def require_case(of: Case | Network, source: str = "") -> Case:
    """Return a case as it is; InputError for lines that meet in joints, or differ."""
    if isinstance(of, Network):
        allowed = Message("refused_command.lines_meet_joints_or_differ")
        raise refused("lines", "", allowed, source)
    return of
