"""Draws a mooring for CAD, with a title block; a drawing unit is a metre.

One line is drawn in its own plane, x from the anchor and y above the bed, with its swing circle
beside it. Several lines are drawn in space, x, y, and z above the bed: from above they are the
general arrangement, with a table of coordinates and the watch circle of the body.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from textwrap import wrap
from types import MappingProxyType
from typing import Final

from catopt._version import identity
from catopt.catenary.case import solve_case
from catopt.catenary.layout import Profile, end_of
from catopt.catenary.solution import Solution
from catopt.constants import STANDARD_GRAVITY
from catopt.decks.deck import End
from catopt.errors import CatoptError
from catopt.export.dxf import (
    WIDE,
    Group,
    Point,
    box,
    circle,
    file_text,
    point,
    polyline,
    section,
    tables,
    text,
)
from catopt.export.export_result import Exported, Source, exported, heading
from catopt.export.exported_line import ExportedLine, ExportedLines
from catopt.loads import read_buoys
from catopt.loads.buoy import buoy
from catopt.loads.buoy_shape import BuoyShape
from catopt.model import Anchor, Case, Segment
from catopt.model.network import Network
from catopt.model.system import ShipAfloat
from catopt.mooring.restoring import watch_circle

LAYERS: Final[Mapping[str, int]] = MappingProxyType(
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
        "SWING": 2,
        "TEXT": 7,
        "TITLE": 7,
    }
)
"""Layers with their colours, as AutoCAD numbers them; those that hold nothing are there too."""

POINTS: Final = 201
"""Of a line, about; every joint and touchdown is among them."""

TEXT_SIZE, MARK_SIZE = 0.014, 0.004
"""Height of a text and radius of a mark over the size of the drawing."""

COLUMNS: Final = 100
"""Letters in a row of text; R12 takes 255 of them, and 7 for one that is not ASCII."""

ROW: Final = 1.6
"""From one row of text to the next, over its height."""

DIRECTIONS: Final = 72
"""Of a watch circle."""

_TITLE_COLUMNS: Final = 60
"""Letters in a row of the title block."""


@dataclass(frozen=True)
class Drawing:
    """How a line's points come onto the drawing.

    `solved`: what is drawn; `whole`: the mooring as its file has it, in still water; `size`: the
    longest span or length of a line, m.
    """

    solved: ExportedLines
    whole: Case | Network
    size: float

    @property
    def in_space(self) -> bool:
        """Whether z is the height; on a drawing of one line it is y."""
        return bool(self.solved.mooring)

    @property
    def text_height(self) -> float:
        """Height of a text, m."""
        return TEXT_SIZE * self.size

    @property
    def mark(self) -> float:
        """Radius of a mark, m."""
        return MARK_SIZE * self.size

    def at(self, line: ExportedLine, distance: float, height: float) -> Point:
        """Place a point of a line's plane."""
        return line.in_space(distance, height) if self.in_space else (distance, height, 0.0)

    def beside(self, place: Point, row: int) -> Point:
        """Place a text beside a mark: in rows above it, from 0, or below it, from -1."""
        x, y, z = place
        up = row * ROW + (0.6 if row >= 0 else 0.2)
        return x + 1.5 * self.mark, y + up * self.text_height, z


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


def dxf_drawing(
    solved: ExportedLines, *, whole: Case | Network | None = None, sources: Sequence[Source] = ()
) -> Exported:
    """Draw lines where they hang.

    `whole`: the mooring as its file has it, where `solved` is it in a load case, for still water
    and the swing circle of all load cases.
    """
    size = max(max(line.solution.span, line.solution.line.length) for line in solved.lines)
    sheet = Drawing(solved, whole or solved.case, size)
    around, missing = _around(sheet)
    remarks = (*_remarks(solved), *missing)
    said = heading("DXF R12 drawing in metres", solved, (), remarks, sources)
    groups: list[Group] = [
        *((999, line.strip()) for line in said if line.strip()),  # CAD programs pass over comments
        *tables(LAYERS),
        *section("ENTITIES", [*_entities(sheet), *around, *_below(sheet, remarks)]),
        (0, "EOF"),
    ]
    return exported("dxf", solved, file_text(groups), remarks, sources)


def _remarks(solved: ExportedLines) -> Iterator[str]:
    yield from solved.warnings
    if solved.EA is not None:
        yield f"drawn with the EA of {solved.EA:.6g} N that was given, not as the case has it"
    if any(line.solution.regime == "slack" for line in solved.lines):
        yield "what lies in bights on the bed is drawn straight"


def _entities(sheet: Drawing) -> Iterator[Group]:
    if not sheet.in_space:
        yield from _levels(sheet)
        yield from _moored_buoy(sheet)
    for line in sheet.solved.lines:
        yield from _line(sheet, line)
    if sheet.in_space:
        yield from _bodies(sheet)
        yield from _coordinates(sheet)


# ------------------------------------------------------------------ bed, water, lines


def _levels(sheet: Drawing) -> Iterator[Group]:
    """Draw the bed, still water and that of the load case, and some room beyond the line."""
    over, span = 0.1 * sheet.size, sheet.solved.lines[0].solution.span
    still, here = sheet.whole.site.water_depth, sheet.solved.case.site.water_depth
    levels = [("BED", 0.0, "bed", 0.5), ("WATER", still, f"still water, {still:.6g} m deep", 0.5)]
    if not math.isclose(still, here):
        words = f"water of this load case, {here:.6g} m deep ({here - still:+.6g} m)"
        levels[1:] = [
            (*levels[1][:3], 0.5 if here < still else -1.5),
            ("WATER", here, words, 0.5 if here > still else -1.5),
        ]
    for layer, height, words, row in levels:
        yield from polyline(layer, ((-over, height, 0.0), (span + over, height, 0.0)))
        yield from text("TEXT", (-over, height + row * sheet.text_height, 0.0), words,
                        sheet.text_height)  # fmt: skip


def _line(sheet: Drawing, line: ExportedLine) -> Iterator[Group]:
    """Draw every segment as a polyline of its own, with its size, and what there is on the line."""
    solution = line.solution
    profile = solution.profile(POINTS)
    start = 0.0
    for segment in solution.line.segments:
        places = _between(profile, start, start + segment.length, 1e-9 * solution.line.length)
        points = [sheet.at(line, *place) for place in places]
        yield from polyline("LINE", points, in_space=sheet.in_space)
        if not sheet.in_space:
            yield from _along(sheet, line, made_of(segment), start + 0.5 * segment.length)
        start += segment.length
    for mark in _marks(sheet, line):
        yield from _drawn(sheet, line, mark)


def _between(
    profile: Profile, start: float, end: float, close: float
) -> Iterator[tuple[float, float]]:
    """Yield the points of a segment; where the tension jumps the profile has them twice."""
    last = -math.inf
    for s, x, z in zip(profile.s, profile.x, profile.z, strict=True):
        if start - close <= s <= end + close and s - last > close:
            last = s
            yield x, z


def made_of(segment: Segment) -> str:
    """Say what a segment is: ``"chain studless R3 76 mm, 45 m"``."""
    name, size = segment.name or segment.component or "line", ""
    if segment.nominal_diameter is not None:
        size = f"{1e3 * segment.nominal_diameter:.4g} mm"
    return f"{name}{'' if size in name else f' {size}'}, {segment.length:.6g} m"


def _along(sheet: Drawing, line: ExportedLine, words: str, arc: float) -> Iterator[Group]:
    """Write words along a line, their middle above a place of it."""
    step = 0.01 * line.solution.line.length
    (x, z), (x1, z1), (x2, z2) = map(line.in_plane, (arc, arc - step, arc + step))
    angle = math.atan2(z2 - z1, x2 - x1)
    height, back = sheet.text_height, 0.5 * WIDE * sheet.text_height * len(words)
    cosine, sine = math.cos(angle), math.sin(angle)
    place = (x - back * cosine - height * sine, z - back * sine + height * cosine, 0.0)
    yield from text("TEXT", place, words, height, angle)


def _marks(sheet: Drawing, line: ExportedLine) -> Iterator[Mark]:
    """Yield what there is on a line; of several lines, only the anchors bear words."""
    solution, in_space = line.solution, sheet.in_space
    held = line.name if in_space else _held(sheet.solved.case.anchor)
    if sheet.solved.points[line.ends[0]].end == "fixed":
        words = f"{held}, {_force(solution.anchor.tension)}"
        yield Mark("ANCHOR", 0.0, solution.anchor_height, words, -1)
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
    if not in_space:
        at_fairlead = f"fairlead, {_force(solution.fairlead.tension)}"
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


def _drawn(sheet: Drawing, line: ExportedLine, mark: Mark) -> Iterator[Group]:
    """Draw a mark with the words beside."""
    place = sheet.at(line, mark.distance, mark.height)
    if mark.layer == "ANCHOR":
        yield from _anchor(sheet, place, line.heading)
    else:
        yield from _spot(sheet, mark.layer, place)
    if mark.words:
        yield from text("TEXT", sheet.beside(place, mark.row), mark.words, sheet.text_height)


def _spot(sheet: Drawing, layer: str, place: Point) -> Iterator[Group]:
    """Draw a circle and a point at its middle, to snap to."""
    yield from point(layer, place)
    yield from circle(layer, place, sheet.mark)


# ------------------------------------------------------------------ what holds a line


def _held(anchor: Anchor | None) -> str:
    """Name what holds a line."""
    if anchor is None:
        return "anchor"
    name = "sinker" if anchor.kind == "sinker" else "drag anchor"
    return name if anchor.mass is None else f"{name} of {1e-3 * anchor.mass:.4g} t"


def _anchor(sheet: Drawing, place: Point, heading: float) -> Iterator[Group]:
    """Draw a sinker as a block, a drag anchor as a triangle, and what is not known as a circle.

    From the side a block stands on the bed behind its eye. It is to scale where its mass is known:
    a cube of its volume.
    """
    anchor = sheet.solved.case.anchor
    if anchor is None:
        yield from _spot(sheet, "ANCHOR", place)
        return
    side = _side(anchor, sheet.solved.case.site.water_density) or 4.0 * sheet.mark
    corners = [(-side, 0.0), (0.0, 0.0), (0.0, side), (-side, side)]
    if sheet.in_space:
        half = 0.5 * side
        corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
    if anchor.kind == "drag":
        side = 4.0 * sheet.mark
        corners = [(0.0, 0.0), (-side, 0.5 * side), (-side, -0.5 * side)]
    x, y, z = place
    cosine, sine = (math.cos(heading), math.sin(heading)) if sheet.in_space else (1.0, 0.0)
    turned = [(x + a * cosine - b * sine, y + a * sine + b * cosine, z) for a, b in corners]
    yield from point("ANCHOR", place)
    yield from polyline("ANCHOR", turned, in_space=sheet.in_space, closed=True)


def _side(anchor: Anchor, water_density: float) -> float | None:
    """Side of the cube that a sinker of a mass and a weight in water is, m; None: not known."""
    if anchor.mass is None or anchor.submerged_weight is None:
        return None
    volume = (anchor.mass - anchor.submerged_weight / STANDARD_GRAVITY) / water_density
    return math.cbrt(volume) if volume > 0.0 else None


# ------------------------------------------------------------------ what is moored


def _shape(mooring: Case | Network) -> BuoyShape | None:
    """Look up the buoy that floats; None where it is none."""
    floater = mooring.floater
    if floater is None or floater.kind != "buoy":
        return None
    return buoy(floater.buoy, read_buoys(floater.file) if floater.file else None)


def _moored_buoy(sheet: Drawing) -> Iterator[Group]:
    """Stand a buoy on the end of its line: every slice of hull and tower as a trapezium."""
    shape, solution = _shape(sheet.solved.case), sheet.solved.lines[0].solution
    if shape is None:
        return
    x, bottom = solution.span, solution.fairlead_height - shape.eye
    for foot, part in shape.parts:
        low, high = bottom + foot, bottom + foot + part.height
        narrow, wide = 0.5 * part.lower, 0.5 * part.upper
        corners = [(x - narrow, low, 0.0), (x + narrow, low, 0.0)]
        corners += [(x + wide, high, 0.0), (x - wide, high, 0.0)]
        yield from polyline("BODY", corners, closed=True)


_LAYER_OF: Final[Mapping[End, str]] = {"coupled": "FAIRLEAD", "free": "JOINTS"}


def _bodies(sheet: Drawing) -> Iterator[Group]:
    """Mark joints and fairleads, and bodies at the height of one."""
    for end in sheet.solved.points:
        if end.end != "fixed":
            yield from _named(sheet, _LAYER_OF[end.end], end.place, end.words)
    for body in sheet.solved.bodies:
        place = (body.x, body.y, body.height)
        words = f"{body.name} under {_force(math.hypot(*body.force))}"
        yield from _named(sheet, "BODY", place, words)
        ends = dict.fromkeys(body.fairleads)
        yield from _arms(place, [at for at in ends if math.dist(at[:2], place[:2]) > 0.0])
        yield from _hull(sheet, place, body.yaw)


def _named(sheet: Drawing, layer: str, place: Point, words: str) -> Iterator[Group]:
    yield from _spot(sheet, layer, place)
    if words:
        yield from text("TEXT", sheet.beside(place, 0), words, sheet.text_height)


def _arms(place: Point, ends: Sequence[Point]) -> Iterator[Group]:
    for end in ends:
        yield from polyline("BODY", (place, end), in_space=True)


_BOW: Final = ((-0.5, 0.42), (-0.45, 0.5), (0.3, 0.5), (0.42, 0.35), (0.5, 0.0))
_BARGE: Final = ((-0.5, 0.5), (0.5, 0.5))
"""Half of a hull from above: along it over its length, beside it over its breadth."""


def _hull(sheet: Drawing, place: Point, yaw: float) -> Iterator[Group]:
    """Draw a buoy or a ship from above; one that turns freely about a turret has no heading."""
    case, (x, y, z) = sheet.solved.case, place
    shape = _shape(case)
    if shape is not None:
        yield from circle("BODY", place, 0.5 * shape.widest)
    floater, arms = case.floater, sheet.solved.bodies[0].fairleads
    ship = None if floater is None else floater.ship
    if ship is None or all(math.dist(at[:2], place[:2]) == 0.0 for at in arms):
        return
    corners = _outline(ship)
    cosine, sine = math.cos(yaw), math.sin(yaw)
    turned = [(x + a * cosine - b * sine, y + a * sine + b * cosine, z) for a, b in corners]
    yield from polyline("BODY", turned, in_space=True, closed=True)


def _outline(ship: ShipAfloat) -> list[tuple[float, float]]:
    """Corners of a hull from above, from the origin of the system, m."""
    half = _BARGE if ship.kind == "barge" else _BOW
    port = [(a * ship.length - ship.mooring_point, b * ship.breadth) for a, b in half]
    return [*port, *((a, -b) for a, b in reversed(port))]


# ------------------------------------------------------------------ general arrangement


def _coordinates(sheet: Drawing) -> Iterator[Group]:
    """Tabulate where every point is, to the right of what is drawn."""
    rows = [("point", "x, m", "y, m", "above bed, m", "from x, deg", "from origin, m")]
    for name, (x, y, z) in _points(sheet):
        angle = math.degrees(math.atan2(y, x)) % 360.0
        numbers = (f"{x + 0.0:.3f}", f"{y + 0.0:.3f}", f"{z + 0.0:.3f}")
        rows.append((name, *numbers, f"{angle:.2f}", f"{math.hypot(x, y):.3f}"))
    x, y = zip(*(place[:2] for _, place in _points(sheet)), strict=True)
    corner = (max(x) + 0.15 * sheet.size, max(y), 0.0)
    yield from box(rows, corner, sheet.text_height)


def _points(sheet: Drawing) -> Iterator[tuple[str, Point]]:
    """Yield every point with its name: all lines at rest."""
    yield from ((each.label, each.place) for each in sheet.solved.points)
    for body in sheet.solved.bodies:
        yield f"{body.name} under its load", (body.x, body.y, body.height)
        if body.neutral is not None:
            yield f"{body.name} without load", (*body.neutral, body.height)


def _around(sheet: Drawing) -> tuple[list[Group], list[str]]:
    """Draw the watch circle of a body, or the swing circle of one line; what is left out, in words.

    The watch circle is the body's path as its load goes round, by so many DIRECTIONS.
    """
    if not sheet.in_space:
        return list(_swing(sheet)), []
    mooring, bodies = sheet.solved.mooring, sheet.solved.bodies
    force = math.hypot(*bodies[0].force) if len(bodies) == 1 else 0.0
    if mooring is None or force == 0.0:
        return [], []
    try:
        found = watch_circle(mooring, force=force, directions=DIRECTIONS)
    except CatoptError as error:
        return [], [f"no watch circle is drawn: {error.message}"]
    track = [(each.x, each.y, 0.0) for each in found.responses]
    most = found.responses[found.farthest]
    words = f"watch circle under {_force(force)} from all around, offset to {most.offset:.2f} m"
    lowest = min(track, key=lambda place: place[1])
    drawn = [*polyline("SWING", track, closed=True)]
    drawn += text("TEXT", sheet.beside(lowest, -2), words, sheet.text_height)
    return drawn, ["the watch circle has no moment on the body"] if bodies[0].moment else []


def _swing(sheet: Drawing) -> Iterator[Group]:
    """Draw the swing circle of one line from above, beside it: its largest span of all states."""
    name, radius = "", sheet.solved.lines[0].solution.span
    if isinstance(sheet.whole, Case) and sheet.whole.find is None and sheet.solved.EA is None:
        for state in sheet.whole.load_cases:
            span = solve_case(sheet.whole.under(state)).span
            if span > radius:
                name, radius = f", {state.name}", span
    middle = (sheet.solved.lines[0].solution.span + 0.2 * sheet.size + radius, radius, 0.0)
    yield from circle("SWING", middle, radius)
    yield from polyline("SWING", (middle, (middle[0] + radius, middle[1], 0.0)))
    yield from _spot(sheet, "SWING", middle)
    words = f"from above: swing circle round the anchor, radius {radius:.2f} m{name}"
    place = (middle[0] - 0.5 * WIDE * sheet.text_height * len(words), 2.0 * radius, 0.0)
    yield from text("TEXT", sheet.beside(place, 0), words, sheet.text_height)


# ------------------------------------------------------------------ below the drawing


def _below(sheet: Drawing, remarks: Sequence[str]) -> Iterator[Group]:
    """Write units, answers and remarks below the drawing, and the title block below those."""
    rows = ["Drawing units are metres; heights are above the bed."]
    if sheet.in_space:
        rows.append(f"Still water is {sheet.whole.site.water_depth:.6g} m deep.")
    for line in sheet.solved.lines:
        solution = line.solution
        rows.append(
            f"{line.name}: span {solution.span:.3f} m, H {_force(solution.horizontal_force)}, "
            f"fairlead tension {_force(solution.fairlead.tension)}"
        )
        if sheet.in_space:
            rows.append("  " + "; ".join(map(made_of, solution.line.segments)))
    for remark in remarks:
        rows += wrap(f"Remark: {remark}", COLUMNS, subsequent_indent="  ", break_on_hyphens=False)
    lowest = min(y for _, (_, y, _) in _points(sheet)) if sheet.in_space else 0.0
    start = (0.0, min(lowest, 0.0), 0.0)
    for number, row in enumerate(rows, start=4):
        yield from text("TEXT", sheet.beside(start, -number), row, sheet.text_height)
    yield from box(_title_block(sheet.whole), sheet.beside(start, -len(rows) - 4),
                   sheet.text_height)  # fmt: skip


def _title_block(mooring: Case | Network) -> list[tuple[str, str]]:
    """Lay out whose drawing it is, with room to sign."""
    known = mooring.document
    rows = [("Title", row) for row in wrap(mooring.title, _TITLE_COLUMNS)[:3]]
    present = None
    if known is not None:
        firm = (("Client", known.client), ("Project", known.project), ("Number", known.number))
        rows = [(key, row) for key, said in firm for row in wrap(said, _TITLE_COLUMNS)] + rows
        present = known.revisions[-1] if known.revisions else None
    for key in ("revision", "date", "changed", "prepared", "checked", "approved"):
        said = "" if present is None else getattr(present, key)
        if said or key in ("revision", "prepared", "checked", "approved"):
            rows.append((key.capitalize(), said))
    return [*rows, ("Program", f"catopt {identity()}")]


def _force(value: float) -> str:
    return f"{value / 1e3:.2f} kN"
