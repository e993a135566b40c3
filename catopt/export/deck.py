"""What is written for another program, as the deck that its reader makes of it."""

from __future__ import annotations

import math

from catopt.constants import STANDARD_GRAVITY
from catopt.decks.deck import Deck, DeckPiece, End, LineType, Point
from catopt.export.moordyn_model import ADDED_MASS, DRAG, ROUNDING, Model, has_drag
from catopt.export.moordyn_model import LineType as Kind


def deck_of(model: Model) -> Deck:
    """Turn cut lines into a deck: types, points from 1 on, and the pieces between them."""
    friction = max(line.solution.seabed_friction for line in model.solved.lines)
    points: dict[str, Point] = {}
    pieces: list[DeckPiece] = []
    for part in model.parts:
        last = len(part.joints) - 1
        for index, joint in enumerate(part.joints):
            name, body = str(len(points) + 1), joint.body
            x, y, height = part.line.at(joint.arc)
            # Without rounding at the water and at the bed: MoorPy lets a line weigh more whose end
            # is 1e-15 m above the water.
            z = height - model.surface
            levels = (0.0, -model.surface)
            z = next((each for each in levels if abs(z - each) <= ROUNDING * model.surface), z)
            end: End = "fixed" if index == 0 else "coupled" if index == last else "free"
            of_body = (body.mass, body.volume, body.drag_area, body.added_mass)
            points[name] = Point(0, name, end, x, y, z, *of_body)
        first = len(points) - last
        for number, piece in enumerate(part.pieces, start=first):
            ends = (str(number), str(number + 1))
            pieces.append(DeckPiece(0, piece.type.name, ends, piece.length))
    types = {each.name: _line_type(each, friction) for each in model.types}
    density = model.solved.case.site.water_density
    return Deck(STANDARD_GRAVITY, density, model.surface, types, points, pieces, friction)


def _line_type(each: Kind, friction: float) -> LineType:
    """Put drag on the volume-equivalent diameter, and along the line on pi times that."""
    segment, body = each.segment, each.body
    drag = DRAG, 0.0, ADDED_MASS, 0.0
    if has_drag(segment):
        assert segment.drag_diameter is not None
        assert segment.drag_normal is not None
        wider = segment.drag_diameter / body.diameter
        drag = (
            segment.drag_normal * wider,
            (segment.drag_axial or 0.0) * wider / math.pi,
            ADDED_MASS if segment.added_mass_normal is None else segment.added_mass_normal,
            segment.added_mass_axial or 0.0,
        )
    own = (segment.MBL, segment.nominal_diameter)
    return LineType(0, body.diameter, body.mass, segment.EA, friction, drag, *own)
