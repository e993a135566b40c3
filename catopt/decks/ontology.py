"""Reads the floating array ontology (YAML) of IEA Wind Task 49 as far as it has moorings.

Headings count clockwise from north (y), relative to the platform; sections run from the anchor.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping

from catopt.decks.deck import Deck, DeckPiece, LineType, Notes, Point, refusal
from catopt.decks.moordyn import with_defaults
from catopt.decks.to_case import DeckSection, PointMass, from_sections
from catopt.decks.tree import YamlTable, parse_yaml

_UNREAD = {
    "unread_weather": "metocean|resource|RAFT|[Ww]aves|marine_growth|_air$",
    "unread_elsewhere": "array|cable|topside|turbine|substation|members|Jtubes|boundaries|"
    "exclusions|seabed|potMod|dlsMax|qtfPath",
    "unread_words": "^(name|comments|type|material|cost|anchorType|d_nom|ID|platformID|"
    "z_location|adjustable|lengthAdjust|EAd|EAd_Lm|anchor_types)$",
}
_ROPE_VOLUME = math.sqrt(4.0 * 679.0 / 1380.0 / math.pi)
_FAMILIES = {
    "chain": (20.0e3, 1.80, 85.6e9, -3.93e7, 0.0, 9.11e2, 1.21e9, -2.19e9),
    "chain_studlink": (21.9e3, 1.89, 88.0e9, 0.0, 0.0, 9.11e2, 1.21e9, -2.19e9),
    "wire": (5293.0, 1.18, 97.1e9, 0.0, 0.0, 0.0, 1022e6, 0.0),
    "polyester": (679.0, _ROPE_VOLUME, 0.0, 0.0, 14.0, 0.0, 308e6, 0.0),
}
"""m/d2, d_vol/d, EA/d2, EA/d3, EA/MBL, MBL/d, MBL/d2, MBL/d3 by MoorPy 1.3.0, MoorProps_default."""

_KEYS = ("gravity", "g"), ("density", "rho_water"), ("depth", "water_depth")


def parse_ontology(text: str, notes: Notes, given: Mapping[str, float]) -> Deck:
    """Read a file; what is wrong with it is noted.

    `given`: ``gravity``, ``density`` and ``depth`` where the user gives them, SI.
    """
    top = parse_yaml(text, notes)
    site = top.table("site")
    general = site.table("general")
    if any(item.value is not None for item in site.table("bathymetry").items.values()):
        bed = site.items["bathymetry"]
        notes.refuse(bed.row, "bathymetry", "level_bed_for_water_depth")
    if "array_mooring" in top and notes.only is None:
        notes.refuse(top.items["array_mooring"].row, "array_mooring", "array_mooring")
    found = {name: general.number(key, above=0.0) for name, key in _KEYS if key in general}
    site_values = with_defaults(found, notes, given)
    friction = general.number("seabed_friction", 0.0, at_least=0.0)
    types = {name: _type(row, notes) for name, row in top.named("mooring_line_types")}
    connectors = {name: _connector(row) for name, row in top.named("mooring_connector_types")}
    configs = dict(top.named("mooring_line_configs"))
    systems = dict(top.named("mooring_systems"))
    points: dict[str, Point] = {}
    pieces: list[DeckPiece] = []
    for place, turned, fairleads, system in _platforms(top, systems, notes):
        for number, row in enumerate(system.rows(), start=1):
            name = row.text("MooringConfigID")
            config = configs.get(name)
            if config is None:
                notes.refuse(row.row, name, "no_such_line", known=", ".join(configs))
                continue
            ends = _ends(row, config, place, turned, fairleads, site_values["depth"])
            parts = list(_parts(config, connectors, types))
            more = from_sections(f"{len(pieces)}-{number}", ends, parts)
            points, pieces = points | more[0], pieces + more[1]
    if not pieces:
        notes.refuse(0, "", "no_mooring_line")
    top.say_unread(_UNREAD)
    gravity, density, depth = (site_values[name] for name, _ in _KEYS)
    return Deck(gravity, density, depth, types, points, pieces, friction)


def _connector(row: YamlTable) -> PointMass:
    """Read what hangs between two sections."""
    mass, volume, area, added = (
        row.number(key, 0.0, at_least=0.0) for key in ("m", "v", "CdA", "Ca")
    )
    return PointMass(row.row, mass, volume, area, added)


def _type(row: YamlTable, notes: Notes) -> LineType:
    """Read a line type; drag is MoorDyn's, on the volume-equivalent diameter."""
    diameter, mass, EA = (row.number(key, above=0.0) for key in ("d_vol", "m", "EA"))
    drag = None
    if "Cd" in row:
        keys = ("Cd", "CdAx", "Ca", "CaAx")
        across, along, added, added_along = (row.number(key, 0.0, at_least=0.0) for key in keys)
        drag = (across, along, added, added_along)
    MBL, nominal = (row.number(key, above=0.0) if key in row else None for key in ("MBL", "d_nom"))
    if "EAd" in row:
        notes.say("static_stiffness", line=row.row, value="EA, EAd", taken=f"{EA:g}")
    return LineType(row.row, diameter, mass, EA, None, drag, MBL, nominal)


def of_family(part: YamlTable, name: str, d: float) -> LineType | None:
    """Return what MoorPy makes of a family and a nominal diameter, m, which decks refer to."""
    if name not in _FAMILIES:
        known = ", ".join(_FAMILIES)
        part.notes.refuse(part.row, f"mooringFamily {name}", "family", known=known)
        return None
    mass, volume, EA2, EA3, EA_MBL, MBL1, MBL2, MBL3 = _FAMILIES[name]
    MBL = MBL1 * d + MBL2 * d**2 + MBL3 * d**3
    EA = EA2 * d**2 + EA3 * d**3 + EA_MBL * MBL
    part.notes.say("family", line=part.row, name=name, EA=EA, MBL=MBL)
    return LineType(part.row, volume * d, mass * d**2, EA, None, None, MBL, d)


Fairleads = list[tuple[complex, float]]
"""x + iy and z of the fairleads of a platform, m; the first is that of rFair and zFair."""


def _platforms(
    top: YamlTable, systems: Mapping[str, YamlTable], notes: Notes
) -> Iterator[tuple[complex, float, Fairleads, YamlTable]]:
    """Yield place, heading (deg), fairleads and mooring system of each platform."""
    kinds = [top.table("platform")] if "platform" in top else list(top.tables("platforms"))
    rows = list(top.table("array").rows())
    if not kinds or not systems:
        notes.refuse(0, "", "platforms_wanted")
        return
    if not rows:
        for system in systems.values():
            yield 0j, 0.0, _fairleads(kinds[0]), system
        return
    alone = len(rows) == 1
    if alone:
        notes.say("platform_at_origin", line=rows[0].row)
    for row in rows:
        x, y = (row.number(key, 0.0) for key in ("x_location", "y_location"))
        number = row.number("platformID", 1.0, at_least=1.0)
        name = row.text("mooringID")
        if name == "0":  # held by the lines of array_mooring alone
            continue
        mooring = systems.get(name)
        if mooring is None or number not in range(1, len(kinds) + 1):
            found = refusal("platform_of", number=number, name=name)
            notes.refuse(row.row, found, "platform_wanted", known=", ".join(systems))
            continue
        place = 0j if alone else complex(x, y)
        yield place, row.number("heading_adjust", 0.0), _fairleads(kinds[int(number) - 1]), mooring


def _fairleads(platform: YamlTable) -> Fairleads:
    """Read the fairleads; headings of one turn it from x to where they point."""
    r, z = platform.number("rFair", 0.0), platform.number("zFair", 0.0)
    found: Fairleads = [(complex(r, 0.0), z)]
    for fairlead in platform.tables("fairleads"):
        x, y, z = fairlead.numbers("r_rel", 3)
        headings = fairlead.item("headings").value
        if headings is None:
            found.append((complex(x, y), z))
            continue
        for number in fairlead.numbers("headings", len(fairlead.items_of("headings"))):
            found.append((complex(x, y) * _ahead(number), z))
    return found


def _ahead(heading: float) -> complex:
    """Return the direction of a compass heading (deg): x is east, y north."""
    return cmath.rect(1.0, math.radians(90.0 - heading))


def _ends(
    row: YamlTable,
    config: YamlTable,
    place: complex,
    turned: float,
    fairleads: Fairleads,
    depth: float,
) -> tuple[Point, Point]:
    """Place anchor and fairlead of a line."""
    ahead = _ahead(turned + row.number("heading"))
    span = config.number("span", above=0.0)
    own, z = fairleads[0]
    top = place + own.real * ahead
    if isinstance(row.item("fairlead").value, list):
        row.notes.refuse(row.row, refusal("several_fairleads"), "bridle")
    elif "fairlead" in row:
        number = row.number("fairlead", at_least=1.0)
        if number not in range(len(fairleads)):
            given, count = f"fairlead {row.text('fairlead')}", len(fairleads) - 1
            row.notes.refuse(row.row, given, "fairleads_are", count=count)
            number = 0.0
        own, z = fairleads[int(number)]
        top = place + own * cmath.rect(1.0, math.radians(-turned))
    foot = top + span * ahead
    return (
        Point(row.row, "", "fixed", foot.real, foot.imag, -depth),
        Point(row.row, "", "coupled", top.real, top.imag, z),
    )


def _parts(
    config: YamlTable, connectors: Mapping[str, PointMass], types: dict[str, LineType]
) -> Iterator[DeckSection | PointMass]:
    """Yield sections and connectors from the anchor to the fairlead; families become types."""
    notes = config.notes
    if config.text("symmetric", "false").lower() in ("true", "yes"):
        notes.refuse(config.row, "symmetric", "two_platforms")
    for part in config.tables("sections"):
        name = part.text("connectorType")
        if name in connectors:
            yield connectors[name]
        elif name and connectors:
            notes.refuse(part.row, name, "none_of_known", known=", ".join(connectors))
        elif name:
            notes.say("connector", line=part.row, name=name)
        if "subsections" in part:
            notes.refuse(part.row, "subsections", "side_by_side")
        elif "mooringFamily" in part:
            kind = of_family(part, part.text("mooringFamily"), part.number("d_nom", above=0.0))
            if kind is not None:
                name = f"{part.text('mooringFamily')} {part.text('d_nom')}"
                types.setdefault(name, kind)
                yield DeckSection(part.row, name, part.number("length", above=0.0))
        elif "type" in part:
            yield DeckSection(part.row, part.text("type"), part.number("length", above=0.0))
