"""What is sought of a line, and what a design may be made of."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal, get_args

from catopt.errors import Problem
from catopt.model.kinds import (
    COUNTS,
    Angle,
    Checked,
    Density,
    Factor,
    Findings,
    Headings,
    Length,
    Mass,
    NotNegative,
    OneOf,
    OneSegment,
    Place,
    Positive,
    Seed,
    Source,
    Strength,
    Text,
    Uplift,
    Whole,
)
from catopt.model.load import LOADS
from catopt.model.plausible_ranges import Plausible
from catopt.model.system import System
from catopt.words import Listed, Message

FindQuantity = Literal["length", "clump_weight", "touchdown_force", "limit_force"]
FIND_QUANTITIES: tuple[str, ...] = get_args(FindQuantity)

FORCES = ("touchdown_force", "limit_force")
"""Quantities that are a horizontal force, so that neither load nor condition is given."""
OF_SPAN = ("fairlead_tension", "horizontal_force")
"""Conditions of a length that is sought for a known span, in place of the load."""
CONDITIONS = ("anchor_angle", "grounded_length", "sag", *OF_SPAN)


@dataclass(frozen=True)
class Find(Checked):
    """What is sought, and the condition that it has to meet."""

    quantity: FindQuantity
    """``"length"`` of a segment or ``"clump_weight"`` of a point load under the case's load;
    ``"touchdown_force"``, the horizontal force at which the touchdown reaches the anchor;
    ``"limit_force"``, the one at which a segment reaches MBL over the safety factor."""
    segment: OneSegment | None = None
    """Which one, counted from 1 at the anchor. None is, for a length, the last one, at the
    fairlead; for a limit force, whichever reaches its limit first."""
    point_load: Annotated[int, Whole("point_load", example=1)] | None = None
    """For a clump weight: which one, counted from 1 at the anchor; None is the first."""
    anchor_angle: Uplift | None = None
    """For length and clump weight: inclination at the anchor, rad."""
    grounded_length: Length | None = None
    """For length, instead of the angle: unstretched length on the bed, m."""
    sag: Length | None = None
    """For length: largest vertical distance below the straight line between the ends, m."""
    fairlead_tension: Strength | None = None
    """For length under a span: tension at the fairlead, N."""
    horizontal_force: Strength | None = None
    """For length under a span: horizontal force at the fairlead, N."""

    def _check(self, found: Findings) -> None:
        found.check()
        # A condition too few or too many, and keys that this quantity does not heed.
        given = [key for key in CONDITIONS if getattr(self, key) is not None]
        what = Listed(given, "and") if given else Message("refused.no_condition")
        if self.quantity == "length" and len(given) != 1:
            found.add("find", what, Message("refused.one_condition"))
        elif self.quantity == "clump_weight" and given != ["anchor_angle"]:
            found.add("find", what, Message("refused.anchor_angle_only"))
        elif self.seeks_force and given:
            found.add("find", what, Message("refused.takes_no_condition", what=self.quantity))
        if self.segment is not None and self.quantity not in ("length", "limit_force"):
            found.add("segment", str(self.segment), Message("refused.with_length_or_limit"))
        if self.point_load is not None and self.quantity != "clump_weight":
            allowed = Message("refused.goes_with", way="clump_weight")
            found.add("point_load", str(self.point_load), allowed)

    @property
    def seeks_force(self) -> bool:
        """Whether a horizontal force is sought, so that neither load nor condition is given."""
        return self.quantity in FORCES


def inconsistencies(
    find: Find | None,
    *,
    load: Collection[str] | None,
    MBL_known: Sequence[bool],
    point_loads: int,
    anchor_height: float,
    has_load_cases: bool = False,
) -> list[Problem]:
    """List what does not fit between what is sought and the rest of a case.

    `load` has the keys of the load that are given, None without a load; load cases stand in for it
    where nothing is sought. Segments and point loads count from 1 in keys as ``find.segment``.
    """
    found = Findings()
    seeks_force = find is not None and find.seeks_force
    if load is None and not seeks_force and not (has_load_cases and find is None):
        table = Message("refused.table_with_one_of", line="[load]", keys=", ".join(LOADS))
        found.add("load", "", Message("refused.missing", wanted=table))
    if find is None:
        return found.problems
    if load is not None and seeks_force:
        allowed = Message("refused.seeks_force", what=find.quantity)
        given = Listed(load, "and") if load else Message("refused_case.a_load")
        found.add("load", given, allowed)
    if find is not None and load is not None and "span" not in load:
        for key in OF_SPAN:
            if (value := getattr(find, key)) is not None:
                found.add(f"find.{key}", f"{value:g} N", Message("refused.with_span"))
    _count(found, "segment", find.segment, len(MBL_known))
    if find.quantity == "clump_weight" and point_loads == 0:
        found.add("find.quantity", find.quantity, Message("refused.no_point_load"))
    else:
        _count(found, "point_load", find.point_load, point_loads)
    if find.quantity == "touchdown_force" and anchor_height > 0.0:
        found.add("line.anchor_height", f"{anchor_height:g} m", Message("refused.on_bed"))
    if find.quantity == "limit_force":
        _strength(found, find.segment, MBL_known)
    return found.problems


def _count(found: Findings, key: str, number: int | None, count: int) -> None:
    if number is not None and number > count:
        said = Message(f"refused.has_{key}" if count else f"refused.has_no_{key}", count=count)
        found.add(f"find.{key}", str(number), said)


def _strength(found: Findings, segment: int | None, MBL_known: Sequence[bool]) -> None:
    """Note when no segment in question has a minimum breaking load."""
    if segment is None and not any(MBL_known):
        found.add("find.quantity", "limit_force", Message("refused.needs_MBL"))
    elif segment is not None and segment <= len(MBL_known) and not MBL_known[segment - 1]:
        found.add(f"line.segments[{segment - 1}].MBL", "", Message("refused.limit_force_needs"))


Objective = Literal["mass", "offset", "excursion", "cost", "length", "anchor_load"]
OBJECTIVES: tuple[str, ...] = get_args(Objective)

FoundBy = Literal["enumeration", "nsga2", "swarm"]
SearchMethod = Literal["auto", FoundBy]

Component = Annotated[str, Text(filled=True, example='"chain studless R3"')]
LineName = Annotated[str, Text(filled=True, example='"leg west"')]
StateName = Annotated[str, Text(filled=True, example='"storm"')]

_OF_A_BODY = ("lines", "anchor_radii", "pretensions", "headings", "line_out", "loads")
_PLAIN: Mapping[str, object] = {"headings": 1}
"""What a key says that might as well be left out."""


@dataclass(frozen=True)
class SegmentChoice(Checked):
    """What one segment may be."""

    lengths: tuple[Length, ...]
    """Unstretched, m; rising."""
    components: tuple[Component, ...] = ()
    """Families with their grades, as the catalogue names them; empty: the segment of the case's
    line at this place as it is, whose length alone may vary."""
    diameters: tuple[Length, ...] = ()
    """Nominal diameters, m; empty: every size that is sold, within the bounds below."""
    diameter_min: Length | None = None
    """Bound on the sizes that are sold, m; None: no bound."""
    diameter_max: Length | None = None
    optional: bool = False
    """Whether the segment may be left out."""
    name: str = ""
    """For tables."""

    def _check(self, found: Findings) -> None:
        found.some("lengths", Message("refused_case.at_least_one_length_wanted"))
        found.check()


@dataclass(frozen=True)
class GroupChoice(SegmentChoice):
    """What one segment of several lines between points may be, the same in each."""

    lines: tuple[LineName, ...] = ()
    """By name, or by number where they have none."""
    segment: OneSegment = 1
    """Of each of them, counted from 1 at its start."""

    def _check(self, found: Findings) -> None:
        super()._check(found)
        found.some("lines", Message("refused_case.at_least_one_wanted"))


@dataclass(frozen=True)
class ClumpWeightChoice(Plausible):
    """What one clump weight may be, and where it may hang."""

    masses: tuple[Mass, ...]
    """In air, kg; rising."""
    density: Density
    """Of its material, kg/m3, for its weight in water."""
    positions: tuple[Length, ...] = ()
    """Unstretched arc length from the anchor, m; rising; empty when it hangs at a joint."""
    joint: Annotated[int, Whole("joint", example=1)] | None = None
    """At the upper end of this segment, counted from 1 at the anchor; None when `positions` are
    given."""
    optional: bool = False
    """Whether it may be left out."""
    name: str = ""
    """For tables."""
    friction: NotNegative | None = None
    """Coulomb coefficient of the body on the bed where it rests there; None: that of the bed."""

    def _check(self, found: Findings) -> None:
        found.some("masses", Message("refused_case.at_least_one_mass_wanted"))
        found.check()
        if (self.joint is None) == (not self.positions):
            found.add("positions", "", Message("refused_case.either_positions_or_joint_wanted"))


@dataclass(frozen=True)
class SinkerChoice(Plausible):
    """Sinkers (deadweight anchors) to choose from; the lightest that holds is taken."""

    masses: tuple[Mass, ...]
    """In air, kg; rising."""
    density: Density
    """Of their material, kg/m3."""
    friction: Positive
    """On the soil, tan(delta)."""
    safety_factor: Factor | None = None
    """On sliding; None: that of the codes that are checked."""
    factor_source: Source = ""
    """Where the factor is from, for the checks; the user when empty."""
    base_holdings: tuple[Strength, ...] = ()
    """Of each on clay, the largest horizontal pull that the soil holds on its base, N; empty where
    friction alone holds."""

    def _check(self, found: Findings) -> None:
        found.check("factor_source")
        if self.factor_source and self.safety_factor is None:
            found.add("factor_source", "", Message("refused.with_safety_factor"))
        found.some("masses", Message("refused_case.at_least_one_mass_wanted"))
        if self.base_holdings and len(self.base_holdings) != len(self.masses):
            numbers = Message("refused.numbers", count=len(self.base_holdings))
            allowed = Message("refused.so_many", count=len(self.masses))
            found.add("base_holdings", numbers, allowed)
        found.check()


@dataclass(frozen=True)
class DesignLoad(Checked):
    """A force on a moored body that every design has to meet."""

    name: StateName
    """As tables show it; no two of a design are the same. Empty: the force of the case's system."""
    force: Strength
    """Its size, N."""
    direction: Angle = 0.0
    """Towards which it acts, counter-clockwise from x, rad."""
    headings: Headings = 1
    """From how many sides it comes, evenly, `direction` the first."""
    water_level: Place = 0.0
    """Above the level of the site's water depth, m; the fairleads go up and down with it."""
    fairlead_rise: Place = 0.0
    """Of the fairleads above their place on the case's body, m."""
    line_out: bool = False
    """Whether each line is gone in turn under it, beside all being there."""

    def _check(self, found: Findings) -> None:
        found.check("force", "water_level", "fairlead_rise", "direction", "headings")

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


def group_misfits(design: GroupDesign | None, segments: Mapping[str, int]) -> Iterator[Problem]:
    """Yield lines and segments of groups that are not there; lines have so many `segments`."""
    for k, group in enumerate(() if design is None else design.groups):
        for i, name in enumerate(group.lines):
            if name not in segments:
                allowed = Message("refused.one_of", words=", ".join(segments))
                yield Problem(f"design.groups[{k}].lines[{i}]", name, allowed)
            elif group.segment > segments[name]:
                allowed = Message("refused.has_segment", count=segments[name])
                yield Problem(f"design.groups[{k}].segment", f"{group.segment}", allowed)


def _check_objectives(objectives: Sequence[str], found: Findings) -> None:
    """Find names that are none, and too few or too many of them."""
    unknown = [name for name in objectives if name not in OBJECTIVES]
    if unknown:
        allowed = Message("refused_case.two_or_three_of", words=", ".join(OBJECTIVES))
        found.add("objectives", ", ".join(unknown), allowed)
    elif not 2 <= len(set(objectives)) == len(objectives) <= 3:
        named = ", ".join(objectives) or Message("refused.none")
        found.add("objectives", named, Message("refused.two_or_three"))


@dataclass(frozen=True)
class Design(Checked):
    """A search for the best lines."""

    segments: tuple[SegmentChoice, ...]
    """From the anchor to the fairlead."""
    clump_weights: tuple[ClumpWeightChoice, ...] = ()
    """On the line; none is needed."""
    sinker: SinkerChoice | None = None
    """At the anchor; None: that of the case, if it has one."""
    objectives: tuple[Annotated[str, OneOf(OBJECTIVES)], ...] = ("mass", "offset")
    """Two or three of: "mass", in air, of segments and clump weights; "offset", the largest span
    over the load cases; "excursion", the largest span less that of the reference case; "cost", of
    the segments' material; "length", of the line; "anchor_load", the largest tension at an anchor
    over the load cases."""
    method: SearchMethod = "auto"
    """"enumeration" of every design, "nsga2", "swarm", or "auto"."""
    evaluations: Annotated[int, Whole("evaluations", example=10_000)] = 10_000
    """Designs that a search other than enumeration may evaluate."""
    population: Annotated[int, Whole("population", example=100)] = 100
    """Designs of one generation, or of the swarm."""
    seed: Seed = 1
    """Of the random numbers."""
    max_enumerated: Annotated[int, Whole("max_enumerated", example=5_000_000)] = 5_000_000
    """The largest number of designs that "auto" enumerates."""
    lines: tuple[Annotated[int, Whole("lines", example=6)], ...] = ()
    """Of a body: how many equal lines it may have, evenly about the azimuth of the first; empty:
    the azimuths of the case."""
    anchor_radii: tuple[Length, ...] = ()
    """Of a body: horizontal distances from its origin to its anchors, m, rising; empty: that of the
    case."""
    pretensions: tuple[Strength, ...] = ()
    """Of a body: instead, horizontal forces in each line with the body at its origin, N, rising."""
    headings: Headings = 1
    """Of a body: from how many sides its force comes, evenly, its own direction the first."""
    line_out: bool = False
    """Of a body: whether each line is gone in turn, beside all being there."""
    loads: tuple[DesignLoad, ...] = ()
    """Of a body: what it has to meet, in the place of its system's force; empty: that force."""
    in_motion: bool = False
    """Whether designs on the front have to pass in motion, too, as the case has it move."""
    max_run: Annotated[int, Whole("max_run", example=300)] = 300
    """Designs that are run in motion at most."""

    varied: ClassVar[str] = "segments"
    """Key of what varies."""

    def _check(self, found: Findings) -> None:
        found.some("segments", Message("refused_case.at_least_one_segment_wanted"))
        if all(segment.optional for segment in self.segments):
            allowed = Message("refused.one_segment")
            found.add("segments", Message("refused_file.all_optional"), allowed)
        _check_objectives(self.objectives, found)
        found.check("method", "evaluations", "population", "seed", "max_enumerated", "max_run")
        self._check_joints(found)
        fewest, most = COUNTS["lines"]
        for index, number in enumerate(self.lines):
            found.number(f"lines[{index}]", number, "", at_least=fewest, at_most=most)
        if list(self.lines) != sorted(set(self.lines)):
            allowed = Message("refused_case.rising_numbers_each_once")
            found.add("lines", ", ".join(map(str, self.lines)), allowed)
        found.check("anchor_radii", "pretensions")
        if self.anchor_radii and self.pretensions:
            allowed = Message("refused_case.one_both_places_anchors_give")
            given = Message("refused_case.beside", key="anchor_radii")
            found.add("pretensions", given, allowed)
        found.check("headings")

    def _check_joints(self, found: Findings) -> None:
        joints = len(self.segments) - 1
        for index, weight in enumerate(self.clump_weights):
            if weight.joint is not None and not weight.joint <= joints:
                key = "refused.has_joints" if joints else "refused.has_no_joint"
                allowed = Message(key, count=joints)
                found.add(f"clump_weights[{index}].joint", str(weight.joint), allowed)


@dataclass(frozen=True)
class GroupDesign(Checked):
    """A search for the best lines between points, by groups of them that are made alike."""

    groups: tuple[GroupChoice, ...]
    """Each a segment of the lines of a group; lines and segments in none stay as they are."""
    objectives: tuple[Annotated[str, OneOf(OBJECTIVES)], ...] = ("mass", "offset")
    """Two or three of: "mass", in air, of all lines; "offset", the largest of any body; "cost", of
    all segments' material; "length", of all lines; "anchor_load", the largest tension at an
    anchor."""
    method: SearchMethod = "auto"
    """"enumeration" of every design, "nsga2", "swarm", or "auto"."""
    evaluations: Annotated[int, Whole("evaluations", example=2_000)] = 2_000
    """Designs that a search other than enumeration may evaluate."""
    population: Annotated[int, Whole("population", example=40)] = 40
    """Designs of one generation, or of the swarm."""
    seed: Seed = 1
    """Of the random numbers."""
    max_enumerated: Annotated[int, Whole("max_enumerated", example=20_000)] = 20_000
    """The largest number of designs that "auto" enumerates."""
    in_motion: bool = False
    """Designs of lines between points are judged at rest alone."""

    # What a design of one line, or of equal lines about a body, may have beside these.
    varied: ClassVar[str] = "groups"
    clump_weights: ClassVar[tuple[()]] = ()
    sinker: ClassVar[None] = None
    loads: ClassVar[tuple[()]] = ()

    @property
    def segments(self) -> tuple[GroupChoice, ...]:
        """What varies."""
        return self.groups

    def _check(self, found: Findings) -> None:
        found.some("groups", Message("refused_case.at_least_one_wanted"))
        _check_objectives(self.objectives, found)
        if self.in_motion:
            found.add("in_motion", "true", Message("refused_command.no_groups_in_motion"))
        if "excursion" in self.objectives:
            allowed = Message("refused_case.take_offset_body_counted_from")
            found.add("objectives", "excursion", allowed)
        found.check("method", "evaluations", "population", "seed", "max_enumerated")


def loads_of(design: Design, system: System) -> tuple[DesignLoad, ...]:
    """List the loads of a design: its own, or the force of the system it is for."""
    if design.loads:
        return design.loads
    x, y = system.force
    headings, line_out = design.headings, design.line_out
    force, direction = math.hypot(x, y), math.atan2(y, x)
    return (DesignLoad("", force, direction, headings=headings, line_out=line_out),)


def body_misfits(
    given: Mapping[str, object], *, has_system: bool, has_force: bool
) -> Iterator[Problem]:
    """Yield what a design says of a body that there is not, or cannot say of one that there is.

    `given`: what a design gives; a key that is left out, or as without it, is missing or empty.
    There may be a body with several lines, and a force on it.
    """

    def said(key: str) -> bool:
        return bool(given.get(key)) and given[key] != _PLAIN.get(key)

    if not has_system:
        allowed = Message("refused_case.body_with_several_lines_add")
        for key in filter(said, _OF_A_BODY):
            yield Problem(f"design.{key}", Message("refused_case.without_system"), allowed)
        return
    if not has_force and not given.get("loads"):
        allowed = Message("refused_case.missing_design_force_on_body")
        yield Problem("system.force", "", allowed)
    if given.get("loads"):
        allowed = Message("refused_case.say_each_design_loads_leave")
        for key in filter(said, ("headings", "line_out")):
            beside = Message("refused_case.beside", key="design.loads")
            yield Problem(f"design.{key}", beside, allowed)
    if given.get("sinker"):
        allowed = Message("refused_case.leave_out_mooring_searched_with")
        yield Problem("design.sinker", Message("refused_case.beside_a_system"), allowed)
    objectives = given.get("objectives")
    if isinstance(objectives, (tuple, list)) and "excursion" in objectives:
        allowed = Message("refused_case.take_offset_body_counted_from")
        yield Problem("design.objectives", "excursion", allowed)
