"""Lines as the floating array ontology (YAML) of IEA Wind Task 49."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from catopt.decks.deck import Deck, Notes
from catopt.decks.strung import Chain, chains_of
from catopt.errors import InputError, Problem
from catopt.export.exported import exact
from catopt.words import Message


def ontology_lines(deck: Deck, said: Iterable[str]) -> Iterator[str]:
    """Yield the lines of the file; `said`: what it says of itself.

    Raises InputError where an anchor stands above the bed.
    """
    chains = chains_of(deck, Notes())
    raised = max(chain.anchor.z for chain in chains) + deck.depth
    if raised > 0.0:
        allowed = Message("refused_command.must_be_0_ontology_anchors")
        raise InputError([Problem("line.anchor_height", f"{raised:.6g} m", allowed)], "ontology")
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
    hung = [point for chain in chains for point in chain.points[1:-1] if point.mass or point.volume]
    if hung:
        yield "mooring_connector_types:"
    for point in hung:
        body = (point.mass, point.volume, point.drag_area, point.added_mass)
        pairs = (f"{k}: {exact(v)}" for k, v in zip(("m", "v", "CdA", "Ca"), body, strict=True))
        yield f"  connector_{point.name}: {{{', '.join(pairs)}}}"
    yield "anchor_types:"
    yield "  anchor: {type: unspecified}"


def _body(chains: list[Chain]) -> Iterator[str]:
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
