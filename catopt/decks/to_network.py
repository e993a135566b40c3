"""From a deck whose lines meet in free points to lines between points."""

from __future__ import annotations

from catopt.decks.chains import check_meeting
from catopt.decks.deck import Deck, Notes
from catopt.decks.to_case import check_depth, friction_of, height_of, say_type, weight_of
from catopt.errors import InputError
from catopt.model import Line, Segment, Site
from catopt.model.network import LineBetween, Network, Point, PointKind

_KIND: dict[str, PointKind] = {"fixed": "anchor", "coupled": "fairlead", "free": "joint"}


def has_joints(deck: Deck) -> bool:
    """Whether more than two lines meet in a free point."""
    ends = [end for piece in deck.pieces for end in piece.ends]
    free = (name for name, point in deck.points.items() if point.end == "free")
    return any(ends.count(name) > 2 for name in free)


def network_of(deck: Deck, notes: Notes, title: str) -> Network:
    """Make every point and every line one of its own; free points are joints.

    Raises InputError with everything that a file of lines with joints cannot say.
    """
    meeting = check_meeting(deck, notes)
    used = {piece.type for piece in deck.pieces}
    friction = friction_of(deck, used, notes)
    points = [point for name, point in deck.points.items() if meeting[name]]
    check_depth(deck, [point for point in points if point.end != "free"], notes)
    notes.raise_if_any()
    for name in dict.fromkeys(piece.type for piece in deck.pieces):
        say_type(deck, name, notes)
    notes.say("at_rest_alone")
    made = []
    for point in points:
        kind = _KIND[point.end]
        if kind == "joint":
            weight = (point.mass - deck.density * point.volume) * deck.gravity
            made.append(Point(point.name, kind, submerged_weight=weight))
        else:
            made.append(Point(point.name, kind, point.x, point.y, height_of(deck, point.z)))
    lines = []
    for number, piece in enumerate(deck.pieces, start=1):
        kind_of = deck.types[piece.type]
        weight = weight_of(deck, kind_of)
        segment = Segment(piece.length, weight, EA=kind_of.EA, MBL=kind_of.MBL, name=piece.type)
        lines.append(LineBetween(Line([segment]), *piece.ends, name=f"{number}"))
    source = f"{notes.source}; g = {deck.gravity:g} m/s^2, water {deck.density:g} kg/m^3"
    site = Site(deck.depth, friction, deck.density)
    try:
        return Network(site, tuple(made), tuple(lines), title, source)
    except InputError as error:
        raise InputError(error.problems, notes.source) from None
