"""A MoorDyn input file (version 2), which MoorPy reads too.

MoorDyn takes the mass in air and the volume-equivalent diameter of a line; its weight in water
follows from them. Heights count from the still water surface. Everything that is said beside the
numbers stands before the first section, where both programs pass over it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from textwrap import wrap

from catopt._version import __version__
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError, Problem
from catopt.export.body_in_water import (
    STEEL_DENSITY,
    BodyInWater,
    of_point_load,
    of_segment,
)
from catopt.export.expected import expected, in_words
from catopt.export.exported import Exported, Source
from catopt.export.hung import Hung, HungLine
from catopt.export.pieces import Joint, Piece, cut_line
from catopt.export.text import plain, significant, word
from catopt.model import Segment

__all__ = ["ELEMENTS", "moordyn_input"]

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

MOORPY_REACH = 2.0
"""Height above the bed below which MoorPy 1.3 takes weight off a point, m."""

ROUNDING = 1e-9
"""Of a height over the water depth."""

DRAG, ADDED_MASS = 1.2, 1.0
"""Of a smooth cylinder; stand in where a segment has no coefficients."""


@dataclass(frozen=True)
class LineType:
    """A line type of MoorDyn: what a segment is made of."""

    name: str
    segment: Segment
    body: BodyInWater


@dataclass(frozen=True)
class Part:
    """One line cut for MoorDyn: its joints with what hangs there, its pieces with their types."""

    line: HungLine
    joints: Sequence[Joint]
    loads: Sequence[BodyInWater]
    pieces: Sequence[Piece]
    types: Sequence[LineType]


@dataclass(frozen=True)
class Model:
    """What is written.

    Attributes
    ----------
    hung : Hung
        The lines.
    parts : sequence of Part
        The same, cut.
    surface : float
        Height of the water surface above the bed, m.
    bed_stiffness, bed_damping : float
        Pa/m and Pa s/m.
    step : float
        s.
    """

    hung: Hung
    parts: Sequence[Part]
    surface: float
    bed_stiffness: float
    bed_damping: float
    step: float

    @property
    def types(self) -> list[LineType]:
        """Every line type once."""
        return list({each.name: each for part in self.parts for each in part.types}.values())


def moordyn_input(
    hung: Hung,
    *,
    elements: int = ELEMENTS,
    true_depth: bool = False,
    sources: Sequence[Source] = (),
) -> Exported:
    """Write lines as the input of MoorDyn.

    Parameters
    ----------
    hung : Hung
        The lines where they hang; every segment has an EA.
    elements : int
        About how many a line is cut into.
    true_depth : bool
        Whether the water ends where it does in the case, even if a line reaches above it.
    sources : sequence of Source
        What the case was read from.

    Raises
    ------
    InputError
        A segment does not stretch, or its mass is missing or too small, with every one at once.
    """
    parts = _parts(hung, elements)
    depth = hung.case.site.water_depth
    surface = hung.highest if _is_above(hung) and not true_depth else depth
    stiffness = _bed_stiffness(parts)
    model = Model(
        hung,
        parts,
        surface,
        stiffness,
        _rounded_down(_bed_damping(parts, stiffness)),
        _rounded_down(_step(parts, stiffness)),
    )
    remarks = tuple(_remarks(model))
    lines = [
        *_header(model, remarks, sources),
        *_line_types(model),
        *_points(model),
        *_lines(model),
        *_options(model),
    ]
    return Exported(
        "moordyn",
        hung.case.title,
        "\n".join(lines) + "\n",
        remarks,
        tuple(expected(line) for line in hung.lines),
        tuple(sources),
    )


def _is_above(hung: Hung) -> bool:
    """Whether a line reaches above the water of the case by more than rounding."""
    depth = hung.case.site.water_depth
    return hung.highest - depth > ROUNDING * depth


# ------------------------------------------------------------------ what is written


def _parts(hung: Hung, elements: int) -> list[Part]:
    """Cut every line, and gather what is wrong with any."""
    density = hung.case.site.water_density
    known: dict[Segment, LineType] = {}
    problems: list[Problem] = []
    parts = []
    for line in hung.lines:
        joints, pieces = cut_line(line.solution.line, elements)
        types: list[LineType] = []
        for number, segment in enumerate(line.solution.line.segments):
            key = replace(segment, length=1.0)
            try:
                known[key] = known.get(key) or _line_type(segment, number, density, known)
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
        raise InputError(list(dict.fromkeys(problems)), "MoorDyn")
    return parts


def _line_type(
    segment: Segment, number: int, density: float, known: dict[Segment, LineType]
) -> LineType:
    key = f"line.segments[{number}]"
    if math.isinf(segment.EA):
        allowed = "missing; MoorDyn lets every line stretch: give the segment its EA"
        raise InputError([Problem(f"{key}.EA", "", allowed)], "MoorDyn")
    wanted = word(segment.name or segment.component, f"segment_{number + 1}")
    taken = {each.name for each in known.values()}
    names = (wanted, *(f"{wanted}_{k}" for k in range(2, len(taken) + 3)))
    name = next(each for each in names if each not in taken)
    return LineType(name, segment, of_segment(segment, density, key))


def _hanging(line: HungLine, joint: Joint, density: float) -> BodyInWater:
    """Put what hangs at a joint together."""
    all_loads = line.solution.line.point_loads
    bodies = [
        of_point_load(load, density, f"line.point_loads[{all_loads.index(load)}]")
        for load in joint.loads
    ]
    return BodyInWater(
        math.fsum(body.mass for body in bodies),
        math.fsum(body.volume for body in bodies),
        all(body.is_known for body in bodies),
    )


def _bed_stiffness(parts: Sequence[Part]) -> float:
    """Return a stiffness by which lines, and weights that lie on the bed, sink in by 1 mm."""
    wanted = [
        each.segment.submerged_weight / (each.body.diameter * SINKING)
        for part in parts
        for each in part.types
    ]
    for part, index, reaction in _resting(parts):
        below, above = part.pieces[index - 1], part.pieces[index]
        area = sum(
            0.5 * piece.length / piece.elements * part.types[piece.segment].body.diameter
            for piece in (below, above)
        )
        wanted.append(reaction / (area * SINKING))
    largest = max(wanted)
    return _rounded_up(largest) if largest > 0.0 else OWN_STIFFNESS


def _resting(parts: Sequence[Part]) -> Iterator[tuple[Part, int, float]]:
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
    return math.ceil(value / unit) * unit


def _rounded_down(value: float) -> float:
    """Round to two significant digits, towards 0."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return math.floor(value / unit) * unit


# ------------------------------------------------------------------ what is said


def _remarks(model: Model) -> Iterator[str]:
    """Say what stands in the file otherwise than in the case, and what does not."""
    yield from model.hung.warnings
    yield from _on_stiffness(model.hung)
    yield from _on_stand_ins(model)
    yield from _on_the_bed(model)
    yield from _on_the_water(model)
    yield from _on_the_rest(model.hung)


def _on_stiffness(hung: Hung) -> Iterator[str]:
    if hung.EA is None:
        return
    changes = [line.solution.fairlead.tension / line.own_tension - 1.0 for line in hung.lines]
    largest = max(changes, key=abs)
    yield (
        f"EA {significant(hung.EA)} N is not of the case, in which the line does not stretch: it "
        "was given for this file, and the closed form here is that of the line that has it. It "
        f"changes the fairlead tension by {100.0 * largest:.2g} %."
    )


def _on_stand_ins(model: Model) -> Iterator[str]:
    unknown = [each.name for each in model.types if not each.body.is_known]
    if unknown:
        yield (
            f"mass in air not known of {', '.join(unknown)}: that of steel ({STEEL_DENSITY:g} "
            "kg/m3) with the submerged weight of the case stands in. At rest it changes nothing."
        )
    if any(not body.is_known for part in model.parts for body in part.loads):
        yield (
            "mass in air not known of a point load: a weight without volume, or a volume without "
            "mass, with its submerged weight stands in. At rest it changes nothing."
        )
    bare = [each.name for each in model.types if not _has_drag(each.segment)]
    if bare:
        yield (
            f"drag and added mass not known of {', '.join(bare)}: Cd {DRAG:g} across, 0 along, Ca "
            f"{ADDED_MASS:g} across, 0 along stand in. At rest they change nothing; give your own "
            "before a run in waves."
        )


def _has_drag(segment: Segment) -> bool:
    return segment.drag_normal is not None and segment.drag_diameter is not None


def _on_the_bed(model: Model) -> Iterator[str]:
    if any(line.at_rest is not None for line in model.hung.lines):
        yield (
            f"bed friction {model.hung.lines[0].solution.seabed_friction:g}: MoorDyn's friction "
            "acts on what moves and is none at rest, and MoorPy drops it. "
            "Compare with the closed form on a bed without friction; the fairleads stand where "
            "they do with friction."
        )
    if any(_resting(model.parts)):
        yield (
            "a point load rests on the bed: a point of MoorDyn does not feel the bed, the line at "
            "its two sides carries it, for which kBot is made stiff enough to let it sink by 1 mm."
        )
    if any(low for part in model.parts for low in _near_the_bed(part)):
        yield (
            "MoorPy lets the bed carry some of a point load that hangs less than 2 m above it: set "
            "zTol of its points to 0.001 before it solves."
        )


def _near_the_bed(part: Part) -> Iterator[bool]:
    """Yield for each joint that bears a weight whether it is within MoorPy's reach of the bed."""
    for joint, body in zip(part.joints, part.loads, strict=True):
        if body.mass > 0.0 or body.volume > 0.0:
            yield part.line.at(joint.arc)[2] < MOORPY_REACH


def _on_the_water(model: Model) -> Iterator[str]:
    depth, highest = model.hung.case.site.water_depth, model.hung.highest
    if not _is_above(model.hung):
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


def _on_the_rest(hung: Hung) -> Iterator[str]:
    if hung.system is not None:
        yield (
            "the body is not in the file: each fairlead is held where it is under the load, and "
            "the forces of all lines together balance that load."
        )
    left = [key for key in ("waves", "current", "motion") if getattr(hung.case, key) is not None]
    if left:
        yield f"not in the file: {', '.join(left)} of the case. It is the line at rest."


# ------------------------------------------------------------------ the sections


def _header(model: Model, remarks: Sequence[str], sources: Sequence[Source]) -> Iterator[str]:
    """Yield what stands before the first section: neither program reads it."""
    hung = model.hung
    yield f"MoorDyn v2 input file, also read by MoorPy; written by catopt {__version__}"
    if hung.case.title:
        yield from _folded(f"Case: {hung.case.title}")
    for source in sources:
        yield from _folded(f"From {source.name}, SHA-256 {source.sha256}")
    yield ""
    for line in in_words(hung):
        yield from _folded(line)
    yield ""
    yield from _folded(
        "Diam is the volume-equivalent diameter: that of a cylinder with the line's volume, from "
        "mass in air less submerged weight over g, over the water's density. It is not the nominal "
        "diameter of chain or rope. Heights count from the water surface. Fairleads are Coupled "
        "points at rest: run without moving them, and compare the force on them."
    )
    missed = _missed(model)
    if missed > 0.0:
        yield from _folded(
            f"MoorDyn's straight elements miss the curve by up to w l^2 / (8 H) = {missed:.2g} m, "
            "as if a fairlead were that much higher or lower. Halve them (--elements) to see what "
            "it does to the tension."
        )
    for number, remark in enumerate(remarks, start=1):
        yield from _folded(f"Remark {number}: {remark}")


def _missed(model: Model) -> float:
    """Return the largest distance of a curve from an element of it, m; 0 where a line is slack."""
    missed = [0.0]
    for part in model.parts:
        H = part.line.expected.horizontal_force
        for piece in part.pieces if H > 0.0 else ():
            weight = abs(part.types[piece.segment].segment.submerged_weight)
            missed.append(weight * (piece.length / piece.elements) ** 2 / (8.0 * H))
    return max(missed)


def _folded(text: str) -> list[str]:
    """Fold to 100 columns; nothing in it looks like the head of a section."""
    indent = " " * (len(text) - len(text.lstrip()))
    safe = plain(text)
    while "---" in safe:
        safe = safe.replace("---", "--")
    return wrap(
        safe, 100, initial_indent=indent, subsequent_indent=indent + "  ", break_on_hyphens=False
    )


def _line_types(model: Model) -> Iterator[str]:
    yield "--- LINE TYPES ---"
    yield "Name Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx"
    yield "(-) (m) (kg/m) (N) (N-s/-) (N-m2) (-) (-) (-) (-)"
    for each in model.types:
        numbers = [each.body.diameter, each.body.mass, each.segment.EA, -DAMPING, 0.0]
        yield " ".join([each.name, *map(significant, [*numbers, *_coefficients(each)])])


def _coefficients(each: LineType) -> tuple[float, float, float, float]:
    """Cd, Ca, CdAx and CaAx as MoorDyn takes them.

    Drag across refers to Diam, along to pi times Diam; added mass to the displaced water.
    """
    segment = each.segment
    if not _has_drag(segment):
        return DRAG, ADDED_MASS, 0.0, 0.0
    assert segment.drag_diameter is not None
    assert segment.drag_normal is not None
    wider = segment.drag_diameter / each.body.diameter
    added = ADDED_MASS if segment.added_mass_normal is None else segment.added_mass_normal
    return (
        segment.drag_normal * wider,
        added,
        (segment.drag_axial or 0.0) * wider / math.pi,
        segment.added_mass_axial or 0.0,
    )


def _points(model: Model) -> Iterator[str]:
    yield "--- POINTS ---"
    yield "ID Attachment X Y Z Mass Volume CdA Ca"
    yield "(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)"
    number = 0
    for part in model.parts:
        last = len(part.joints) - 1
        for index, (joint, body) in enumerate(zip(part.joints, part.loads, strict=True)):
            number += 1
            x, y, height = part.line.at(joint.arc)
            kind = "Fixed" if index == 0 else "Coupled" if index == last else "Free"
            numbers = (x, y, height - model.surface, body.mass, body.volume, 0.0, 0.0)
            yield " ".join([str(number), kind, *map(significant, numbers)])


def _lines(model: Model) -> Iterator[str]:
    yield "--- LINES ---"
    yield "ID LineType AttachA AttachB UnstrLen NumSegs Outputs"
    yield "(#) (name) (#) (#) (m) (-) (-)"
    number, point = 0, 0
    for part in model.parts:
        for piece in part.pieces:
            number, point = number + 1, point + 1
            name, length = part.types[piece.segment].name, significant(piece.length)
            yield f"{number} {name} {point} {point + 1} {length} {piece.elements} -"
        point += 1


def _options(model: Model) -> Iterator[str]:
    site = model.hung.case.site
    friction = max(line.solution.seabed_friction for line in model.hung.lines)
    yield "--- OPTIONS ---"
    for value, key, words in (
        (0.0, "writeLog", "no log file"),
        (model.step, "dtM", f"time step (s): {STEP:g} of a tension wave through an element"),
        (STANDARD_GRAVITY, "g", "standard gravity (m/s^2)"),
        (site.water_density, "rho", "water density (kg/m^3)"),
        (model.surface, "WtrDpth", "water depth (m)"),
        (model.bed_stiffness, "kBot", "bed stiffness (Pa/m): what lies on it sinks in by 1 mm"),
        (model.bed_damping, "cBot", "bed damping (Pa-s/m): critical"),
        (friction, "FrictionCoefficient", "of line on bed; acts on what moves"),
        (1.0, "ICgenDynamic", "let it come to rest by itself: MoorDyn's other way can stop early"),
        (100.0, "CdScaleIC", "drag while it comes to rest, over that of the line"),
        (1.0, "dtIC", "how long the tensions have to keep still (s)"),
        (1e-7, "threshIC", "how still: largest change over the tension"),
        (600.0, "TmaxIC", "longest time to come to rest (s)"),
    ):
        yield f"{significant(value)} {key} {words}"
    yield "--- END ---"
