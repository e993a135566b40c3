"""Reads MAP++'s input: four sections of three heading lines each, columns by position."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace

from catopt.decks.deck import MOST_PARTS, Deck, DeckPiece, End, LineType, Notes, Point, Row

_SECTIONS = ("types", "points", "lines", "options")
_HEADINGS = 2
"""Lines below the one with dashes that are not read."""

_OUTPUTS = """
gx_pos gy_pos gz_pos gx_a_pos gy_a_pos gz_a_pos gx_force gy_force gz_force h_fair v_fair h_anch
v_anch h_anchor v_anchor tension_fair tension_anch x_force y_force z_force fair_tension
anch_tension line_tension x_excursion z_excursion horizontal_excursion vertical_excursion
lay_length azimuth altitude altitude_anch altitude_anchor plot diagnostic contact
"""
_REFUSED = frozenset({"omit_contact", "linear_spring", "damage_time"})
"""Flags that change the answer; the refusals have them for keys."""
_ENDS: Mapping[str, End] = {"fix": "fixed", "vessel": "coupled", "connect": "free"}
_GIVEN = {
    "gravity": "--gravity 9.80665",
    "density": '--density "1025 kg/m^3"',
    "depth": '--depth "200 m"',
}


def parse_mappp(text: str, notes: Notes, given: Mapping[str, float]) -> Deck:
    """Read a deck; what is wrong with it is noted.

    `given`: ``gravity``, ``density`` and ``depth`` where the user gives them, SI: MAP++ has none of
    them in its file.
    """
    missing = [option for key, option in _GIVEN.items() if key not in given]
    if missing:
        notes.refuse(0, "", "map_has_none", missing=" ".join(missing))
    sections = _sections(text, notes)
    depth = given.get("depth", math.nan)
    types = notes.by_name({row: _type(row, notes) for row in sections["types"]})
    points = notes.by_name({row: _point(row, depth, notes) for row in sections["points"]})
    pieces = [piece for row in sections["lines"] for piece in _piece(row, notes)]
    named = {name.casefold(): name for name in types} | {name: name for name in types}
    pieces = [
        replace(piece, type=named.get(piece.type, named.get(piece.type.casefold(), piece.type)))
        for piece in pieces
    ]
    repeats = _repeats(sections["options"], notes)
    if len(repeats) * max(len(points), len(pieces)) > MOST_PARTS:
        notes.refuse(repeats[0][0], "repeat", "most_parts", count=len(repeats), most=MOST_PARTS)
        notes.raise_if_any()
    for number, angle in repeats:
        notes.say("repeat", line=number, angle=angle)
        turned = _turned(points, pieces, angle)
        points, pieces = points | turned[0], pieces + turned[1]
    gravity, density = (given.get(key, math.nan) for key in ("gravity", "density"))
    return Deck(gravity, density, depth, types, points, pieces)


def _sections(text: str, notes: Notes) -> dict[str, list[Row]]:
    found: dict[str, list[Row]] = {name: [] for name in _SECTIONS}
    section, skip = -1, 0
    for number, line in enumerate(text.splitlines(), start=1):
        words = tuple(line.split("!")[0].split())
        if line.startswith("-"):
            section, skip = section + 1, _HEADINGS
        elif not 0 <= section < len(_SECTIONS):
            if line.strip():
                notes.refuse(number, line.strip()[:40], "four_sections")
        elif skip:
            skip -= 1
        elif words and _SECTIONS[section] == "options" and line[0] in " \t":
            notes.say("commented", line=number, text=" ".join(words)[:40])
        elif words:
            found[_SECTIONS[section]].append(Row(number, words))
    notes.require(found)
    return found


def _type(row: Row, notes: Notes) -> LineType:
    names = "Diam", "MassDenInAir", "EA"
    diameter, mass, EA = (notes.number(row, k + 1, names[k], above=0.0) for k in range(3))
    friction = notes.number(row, 4, "CB", at_least=0.0)
    if len(row.words) > 5:
        notes.say("unused_by_map", line=row.number, values=" ".join(row.words[5:9]))
    return LineType(row.number, diameter, mass, EA, friction)


def _point(row: Row, depth: float, notes: Notes) -> Point:
    kind = row.words[1].lower() if len(row.words) > 1 else ""
    if kind not in _ENDS:
        notes.refuse(row.number, " ".join(row.words[:2]), "node_kind")
    end = _ENDS.get(kind, "free")
    x, y, z = (_coordinate(row, column, depth, end, notes) for column in (2, 3, 4))
    mass, volume = (notes.number(row, 5 + k, "MB"[k], at_least=0.0) for k in (0, 1))
    point = Point(row.number, row.words[0], end, x, y, z, mass, volume)
    if end != "free":
        return point  # MAP++ takes what stands there for a guess
    along, across, up = (_force(row, 7 + k, notes) for k in range(3))
    return replace(point, force=(along, across, up))


def _force(row: Row, column: int, notes: Notes) -> float:
    """Read what pulls a node that is to be found; a number after # is no force of it."""
    word = row.words[column] if column < len(row.words) else "#"
    return 0.0 if word.startswith("#") else notes.value(row.number, word, f"F{'XYZ'[column - 7]}")


def _coordinate(row: Row, column: int, depth: float, end: End, notes: Notes) -> float:
    if column >= len(row.words):
        return notes.number(row, column, "XYZ"[column - 2])
    word = row.words[column]
    if word.lower() == "depth" and column == 4 and end == "fixed":
        return -depth
    if word.startswith("#"):
        if end != "free":
            notes.refuse(row.number, word, "give_a_number")
        word = word[1:] or "0"  # where a node that is to be found begins does not matter
    return notes.value(row.number, word, "XYZ"[column - 2])


def _piece(row: Row, notes: Notes) -> Iterator[DeckPiece]:
    if len(row.words) < 5:
        notes.refuse(row.number, " ".join(row.words), "line_of_five")
        return
    for flag in row.words[5:]:
        if flag.lower() in _REFUSED:
            notes.refuse(row.number, flag, flag.lower())
        elif flag.lower() in _OUTPUTS.split():
            notes.say("flag", line=row.number)
        else:
            notes.refuse(row.number, flag, "flag_not_known")
    length = notes.number(row, 2, "UnstrLen", above=0.0)
    yield DeckPiece(row.number, row.words[1], (row.words[3], row.words[4]), length)


def _repeats(rows: list[Row], notes: Notes) -> list[tuple[int, float]]:
    found: list[tuple[int, float]] = []
    run: list[str] = []
    for row in rows:
        if row.words[0].lower() == "repeat":
            found += [(row.number, notes.value(row.number, w, "repeat")) for w in row.words[1:]]
        else:
            run.append(f"{row.words[0]} ({row.number})")
    if run:
        notes.say("run", keys=", ".join(run))
    return found


def _turned(
    points: Mapping[str, Point], pieces: list[DeckPiece], angle: float
) -> tuple[dict[str, Point], list[DeckPiece]]:
    """Copy the first arrangement, turned clockwise as MAP++ does it."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    own = {name: point for name, point in points.items() if "@" not in name}
    tag = f"@{angle:g}"
    copies = {
        name + tag: replace(
            point,
            name=name + tag,
            x=c * point.x + s * point.y,
            y=c * point.y - s * point.x,
            force=(
                c * point.force[0] + s * point.force[1],
                c * point.force[1] - s * point.force[0],
                point.force[2],
            ),
        )
        for name, point in own.items()
    }
    return copies, [
        replace(piece, ends=(piece.ends[0] + tag, piece.ends[1] + tag))
        for piece in pieces
        if "@" not in piece.ends[0]
    ]
