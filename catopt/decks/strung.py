"""Lines of a deck: pieces from point to point, and sections in order with what hangs on them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from catopt.decks.deck import Deck, DeckPiece, Notes, Point, refusal


@dataclass(frozen=True)
class Chain:
    """A mooring line of a deck, from its anchor to its fairlead; one point more than pieces."""

    points: Sequence[Point]
    pieces: Sequence[DeckPiece]

    @property
    def anchor(self) -> Point:
        """The lower end, or the fixed one."""
        return self.points[0]

    @property
    def fairlead(self) -> Point:
        """The other end."""
        return self.points[-1]


def chains_of(deck: Deck, notes: Notes, only: int | None = None) -> list[Chain]:
    """Follow the pieces of a deck; what is no chain is noted.

    `only`: the one line that is wanted, counted from 1. Raises InputError with everything that is
    no line between two ends.
    """
    meeting = check_meeting(deck, notes)
    _refuse_joints(deck, meeting, notes)
    notes.raise_if_any()
    left = list(deck.pieces)
    found = []
    while left:
        start = next((p for p in left if _held(deck, p) is not None), None)
        if start is None:
            notes.refuse(left[0].row, refusal("in_a_circle"), "nothing_holds")
            break
        found.append(_oriented(_follow(deck, start, left)))
    if only is not None and not 1 <= only <= len(found):
        notes.refuse(0, f"--line {only}", "lines_are", count=len(found))
    elif only is not None:
        if len(found) > 1:
            notes.say("only", number=only, count=len(found))
        found = [found[only - 1]]
    notes.raise_if_any()
    return found


def check_meeting(deck: Deck, notes: Notes) -> dict[str, list[DeckPiece]]:
    """List the lines that meet in every point; a free one that holds nothing is refused."""
    meeting = _meeting(deck, notes)
    notes.raise_if_any()
    for name, pieces in meeting.items():
        point = deck.points[name]
        if not pieces:
            notes.say("unattached", line=point.row, name=name)
        elif point.end == "free" and len(pieces) == 1 and not _is_pulled(deck, point):
            notes.refuse(point.row, refusal("point", name=name), "nothing_holds_end")
        elif point.end != "free" and (point.mass or point.volume):
            notes.say("held_mass", line=point.row, name=name)
    return meeting


def _refuse_joints(deck: Deck, meeting: Mapping[str, Sequence[DeckPiece]], notes: Notes) -> None:
    """Refuse a free point that does not hang in one line, of which one alone is wanted."""
    for name, pieces in meeting.items():
        if pieces and is_joint(deck.points[name], len(pieces)):
            found = refusal("point_of_lines", name=name, count=len(pieces))
            notes.refuse(deck.points[name].row, found, "joint")


def is_joint(point: Point, lines: int) -> bool:
    """Whether a point in which so many lines end is one of its own, and no load on one line."""
    return point.end == "free" and (lines != 2 or any(point.force))


def _is_pulled(deck: Deck, point: Point) -> bool:
    along, across, up = point.force
    return up > deck.hung_weight(point) or along != 0.0 or across != 0.0


def _meeting(deck: Deck, notes: Notes) -> dict[str, list[DeckPiece]]:
    found: dict[str, list[DeckPiece]] = {name: [] for name in deck.points}
    for piece in deck.pieces:
        if piece.type not in deck.types:
            kind, known = refusal("line_type", name=piece.type), ", ".join(deck.types)
            notes.refuse(piece.row, kind, "none_of_known", known=known)
        for end in piece.ends:
            if end in found:
                found[end].append(piece)
            elif end:
                notes.refuse(piece.row, refusal("point", name=end), "no_such_point")
        if piece.ends[0] == piece.ends[1]:
            notes.refuse(piece.row, refusal("point_twice", name=piece.ends[0]), "two_points")
    return found


def _held(deck: Deck, piece: DeckPiece) -> str | None:
    return next((end for end in piece.ends if deck.points[end].end != "free"), None)


def _follow(deck: Deck, piece: DeckPiece, left: list[DeckPiece]) -> Chain:
    """Take the pieces of one chain out of those that are left."""
    name = _held(deck, piece)
    assert name is not None
    points, pieces = [deck.points[name]], []
    while True:
        left.remove(piece)
        pieces.append(piece)
        name = piece.ends[1] if piece.ends[0] == name else piece.ends[0]
        points.append(deck.points[name])
        if deck.points[name].end != "free":
            return Chain(points, pieces)
        piece = next(each for each in left if name in each.ends)


def _oriented(chain: Chain) -> Chain:
    """Begin at the anchor: the fixed end, or of two alike the lower one."""
    ends = chain.anchor, chain.fairlead
    turn = ends[0].end == "coupled" and ends[1].end == "fixed"
    if ends[0].end == ends[1].end:
        turn = ends[1].z < ends[0].z
    if not turn:
        return chain
    return replace(chain, points=chain.points[::-1], pieces=chain.pieces[::-1])


@dataclass(frozen=True)
class DeckSection:
    """A uniform stretch: line of the file, line type and unstretched length, m."""

    row: int
    type: str
    length: float


@dataclass(frozen=True)
class PointMass:
    """What hangs between two sections: kg, m3, Cd A in m2, and Ca."""

    row: int
    mass: float
    volume: float
    drag_area: float = 0.0
    added_mass: float = 0.0


def from_sections(
    name: str, ends: tuple[Point, Point], parts: Sequence[DeckSection | PointMass]
) -> tuple[dict[str, Point], list[DeckPiece]]:
    """Turn a line into points ``NAME.1`` and so on and pieces, both from its first end.

    `ends`: where it is held; their own names do not count.
    """
    first, last = ends
    total = sum(part.length for part in parts if isinstance(part, DeckSection)) or 1.0
    points, pieces, arc = [replace(first, name=f"{name}.1")], list[DeckPiece](), 0.0
    for part in parts:
        if isinstance(part, DeckSection):
            arc += part.length
            along = arc / total  # where it begins to be sought does not matter
            x, y, z = (
                a + along * (b - a)
                for a, b in zip((first.x, first.y, first.z), (last.x, last.y, last.z), strict=True)
            )
            points.append(Point(part.row, f"{name}.{len(points) + 1}", "free", x, y, z))
            between = (points[-2].name, points[-1].name)
            pieces.append(DeckPiece(part.row, part.type, between, part.length))
        else:
            points[-1] = _with(points[-1], part)
    end = points[-1]
    if pieces:
        body = (end.mass, end.volume, end.drag_area, end.added_mass)
        points[-1] = Point(last.row, end.name, last.end, last.x, last.y, last.z, *body)
    return {point.name: point for point in points}, pieces


def _with(point: Point, hung: PointMass) -> Point:
    """Hang something at a point, beside what hangs there already."""
    volume = point.volume + hung.volume
    added = point.volume * point.added_mass + hung.volume * hung.added_mass
    return replace(
        point,
        row=hung.row,
        mass=point.mass + hung.mass,
        volume=volume,
        drag_area=point.drag_area + hung.drag_area,
        added_mass=added / volume if volume else 0.0,
    )
