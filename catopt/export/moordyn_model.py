"""Lines cut into what other programs know: line types, points and pieces of a line."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, pairwise

from catopt.errors import InputError, Problem
from catopt.export.exported import word
from catopt.export.exported_line import (
    BodyInWater,
    ExportedLine,
    ExportedLines,
    of_point_load,
    of_segment,
)
from catopt.model import Line, PointLoad, Segment
from catopt.words import Message

ELEMENTS = 50
"""Of a line, unless it is said how many."""

ROUNDING = 1e-9
"""Of a height over the water depth."""

SAME_PLACE = 1e-9
"""Distance over the line's length at which two cuts are one: rounding of lengths added up."""


@dataclass(frozen=True)
class LineType:
    """What a segment is made of, by its name in the file."""

    name: str
    segment: Segment
    body: BodyInWater


@dataclass(frozen=True)
class Joint:
    """A place between two pieces, or an end of the line.

    `arc`: unstretched, from the anchor, m; `loads`: what hangs there, all together `body`.
    """

    arc: float
    loads: Sequence[PointLoad]
    body: BodyInWater


@dataclass(frozen=True)
class ModelPiece:
    """A uniform part of the line between two joints that follow each other.

    `length`: unstretched, m; `elements`: into how many equal parts it is cut.
    """

    type: LineType
    length: float
    elements: int


@dataclass(frozen=True)
class LinePart:
    """One line cut: its joints, one more than its pieces."""

    line: ExportedLine
    joints: Sequence[Joint]
    pieces: Sequence[ModelPiece]


@dataclass(frozen=True)
class Model:
    """What is written: all lines cut, and the height of the water surface above the bed, m."""

    solved: ExportedLines
    parts: Sequence[LinePart]
    surface: float

    @property
    def pieces(self) -> list[ModelPiece]:
        """Those of all lines, in order."""
        return [piece for part in self.parts for piece in part.pieces]

    @property
    def types(self) -> list[LineType]:
        """Every line type once."""
        return list({piece.type.name: piece.type for piece in self.pieces}.values())


def model_of(
    solved: ExportedLines,
    *,
    elements: int = ELEMENTS,
    true_depth: bool = False,
    program: str = "MoorDyn",
) -> Model:
    """Cut the lines.

    `solved`: the lines where they hang; every segment has an EA; `true_depth`: whether the water
    ends where it does in the case, even if a line reaches above it; `program`: whom it is for.
    Raises InputError when a segment does not stretch, or its mass is missing or too small, with
    every one at once.
    """
    raised = is_above(solved) and not true_depth
    surface = solved.highest if raised else solved.case.site.water_depth
    return Model(solved, _parts(solved, elements, program), surface)


def is_above(solved: ExportedLines) -> bool:
    """Whether a line reaches above the water of the case by more than rounding."""
    depth = solved.case.site.water_depth
    return solved.highest - depth > ROUNDING * depth


def _parts(solved: ExportedLines, elements: int, program: str) -> list[LinePart]:
    """Cut every line, and gather what is wrong with any."""
    density = solved.case.site.water_density
    known: dict[Segment, LineType] = {}
    problems: list[Problem] = []
    parts = []
    for line in solved.lines:
        of = line.solution.line
        types: list[LineType] = []
        for number, segment in enumerate(of.segments):
            key = replace(segment, length=1.0)
            try:
                known[key] = known.get(key) or _line_type(segment, number, density, known, program)
                types.append(known[key])
            except InputError as error:
                problems += error.problems
        try:
            joints = _joints(of, density)
        except InputError as error:
            problems += error.problems
        if not problems:
            parts.append(LinePart(line, joints, _pieces(of, joints, types, elements)))
    if problems:
        raise InputError(list(dict.fromkeys(problems)), program)
    return parts


def _line_type(
    segment: Segment,
    number: int,
    density: float,
    known: Mapping[Segment, LineType],
    program: str,
) -> LineType:
    key = f"line.segments[{number}]"
    if segment.is_inextensible:
        allowed = Message("refused_command.missing_lets_every_line_stretch", program=program)
        raise InputError([Problem(f"{key}.EA", "", allowed)], program)
    wanted = word(segment.name or segment.component, f"segment_{number + 1}")
    taken = {each.name for each in known.values()}
    names = (wanted, *(f"{wanted}_{k}" for k in range(2, len(taken) + 3)))
    name = next(each for each in names if each not in taken)
    return LineType(name, segment, of_segment(segment, density, key))


def _joints(line: Line, density: float) -> list[Joint]:
    """Cut a line where segments meet and loads hang, and put together what hangs at one place."""
    total = line.length
    between = list(accumulate(segment.length for segment in line.segments[:-1]))
    arcs: list[float] = []
    for arc in sorted([0.0, *between, total, *(load.position for load in line.point_loads)]):
        if not arcs or arc - arcs[-1] > SAME_PLACE * total:
            arcs.append(arc)
    hung: list[list[PointLoad]] = [[] for _ in arcs]
    for load in line.point_loads:
        hung[min(range(len(arcs)), key=lambda k: abs(arcs[k] - load.position))].append(load)
    return [
        Joint(arc, loads, _hanging(line, loads, density))
        for arc, loads in zip(arcs, hung, strict=True)
    ]


def _hanging(line: Line, loads: Sequence[PointLoad], density: float) -> BodyInWater:
    """Put what hangs at a joint together."""
    bodies = [
        of_point_load(load, density, f"line.point_loads[{line.point_loads.index(load)}]")
        for load in loads
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


def _pieces(
    line: Line, joints: Sequence[Joint], types: Sequence[LineType], elements: int
) -> list[ModelPiece]:
    """Say what lies between each two joints: of which segment it is, and how finely cut."""
    ends = list(accumulate(segment.length for segment in line.segments))
    pieces = []
    for lower, upper in pairwise(joints):
        middle = 0.5 * (lower.arc + upper.arc)
        number = next((k for k, end in enumerate(ends) if middle < end), len(ends) - 1)
        length = upper.arc - lower.arc
        cuts = max(2, round(elements * length / line.length))
        pieces.append(ModelPiece(types[number], length, cuts))
    return pieces


def resting(parts: Sequence[LinePart]) -> Iterator[tuple[LinePart, int, float]]:
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
