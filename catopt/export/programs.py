"""The programs that take lines at rest: what each takes otherwise, and its file."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

from catopt.constants import STANDARD_GRAVITY
from catopt.decks.deck import Deck, DeckPiece, End, LineType, Point
from catopt.decks.to_case import Chain, weight_of
from catopt.errors import InputError, Problem, refused
from catopt.export.body_in_water import BodyInWater
from catopt.export.export_result import Exported, Source, exact, exported, heading, significant
from catopt.export.exported_line import ExportedLines
from catopt.export.moordyn_model import (
    ADDED_MASS,
    DRAG,
    ROUNDING,
    Model,
    common_remarks,
    has_drag,
    is_above,
    model_of,
)
from catopt.export.moordyn_model import LineType as Kind
from catopt.words import Message

Force = tuple[float, float, float]
NO_FORCE: Force = (0.0, 0.0, 0.0)


def deck_of(model: Model) -> Deck:
    """Turn cut lines into a deck: types, points from 1 on, and the pieces between them."""
    friction = max(line.solution.seabed_friction for line in model.solved.lines)
    points: dict[str, Point] = {}
    pieces: list[DeckPiece] = []
    numbers: dict[int, str] = {}

    def put(end: End, place: Sequence[float], body: BodyInWater, force: Force = NO_FORCE) -> str:
        # Without rounding at the water and at the bed: MoorPy lets a line weigh more whose end is
        # 1e-15 m above the water.
        z, levels = place[2] - model.surface, (0.0, -model.surface)
        z = next((each for each in levels if abs(z - each) <= ROUNDING * model.surface), z)
        name = str(len(points) + 1)
        own = (body.mass, body.volume, body.drag_area, body.added_mass, force)
        points[name] = Point(0, name, end, place[0], place[1], z, *own)
        return name

    for part in model.parts:
        names = []
        for index, joint in enumerate(part.joints):
            at = part.line.ends[-1 if index else 0]
            if 0 < index < len(part.joints) - 1:
                names.append(put("free", part.line.at(joint.arc), joint.body))
                continue
            if at not in numbers:
                of = model.solved.points[at]
                numbers[at] = put(of.end, of.place, model.ends[at], of.force)
            names.append(numbers[at])
        for piece, *ends in zip(part.pieces, names, names[1:], strict=False):
            pieces.append(DeckPiece(0, piece.type.name, (ends[0], ends[1]), piece.length))
    types = {each.name: _line_type(each, friction) for each in model.types}
    density = model.solved.case.site.water_density
    return Deck(STANDARD_GRAVITY, density, model.surface, types, points, pieces, friction)


def chains_in(model: Model, deck: Deck) -> list[Chain]:
    """Cut a deck into the lines that it is of."""
    found, left = [], list(deck.pieces)
    for part in model.parts:
        pieces, left = left[: len(part.pieces)], left[len(part.pieces) :]
        names = [pieces[0].ends[0], *(piece.ends[1] for piece in pieces)]
        found.append(Chain([deck.points[name] for name in names], pieces))
    return found


def named_points(model: Model, deck: Deck) -> list[str]:
    """Say which number the points of the case have in the file, where lines meet."""
    if not any(point.joint for point in model.solved.points):
        return []
    found: dict[str, str] = {}
    for part, line in zip(model.parts, chains_in(model, deck), strict=True):
        ends = (model.solved.points[end].name for end in part.line.ends)
        found |= zip((line.anchor.name, line.fairlead.name), ends, strict=True)
    return [f"Points: {', '.join(f'{number} {name}' for number, name in found.items())}"]


def refuse_forces(model: Model, program: str) -> None:
    """Refuse forces along the water on joints; InputError with each."""
    allowed = Message("refused_command.no_force_on_a_point", program=program)
    problems = [
        Problem(f"{point.key}.force", f"{point.force[:2]} N", allowed)
        for point in model.solved.points
        if any(point.force)
    ]
    if problems:
        raise InputError(problems, program)


def _line_type(each: Kind, friction: float) -> LineType:
    """Put drag on the volume-equivalent diameter, and along the line on pi times that."""
    segment, body = each.segment, each.body
    drag = DRAG, 0.0, ADDED_MASS, 0.0
    if has_drag(segment):
        assert segment.drag_diameter is not None
        assert segment.drag_normal is not None
        wider = segment.drag_diameter / body.diameter
        drag = (
            segment.drag_normal * wider,
            (segment.drag_axial or 0.0) * wider / math.pi,
            ADDED_MASS if segment.added_mass_normal is None else segment.added_mass_normal,
            segment.added_mass_axial or 0.0,
        )
    own = (segment.MBL, segment.nominal_diameter)
    return LineType(0, body.diameter, body.mass, segment.EA, friction, drag, *own)


_TOLERANCES = ("inner_ftol 1e-12", "inner_gtol 1e-12", "inner_xtol 1e-12", "outer_tol 1e-5")
"""With its own for the lines, 1e-6, MAP++ does not balance a node below which friction acts."""

_KINDS = {"fixed": "fix", "coupled": "vessel", "free": "connect"}


def mappp_lines(deck: Deck, _chains: Sequence[Chain], said: Iterable[str]) -> Iterator[str]:
    """Yield the lines of the file; `said`: what it says of itself.

    A comment begins with a blank for MAP++ itself, and with ``!`` for OpenFAST.
    """
    yield "---- LINE DICTIONARY ----"
    yield "LineType Diam MassDenInAir EA CB CIntDamp Ca Cdn Cdt"
    yield "(-) (m) (kg/m) (N) (-) (Pa-s) (-) (-) (-)"
    for name, kind in deck.types.items():
        across, along, added, _ = kind.drag or (0.0, 0.0, 0.0, 0.0)
        at_rest = (kind.diameter, kind.mass, kind.EA, kind.friction or 0.0)
        yield " ".join([name, *map(exact, (*at_rest, 0.0, added, across, along))])
    yield "---- NODE PROPERTIES ----"
    yield "Node Type X Y Z M B FX FY FZ"
    yield "(-) (-) (m) (m) (m) (kg) (m3) (N) (N) (N)"
    for point in deck.points.values():
        # Write a node; MAP++ is to find where a free one comes to rest.
        mark = "#" if point.end == "free" else ""
        place = [mark + exact(each) for each in (point.x, point.y, point.z)]
        if point.end == "fixed" and point.z == -deck.depth:
            place[2] = "depth"
        forces = " ".join(map(significant, point.force)) if mark else "# # #"
        of_body = f"{exact(point.mass)} {exact(point.volume)}"
        yield " ".join([point.name, _KINDS[point.end], *place, of_body, forces])
    yield "---- LINE PROPERTIES ----"
    yield "Line LineType UnstrLen NodeAnch NodeFair Flags"
    yield "(-) (-) (m) (-) (-) (-)"
    for number, piece in enumerate(deck.pieces, start=1):
        ends = " ".join(piece.ends)
        yield f"{number} {piece.type} {exact(piece.length)} {ends} tension_fair h_fair"
    yield "---- SOLVER OPTIONS ----"
    yield "Option"
    yield "(-)"
    yield from _TOLERANCES
    for line in said:
        yield f" ! {line}".rstrip()


_MOORPY_SCRIPT_KINDS = {"fixed": 1, "coupled": -1, "free": 0}

_SOLVED = """\
for name, d_vol, m, EA, Cd, CdAx, Ca, CaAx in LINE_TYPES:
    kind = {"name": name, "material": name, "d_vol": d_vol, "m": m, "EA": EA, "cost": 0.0}
    kind["w"] = (m - np.pi / 4 * d_vol**2 * system.rho) * system.g
    system.lineTypes[name] = kind | {"Cd": Cd, "CdAx": CdAx, "Ca": Ca, "CaAx": CaAx}
for kind, place, m, v, CdA, Ca, force in POINTS:
    point = system.addPoint(kind, np.array(place), m=m, v=v, fExt=np.array(force))
    point.CdA, point.Ca = CdA, Ca
    point.zTol = 0.001  # its own 2 m take weight off what hangs near the bed
    point.zSpan = np.array([-2.0, -1.0]) * system.depth  # all of it is under water
for length, name, anchor_side, fairlead_side in LINES:
    system.addLine(length, name, pointA=anchor_side, pointB=fairlead_side)
system.initialize()
system.solveEquilibrium(DOFtype="free", tol=1e-7)

for point in system.pointList:
    if point.type == -1:
        fx, fy, fz = point.getForces(xyz=True)
        print(f"fairlead {point.number}: H {np.hypot(fx, fy):.1f} N, V {-fz:.1f} N")"""


def moorpy_lines(deck: Deck, _chains: Sequence[Chain], said: Iterable[str]) -> Iterator[str]:
    """Yield the lines of the script; `said`: what it says of itself."""
    for line in said:
        yield f"# {line}".rstrip()
    yield ""
    yield "import moorpy"
    yield "import numpy as np"
    yield ""
    place = ", ".join(
        f"{key}={exact(value)}"
        for key, value in (("depth", deck.depth), ("rho", deck.density), ("g", deck.gravity))
    )
    yield f"system = moorpy.System({place})"
    yield "LINE_TYPES = [  # name, volume-equivalent diameter (m), kg/m, N, Cd, CdAx, Ca, CaAx"
    for name, kind in deck.types.items():
        assert kind.drag is not None
        numbers = (kind.diameter, kind.mass, kind.EA, *kind.drag)
        yield f'    ("{name}", {", ".join(map(exact, numbers))}),'
    yield "]"
    yield "POINTS = [  # 1 fixed, -1 held on the body, 0 free; place (m), kg, m3, Cd A (m2), Ca, N"
    for point in deck.points.values():
        at = ", ".join(map(exact, (point.x, point.y, point.z)))
        body = ", ".join(map(exact, point.body))
        force = ", ".join(map(exact, point.force))
        yield f"    ({_MOORPY_SCRIPT_KINDS[point.end]}, ({at}), {body}, ({force})),"
    yield "]"
    yield "LINES = [  # unstretched length (m), type, points at its ends"
    for piece in deck.pieces:
        yield f'    ({exact(piece.length)}, "{piece.type}", {", ".join(piece.ends)}),'
    yield "]"
    yield _SOLVED


def ontology_lines(deck: Deck, chains: Sequence[Chain], said: Iterable[str]) -> Iterator[str]:
    """Yield the lines of the file; `said`: what it says of itself.

    Raises InputError where a line does not run from an anchor on the bed to a platform.
    """
    if any((chain.anchor.end, chain.fairlead.end) != ("fixed", "coupled") for chain in chains):
        raise refused("points", "", Message("refused_command.ontology_lines"), "ontology")
    raised = max(chain.anchor.z for chain in chains) + deck.depth
    if raised > 0.0:
        allowed = Message("refused_command.must_be_0_ontology_anchors")
        raise refused("line.anchor_height", f"{raised:.6g} m", allowed, "ontology")
    for line in said:
        yield f"# {line}".rstrip()
    yield "site:"
    yield "  general:"
    yield f"    water_depth: {exact(deck.depth)}"
    yield f"    rho_water: {exact(deck.density)}"
    yield f"    g: {exact(deck.gravity)}"
    yield f"    seabed_friction: {exact(deck.friction or 0.0)}"
    yield from _body(chains)
    yield "mooring_line_configs:"
    for number, chain in enumerate(chains, start=1):
        yield from _config(number, chain)
    yield "mooring_line_types:"
    for name, kind in deck.types.items():
        across, along, added, added_along = kind.drag or (0.0, 0.0, 0.0, 0.0)
        values = {
            "d_nom": kind.nominal_diameter, "d_vol": kind.diameter, "m": kind.mass, "EA": kind.EA,
            "MBL": kind.MBL, "Cd": across, "CdAx": along, "Ca": added, "CaAx": added_along,
        }  # fmt: skip
        pairs = (f"{key}: {exact(value)}" for key, value in values.items() if value is not None)
        yield f'  "{name}": {{{", ".join(pairs)}}}'
    hung = [point for chain in chains for point in chain.hung]
    if hung:
        yield "mooring_connector_types:"
    for point in hung:
        keys = ("m", "v", "CdA", "Ca")
        pairs = (f"{key}: {exact(of)}" for key, of in zip(keys, point.body, strict=True))
        yield f"  connector_{point.name}: {{{', '.join(pairs)}}}"
    yield "anchor_types:"
    yield "  anchor: {type: unspecified}"


def _body(chains: Sequence[Chain]) -> Iterator[str]:
    """Yield the platform at x = y = 0, its fairleads and its mooring system."""
    yield "array:"
    keys = "ID, topsideID, platformID, mooringID, x_location, y_location, heading_adjust"
    yield f"  keys: [{keys}]"
    yield "  data: [[body, 0, 1, ms1, 0.0, 0.0, 0.0]]"
    first = chains[0].fairlead
    yield "platform:"
    yield "  type: FOWT"
    yield f"  rFair: {exact(math.hypot(first.x, first.y))}"
    yield f"  zFair: {exact(first.z)}"
    yield "  fairleads:"
    for number, chain in enumerate(chains, start=1):
        place = ", ".join(map(exact, (chain.fairlead.x, chain.fairlead.y, chain.fairlead.z)))
        yield f"    - {{name: fairlead{number}, r_rel: [{place}]}}"
    yield "mooring_systems:"
    yield "  ms1:"
    yield "    keys: [MooringConfigID, heading, anchorType, fairlead]"
    yield "    data:"
    for number, chain in enumerate(chains, start=1):
        x, y = chain.anchor.x - chain.fairlead.x, chain.anchor.y - chain.fairlead.y
        heading = math.degrees(math.atan2(x, y))
        yield f"      - [line_{number}, {exact(heading)}, anchor, {number}]"


def _config(number: int, chain: Chain) -> Iterator[str]:
    """Yield span and sections of a line, from its anchor."""
    anchor, fairlead = chain.anchor, chain.fairlead
    yield f"  line_{number}:"
    yield f"    span: {exact(math.hypot(fairlead.x - anchor.x, fairlead.y - anchor.y))}"
    yield "    sections:"
    for piece, point in zip(chain.pieces, chain.points[1:], strict=True):
        yield f'      - {{type: "{piece.type}", length: {exact(piece.length)}}}'
        if point.end == "free" and (point.mass or point.volume):
            yield f"      - {{connectorType: connector_{point.name}}}"


SINKING = 1e-3
"""How deep the heaviest line sinks into the bed, m."""

_CONNECTION = (
    "Connection, ConnectionX, ConnectionY, ConnectionZ, ConnectionAzimuth, ConnectionDeclination, "
    "ConnectionGamma, ConnectionReleaseStage, ConnectionzRelativeTo"
)
_ATTACHMENT = "AttachmentType, Attachmentx, Attachmenty, Attachmentz, AttachmentzRelativeTo"


def orcaflex_lines(deck: Deck, chains: Sequence[Chain], said: Iterable[str]) -> Iterator[str]:
    """Yield the lines of the file; `said`: what it says of itself."""
    contact = max(kind.diameter for kind in deck.types.values())
    weights = (weight_of(deck, kind) for kind in deck.types.values())
    stiffness = exact(max(1.0, *weights) / (contact * SINKING) / 1e3)
    yield "%YAML 1.1"
    for line in said:
        yield f"# {line}".rstrip()
    yield "---"
    yield "General: {UnitsSystem: SI}"
    yield "Environment:"
    yield "  WaterSurfaceZ: 0"
    yield f"  WaterDepth: {exact(deck.depth + 0.5 * contact)}"
    yield f"  Density: {exact(deck.density / 1e3)}"
    yield "  SeabedType: Flat"
    yield "  SeabedModel: Elastic"
    yield f"  SeabedNormalStiffness: {stiffness}"
    yield f"  SeabedShearStiffness: {stiffness}"
    yield "LineTypes:"
    for name, kind in deck.types.items():
        yield from _type(name, kind, contact)
    hung = [point for chain in chains for point in chain.hung]
    if hung:
        yield "ClumpTypes:"
    for point in hung:
        body = f"Mass: {exact(point.mass / 1e3)}, Volume: {exact(point.volume)}"
        yield f"  - {{Name: clump_{point.name}, {body}}}"
    yield "6DBuoys:"
    yield "  - Name: body"
    yield "    BuoyType: Lumped buoy"
    yield "    Connection: Fixed"
    yield "    InitialPosition: [0, 0, 0]"
    yield "    InitialAttitude: [0, 0, 0]"
    ends = (point for chain in chains for point in (chain.anchor, chain.fairlead))
    joints = list(dict.fromkeys(point for point in ends if point.end == "free"))
    if joints:
        yield "3DBuoys:"
    for point in joints:
        yield from _joint(point)
    yield "Lines:"
    for number, chain in enumerate(chains, start=1):
        yield from _line(number, chain, deck.depth, 0.5 * contact)


def _type(name: str, kind: LineType, contact: float) -> Iterator[str]:
    across, along, added, added_along = map(exact, kind.drag or (0.0, 0.0, 0.0, 0.0))
    friction = exact(kind.friction or 0.0)
    yield f'  - Name: "{name}"'
    yield "    Category: General"
    yield f"    OD: {exact(kind.diameter)}"
    yield "    ID: 0"
    yield f"    MassPerUnitLength: {exact(kind.mass / 1e3)}"
    yield "    CompressionIsLimited: Yes"
    yield "    EI: [0, ~]"
    yield f"    EA: {exact(kind.EA / 1e3)}"
    yield f"    OuterContactDiameter: {exact(contact)}"
    yield f"    Ca: [{added}, ~, {added_along}]"
    yield f"    Cd: [{across}, ~, {along}]"
    yield f"    SeabedLateralFrictionCoefficient: {friction}"
    yield "    SeabedAxialFrictionCoefficient: ~"


def _joint(point: Point) -> Iterator[str]:
    """Yield a buoy in which lines meet; it is no higher than a point."""
    yield f"  - Name: joint_{point.name}"
    yield "    Connection: Free"
    yield f"    InitialPosition: [{_place(point, 0.0)}]"
    yield f"    Mass: {exact(point.mass / 1e3)}"
    yield f"    Volume: {exact(point.volume)}"
    yield "    Height: 0.001"
    yield f"    DragArea: [{', '.join([exact(point.drag_area)] * 3)}]"
    yield "    Cd: [1, 1, 1]"
    yield f"    Ca: [{', '.join([exact(point.added_mass)] * 3)}]"


def _connection(point: Point, up: float, declination: int) -> str:
    """Say to what an end of a line is connected; heights of anchors count from the bed."""
    to, lift = {
        "fixed": ("Anchored", up), "coupled": ("body", 0.0), "free": (f"joint_{point.name}", 0.0)
    }[point.end]  # fmt: skip
    place = "0, 0, 0" if point.end == "free" else _place(point, lift)
    return f"[{to}, {place}, 0, {declination}, 0, ~]"


def _line(number: int, chain: Chain, depth: float, lifted: float) -> Iterator[str]:
    """Yield a line; its fairlead is held by a fixed buoy that stands for the body."""
    anchor, fairlead = chain.anchor, chain.fairlead
    laid = math.degrees(math.atan2(fairlead.y - anchor.y, fairlead.x - anchor.x))
    yield f"  - Name: line {number}"
    yield "    TopEnd: End A"
    yield f"    ? {_CONNECTION}"
    yield f"    : - {_connection(fairlead, depth + lifted, 0)}"
    yield f"      - {_connection(anchor, depth + lifted, 90)}"
    yield "    LineType, Length, TargetSegmentLength:"
    total = math.fsum(piece.length for piece in chain.pieces)
    for piece in reversed(chain.pieces):
        target = exact(min(total / 50.0, piece.length))
        yield f'      - ["{piece.type}", {exact(piece.length)}, {target}]'
    arc, clumps = 0.0, []
    for piece, point in zip(reversed(chain.pieces), chain.points[-2:0:-1], strict=False):
        arc += piece.length
        if point.mass or point.volume:
            clumps.append(f"      - [clump_{point.name}, 0, 0, {exact(arc)}, End A]")
    if clumps:
        yield f"    {_ATTACHMENT}:"
        yield from clumps
    yield "    StaticsStep1: Catenary"
    yield "    StaticsStep2: Full statics"
    yield "    StaticsSeabedFrictionPolicy: As laid"
    yield f"    LayAzimuth: {exact(laid % 360.0)}"


def _place(point: Point, up: float) -> str:
    return ", ".join(map(exact, (point.x, point.y, point.z + up)))


ProgramFormat = Literal["map", "moorpy", "ontology", "orcaflex"]


@dataclass(frozen=True)
class Program:
    """A program that takes lines at rest.

    `first`: what the file is; `lines`: from the deck, its chains and what the file says of itself,
    to its lines; `remarks`: what the program takes otherwise; `true_depth`: whether all of a line
    weighs what it weighs in water, above the water too; for another program the depth is raised to
    the highest point of the lines; `takes_forces`: on joints, beside their weight.
    """

    name: str
    first: str
    lines: Callable[[Deck, Sequence[Chain], Iterable[str]], Iterator[str]]
    remarks: Callable[[Model], Iterator[str]]
    true_depth: bool = False
    takes_forces: bool = False


def program_input(
    to: ProgramFormat, solved: ExportedLines, *, sources: Sequence[Source] = ()
) -> Exported:
    """Write lines for a program.

    `solved`: the lines where they hang; every segment has an EA; `sources`: what the case was read
    from. InputError: a segment does not stretch, or its mass is missing or too small, with every
    one; for the ontology, the anchor stands above the bed.

    Examples
    --------
    >>> import catopt
    >>> from catopt.export.export_result import exported_lines
    >>> from catopt.export.programs import program_input
    >>> chain = catopt.Segment(60.0, 2100.0, EA=2e8, mass=246.0, name="chain")
    >>> load = catopt.Load(horizontal_force=1e5)
    >>> case = catopt.Case(catopt.Site(20.0), catopt.Line([chain]), load, 20.0)
    >>> program_input("map", exported_lines(case)).text.splitlines()[3][:15]
    'chain 0.1989359'
    """
    program = PROGRAMS[to]
    model = model_of(solved, true_depth=program.true_depth, program=program.name)
    remarks = (*common_remarks(model), *program.remarks(model), *_of_the_water(model))
    deck = deck_of(model)
    if not program.takes_forces:
        refuse_forces(model, program.name)
    said = heading(program.first, solved, named_points(model, deck), remarks, sources)
    text = "\n".join(program.lines(deck, chains_in(model, deck), said)) + "\n"
    return exported(to, solved, text, remarks, sources)


def _of_the_water(model: Model) -> Iterator[str]:
    """Say where the depth is not that of the case."""
    depth = model.solved.case.site.water_depth
    if is_above(model.solved) and model.surface > depth:
        height = model.solved.highest - depth
        yield Message("export.raised", height=height, depth=depth, raised=model.surface)


def _of_mappp(model: Model) -> Iterator[str]:
    site = model.solved.case.site
    yield Message(
        "export.map_place",
        gravity=STANDARD_GRAVITY,
        density=site.water_density,
        depth=site.water_depth,
    )
    depth = model.surface
    free = (point for point in deck_of(model).points.values() if point.end == "free")
    bed = [point.name for point in free if point.z + depth <= 1e-9 * depth]
    if bed:
        yield Message("export.map_bed", nodes=", ".join(bed))


def _of_moorpy(model: Model) -> Iterator[str]:
    if any(line.at_rest is not None for line in model.solved.lines):
        friction = model.solved.lines[0].solution.seabed_friction
        yield Message("export.no_friction", friction=friction)


def _of_ontology(model: Model) -> Iterator[str]:
    yield Message("export.ontology_keys")
    if is_above(model.solved):
        height = model.solved.highest - model.solved.case.site.water_depth
        yield Message("export.above", height=height)


def _of_orcaflex(model: Model) -> Iterator[str]:
    yield Message("export.orcaflex", contact=max(each.body.diameter for each in model.types))
    if any(joint.body.drag_area for part in model.parts for joint in part.joints):
        yield Message("export.orcaflex_clumps")


PROGRAMS: Mapping[ProgramFormat, Program] = MappingProxyType(
    {
        "map": Program("MAP++", "MAP++ input file", mappp_lines, _of_mappp, True, True),
        "ontology": Program(
            "the ontology", "Floating array ontology", ontology_lines, _of_ontology, true_depth=True
        ),
        "orcaflex": Program("OrcaFlex", "OrcaFlex text data", orcaflex_lines, _of_orcaflex),
        "moorpy": Program("MoorPy", "MoorPy script", moorpy_lines, _of_moorpy, False, True),
    }
)
"""What `program_input` writes, by the name of its format."""
