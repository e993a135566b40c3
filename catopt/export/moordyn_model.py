"""A line cut into what MoorDyn knows: line types, points, elements, a bed and a time step."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from catopt.errors import InputError, Problem
from catopt.export.body_in_water import (
    BodyInWater,
    of_point_load,
    of_segment,
)
from catopt.export.exported_line import ExportedLine, ExportedLines
from catopt.export.text import word
from catopt.model import Line, PointLoad, Segment

ELEMENTS = 50
"""Of a line, unless it is said how many."""

SINKING = 1e-3
"""How deep the bed's springs let the line's own weight sink in, m."""

OWN_STIFFNESS = 3.0e6
"""MoorDyn's own bottom stiffness, Pa/m, where nothing lies on the bed by its weight."""

STEP = 0.4
"""Time step over the time that a wave of tension takes through the shortest element.

MoorDyn's RK2 with a damping of 0.8 of critical is stable to 0.95.
"""

DAMPING = 0.8
"""Of each element, over critical: MoorDyn's recommendation, written as -0.8."""

ROUNDING = 1e-9
"""Of a height over the water depth."""


SAME_PLACE = 1e-9
"""Distance over the line's length at which two cuts are one: rounding of lengths added up."""


@dataclass(frozen=True)
class Joint:
    """A place between two pieces, or an end of the line.

    `arc`: unstretched, from the anchor, m; `loads`: what hangs there.
    """

    arc: float
    loads: tuple[PointLoad, ...] = ()


@dataclass(frozen=True)
class Piece:
    """A uniform part of the line between two joints that follow each other.

    `segment`: which one it belongs to, counted from 0 at the anchor; `length`: unstretched, m;
    `elements`: into how many equal parts it is cut.
    """

    segment: int
    length: float
    elements: int


@dataclass(frozen=True)
class LineType:
    """A line type of MoorDyn: what a segment is made of."""

    name: str
    segment: Segment
    body: BodyInWater


@dataclass(frozen=True)
class Part:
    """One line cut for MoorDyn: its joints with what hangs there, its pieces with their types."""

    line: ExportedLine
    joints: Sequence[Joint]
    loads: Sequence[BodyInWater]
    pieces: Sequence[Piece]
    types: Sequence[LineType]


@dataclass(frozen=True)
class Model:
    """What is written.

    `parts`: the same, cut; `surface`: height of the water surface above the bed, m;
    `bed_stiffness`, `bed_damping`: Pa/m and Pa s/m; `step`: s.
    """

    solved: ExportedLines
    parts: Sequence[Part]
    surface: float
    bed_stiffness: float
    bed_damping: float
    step: float

    @property
    def types(self) -> list[LineType]:
        """Every line type once."""
        return list({each.name: each for part in self.parts for each in part.types}.values())


def model_of(
    solved: ExportedLines,
    *,
    elements: int = ELEMENTS,
    true_depth: bool = False,
    program: str = "MoorDyn",
) -> Model:
    """Cut the lines, and choose a bed and a time step.

    `solved`: the lines where they hang; every segment has an EA; `true_depth`: whether the water
    ends where it does in the case, even if a line reaches above it; `program`: whom it is for.
    Raises InputError when a segment does not stretch, or its mass is missing or too small, with
    every one at once.
    """
    parts = _parts(solved, elements, program)
    depth = solved.case.site.water_depth
    stiffness = _bed_stiffness(parts)
    return Model(
        solved,
        parts,
        solved.highest if is_above(solved) and not true_depth else depth,
        stiffness,
        _rounded_down(_bed_damping(parts, stiffness)),
        _rounded_down(_step(parts, stiffness)),
    )


def is_above(solved: ExportedLines) -> bool:
    """Whether a line reaches above the water of the case by more than rounding."""
    depth = solved.case.site.water_depth
    return solved.highest - depth > ROUNDING * depth


def _parts(solved: ExportedLines, elements: int, program: str) -> list[Part]:
    """Cut every line, and gather what is wrong with any."""
    density = solved.case.site.water_density
    known: dict[Segment, LineType] = {}
    problems: list[Problem] = []
    parts = []
    for line in solved.lines:
        joints, pieces = cut_line(line.solution.line, elements)
        types: list[LineType] = []
        for number, segment in enumerate(line.solution.line.segments):
            key = replace(segment, length=1.0)
            try:
                known[key] = known.get(key) or _line_type(segment, number, density, known, program)
                types.append(known[key])
            except InputError as error:
                problems += error.problems
        try:
            loads = [_hanging(line, joint, density) for joint in joints]
        except InputError as error:
            problems += error.problems
            continue
        if len(types) == len(line.solution.line.segments):
            parts.append(Part(line, joints, loads, pieces, types))
    if problems:
        raise InputError(list(dict.fromkeys(problems)), program)
    return parts


def _line_type(
    segment: Segment,
    number: int,
    density: float,
    known: dict[Segment, LineType],
    program: str,
) -> LineType:
    key = f"line.segments[{number}]"
    if math.isinf(segment.EA):
        allowed = f"missing; {program} lets every line stretch: give the segment its EA"
        raise InputError([Problem(f"{key}.EA", "", allowed)], program)
    wanted = word(segment.name or segment.component, f"segment_{number + 1}")
    taken = {each.name for each in known.values()}
    names = (wanted, *(f"{wanted}_{k}" for k in range(2, len(taken) + 3)))
    name = next(each for each in names if each not in taken)
    return LineType(name, segment, of_segment(segment, density, key))


def _hanging(line: ExportedLine, joint: Joint, density: float) -> BodyInWater:
    """Put what hangs at a joint together."""
    all_loads = line.solution.line.point_loads
    bodies = [
        of_point_load(load, density, f"line.point_loads[{all_loads.index(load)}]")
        for load in joint.loads
    ]
    volume = math.fsum(body.volume for body in bodies)
    added = math.fsum(body.volume * body.added_mass for body in bodies)
    return BodyInWater(
        math.fsum(body.mass for body in bodies),
        volume,
        all(body.is_known for body in bodies),
        math.fsum(body.drag_area for body in bodies),
        added / volume if volume > 0.0 else 0.0,
    )


def _bed_stiffness(parts: Sequence[Part]) -> float:
    """Return a stiffness by which lines, and weights that lie on the bed, sink in by 1 mm."""
    wanted = [
        each.segment.submerged_weight / (each.body.diameter * SINKING)
        for part in parts
        for each in part.types
    ]
    for part, index, reaction in resting(parts):
        below, above = part.pieces[index - 1], part.pieces[index]
        area = sum(
            0.5 * piece.length / piece.elements * part.types[piece.segment].body.diameter
            for piece in (below, above)
        )
        wanted.append(reaction / (area * SINKING))
    largest = max(wanted)
    return _rounded_up(largest) if largest > 0.0 else OWN_STIFFNESS


def resting(parts: Sequence[Part]) -> Iterator[tuple[Part, int, float]]:
    """Yield the joints at which the bed carries some of what hangs there, with how much; N."""
    for part in parts:
        states = part.line.solution.point_loads
        for index, joint in enumerate(part.joints[1:-1], start=1):
            carried = sum(
                state.seabed_reaction
                for state, load in zip(states, part.line.solution.line.point_loads, strict=True)
                if load in joint.loads
            )
            if carried > 0.0:
                yield part, index, carried


def _bed_damping(parts: Sequence[Part], stiffness: float) -> float:
    """Return what is critical for the line that is the lightest for its diameter."""
    return min(
        2.0 * math.sqrt(stiffness * each.body.mass / each.body.diameter)
        for part in parts
        for each in part.types
    )


def _step(parts: Sequence[Part], stiffness: float) -> float:
    """Return a step at which neither the line's nor the bed's springs make the run unstable."""
    times = []
    for part in parts:
        for piece in part.pieces:
            kind = part.types[piece.segment]
            element = piece.length / piece.elements
            times.append(element * math.sqrt(kind.body.mass / kind.segment.EA))
            times.append(math.sqrt(kind.body.mass / (stiffness * kind.body.diameter)))
    return STEP * min(times)


def _rounded_up(value: float) -> float:
    """Round to two significant digits, away from 0."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return math.ceil(value / unit * (1.0 - ROUNDING)) * unit


def _rounded_down(value: float) -> float:
    """Round to two significant digits, towards 0."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return math.floor(value / unit * (1.0 + ROUNDING)) * unit


def cut_line(line: Line, elements: int) -> tuple[list[Joint], list[Piece]]:
    """Cut a line; there is one joint more than pieces."""
    total = line.length
    ends: list[float] = []
    for segment in line.segments:
        ends.append((ends[-1] if ends else 0.0) + segment.length)
    joints: list[Joint] = []
    for arc in sorted([0.0, *ends[:-1], total, *(load.position for load in line.point_loads)]):
        if not joints or arc - joints[-1].arc > SAME_PLACE * total:
            joints.append(Joint(arc))
    for load in line.point_loads:
        at = min(range(len(joints)), key=lambda k: abs(joints[k].arc - load.position))
        joints[at] = Joint(joints[at].arc, (*joints[at].loads, load))
    pieces = []
    for lower, upper in pairwise(joints):
        middle = 0.5 * (lower.arc + upper.arc)
        segment_number = next((k for k, end in enumerate(ends) if middle < end), len(ends) - 1)
        length = upper.arc - lower.arc
        pieces.append(Piece(segment_number, length, max(2, round(elements * length / total))))
    return joints, pieces
