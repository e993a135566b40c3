"""From a deck whose lines meet in free points to lines between points."""

from __future__ import annotations

from catopt.decks.chains import check_meeting
from catopt.decks.deck import Deck, Notes
from catopt.decks.to_case import height_of, hung_weight, site_of, weight_of
from catopt.errors import InputError
from catopt.model import Line, Segment
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
    points = [point for name, point in deck.points.items() if meeting[name]]
    ends = [point for point in points if point.end != "free"]
    site, source = site_of(deck, deck.pieces, ends, notes)
    notes.say("at_rest_alone")
    made = []
    for point in points:
        kind = _KIND[point.end]
        if kind == "joint":
            made.append(Point(point.name, kind, submerged_weight=hung_weight(deck, point)))
        else:
            made.append(Point(point.name, kind, point.x, point.y, height_of(deck, point.z)))
    lines = []
    for number, piece in enumerate(deck.pieces, start=1):
        kind_of = deck.types[piece.type]
        weight = weight_of(deck, kind_of)
        segment = Segment(piece.length, weight, EA=kind_of.EA, MBL=kind_of.MBL, name=piece.type)
        lines.append(LineBetween(Line([segment]), *piece.ends, name=f"{number}"))
    try:
        return Network(site, tuple(made), tuple(lines), title, source)
    except InputError as error:
        raise InputError(error.problems, notes.source) from None
