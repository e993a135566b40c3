"""A MoorDyn input file (version 2), which MoorPy reads too.

MoorDyn takes the mass in air and the volume-equivalent diameter of a line; its weight in water
follows from them. Heights count from the still water surface. Everything that is said beside the
numbers stands before the first section, where both programs pass over it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from catopt.constants import STANDARD_GRAVITY
from catopt.decks.deck import Deck
from catopt.export.deck import deck_of
from catopt.export.expected import expected, heading
from catopt.export.exported import Exported, Source
from catopt.export.exported_line import ExportedLines
from catopt.export.moordyn_model import DAMPING, ELEMENTS, STEP, Model, model_of
from catopt.export.moordyn_remarks import remarks_of
from catopt.export.text import significant


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
    deck = deck_of(model)
    lines = [
        *_header(model, remarks, sources),
        *_line_types(deck),
        *_points(deck),
        *_lines(deck, model),
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
    own = [
        "Diam is the volume-equivalent diameter: that of a cylinder with the line's volume, from "
        "mass in air less submerged weight over g, over the water's density. It is not the nominal "
        "diameter of chain or rope. Heights count from the water surface. Fairleads are Coupled "
        "points at rest: run without moving them, and compare the force on them."
    ]
    missed = _missed(model)
    if missed > 0.0:
        own.append(
            f"MoorDyn's straight elements miss the curve by up to w l^2 / (8 H) = {missed:.2g} m, "
            "as if a fairlead were that much higher or lower. Halve them (--elements) to see what "
            "it does to the tension."
        )
    first = "MoorDyn v2 input file, also read by MoorPy"
    yield from heading(first, model.solved, own, remarks, sources)


def _missed(model: Model) -> float:
    """Return the largest distance of a curve from an element of it, m; 0 where a line is slack."""
    missed = [0.0]
    for part in model.parts:
        H = part.line.expected.horizontal_force
        for piece in part.pieces if H > 0.0 else ():
            weight = abs(part.types[piece.segment].segment.submerged_weight)
            missed.append(weight * (piece.length / piece.elements) ** 2 / (8.0 * H))
    return max(missed)


def _line_types(deck: Deck) -> Iterator[str]:
    yield "--- LINE TYPES ---"
    yield "Name Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx"
    yield "(-) (m) (kg/m) (N) (N-s/-) (N-m2) (-) (-) (-) (-)"
    for name, kind in deck.types.items():
        assert kind.drag is not None
        across, along, added, added_along = kind.drag
        numbers = [kind.diameter, kind.mass, kind.EA, -DAMPING, 0.0]
        coefficients = [across, added, along, added_along]
        yield " ".join([name, *map(significant, [*numbers, *coefficients])])


def _points(deck: Deck) -> Iterator[str]:
    yield "--- POINTS ---"
    yield "ID Attachment X Y Z Mass Volume CdA Ca"
    yield "(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)"
    for each in deck.points.values():
        of_body = (each.mass, each.volume, each.drag_area, each.added_mass)
        numbers = map(significant, (each.x, each.y, each.z, *of_body))
        yield " ".join([each.name, each.end.capitalize(), *numbers])


def _lines(deck: Deck, model: Model) -> Iterator[str]:
    yield "--- LINES ---"
    yield "ID LineType AttachA AttachB UnstrLen NumSegs Outputs"
    yield "(#) (name) (#) (#) (m) (-) (-)"
    elements = (piece.elements for part in model.parts for piece in part.pieces)
    for number, (piece, count) in enumerate(zip(deck.pieces, elements, strict=True), start=1):
        ends = " ".join(piece.ends)
        yield f"{number} {piece.type} {ends} {significant(piece.length)} {count} -"


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
