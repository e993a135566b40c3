"""A drawing of the lines as DXF R12, the version that every CAD program reads.

One line is drawn in its own plane: x from the anchor, y above the bed. Several lines of a body are
drawn in space: x, y, and z above the bed. A drawing unit is a metre.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from textwrap import wrap
from types import MappingProxyType

from catopt._version import identity
from catopt.catenary.layout import Profile, end_of
from catopt.catenary.solution import Solution
from catopt.export.export_result import (
    Exported,
    ExportedLine,
    ExportedLines,
    Source,
    exported,
    heading,
)

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


def polyline(layer: str, points: Iterable[Point], *, in_space: bool) -> Iterator[Group]:
    """Draw an open polyline; R12 wants every vertex as an entity, and 8 and 32 for one in space."""
    head: list[Group] = [(66, "1"), *_xyz((0.0, 0.0, 0.0)), (70, "8" if in_space else "0")]
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


def text(layer: str, place: Point, words: str, height: float) -> Iterator[Group]:
    """Write a text that begins at a place; m."""
    one_line = " ".join(words.split())
    # In ASCII, other letters by their numbers as CAD programs read them.
    ascii_text = "".join(each if each.isascii() else f"\\U+{ord(each):04X}" for each in one_line)
    yield from _entity("TEXT", layer, [*_xyz(place), (40, _number(height)), (1, ascii_text)])


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


LAYERS = MappingProxyType(
    {
        "BED": 34,
        "WATER": 5,
        "LINE": 7,
        "ANCHOR": 1,
        "FAIRLEAD": 3,
        "TOUCHDOWN": 6,
        "CLUMP_WEIGHTS": 30,
        "BUOYS": 4,
        "JOINTS": 8,
        "BODY": 3,
        "TEXT": 7,
    }
)
"""Layers with their colours, as AutoCAD numbers them; those that hold nothing are there too."""

POINTS = 201
"""Of a line, about; every joint and touchdown is among them."""

TEXT_SIZE, MARK_SIZE = 0.012, 0.004
"""Height of a text and radius of a mark over the size of the drawing."""

COLUMNS = 100
"""Letters in a row of text; R12 takes 255 of them, and 7 for one that is not ASCII."""

ROW = 1.6
"""From one row of text to the next, over its height."""


@dataclass(frozen=True)
class Drawing:
    """How a line's points come onto the drawing.

    `solved`: what is drawn; `size`: the longest span or length of a line, m.
    """

    solved: ExportedLines
    size: float

    @property
    def in_space(self) -> bool:
        """Whether z is the height; on a drawing of one line it is y."""
        return self.solved.system is not None

    @property
    def text_height(self) -> float:
        """Height of a text, m."""
        return TEXT_SIZE * self.size

    def at(self, line: ExportedLine, distance: float, height: float) -> Point:
        """Place a point of a line's plane."""
        return line.in_space(distance, height) if self.in_space else (distance, height, 0.0)

    def beside(self, place: Point, row: int) -> Point:
        """Place a text beside a mark: in rows above it, from 0, or below it, from -1."""
        x, y, z = place
        right = 1.5 * MARK_SIZE * self.size
        up = row * ROW + (0.6 if row >= 0 else 0.2)
        return x + right, y + up * self.text_height, z


@dataclass(frozen=True)
class Mark:
    """Something on a line.

    `layer`: one of LAYERS; `distance`, `height`: from the anchor, and above the bed, m; `row`:
    where the words stand (`Drawing.beside`).
    """

    layer: str
    distance: float
    height: float
    words: str
    row: int = 0


def dxf_drawing(solved: ExportedLines, *, sources: Sequence[Source] = ()) -> Exported:
    """Draw lines where they hang."""
    size = max(max(line.solution.span, line.solution.line.length) for line in solved.lines)
    sheet = Drawing(solved, size)
    remarks = tuple(_remarks(solved))
    said = heading("DXF R12 drawing in metres", solved, (), remarks, sources)
    groups: list[Group] = [
        *((999, line.strip()) for line in said if line.strip()),  # CAD programs pass over comments
        *tables(LAYERS),
        *section("ENTITIES", _entities(sheet, remarks)),
        (0, "EOF"),
    ]
    return exported("dxf", solved, file_text(groups), remarks, sources)


def _remarks(solved: ExportedLines) -> Iterator[str]:
    yield from solved.warnings
    if solved.EA is not None:
        yield f"drawn with the EA of {solved.EA:.6g} N that was given, not as the case has it"
    if any(line.solution.regime == "slack" for line in solved.lines):
        yield "what lies in bights on the bed is drawn straight"


def _entities(sheet: Drawing, remarks: Sequence[str]) -> Iterator[Group]:
    if not sheet.in_space:
        # Draw the bed and the still water, both a tenth of the length beyond the line.
        over, span = 0.1 * sheet.size, sheet.solved.lines[0].solution.span
        depth = sheet.solved.case.site.water_depth
        for layer, height, words in (
            ("BED", 0.0, "bed"),
            ("WATER", depth, f"still water, {depth:.6g} m above the bed"),
        ):
            ends = ((-over, height, 0.0), (span + over, height, 0.0))
            yield from polyline(layer, ends, in_space=False)
            beside = (-over, height + 0.5 * sheet.text_height, 0.0)
            yield from text("TEXT", beside, words, sheet.text_height)
    for line in sheet.solved.lines:
        # Draw every segment as a polyline of its own.
        solution = line.solution
        profile = solution.profile(POINTS)
        start = 0.0
        for segment in solution.line.segments:
            places = _between(profile, start, start + segment.length, 1e-9 * solution.line.length)
            start += segment.length
            points = [sheet.at(line, *place) for place in places]
            yield from polyline("LINE", points, in_space=sheet.in_space)
        for mark in _marks(line, in_space=sheet.in_space):
            yield from _drawn(sheet, mark, sheet.at(line, mark.distance, mark.height))
    system = sheet.solved.system
    if system is not None:
        # Mark the body's origin at the height of the first fairlead.
        height = sheet.solved.lines[0].solution.fairlead_height
        words = f"body under {_force(math.hypot(*system.system.force))}"
        mark = Mark("BODY", 0.0, height, words)
        yield from _drawn(sheet, mark, (system.position.x, system.position.y, height))
    yield from _legend(sheet, remarks)


def _between(
    profile: Profile, start: float, end: float, close: float
) -> Iterator[tuple[float, float]]:
    """Yield the points of a segment; where the tension jumps the profile has them twice."""
    last = -math.inf
    for s, x, z in zip(profile.s, profile.x, profile.z, strict=True):
        if start - close <= s <= end + close and s - last > close:
            last = s
            yield x, z


def _marks(line: ExportedLine, *, in_space: bool) -> Iterator[Mark]:
    """Yield what there is on a line; of several lines, only the anchors bear words."""
    solution = line.solution
    at_anchor = f"{line.name if in_space else 'anchor'}, {_force(solution.anchor.tension)}"
    yield Mark("ANCHOR", 0.0, solution.anchor_height, at_anchor, -1)
    for distance, height in _touchdowns(solution):
        words = "" if in_space else f"touchdown, {distance:.2f} m"
        yield Mark("TOUCHDOWN", distance, height, words, -2)
    for state, load in zip(solution.point_loads, solution.line.point_loads, strict=True):
        layer, what = "CLUMP_WEIGHTS", "clump weight"
        if load.submerged_weight < 0.0:
            layer, what = "BUOYS", "buoy"
        words = f"{load.name or what}, {_force(load.submerged_weight)} in water"
        yield Mark(layer, state.x, state.z, "" if in_space else words)
    for arc, words in _joints(solution):
        row = sum(abs(load.position - arc) < 0.02 * solution.line.length
                  for load in solution.line.point_loads)  # fmt: skip
        distance, height = line.in_plane(arc)
        yield Mark("JOINTS", distance, height, "" if in_space else words, row)
    at_fairlead = "" if in_space else f"fairlead, {_force(solution.fairlead.tension)}"
    yield Mark("FAIRLEAD", solution.span, solution.fairlead_height, at_fairlead)


def _touchdowns(solution: Solution) -> Iterator[tuple[float, float]]:
    """Yield where the line comes down to the bed: towards a raised anchor and the fairlead."""
    lying = [stretch for stretch in solution.stretches if stretch.on_bed]
    if not lying:
        return
    if lying[0] is not solution.stretches[0]:
        yield lying[0].x, lying[0].z
    if lying[-1] is not solution.stretches[-1]:
        yield end_of(lying[-1], lying[-1].length)


def _joints(solution: Solution) -> Iterator[tuple[float, str]]:
    """Yield where segments meet, with both their names."""
    arc = 0.0
    for lower, upper in pairwise(solution.line.segments):
        arc += lower.length
        yield arc, f"{lower.name} / {upper.name}" if lower.name and upper.name else "joint"


def _legend(sheet: Drawing, remarks: Sequence[str]) -> Iterator[Group]:
    """Write title, units and answers below the drawing."""
    rows = [sheet.solved.case.title, "Drawing units are metres; heights are above the bed."]
    for line in sheet.solved.lines:
        solution = line.solution
        rows.append(
            f"{line.name}: span {solution.span:.3f} m, H {_force(solution.horizontal_force)}, "
            f"fairlead tension {_force(solution.fairlead.tension)}"
        )
    rows.append(f"catopt {identity()}")
    for remark in remarks:
        rows += wrap(f"Remark: {remark}", COLUMNS, subsequent_indent="  ", break_on_hyphens=False)
    lowest = min(line.anchor[1] for line in sheet.solved.lines) if sheet.in_space else 0.0
    for number, row in enumerate((row for row in rows if row), start=4):
        place = sheet.beside((0.0, min(lowest, 0.0), 0.0), -number)
        yield from text("TEXT", place, row, sheet.text_height)


def _drawn(sheet: Drawing, mark: Mark, place: Point) -> Iterator[Group]:
    """Draw a circle and a point at its middle, to snap to, with the words beside."""
    yield from point(mark.layer, place)
    yield from circle(mark.layer, place, MARK_SIZE * sheet.size)
    if mark.words:
        yield from text("TEXT", sheet.beside(place, mark.row), mark.words, sheet.text_height)


def _force(value: float) -> str:
    return f"{value / 1e3:.2f} kN"
