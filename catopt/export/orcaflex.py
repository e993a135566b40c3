"""Lines as OrcaFlex's text data (YAML): te, kN, m and degrees, from the fairlead down.

OrcaFlex lays a line down by its outside: the bed is put half a contact diameter lower.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from catopt.decks.deck import Deck, LineType, Notes, Point
from catopt.decks.strung import Chain, chains_of
from catopt.decks.to_case import weight_of
from catopt.export.exported import exact

SINKING = 1e-3
"""How deep the heaviest line sinks into the bed, m."""

_CONNECTION = (
    "Connection, ConnectionX, ConnectionY, ConnectionZ, ConnectionAzimuth, ConnectionDeclination, "
    "ConnectionGamma, ConnectionReleaseStage, ConnectionzRelativeTo"
)
_ATTACHMENT = "AttachmentType, Attachmentx, Attachmenty, Attachmentz, AttachmentzRelativeTo"


def orcaflex_lines(deck: Deck, said: Iterable[str]) -> Iterator[str]:
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
    chains = chains_of(deck, Notes())
    hung = [point for chain in chains for point in chain.points[1:-1] if point.mass or point.volume]
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


def _line(number: int, chain: Chain, depth: float, lifted: float) -> Iterator[str]:
    """Yield a line; its fairlead is held by a fixed buoy that stands for the body."""
    anchor, fairlead = chain.anchor, chain.fairlead
    laid = math.degrees(math.atan2(fairlead.y - anchor.y, fairlead.x - anchor.x))
    yield f"  - Name: line {number}"
    yield "    TopEnd: End A"
    yield f"    ? {_CONNECTION}"
    yield f"    : - [body, {_place(fairlead, 0.0)}, 0, 0, 0, ~]"
    yield f"      - [Anchored, {_place(anchor, depth + lifted)}, 0, 90, 0, ~]"
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
