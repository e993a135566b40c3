"""From the lines of a deck to a case.

The weight in water of a line is w = (m - pi/4 d^2 rho) g with its volume-equivalent diameter d,
that of a point W = (M - rho V) g.
"""

from __future__ import annotations

import cmath
import math
from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from operator import attrgetter
from statistics import fmean

from catopt.decks.deck import Deck, DeckPiece, LineType, Notes, Point, refusal
from catopt.model import Case, Line, Load, PointLoad, Segment, Site, System


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

    @property
    def hung(self) -> list[Point]:
        """Points between its ends at which something hangs."""
        return [point for point in self.points[1:-1] if point.mass or point.volume]


def chains_of(deck: Deck, notes: Notes, only: int | None = None) -> list[Chain]:
    """Follow the pieces of a deck; what is no chain is noted.

    `only`: the one line that is required, counted from 1. Raises InputError with everything that is
    no line between two ends.
    """
    meeting = check_meeting(deck, notes)
    for name, pieces in meeting.items():
        if pieces and is_joint(deck.points[name], len(pieces)):
            of_lines = refusal("point_of_lines", name=name, count=len(pieces))
            notes.refuse(deck.points[name].row, of_lines, "joint")
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


def without_floating_ends(deck: Deck, notes: Notes) -> Deck:
    """Make a float of a line that floats with a free end, on the point from which it floats.

    In still water it stands upright there and pulls with its net buoyancy, as long as all of it is
    under water: its length is its height.
    """
    points, pieces = dict(deck.points), []
    meeting = Counter(end for piece in deck.pieces for end in piece.ends)
    for number, piece in enumerate(deck.pieces, start=1):
        kind, known = deck.types.get(piece.type), set(piece.ends) <= points.keys()
        lift = 0.0 if kind is None else -weight_of(deck, kind) * piece.length
        ends = [points[end] for end in piece.ends] if known and lift > 0.0 else []
        bare = [end for end in ends if meeting[end.name] == 1 and _is_bare(end)]
        feet = [end for end in ends if end not in bare]
        if len(bare) != 1 or len(feet) != 1 or feet[0].end != "free":
            pieces.append(piece)
            continue
        (foot,) = feet
        own = {"name": f"{number}", "point": foot.name, "length": piece.length}
        notes.say("floats_free", line=piece.row, lift=lift, **own)
        assert kind is not None
        mass = kind.mass * piece.length
        volume = foot.volume + (lift / deck.gravity + mass) / deck.density
        points[foot.name] = replace(
            foot, mass=foot.mass + mass, volume=volume, float_height=piece.length
        )
        del points[bare[0].name]
    return replace(deck, points=points, pieces=pieces)


def _is_bare(point: Point) -> bool:
    """Whether a point is free, with nothing on it."""
    return point.end == "free" and not any(point.body) and not any(point.force)


def check_meeting(deck: Deck, notes: Notes) -> dict[str, list[DeckPiece]]:
    """List the lines that meet in every point."""
    meeting = _meeting(deck, notes)
    notes.raise_if_any()
    for name, pieces in meeting.items():
        point = deck.points[name]
        if not pieces:
            notes.say("unattached", line=point.row, name=name)
        elif point.end != "free" and (point.mass or point.volume):
            notes.say("held_mass", line=point.row, name=name)
    return meeting


def is_joint(point: Point, lines: int) -> bool:
    """Whether a point in which so many lines end is one of its own, and no load on one line."""
    return point.end == "free" and (lines != 2 or any(point.force))


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
        piece = next(run for run in left if name in run.ends)


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
    """What hangs between two sections: kg, m3, Cd A in m2, Ca, and its name."""

    row: int
    mass: float
    volume: float
    drag_area: float = 0.0
    added_mass: float = 0.0
    name: str = ""


def from_sections(
    name: str, ends: tuple[Point, Point], parts: Sequence[DeckSection | PointMass]
) -> tuple[dict[str, Point], list[DeckPiece]]:
    """Turn a line into points ``NAME.1`` and so on and pieces, both from its first end.

    `ends`: where it is held, whose own names do not count; or joints, which keep theirs.
    """
    first, last = ends
    total = sum(part.length for part in parts if isinstance(part, DeckSection)) or 1.0
    begun = first if first.end == "free" else replace(first, name=f"{name}.1")
    points, pieces, arc = [begun], list[DeckPiece](), 0.0
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
    if pieces and last.end == "free":
        points[-1] = last
        between = (pieces[-1].ends[0], last.name)
        pieces[-1] = replace(pieces[-1], ends=between)
    elif pieces:
        points[-1] = Point(last.row, end.name, last.end, last.x, last.y, last.z, *end.body)
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
        hung=", ".join(filter(None, (point.hung, hung.name))),
    )


ROUNDING = 5e-5
"""Of a line's length, by which ends may lie off equal lines around a body: 4 cm of 800 m."""

BALANCED = 1e-3
"""Of the largest horizontal force: what is left over of lines that balance each other."""


def case_of(
    deck: Deck, chains: Sequence[Chain], lines: Sequence[Line], notes: Notes, title: str
) -> Case:
    """Make the case: of one line between its ends, of several equal ones around a body.

    Raises InputError with everything that a case cannot say, by the lines of the file.
    """
    site, source = site_of_chains(deck, chains, notes)
    make = _one_line if len(chains) == 1 else _body
    return replace(make(deck, chains, lines, site, notes), title=title, source=source)


def lines_of(deck: Deck, chains: Sequence[Chain]) -> list[Line]:
    """Return what each chain is made of."""
    return [_line(deck, chain) for chain in chains]


def site_of_chains(deck: Deck, chains: Sequence[Chain], notes: Notes) -> tuple[Site, str]:
    """Return the site and where the lines are from, as `site_of`."""
    pieces = [piece for chain in chains for piece in chain.pieces]
    ends = [point for chain in chains for point in (chain.anchor, chain.fairlead)]
    found = site_of(deck, pieces, ends, notes)
    if any(chain.fairlead.z > 0.0 for chain in chains):
        notes.say("above_water")
    return found


ABOVE_BED = 0.01
"""Of the depth: a point that is fixed higher above the bed is remarked on."""


def site_of(
    deck: Deck, pieces: Sequence[DeckPiece], ends: Sequence[Point], notes: Notes
) -> tuple[Site, str]:
    """Return the site of lines and where they are from; what they are made of is checked and said.

    InputError with all that was noted so far, and for ends of lines that are below the bed.
    """
    used = dict.fromkeys(piece.type for piece in pieces)
    friction = _friction(deck, used, notes)
    for point in ends:
        if point.z < -deck.depth * (1.0 + 1e-9):
            notes.refuse(point.row, f"Z {point.z:g} m", "below_bed", bed=-deck.depth)
        elif point.end == "fixed" and point.z + deck.depth > ABOVE_BED * deck.depth:
            height = point.z + deck.depth
            notes.say("anchor_above_bed", line=point.row, name=point.name, height=height)
    notes.raise_if_any()
    for name in used:
        # Say the weight in water of a line type, and its drag.
        kind = deck.types[name]
        notes.say(
            "weight",
            line=kind.row,
            name=name,
            weight=weight_of(deck, kind),
            mass=kind.mass,
            diameter=kind.diameter,
            density=deck.density,
            gravity=deck.gravity,
        )
        if kind.drag is not None:
            notes.say("drag", line=kind.row, name=name, normal=kind.drag[0], axial=kind.drag[1])
    source = f"{notes.source}; g = {deck.gravity:g} m/s^2, water {deck.density:g} kg/m^3"
    return Site(deck.depth, friction, deck.density), source


def _friction(deck: Deck, used: Collection[str], notes: Notes) -> float:
    """Take the friction of the bed: one for all, which MAP++ has by line type."""
    if deck.friction is not None:
        return deck.friction
    found = {deck.types[name].friction or 0.0 for name in used}
    if len(found) > 1:
        row = min(deck.types[name].row for name in used)
        given = f"CB {', '.join(f'{value:g}' for value in sorted(found))}"
        notes.refuse(row, given, "one_friction")
    notes.say("friction", friction=max(found))
    return max(found)


def weight_of(deck: Deck, kind: LineType) -> float:
    """Return the weight in water of a line type, N/m."""
    volume = 0.25 * math.pi * kind.diameter**2
    return (kind.mass - volume * deck.density) * deck.gravity


def _line(deck: Deck, chain: Chain) -> Line:
    """Put the pieces together; those of one type that follow each other are one segment."""
    segments = [
        _segment(deck, name, math.fsum(piece.length for piece in pieces))
        for name, pieces in groupby(chain.pieces, key=attrgetter("type"))
    ]
    loads = []
    for number, point in enumerate(chain.points[1:-1], start=1):
        if point.mass or point.volume or point.drag_area:
            loads.append(
                PointLoad(
                    math.fsum(piece.length for piece in chain.pieces[:number]),
                    deck.hung_weight(point),
                    mass=point.mass,
                    name=point.hung or f"point {point.name}",
                    drag_area=point.drag_area or None,
                    drag_coefficient=1.0 if point.drag_area else None,
                    added_mass_coefficient=point.added_mass if point.volume else 0.0,
                )
            )
    return Line(segments, loads)


def _segment(deck: Deck, name: str, length: float) -> Segment:
    kind = deck.types[name]
    segment = Segment(
        length,
        weight_of(deck, kind),
        EA=kind.EA,
        mass=kind.mass,
        MBL=kind.MBL,
        name=name,
        nominal_diameter=kind.nominal_diameter,
    )
    if kind.drag is None:
        return segment
    across, along, added, added_along = kind.drag
    return replace(
        segment,
        drag_diameter=kind.diameter,
        drag_normal=across,
        drag_axial=math.pi * along,
        added_mass_normal=added,
        added_mass_axial=added_along,
    )


def height_of(deck: Deck, z: float) -> float:
    """Return the height above the bed of a z from the still water, m."""
    height = z + deck.depth
    return 0.0 if abs(height) <= 1e-9 * deck.depth else height


def _one_line(
    deck: Deck, chains: Sequence[Chain], lines: Sequence[Line], site: Site, notes: Notes
) -> Case:
    anchor, fairlead = chains[0].anchor, chains[0].fairlead
    span = math.hypot(fairlead.x - anchor.x, fairlead.y - anchor.y)
    if fairlead.z < anchor.z:
        notes.refuse(fairlead.row, f"Z {fairlead.z:g} m", "fairlead_below_anchor")
    notes.raise_if_any()
    if anchor.end == fairlead.end:
        notes.say("ends_alike", anchor=anchor.name, fairlead=fairlead.name)
    notes.say("one_line", span=span)
    heights = height_of(deck, fairlead.z), height_of(deck, anchor.z)
    return Case(site, lines[0], Load(span=span), heights[0], heights[1])


@dataclass(frozen=True)
class _Around:
    """Equal lines around a body: m from x = y = 0, and how far off an end is."""

    radius: float
    azimuths: list[float]
    place: complex
    arm: complex
    heights: tuple[float, float]
    moved: float


def is_radial(deck: Deck, chains: Sequence[Chain], lines: Sequence[Line]) -> bool:
    """Whether it is one line, or equal ones around a body up to the rounding of the deck."""
    if len(chains) == 1:
        return True
    if any(_bare(line) != _bare(lines[0]) for line in lines):
        return False
    if any(
        chain.anchor.end == chain.fairlead.end
        or chain.fairlead.z < chain.anchor.z
        or (chain.fairlead.x, chain.fairlead.y) == (chain.anchor.x, chain.anchor.y)
        for chain in chains
    ):
        return False
    return _around(deck, chains).moved <= ROUNDING * lines[0].length


def _around(deck: Deck, chains: Sequence[Chain]) -> _Around:
    ends = [(complex(c.anchor.x, c.anchor.y), complex(c.fairlead.x, c.fairlead.y)) for c in chains]
    radius = fmean(abs(anchor) for anchor, _ in ends)
    azimuths = [cmath.phase(anchor) for anchor, _ in ends]
    ahead = [cmath.rect(1.0, azimuth) for azimuth in azimuths]
    place, arm = _fitted(ahead, [fairlead for _, fairlead in ends])
    fairlead_height, anchor_height = (
        fmean(height_of(deck, point.z) for point in points)
        for points in ([c.fairlead for c in chains], [c.anchor for c in chains])
    )
    moved = max(
        *(abs(abs(anchor) - radius) for anchor, _ in ends),
        *(abs(place + arm * e - end) for e, (_, end) in zip(ahead, ends, strict=True)),
        *(abs(height_of(deck, c.fairlead.z) - fairlead_height) for c in chains),
        *(abs(height_of(deck, c.anchor.z) - anchor_height) for c in chains),
    )
    return _Around(radius, azimuths, place, arm, (fairlead_height, anchor_height), moved)


def _body(
    deck: Deck, chains: Sequence[Chain], lines: Sequence[Line], site: Site, notes: Notes
) -> Case:
    """Put equal lines around a body, which stands where the deck holds its fairleads."""
    found = _around(deck, chains)
    place, arm, heights, moved = found.place, found.arm, found.heights, found.moved
    if moved > 1e-6:
        notes.say("moved", distance=moved)
    small = 3.0 * moved + 1e-6
    place = 0j if abs(place) <= small else place
    if abs(arm) <= small:
        arm = 0j
    elif abs(arm.imag) <= small:
        arm = complex(abs(arm), 0.0)
    system = System.around(
        lines[0],
        azimuths=found.azimuths,
        anchor_radius=found.radius,
        fairlead_height=heights[0],
        fairlead_radius=abs(arm),
        anchor_height=heights[1],
        seabed_friction=site.seabed_friction,
    )
    force, moment = _holding(system, place, arm, notes)
    if force != (0.0, 0.0) or moment:
        system = replace(system, force=force, moment=moment)
    return Case(site, lines[0], None, heights[0], heights[1], system=system)


def _bare(line: Line) -> tuple[object, ...]:
    """Return what a line is made of, without the names of its points."""
    return (line.segments, tuple(replace(load, name="") for load in line.point_loads))


def _fitted(ahead: Sequence[complex], fairleads: Sequence[complex]) -> tuple[complex, complex]:
    """Find place p and arm q of a body by least squares: each fairlead at p + q e of its line."""
    middle, centre = sum(ahead) / len(ahead), sum(fairleads) / len(ahead)
    spread = sum(abs(e - middle) ** 2 for e in ahead)
    if spread < 1e-12:
        return centre, 0j
    arm = sum(
        (end - centre) * (e - middle).conjugate() for e, end in zip(ahead, fairleads, strict=True)
    )
    return centre - arm / spread * middle, arm / spread


def _holding(
    system: System, place: complex, arm: complex, notes: Notes
) -> tuple[tuple[float, float], float]:
    """Find what holds the body where the deck has it: against the pull of its lines."""
    from catopt.catenary.solve import solve

    pull, moment, largest = 0j, 0.0, 0.0
    for leg in system.legs:
        lever = arm * cmath.rect(1.0, leg.azimuth)
        to_anchor = complex(*leg.anchor) - place - lever
        H = solve(
            leg.line,
            height=leg.fairlead_height,
            anchor_height=leg.anchor_height,
            seabed_friction=system.seabed_friction,
            span=abs(to_anchor),
        ).horizontal_force
        own = H * to_anchor / abs(to_anchor)
        pull += own
        moment += (lever.conjugate() * own).imag
        largest = max(largest, H)
    if max(abs(pull), abs(moment) / (abs(arm) or 1.0)) <= BALANCED * largest and not place:
        notes.say("balanced", lines=len(system.legs), left=abs(pull) / 1e3)
        return (0.0, 0.0), 0.0
    notes.say("held", x=place.real, y=place.imag, force=abs(pull) / 1e3, moment=-moment / 1e3)
    return (-pull.real, -pull.imag), -moment if arm else 0.0
