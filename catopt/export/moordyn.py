"""A MoorDyn input file (version 2), which MoorPy reads too.

MoorDyn takes the mass in air and the volume-equivalent diameter of a line; its weight in water
follows from them. Heights count from the still water surface. Everything that is said beside the
numbers stands before the first section, where both programs pass over it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from catopt.decks.deck import Deck
from catopt.export.export_result import Exported, Source, exported, heading, significant
from catopt.export.exported_line import ExportedLines
from catopt.export.moordyn_model import ELEMENTS, ROUNDING, Model, model_of, remarks_of, resting
from catopt.export.programs import deck_of, named_points, refuse_forces

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
    refuse_forces(model, "MoorDyn")
    deck = deck_of(model)
    lines = [
        *_header(model, deck, remarks, sources),
        *_line_types(deck),
        *_points(deck),
        *_lines(deck, model),
        *_options(deck, model),
    ]
    return exported("moordyn", solved, "\n".join(lines) + "\n", remarks, sources)


def _header(
    model: Model, deck: Deck, remarks: Sequence[str], sources: Sequence[Source]
) -> Iterator[str]:
    """Yield what stands before the first section: neither program reads it."""
    own = [
        "Diam is the volume-equivalent diameter: that of a cylinder with the line's volume, from "
        "mass in air less submerged weight over g, over the water's density. It is not the nominal "
        "diameter of chain or rope. Heights count from the water surface. Fairleads are Coupled "
        "points at rest: run without moving them, and compare the force on them."
    ]
    own += named_points(model, deck)
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
            weight = abs(piece.type.segment.submerged_weight)
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
        numbers = map(significant, (each.x, each.y, each.z, *each.body))
        yield " ".join([each.name, each.end.capitalize(), *numbers])


def _lines(deck: Deck, model: Model) -> Iterator[str]:
    yield "--- LINES ---"
    yield "ID LineType AttachA AttachB UnstrLen NumSegs Outputs"
    yield "(#) (name) (#) (#) (m) (-) (-)"
    for number, (piece, cut) in enumerate(zip(deck.pieces, model.pieces, strict=True), start=1):
        ends = " ".join(piece.ends)
        yield f"{number} {piece.type} {ends} {significant(piece.length)} {cut.elements} -"


def _options(deck: Deck, model: Model) -> Iterator[str]:
    stiffness = _bed_stiffness(model)
    step, damping = _step(model, stiffness), _bed_damping(model, stiffness)
    of_step = f"time step (s): {STEP:g} of a tension wave through an element"
    yield "--- OPTIONS ---"
    for value, key, words in (
        (0.0, "writeLog", "no log file"),
        (_rounded_down(step), "dtM", of_step),
        (deck.gravity, "g", "standard gravity (m/s^2)"),
        (deck.density, "rho", "water density (kg/m^3)"),
        (deck.depth, "WtrDpth", "water depth (m)"),
        (stiffness, "kBot", "bed stiffness (Pa/m): what lies on it sinks in by 1 mm"),
        (_rounded_down(damping), "cBot", "bed damping (Pa-s/m): critical"),
        (deck.friction or 0.0, "FrictionCoefficient", "of line on bed; acts on what moves"),
        (1.0, "ICgenDynamic", "let it come to rest by itself: MoorDyn's other way can stop early"),
        (100.0, "CdScaleIC", "drag while it comes to rest, over that of the line"),
        (1.0, "dtIC", "how long the tensions have to keep still (s)"),
        (1e-7, "threshIC", "how still: largest change over the tension"),
        (600.0, "TmaxIC", "longest time to come to rest (s)"),
    ):
        yield f"{significant(value)} {key} {words}"
    yield "--- END ---"


def _bed_stiffness(model: Model) -> float:
    """Return a stiffness by which lines, and weights that lie on the bed, sink in by 1 mm."""
    wanted = [
        each.segment.submerged_weight / (each.body.diameter * SINKING) for each in model.types
    ]
    for reaction, pieces in resting(model):
        area = sum(
            0.5 * piece.length / piece.elements * piece.type.body.diameter for piece in pieces
        )
        wanted.append(reaction / (area * SINKING))
    largest = max(wanted)
    if largest <= 0.0:
        return OWN_STIFFNESS
    unit = _unit(largest)
    return math.ceil(largest / unit * (1.0 - ROUNDING)) * unit


def _bed_damping(model: Model, stiffness: float) -> float:
    """Return what is critical for the line that is the lightest for its diameter."""
    return min(
        2.0 * math.sqrt(stiffness * each.body.mass / each.body.diameter) for each in model.types
    )


def _step(model: Model, stiffness: float) -> float:
    """Return a step at which neither the line's nor the bed's springs make the run unstable."""
    times = []
    for piece in model.pieces:
        kind, element = piece.type, piece.length / piece.elements
        times.append(element * math.sqrt(kind.body.mass / kind.segment.EA))
        times.append(math.sqrt(kind.body.mass / (stiffness * kind.body.diameter)))
    return STEP * min(times)


def _rounded_down(value: float) -> float:
    """Round to two significant digits, towards 0."""
    unit = _unit(value)
    return math.floor(value / unit * (1.0 + ROUNDING)) * unit


def _unit(value: float) -> float:
    """Return what the second significant digit counts."""
    scale: float = 10.0 ** (math.floor(math.log10(value)) - 1)
    return scale
