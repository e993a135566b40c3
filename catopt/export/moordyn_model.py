"""Lines cut into what MoorDyn and its kin know, and what stands there otherwise than in a case."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, chain, pairwise

from catopt.errors import InputError, Problem, refused
from catopt.export.body_in_water import STEEL_DENSITY, BodyInWater, of_point_load, of_segment
from catopt.export.export_result import significant, word
from catopt.export.exported_line import ExportedLine, ExportedLines
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
    """What is written: all lines cut, and the height of the water surface above the bed, m.

    `ends`: what hangs where lines end or meet, by the number of the point.
    """

    solved: ExportedLines
    parts: Sequence[LinePart]
    ends: Sequence[BodyInWater]
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
    parts = _parts(solved, elements, program)
    return Model(solved, parts, _at_ends(solved, parts), surface)


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
                known[key] = known.get(key) or _line_type(
                    segment, (number, line.key_of(number)), density, known, program
                )
                types.append(known[key])
            except InputError as error:
                problems += error.problems
        try:
            joints = _joints(of, density, line.key)
        except InputError as error:
            problems += error.problems
        if not problems:
            parts.append(LinePart(line, joints, _pieces(of, joints, types, elements)))
    if problems:
        raise InputError(list(dict.fromkeys(problems)), program)
    return parts


def _line_type(
    segment: Segment,
    place: tuple[int, str],
    density: float,
    known: Mapping[Segment, LineType],
    program: str,
) -> LineType:
    number, key = place
    if segment.is_inextensible:
        allowed = Message("refused_command.missing_lets_every_line_stretch", program=program)
        raise refused(f"{key}.EA", "", allowed, program)
    wanted = word(segment.name or segment.component, f"segment_{number + 1}")
    taken = {each.name for each in known.values()}
    names = (wanted, *(f"{wanted}_{k}" for k in range(2, len(taken) + 3)))
    name = next(each for each in names if each not in taken)
    return LineType(name, segment, of_segment(segment, density, key))


def _at_ends(solved: ExportedLines, parts: Sequence[LinePart]) -> list[BodyInWater]:
    """Put what hangs at each point together: of its own, and at the ends of its lines."""
    density, problems = solved.case.site.water_density, list[Problem]()
    hung: list[list[BodyInWater]] = [[] for _ in solved.points]
    for bodies, point in zip(hung, solved.points, strict=True):
        try:
            bodies += [of_point_load(point.joint, density, point.key)] if point.joint else []
        except InputError as error:
            problems += error.problems
    if problems:
        raise InputError(problems, "export")
    for part in parts:
        for end, joint in zip(part.line.ends, (part.joints[0], part.joints[-1]), strict=True):
            hung[end].append(joint.body)
    return [_together(bodies) for bodies in hung]


def _joints(line: Line, density: float, key: str) -> list[Joint]:
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
        Joint(arc, loads, _hanging(line, loads, density, key))
        for arc, loads in zip(arcs, hung, strict=True)
    ]


def _hanging(line: Line, loads: Sequence[PointLoad], density: float, key: str) -> BodyInWater:
    """Put what hangs at a joint together."""
    return _together(
        [
            of_point_load(load, density, f"{key}.point_loads[{line.point_loads.index(load)}]")
            for load in loads
        ]
    )


def _together(bodies: Sequence[BodyInWater]) -> BodyInWater:
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


def resting(model: Model) -> Iterator[tuple[float, list[ModelPiece]]]:
    """Yield what the bed carries of each point and point load that rests on it, N; and the pieces.

    These are those that meet there.
    """
    for part in model.parts:
        states = part.line.solution.point_loads
        for index, joint in enumerate(part.joints[1:-1], start=1):
            carried = sum(
                state.seabed_reaction
                for state, load in zip(states, part.line.solution.line.point_loads, strict=True)
                if load in joint.loads
            )
            if carried > 0.0:
                yield carried, list(part.pieces[index - 1 : index + 1])
    for number, point in enumerate(model.solved.points):
        if point.bed_reaction > 0.0:
            ends = ((part, end) for part in model.parts for end in (0, -1))
            meeting = [part.pieces[e] for part, e in ends if part.line.ends[e] == number]
            yield point.bed_reaction, meeting


MOORPY_REACH = 2.0
"""Height above the bed below which MoorPy 1.3 takes weight off a point, m."""

DRAG, ADDED_MASS = 1.2, 1.0
"""Of a smooth cylinder; stand in where a segment has no coefficients."""


def remarks_of(model: Model) -> Iterator[str]:
    """Say what stands in the file otherwise than in the case, and what does not."""
    yield from common_remarks(model)
    if any(line.at_rest is not None for line in model.solved.lines):
        yield (
            f"bed friction {model.solved.lines[0].solution.seabed_friction:g}: MoorDyn's friction "
            "acts on what moves and is none at rest, and MoorPy drops it. "
            "Compare with the closed form on a bed without friction; the fairleads stand where "
            "they do with friction."
        )
    if any(resting(model)):
        yield (
            "a point load rests on the bed: a point of MoorDyn does not feel the bed, the line at "
            "its two sides carries it, for which kBot is made stiff enough to let it sink by 1 mm."
        )
    inner = ((p.line.at(j.arc)[2], j.body) for p in model.parts for j in p.joints[1:-1])
    ends = ((p.place[2], body) for p, body in zip(model.solved.points, model.ends, strict=True))
    heights = (height for height, body in chain(inner, ends) if body.mass or body.volume)
    if any(height < MOORPY_REACH for height in heights):
        yield (
            "MoorPy lets the bed carry some of a point load that hangs less than 2 m above it: set "
            "zTol of its points to 0.001 before it solves."
        )
    depth, highest = model.solved.case.site.water_depth, model.solved.highest
    if not is_above(model.solved):
        return
    if model.surface > depth:
        yield (
            f"a line reaches {significant(highest - depth)} m above the water of the case, "
            f"{significant(depth)} m deep. The closed form lets all of it weigh what it weighs in "
            f"water; for MoorDyn to do so too the depth is put at {significant(model.surface)} m. "
            "With --true-depth it weighs there what it weighs in air."
        )
    else:
        yield (
            f"a line reaches {significant(highest - depth)} m above the water. MoorDyn lets that "
            "part weigh what it weighs in air, the closed form what it weighs in water, and so "
            "does MoorPy: the tensions differ by that."
        )


def common_remarks(model: Model) -> Iterator[str]:
    """Say what holds for any program that lets its lines stretch and takes mass and diameter."""
    solved = model.solved
    yield from solved.warnings
    if solved.EA is not None:
        changes = [line.solution.fairlead.tension / line.own_tension - 1.0 for line in solved.lines]
        yield (
            f"EA {significant(solved.EA)} N is not of the case, in which the line does not "
            "stretch: it was given for this file, and the closed form here is that of the line "
            "that has it. It changes the fairlead tension by "
            f"{100.0 * max(changes, key=abs):.2g} %."
        )
    unknown = [each.name for each in model.types if not each.body.is_known]
    if unknown:
        yield (
            f"mass in air not known of {', '.join(unknown)}: that of steel ({STEEL_DENSITY:g} "
            "kg/m3) with the submerged weight of the case stands in. At rest it changes nothing."
        )
    inner = (joint.body for part in model.parts for joint in part.joints)
    if not all(body.is_known for body in chain(inner, model.ends)):
        yield (
            "mass in air not known of a point load: a weight without volume, or a volume without "
            "mass, with its submerged weight stands in. At rest it changes nothing."
        )
    bare = [each.name for each in model.types if not has_drag(each.segment)]
    if bare:
        yield (
            f"drag and added mass not known of {', '.join(bare)}: Cd {DRAG:g} across, 0 along, Ca "
            f"{ADDED_MASS:g} across, 0 along stand in. At rest they change nothing; give your own "
            "before a run in waves."
        )
    for body in solved.bodies:
        yield (
            f"the {body.name} is not in the file: each fairlead is held where it is under the "
            "load, and the forces of all lines together balance that load."
        )
    left = [key for key in ("waves", "current", "motion") if getattr(solved.case, key) is not None]
    if left:
        yield f"not in the file: {', '.join(left)} of the case. It is the line at rest."
    own = {
        f"{load.friction:g}"
        for line in solved.lines
        for load in line.solution.line.point_loads
        if load.friction is not None
    }
    if own:
        yield Message("export.load_friction", values=", ".join(sorted(own)))


def has_drag(segment: Segment) -> bool:
    """Whether the coefficients of a segment are known, with the diameter that they refer to."""
    return segment.drag_normal is not None and segment.drag_diameter is not None
