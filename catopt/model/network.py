"""Lines that meet in free joints: crowfoot and bridle, a leg that splits."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterable
from dataclasses import dataclass, field
from typing import Annotated, Literal

from catopt.errors import Problem
from catopt.model.anchor import Anchor
from catopt.model.checks import Checks
from catopt.model.kinds import Force, Height, Place, Size, Text
from catopt.model.line import Line, weightless
from catopt.model.service import Service
from catopt.model.site import Site
from catopt.model.validity import Checked, Findings
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
    """Above the seabed, m."""
    submerged_weight: Force = 0.0
    """Of a joint: clump weight, or buoy below 0, N."""
    force: Annotated[tuple[Force, ...], Size(3, 3)] = (0.0, 0.0, 0.0)
    """On a joint, of what pulls there beside the lines, along x, y and up, N."""

    def _check(self, found: Findings) -> None:
        if not self.name:
            found.add("name", "", Message("refused_case.missing_lines_name_point_by"))
        found.check("kind")
        found.problems += point_misfits(vars(self))
        object.__setattr__(self, "force", tuple(self.force))
        found.check("x", "y", "height", "submerged_weight", "force")

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
    found = []
    for key in ("x", "y", "height"):
        value = given.get(key)
        if is_joint and value is not None:
            allowed = Message("refused_case.leave_out_where_joint_comes")
            found.append(Problem(key, f"{value}", allowed))
        elif value is None and given.get("kind") in ("anchor", "fairlead"):
            found.append(
                Problem(key, "", Message("refused_case.missing_s_have_x_y", value=given["kind"]))
            )
    allowed = Message("refused_case.leave_out_only_joint_feels")
    if given.get("submerged_weight") and not is_joint:
        found.append(Problem("submerged_weight", f"{given['submerged_weight']}", allowed))
    force = given.get("force")
    if isinstance(force, Iterable) and any(force) and not is_joint:
        found.append(Problem("force", f"{given['force']}", allowed))
    return found


@dataclass(frozen=True)
class LineBetween:
    """A line from one point to another, by their names; its segments run that way."""

    line: Line
    start: PointName
    end: PointName
    name: str = ""


@dataclass(frozen=True)
class Network(Checked):
    """Lines between points, of which some are free joints, and a body that is held.

    Any iterables of points and lines are taken; at least one of each.
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

    def _check(self, found: Findings) -> None:
        object.__setattr__(self, "points", tuple(self.points))
        object.__setattr__(self, "lines", tuple(self.lines))
        for key in ("points", "lines"):
            if not getattr(self, key):
                found.add(key, Message("refused.none"), Message("refused_case.at_least_one_wanted"))
        names = [point.name for point in self.points]
        joints = [point.name for point in self.points if point.kind == "joint"]
        pulled = {each.name for each in self.points if each.hung[2] > 0.0 or any(each.hung[:2])}
        ends = [(line.start, line.end) for line in self.lines]
        found.problems += network_misfits(names, joints, ends, pulled)
        for k, each in enumerate(self.lines):
            segments = each.line.segments
            if not any(segment.submerged_weight for segment in segments):
                found.add(f"lines[{k}].segments", *weightless("a line between points"))
            if {each.start, each.end} & set(joints):
                allowed = Message("refused_case.missing_lines_meet_joints_have")
                for i in (i for i, segment in enumerate(segments) if math.isinf(segment.EA)):
                    found.add(f"lines[{k}].segments[{i}].EA", "", allowed)
        self._check_site(found)
        for key in ("max_span", "max_offset"):
            if (limit := getattr(self.checks, key)) is not None:
                allowed = Message("refused_case.span_is_of_a_line")
                found.add(f"checks.{key}", f"{limit:g} m", allowed)
        if self.anchor is not None:
            self._check_anchors(found, ends)

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
                allowed = Message("refused_case.anchor_holds_one_line")
                found.add(
                    "anchor",
                    Message("refused_file.lines_at", lines=", ".join(lines), name=name),
                    allowed,
                )
        for k, pair in enumerate(ends, start=1):
            if pair[0] != pair[1] and set(pair) <= set(anchors):
                allowed = Message("refused_case.anchor_holds_one_end")
                found.add(
                    "anchor",
                    Message("refused_file.line_between", line=k, start=pair[0], end=pair[1]),
                    allowed,
                )

    @property
    def numbers(self) -> dict[str, int]:
        """Which point has which name, from 0."""
        return {point.name: k for k, point in enumerate(self.points)}


def network_misfits(
    names: list[str],
    joints: list[str],
    ends: list[tuple[str, str]],
    pulled: Collection[str] = (),
) -> list[Problem]:
    """List ends that are no points, names given twice, joints that nothing holds.

    `pulled`: joints that a force or their buoyancy keeps from falling.
    """
    first = {name: k for k, name in reversed([*enumerate(names)])}
    found = [
        Problem(f"points[{k}].name", name, Message("refused_case.another_point_has_this_name"))
        for k, name in enumerate(names)
        if first[name] < k
    ]
    for k, pair in enumerate(ends):
        found += (
            Problem(
                f"lines[{k}].{key}",
                end,
                Message("refused_case.no_such_point_there_are", names=", ".join(names)),
            )
            for key, end in zip(("start", "end"), pair, strict=True)
            if end not in first
        )
        if pair[0] == pair[1]:
            found.append(
                Problem(f"lines[{k}].end", pair[1], Message("refused_case.line_begins_there_too"))
            )
    meeting = Counter(name for pair in ends for name in {*pair})
    held = joined({*names} - {*joints}, ends)
    return found or [
        Problem(f"points[{k}]", name, allowed)
        for k, name in enumerate(names)
        if (allowed := _loose(meeting[name], name in joints, name in pulled, name in held))
    ]


def joined(to: Iterable[str], ends: Iterable[tuple[str, str]]) -> set[str]:
    """Gather the points that lines join to some, by way of any others; these among them."""
    found, pairs = {*to}, [{*pair} for pair in ends]
    while more := {end for pair in pairs if pair & found for end in pair} - found:
        found |= more
    return found


def _loose(meeting: int, is_joint: bool, is_pulled: bool, is_held: bool) -> str:
    """Say why nothing holds a point, or what it is for; empty where that is in order."""
    if not meeting:
        return Message("refused_case.no_line_ends_here")
    if not is_joint:
        return ""
    if meeting == 1 and not is_pulled:
        return Message("refused_case.one_line_ends_here")
    return "" if is_held else Message("refused_case.no_line_leads_to_an_anchor")
