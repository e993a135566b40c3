"""A MoorDyn input file (version 2), which MoorPy reads too.

MoorDyn takes the mass in air and the volume-equivalent diameter of a line; its weight in water
follows from them. Heights count from the still water surface. Everything that is said beside the
numbers stands before the first section, where both programs pass over it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from textwrap import wrap

from catopt._version import __version__
from catopt.constants import STANDARD_GRAVITY
from catopt.export.expected import expected, in_words
from catopt.export.exported import Exported, Source
from catopt.export.exported_line import ExportedLines
from catopt.export.moordyn_model import DAMPING, ELEMENTS, STEP, LineType, Model, model_of
from catopt.export.moordyn_remarks import ADDED_MASS, DRAG, has_drag, remarks_of
from catopt.export.text import plain, significant


def moordyn_input(
    solved: ExportedLines,
    *,
    elements: int = ELEMENTS,
    true_depth: bool = False,
    sources: Sequence[Source] = (),
) -> Exported:
    """Write lines as the input of MoorDyn.

    `solved`: the lines where they hang; every segment has an EA; `true_depth`: whether the water
    ends where it does in the case, even if a line reaches above it. Raises InputError when a
    segment does not stretch, or its mass is missing or too small, with every one at once.
    """
    model = model_of(solved, elements=elements, true_depth=true_depth)
    remarks = tuple(remarks_of(model))
    lines = [
        *_header(model, remarks, sources),
        *_line_types(model),
        *_points(model),
        *_lines(model),
        *_options(model),
    ]
    return Exported(
        "moordyn",
        solved.case.title,
        "\n".join(lines) + "\n",
        remarks,
        tuple(expected(line) for line in solved.lines),
        tuple(sources),
    )


def _header(model: Model, remarks: Sequence[str], sources: Sequence[Source]) -> Iterator[str]:
    """Yield what stands before the first section: neither program reads it."""
    solved = model.solved
    yield f"MoorDyn v2 input file, also read by MoorPy; written by catopt {__version__}"
    if solved.case.title:
        yield from _folded(f"Case: {solved.case.title}")
    for source in sources:
        yield from _folded(f"From {source.name}, SHA-256 {source.sha256}")
    yield ""
    for line in in_words(solved):
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
    if not has_drag(segment):
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
            of_body = (body.mass, body.volume, body.drag_area, body.added_mass)
            numbers = (x, y, height - model.surface, *of_body)
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
    site = model.solved.case.site
    friction = max(line.solution.seabed_friction for line in model.solved.lines)
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
