"""Reads the mooring tables of RAFT's designs and of windIO (YAML): points or nodes, lines, types.

Places are from the still water, those of a vessel's points along its axes, where it stands at
x = y = 0. The diameter of a line type is the volume-equivalent one, as MoorPy takes it.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping

from catopt.decks.deck import Deck, DeckPiece, End, LineType, Notes, Point
from catopt.decks.moordyn import with_defaults
from catopt.decks.ontology import of_family
from catopt.decks.tree import YamlTable, parse_yaml

_ENDS: Mapping[str, End] = {
    "fixed": "fixed",
    "anchor": "fixed",
    "vessel": "coupled",
    "coupled": "coupled",
    "body": "coupled",
    "free": "free",
    "connection": "free",
    "connect": "free",
}
_UNREAD = {
    "unread_weather": "^(wave|wind|metocean|current|shearExp|air|soil)",
    "unread_elsewhere": "^(turbine|platform|members|settings|cases|tower|blade|nacelle|hub|"
    "assembly|components|control|bos|costs|materials|airfoils|array|floating_platform|environment|joints)",
    "unread_words": "^(name|type|comments|description|windIO_version|anchor|cost|potMod|moorMod|"
    "currentMod|joint|transition)",
}
_GRAVITY = 9.81
"""m/s2: what RAFT takes where a design has none (raft_model.py)."""


def parse_tables(text: str, notes: Notes, given: Mapping[str, float]) -> Deck:
    """Read a file; what is wrong with it is noted.

    `given`: ``gravity``, ``density`` and ``depth`` where the user gives them, SI.
    """
    top = parse_yaml(text, notes)
    components = top.table("components")
    is_raft = "mooring" in top
    mooring = (top if is_raft else components).table("mooring")
    place = (top.table("site"), mooring) if is_raft else (top.table("environment"),)
    keys = {
        "gravity": ("g", "gravity"),
        "density": ("rho_water", "water_density"),
        "depth": ("water_depth",),
    }
    found = {
        name: table.number(key, above=0.0)
        for name, names in keys.items()
        for table in place
        for key in names
        if key in table
    }
    if is_raft and "gravity" not in {*found, *given}:
        found["gravity"] = _GRAVITY
        notes.say("raft_gravity", value=_GRAVITY)
    site = with_defaults(found, notes, given)
    joints = dict(_joints(components.table("floating_platform")))
    types = {row.text("name"): _type(row) for row in mooring.tables("line_types")}
    points = {
        row.text("name"): _point(row, joints)
        for key in ("points", "nodes")
        for row in mooring.tables(key)
    }
    pieces = [_piece(row) for row in mooring.tables("lines")]
    if not pieces:
        notes.refuse(mooring.row, "", "no_mooring_line")
    notes.say("vessel_at_origin")
    top.say_unread(_UNREAD)
    return Deck(site["gravity"], site["density"], site["depth"], types, points, pieces)


def _type(row: YamlTable) -> LineType:
    """Read a line type: its own figures, or those of a family by its nominal diameter."""
    family, diameter = row.text("type", "custom"), row.number("diameter", above=0.0)
    if "mass_density" not in row and family != "custom":
        return of_family(row, family, diameter) or LineType(row.row, diameter, 1.0, 1.0)
    mass, EA = row.number("mass_density", above=0.0), row.number("stiffness", above=0.0)
    keys = ("drag", "added_mass")
    drag = None
    if "transverse_drag" in row:
        across, along, added, added_along = (
            row.number(f"{way}_{key}", 0.0, at_least=0.0)
            for key in keys
            for way in ("transverse", "tangential")
        )
        drag = (across, along, added, added_along)
    MBL = row.number("breaking_load", above=0.0) if "breaking_load" in row else None
    return LineType(row.row, diameter, mass, EA, None, drag, MBL)


def _joints(platform: YamlTable) -> Iterator[tuple[str, tuple[float, float, float]]]:
    """Place the joints of windIO's floating platform, and those on the axes of its members."""
    known: dict[str, tuple[float, float, float]] = {}
    for row in platform.tables("joints"):
        x, y, z = row.numbers("location", 3)
        if row.text("cylindrical", "false").lower() == "true":
            place = cmath.rect(x, math.radians(y))
            x, y = place.real, place.imag
        known[row.text("name")] = (x, y, z)
    yield from known.items()
    for member in platform.tables("members"):
        first, last = (known.get(member.text(key)) for key in ("joint1", "joint2"))
        for row in member.tables("axial_joints"):
            if first is not None and last is not None:
                share = row.number("grid", at_least=0.0)
                x, y, z = (a + share * (b - a) for a, b in zip(first, last, strict=True))
                yield row.text("name"), (x, y, z)


def _point(row: YamlTable, joints: Mapping[str, tuple[float, float, float]]) -> Point:
    """Read a point of RAFT's or a node of windIO's, which may be at a joint of the platform."""
    notes, name = row.notes, row.text("name")
    word = row.text("type") or row.text("node_type")
    end = _ENDS.get(word.lower())
    if end is None:
        notes.refuse(row.row, word, "one_of", known=", ".join(_ENDS))
    joint = row.text("joint")
    if joint and joint not in joints and "location" not in row:
        notes.refuse(row.row, joint, "one_of", known=", ".join(joints))
    x, y, z = joints[joint] if joint in joints else row.numbers("location", 3)
    mass, volume, area, added = (
        row.number(long if long in row else short, 0.0, at_least=0.0)
        for long, short in (
            ("node_mass", "mass"),
            ("node_volume", "volume"),
            ("drag_area", "CdA"),
            ("added_mass", "Ca"),
        )
    )
    return Point(row.row, name, end or "free", x, y, z, mass, volume, area, added)


def _piece(row: YamlTable) -> DeckPiece:
    """Read a line."""
    ends = (
        row.text("endA") or row.text("node1"),
        row.text("endB") or row.text("node2"),
    )
    key = "unstretched_length" if "unstretched_length" in row else "length"
    kind = row.text("type") or row.text("line_type")
    return DeckPiece(row.row, kind, ends, row.number(key, above=0.0))
