"""Reads OrcaFlex's text data (YAML) as far as it has moorings; te, kN, m and degrees.

Positions are global, those on an object count along its axes; sections run from End A.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace

from catopt.constants import STANDARD_GRAVITY
from catopt.decks.deck import Deck, DeckPiece, LineType, Notes, Point, along_axes
from catopt.decks.to_case import DeckSection, PointMass, from_sections
from catopt.decks.tree import YamlTable, parse_yaml
from catopt.tables import number

TONNE, KILO = 1e3, 1e3
"""kg and N of OrcaFlex's units of mass and force."""

_UNREAD = {
    "unread_weather": "Wave|Wind|Current|Air|Kinematic|Reynolds|SeaTemperature|WaterDensity",
    "unread_bed": "Seabed|^Lay|AsLaid|Covered",
    "unread_elsewhere": "^(VariableData|Constraints|Groups|BrowserGroups|Links|Winches|Shapes|"
    "Turbines|VesselTypes|6DBuoyTypes|.+Types|MultibodyGroups)$",
    "unread_words": "^(Name|Length|Draught|Type|Pen|Notes)$|Segment|Torsion|TopEnd|PyModel|Static|"
    "Represent|PreBend|Formulation|VIV|Azimuth|Declin|Gamma|Release|Stiffness|Arclength|Contents|"
    "Draw|ContactPen|Mass|Bulk|Compression|Allowable|Radius|Poisson|Expansion|GJ|Coupling|Contact|"
    "^C[a-z]$|Stress|Rayleigh|Inertia|Buoy|Vessel|Included|Include|Primary|Motion|Calculat|Damping|"
    "Shaded|Log|Stage|Jacobian|Dynamics|Time|View|Restart|Policy|Hidden|Disturbance|Cylinder|Stack|"
    "Munk|Attachment[xy]",
}
"""What the keys of OrcaFlex are about that are not read; the first that fits is said."""

ROUNDING = 1e-6
"""Of a height over the depth, by which the ends of lines may lie differently on the bed."""


def parse_orcaflex(text: str, notes: Notes, given: Mapping[str, float]) -> Deck:
    """Read a file; what is wrong with it is noted.

    `given`: what the user gives beside it: nothing, since OrcaFlex has its own gravity.
    """
    for key, value in given.items():
        notes.refuse(0, f"--{key} {value:g}", "orcaflex_has")
    top = parse_yaml(text, notes)
    _check_whole(top)
    surface, depth, density = _sea(top.table("Environment"))
    kinds, clumps = _by_name(top, "LineTypes"), _by_name(top, "ClumpTypes")
    objects = _by_name(top, "Vessels") | _by_name(top, "6DBuoys")
    buoys = _by_name(top, "3DBuoys")
    types: dict[str, LineType] = {}
    points: dict[str, Point] = {}
    pieces: list[DeckPiece] = []
    lying: set[float] = set()
    for line in _wanted(top):
        parts = list(_parts(line, clumps))
        ends = [
            _joint(buoys[to], surface)
            if (to := row.text("Connection")) in buoys
            else _end(row, objects, depth, surface)
            for row in line.columns("Connection")
        ]
        sections = [part for part in parts if isinstance(part, DeckSection)]
        new = {part.type for part in sections} & kinds.keys() - types.keys()
        types |= {name: _type(kinds[name]) for name in new}
        if len(ends) != 2 or not sections:
            notes.refuse(line.row, line.text("Name"), "two_ends")
            continue
        lower = sections[0 if ends[0].z < ends[1].z else -1]
        if lower.type in kinds:
            kind = kinds[lower.type]
            # The contact diameter is by default the outer one.
            key = "OuterContactDiameter" if "OuterContactDiameter" in kind else "OD"
            lying.add(0.5 * kind.number(key, at_least=0.0))
        more = from_sections(line.text("Name"), (ends[0], ends[1]), parts)
        points, pieces = points | more[0], pieces + more[1]
    if not pieces:
        notes.refuse(0, "", "no_line")
    top.say_unread(_UNREAD)
    if len(lying) > 1:
        notes.refuse(0, f"OuterContactDiameter/2 {sorted(lying)} m", "one_contact")
    bed = depth - max(lying, default=0.0)
    notes.say("contact", offset=depth - bed, depth=bed)
    points = {name: _on_bed(point, depth, bed, notes) for name, point in points.items()}
    return Deck(STANDARD_GRAVITY, density, bed, types, points, pieces)


def _by_name(top: YamlTable, key: str) -> dict[str, YamlTable]:
    return {table.text("Name"): table for table in top.tables(key)}


def _wanted(top: YamlTable) -> list[YamlTable]:
    """Return the lines, or the one that is required; the others need not be readable then."""
    notes, lines = top.notes, list(top.tables("Lines"))
    if notes.only is None or notes.only > len(lines):
        return lines
    notes.say("only", number=notes.only, count=len(lines))
    wanted, notes.only = lines[notes.only - 1], None
    return [wanted]


def _check_whole(top: YamlTable) -> None:
    if "BaseFile" in top:
        given = f"BaseFile {top.text('BaseFile')}"
        top.notes.refuse(top.items["BaseFile"].row, given, "files_within")
    units = top.table("General").text("UnitsSystem", "SI")
    if units != "SI":
        top.notes.refuse(0, f"UnitsSystem {units}", "SI")


def _on_bed(point: Point, depth: float, bed: float, notes: Notes) -> Point:
    """Lift an end that lies deeper than the line's centre does on the bed, which is said."""
    if point.end != "fixed" or not -depth * (1.0 + ROUNDING) <= point.z < -bed:
        return point
    if point.z < -bed - ROUNDING * depth:
        notes.say("lifted", line=point.row, distance=-bed - point.z)
    return replace(point, z=-bed)


def _sea(sea: YamlTable) -> tuple[float, float, float]:
    """Return z of the water's surface, depth and density."""
    for key, allowed in (("SeabedType", "Flat"), ("VerticalDensityVariation", "Constant")):
        if sea.text(key, allowed) != allowed:
            sea.notes.refuse(
                sea.items[key].row, f"{key} {sea.text(key)}", "is_wanted", word=allowed
            )
    if sea.number("SeabedSlope", 0.0) != 0.0:
        sea.notes.refuse(sea.items["SeabedSlope"].row, "SeabedSlope", "level_bed")
    density = sea.number("Density", above=0.0) * TONNE
    surface = sea.number("WaterSurfaceZ", 0.0)
    key = "SeabedOriginDepth" if "SeabedOriginDepth" in sea else "WaterDepth"  # 11.6, or before
    return surface, sea.number(key, above=0.0), density


def _type(kind: YamlTable) -> LineType:
    """Read a line type; drag goes from its own diameters to the outer one."""
    notes = kind.notes
    name, category = kind.text("Name"), kind.text("Category", "General")
    if category != "General":
        notes.refuse(kind.row, f"{name}: Category {category}", "general")
    if kind.number("ID", 0.0) != 0.0:
        notes.refuse(kind.items["ID"].row, f"{name}: ID", "hollow")
    OD = kind.number("OD", above=0.0)
    mass = kind.number("MassPerUnitLength", above=0.0) * TONNE
    EA = kind.number("EA", above=0.0) * KILO
    if (EI := _each(kind, "EI")) and EI[0] > 0.0:
        notes.say("bending", line=kind.items["EI"].row, name=name, value=EI[0] * KILO)
    normal = kind.number("NormalDragLiftDiameter", OD, at_least=0.0) / OD
    axial = kind.number("AxialDragLiftDiameter", OD, at_least=0.0) / OD
    Cd, Ca = _each(kind, "Cd"), _each(kind, "Ca")
    drag = None
    if len(Cd) == 3 and len(Ca) == 3:
        drag = (Cd[0] * normal, Cd[2] * axial, Ca[0], Ca[2])
    lateral = kind.number("SeabedLateralFrictionCoefficient", 0.0, at_least=0.0)
    friction = kind.number("SeabedAxialFrictionCoefficient", lateral, at_least=0.0)
    return LineType(kind.row, OD, mass, EA, friction, drag)


def _each(kind: YamlTable, key: str) -> list[float]:
    """Return numbers along x, y, z; none where one names a table, which is said."""
    found = kind.item(key)
    words = [item.value for item in found.value] if isinstance(found.value, list) else []
    try:
        numbers = [0.0 if word is None else number(word) for word in words]
        if any(map(math.isnan, numbers)):
            raise ValueError
    except (TypeError, ValueError):
        kind.notes.say("variable", line=found.row, key=key, value=", ".join(map(str, words)))
        return []
    if len(words) > 2 and words[1] is not None and numbers[1] != numbers[0]:
        kind.notes.say("variable", line=found.row, key=key, value=f"{words[1]} (y)")
    return numbers


def _joint(buoy: YamlTable, surface: float) -> Point:
    """Read a buoy in which lines meet; its drag is that along x."""
    x, y, z = buoy.numbers("InitialPosition", 3)
    name, connection = buoy.text("Name"), buoy.text("Connection", "Free")
    if connection != "Free":
        buoy.notes.refuse(buoy.row, f"{name}: Connection {connection}", "not_followed")
    area, Cd, Ca = (_each(buoy, key) or [0.0] for key in ("DragArea", "Cd", "Ca"))
    return Point(
        buoy.row,
        name,
        "free",
        x,
        y,
        z - surface,
        buoy.number("Mass", at_least=0.0) * TONNE,
        buoy.number("Volume", 0.0, at_least=0.0),
        area[0] * Cd[0],
        Ca[0],
    )


def _end(row: YamlTable, objects: Mapping[str, YamlTable], depth: float, surface: float) -> Point:
    """Place an end of a line."""
    to = row.text("Connection")
    x, y, z = (row.number(f"Connection{axis}") for axis in "XYZ")
    if to == "Anchored":
        return Point(row.row, to, "fixed", x, y, z - depth)
    if row.text("ConnectionzRelativeTo") or to not in ("Fixed", *objects):
        row.notes.refuse(row.row, to, "one_of", known=", ".join(objects))
        return Point(row.row, to, "fixed", x, y, z)
    if to == "Fixed":
        return Point(row.row, to, "fixed", x, y, z - surface)
    own = objects[to]
    if own.text("Connection", "Free") not in ("Free", "Fixed"):
        own.notes.refuse(own.row, f"{to}: Connection {own.text('Connection')}", "not_followed")
    at = own.numbers("InitialPosition", 3)
    turned = own.numbers("Orientation" if "Orientation" in own else "InitialAttitude", 3)
    if any(turned[:2]) and sum(angle != 0.0 for angle in turned) > 1:
        own.notes.refuse(own.row, f"{to}: {turned} deg", "turned_about_several")
    elif any(turned[:2]):
        about = 0 if turned[0] else 1
        own.notes.say("tilted", name=to, angle=turned[about], axis="xyz"[about])
    if own.text("Connection", "Free") == "Free":
        own.notes.say("free_object", name=to, x=at[0], y=at[1], z=at[2])
    x, y, z = along_axes((x, y, z), turned)
    return Point(row.row, to, "coupled", at[0] + x, at[1] + y, at[2] + z - surface)


def _parts(line: YamlTable, clumps: Mapping[str, YamlTable]) -> Iterator[DeckSection | PointMass]:
    """Yield sections from End A, cut where clumps hang."""
    if line.text("LengthAndEndOrientations", "Explicit") != "Explicit":
        line.notes.refuse(line.row, "LengthAndEndOrientations", "is_wanted", word="Explicit")
    sections = [
        DeckSection(row.row, row.text("LineType"), row.number("Length", above=0.0))
        for row in line.columns("LineType")
    ]
    hung = sorted(_hung(line, clumps, sum(part.length for part in sections)), key=lambda at: at[0])
    arc = 0.0
    for section in sections:
        end = arc + section.length
        while hung and hung[0][0] < end * (1.0 - 1e-12):
            at, body = hung.pop(0)
            if at > arc:
                yield replace(section, length=at - arc)
                arc = at
            yield body
        yield replace(section, length=end - arc)
        arc = end
    yield from (body for _, body in hung)


def _hung(
    line: YamlTable, clumps: Mapping[str, YamlTable], length: float
) -> Iterator[tuple[float, PointMass]]:
    """Yield clumps with their distance from End A."""
    for row in line.columns("AttachmentType"):
        name, z = row.text("AttachmentType"), row.number("Attachmentz")
        known = {key: row.items[key] for key in row.items if key.startswith("AttachmentzRel")}
        from_B = any(row.text(key) == "End B" for key in known)
        if name not in clumps:
            row.notes.refuse(row.row, name, "clump", known=", ".join(clumps))
            continue
        at = length - z if from_B else z
        if not 0.0 <= at <= length * (1.0 + 1e-12):
            row.notes.refuse(row.row, f"Attachmentz {z:g} m", "line_is_long", length=length)
        clump = clumps[name]
        mass = clump.number("Mass", at_least=0.0) * TONNE
        volume = clump.number("Volume", 0.0, at_least=0.0)
        yield at, PointMass(row.row, mass, volume, name=name)
