"""A line of a deck that is written as sections in order, with what hangs between them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from catopt.decks.deck import Piece, Point


@dataclass(frozen=True)
class Section:
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
    name: str, ends: tuple[Point, Point], parts: Sequence[Section | PointMass]
) -> tuple[dict[str, Point], list[Piece]]:
    """Turn a line into points ``NAME.1`` and so on and pieces, both from its first end.

    `ends`: where it is held; their own names do not count.
    """
    first, last = ends
    total = sum(part.length for part in parts if isinstance(part, Section)) or 1.0
    points, pieces, arc = [replace(first, name=f"{name}.1")], list[Piece](), 0.0
    for part in parts:
        if isinstance(part, Section):
            arc += part.length
            along = arc / total  # where it begins to be sought does not matter
            x, y, z = (
                a + along * (b - a)
                for a, b in zip((first.x, first.y, first.z), (last.x, last.y, last.z), strict=True)
            )
            points.append(Point(part.row, f"{name}.{len(points) + 1}", "free", x, y, z))
            between = (points[-2].name, points[-1].name)
            pieces.append(Piece(part.row, part.type, between, part.length))
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
