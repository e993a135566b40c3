"""Writes DXF R12, the version that every CAD program reads; a drawing unit is a metre."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

Group = tuple[int, str]
Point = tuple[float, float, float]


def file_text(groups: Iterable[Group]) -> str:
    """Return the text of a file, ASCII."""
    return "".join(f"{code:>3}\n{value}\n" for code, value in groups)


def tables(layers: Mapping[str, int]) -> Iterator[Group]:
    """Yield the sections before the drawing: the version, and layers with their colours."""
    yield from section("HEADER", [(9, "$ACADVER"), (1, "AC1009")])
    types = [
        (0, "TABLE"), (2, "LTYPE"), (70, "1"),
        (0, "LTYPE"), (2, "CONTINUOUS"), (70, "0"), (3, "Solid line"), (72, "65"), (73, "0"),
        (40, "0.0"), (0, "ENDTAB"),
    ]  # fmt: skip
    named: list[Group] = [(0, "TABLE"), (2, "LAYER"), (70, str(len(layers)))]
    for name, colour in layers.items():
        named += [(0, "LAYER"), (2, name), (70, "0"), (62, str(colour)), (6, "CONTINUOUS")]
    named.append((0, "ENDTAB"))
    yield from section("TABLES", [*types, *named])


def section(name: str, groups: Iterable[Group]) -> Iterator[Group]:
    """Yield a section with what it holds."""
    yield 0, "SECTION"
    yield 2, name
    yield from groups
    yield 0, "ENDSEC"


def polyline(
    layer: str, points: Iterable[Point], *, in_space: bool = False, closed: bool = False
) -> Iterator[Group]:
    """Draw a polyline; R12 wants every vertex as an entity, and 8 and 32 for one in space."""
    flags = (8 if in_space else 0) + (1 if closed else 0)
    head: list[Group] = [(66, "1"), *_xyz((0.0, 0.0, 0.0)), (70, str(flags))]
    yield from _entity("POLYLINE", layer, head)
    for place in points:
        flag: list[Group] = [(70, "32")] if in_space else []
        yield from _entity("VERTEX", layer, [*_xyz(place), *flag])
    yield from _entity("SEQEND", layer, [])


def point(layer: str, place: Point) -> Iterator[Group]:
    """Draw a point, to snap to."""
    yield from _entity("POINT", layer, _xyz(place))


def circle(layer: str, place: Point, radius: float) -> Iterator[Group]:
    """Draw a circle round a place; m."""
    yield from _entity("CIRCLE", layer, [*_xyz(place), (40, _number(radius))])


def text(
    layer: str, place: Point, words: str, height: float, angle: float = 0.0
) -> Iterator[Group]:
    """Write a text that begins at a place; m, and rad counter-clockwise from x."""
    one_line = " ".join(words.split())
    # In ASCII, other letters by their numbers as CAD programs read them.
    ascii_text = "".join(each if each.isascii() else f"\\U+{ord(each):04X}" for each in one_line)
    turn = [(50, _number(math.degrees(angle)))] if angle else []
    yield from _entity("TEXT", layer, [*_xyz(place), (40, _number(height)), (1, ascii_text), *turn])


WIDE = 0.9
"""Of a letter over its height: CAD programs' own fonts are no wider."""


def box(rows: Sequence[Sequence[str]], corner: Point, height: float) -> Iterator[Group]:
    """Draw a title block of rows with a heading and a text, its upper left corner at a place."""
    x, top, z = corner
    ends = [0.0]
    for column in zip(*rows, strict=True):
        ends.append(ends[-1] + (max(map(len, column)) + 2) * WIDE * height)
    tall = 2.0 * height
    for number in range(len(rows) + 1):
        y = top - number * tall
        yield from polyline("TITLE", ((x, y, z), (x + ends[-1], y, z)))
    for end in ends:
        yield from polyline("TITLE", ((x + end, top, z), (x + end, top - len(rows) * tall, z)))
    for number, row in enumerate(rows, start=1):
        for end, words in zip(ends, row, strict=False):
            place = (x + end + WIDE * height, top - (number - 0.25) * tall, z)
            yield from text("TITLE", place, words, height)


def _entity(kind: str, layer: str, groups: Iterable[Group]) -> Iterator[Group]:
    yield 0, kind
    yield 8, layer
    yield from groups


def _xyz(place: Point) -> Iterator[Group]:
    for code, value in zip((10, 20, 30), place, strict=True):
        yield code, _number(value)


def _number(value: float) -> str:
    """Return a length to the micrometre, a zero without sign."""
    return f"{round(value, 6) + 0.0:.6f}"
