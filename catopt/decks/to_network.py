"""From a deck whose lines meet in free points, or differ, to lines between points."""

from __future__ import annotations

from collections.abc import Sequence

from catopt.decks.chains import Chain, check_meeting, is_joint
from catopt.decks.deck import Deck, Notes
from catopt.decks.to_case import height_of, site_of, site_of_chains, weight_of
from catopt.errors import InputError
from catopt.model import Line, Segment, Site
from catopt.model.network import LineBetween, Network, Point, PointKind

_KIND: dict[str, PointKind] = {"fixed": "anchor", "coupled": "fairlead", "free": "joint"}


def has_joints(deck: Deck) -> bool:
    """Whether a free point is more than what hangs between two lines."""
    ends = [end for piece in deck.pieces for end in piece.ends]
    return any(
        is_joint(point, ends.count(name)) for name, point in deck.points.items() if name in ends
    )


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
            weight = deck.hung_weight(point)
            made.append(Point(point.name, kind, submerged_weight=weight, force=point.force))
        else:
            made.append(Point(point.name, kind, point.x, point.y, height_of(deck, point.z)))
    lines = []
    for number, piece in enumerate(deck.pieces, start=1):
        kind_of = deck.types[piece.type]
        weight = weight_of(deck, kind_of)
        segment = Segment(piece.length, weight, EA=kind_of.EA, MBL=kind_of.MBL, name=piece.type)
        lines.append(LineBetween(Line([segment]), *piece.ends, name=f"{number}"))
    return _network(site, made, lines, title, source, notes)


def network_of_lines(
    deck: Deck, chains: Sequence[Chain], lines: Sequence[Line], notes: Notes, title: str
) -> Network:
    """Put every line between its own two points, for lines that are not alike or not radial."""
    site, source = site_of_chains(deck, chains, notes)
    notes.say("apart", lines=len(lines))
    ends = {point.name: point for c in chains for point in (c.anchor, c.fairlead)}
    points = [
        Point(point.name, _KIND[point.end], point.x, point.y, height_of(deck, point.z))
        for point in ends.values()
    ]
    between = [
        LineBetween(line, chain.anchor.name, chain.fairlead.name, name=f"{number}")
        for number, (line, chain) in enumerate(zip(lines, chains, strict=True), start=1)
    ]
    return _network(site, points, between, title, source, notes)


def _network(
    site: Site,
    points: Sequence[Point],
    lines: Sequence[LineBetween],
    title: str,
    source: str,
    notes: Notes,
) -> Network:
    try:
        return Network(site, tuple(points), tuple(lines), title, source)
    except InputError as error:
        raise InputError(error.problems, notes.source) from None
