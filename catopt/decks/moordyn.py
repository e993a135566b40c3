"""Reads MoorDyn's input, version 1 and 2, as its C++ and Fortran editions and MoorPy take it.

Sections are found by a line with ``---`` and a key word; columns go by position.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping

from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.decks.deck import Deck, End, Limits, LineType, Notes, Piece, Point, Row

_SECTIONS = (
    (r"ROD\s+(TYPES|DICTIONARY)", "rod types"),
    (r"LINE\s+(TYPES|DICTIONARY)", "types"),
    (r"FAILURE", "failures"),
    (r"CONTROL", "control"),
    (r"EXTERNAL", "external loads"),
    (r"\bBOD(Y|IES)\b", "bodies"),
    (r"\bRODS?\b", "rods"),
    (r"\b(POINTS?|CONNECTIONS?|NODE)\b", "points"),
    (r"\bLINES\b|LINE\s+(LIST|PROPERTIES)", "lines"),
    (r"OPTIONS", "options"),
    (r"OUTPUT", "outputs"),
)
"""Key words of the sections; the first that is found decides."""

_REFUSED = {
    "rods": "catopt has no rods; hold the lines' ends where the rod would (Fixed or Coupled)",
    "failures": "lines do not fail in a case; take the section out, and see catopt system "
    "--without for a lost line",
    "control": "lines that are paid out or hauled in have no case; give each its length and "
    "take the section out",
    "external loads": "forces and dampings of their own have no case; take the section out",
}
"""Sections that change the answer, with the way out."""

_MEANINGS = {
    "gravity": "g gravity",
    "density": "rho wtrdnsty rhow",
    "depth": "wtrdpth wtrdepth depth waterdepth",
    "friction": "frictioncoefficient mu_ka",
    "bed": "kbot kb cbot cb fricdamp statdynfricscale mu_kt cv mc",
    "water": "wavekin waterkin currents dtwave",
    "bathymetry": "bathymetry bathymetryfile bathyfile seafloorfile seafloorpath",
    "run": "dtm dtic dtout tmaxic cdscaleic threshic icgendynamic icdfac icdt ictmax icthresh "
    "writelog writeunits writestate tscheme cfl relax dtmax inertialf inertialf_rampt echo fileic "
    "outswitch disableouttime disableoutput",
}
_NAMES = {key: meaning for meaning, keys in _MEANINGS.items() for key in keys.split()}
"""What the keys of OPTIONS mean, in lower case; several readers, several names."""

_KINDS: Mapping[End, str] = {
    "fixed": "fixed fix anchor",
    "coupled": "coupled vessel ves cpld fairlead",
    "free": "free point connect con",
}
_ENDS = {word: end for end, words in _KINDS.items() for word in words.split()}
_BED = frozenset({"seabed", "ground", "floor"})
_COLUMNS_1, _COLUMNS_2 = 9, (10, 11, 13)
"""Of LINE TYPES, in the two versions."""


def parse_moordyn(text: str, notes: Notes, given: Mapping[str, float]) -> Deck:
    """Read a deck; what is wrong with it is noted.

    `given`: ``gravity``, ``density`` and ``depth`` where the user gives them, SI.
    """
    sections = _sections(text, notes)
    for name, allowed in _REFUSED.items():
        for row in sections.get(name, ()):
            notes.refuse(row.number, f"{name}: {' '.join(row.words)[:40]}", allowed)
    if sections.get("outputs"):
        notes.say("outputs", line=sections["outputs"][0].number)
    for row in sections.get("rod types", ()):
        notes.say("rod_type", line=row.number, name=row.words[0])
    notes.want(sections)
    options = _options(sections.get("options", []), notes, given)
    first = sections["types"][0] if sections.get("types") else None
    is_first_version = first is not None and len(first.words) == _COLUMNS_1
    notes.say("version", version=1 if is_first_version else 2)
    bodies = dict(_bodies(sections.get("bodies", []), notes))
    gravity, density, depth, friction = (
        options[k] for k in ("gravity", "density", "depth", "friction")
    )
    types = {row: _type(row, notes) for row in sections.get("types", ())}
    points = {row: _point(row, depth, bodies, notes) for row in sections.get("points", ())}
    pieces = [_piece(row, notes, first=is_first_version) for row in sections.get("lines", ())]
    if friction > 0.0:
        notes.say("friction_at_rest", friction=friction)
    named = notes.by_name(types), notes.by_name(points)
    return Deck(gravity, density, depth, *named, pieces, friction)


def _sections(text: str, notes: Notes) -> dict[str, list[Row]]:
    """Cut the file; the two lines below the head of a section are not read."""
    found: dict[str, list[Row]] = {}
    name, heading = "", 0
    for number, line in enumerate(text.splitlines(), start=1):
        words = tuple(line.split("#")[0].split())
        if "---" in line:
            name = _named(line, begun=bool(found))
            heading = 0 if name in ("", "options", "outputs") or name[0] == "?" else 2
            if name and not name.startswith("?"):
                found.setdefault(name, [])
        elif heading:
            # Version 1 says how many there are: ``3 NTypes``.
            is_count = len(words) > 1 and re.fullmatch(r"N[A-Z]\w+", words[1]) is not None
            heading -= not is_count
        elif words[:1] == ("END",) and name == "outputs":
            name = ""
        elif words and name.startswith("?"):
            notes.refuse(number, f"section {name[1:]!r}", "it is not known; take it out")
            name = ""
        elif words and name:
            if "\t" in line.rstrip() and name != "outputs":
                notes.say("tab", line=number)
            found[name].append(Row(number, words))
    return found


def _named(head: str, *, begun: bool) -> str:
    """Return the section of a line with ``---``; before the first one, a title is none."""
    for pattern, name in _SECTIONS:
        if re.search(pattern, head.upper()):
            return name
    words = head.replace("-", " ").strip()
    if not begun or not words or words.upper() == "END" or "need this line" in words.lower():
        return ""
    return f"?{words[:40]}"


def _options(rows: list[Row], notes: Notes, given: Mapping[str, float]) -> dict[str, float]:
    """Read the options; of one that stands twice the last counts."""
    found: dict[str, float] = {}
    run: dict[str, int] = {}
    for row in rows:
        if len(row.words) < 2:
            notes.refuse(row.number, row.words[0], "a value and a key are wanted")
            continue
        value, key = row.words[0], row.words[1]
        meaning = _NAMES.get(key.lower(), "")
        if meaning in ("gravity", "density", "depth", "friction"):
            _option(row, meaning, found, notes)
        elif meaning == "bathymetry":
            allowed = "the bed is level in a case; take it out and give WtrDpth one number"
            notes.refuse(row.number, f"{key} {value}", allowed)
        elif meaning == "run":
            run.setdefault(key, row.number)
        elif meaning == "water":
            if value != "0":
                notes.say("water", line=row.number, key=key, value=value)
        elif meaning:
            notes.say("bed", line=row.number, key=key, value=value)
        else:
            notes.say("option", line=row.number, key=key, value=value)
    if run:
        listed = ", ".join(f"{key} ({number})" for key, number in run.items())
        notes.say("run", keys=listed)
    return settled(found, notes, given)


def _option(row: Row, meaning: str, found: dict[str, float], notes: Notes) -> None:
    value, key = row.words[:2]
    if meaning == "depth" and not re.match(r"[-+.\d]", value):
        allowed = "the bed is level in a case; give one depth in metres"
        notes.refuse(row.number, f"{key} {value}", allowed)
        return
    if meaning in found:
        notes.say("twice", line=row.number, key=key, value=value)
    low: Limits = {"at_least": 0.0} if meaning == "friction" else {"above": 0.0}
    found[meaning] = notes.value(row.number, value, key, **low)


def settled(found: dict[str, float], notes: Notes, given: Mapping[str, float]) -> dict[str, float]:
    """Put in what the user gives, and what MoorDyn takes where the deck says nothing.

    `found`, `given`: gravity, density, depth and friction as far as the deck and the user have
    them, SI; `notes`: takes problems and remarks.
    """
    for key, value in given.items():
        if key in found:
            allowed = f"the deck has {found[key]:g}; leave the option out"
            notes.refuse(0, f"--{key} {value:g}", allowed)
        found[key] = value
    for key, own, remark in (
        ("gravity", STANDARD_GRAVITY, "no_gravity"),
        ("density", SEA_WATER_DENSITY, "no_density"),
    ):
        if key not in found:
            found[key] = own
            notes.say(remark, value=own)
    if "depth" not in found:
        allowed = (
            "the water depth is missing in the deck; write it with catopt import FILE "
            '--depth "200 m" --out case.toml'
        )
        notes.refuse(0, "", allowed)
    return {"depth": math.nan, "friction": 0.0} | found


def _type(row: Row, notes: Notes) -> LineType:
    count = len(row.words)
    if count != _COLUMNS_1 and count not in _COLUMNS_2:
        allowed = "9 are wanted in version 1, 10, 11 or 13 in version 2; MoorDyn fails on others"
        notes.refuse(row.number, f"{count} columns", allowed)
        return LineType(row.number, math.nan, math.nan, math.nan)
    name = row.words[0]
    diameter = notes.number(row, 1, "Diam", above=0.0)
    mass = notes.number(row, 2, "MassDen", above=0.0)
    EA = _stiffness(row, notes)
    if row.words[4].split("|")[0] not in ("0", "0.0"):
        notes.say("damping", line=row.number, value=row.words[4])
    first = count == _COLUMNS_1
    if not first:
        EI = notes.number(row, 5, "EI", at_least=0.0)
        if EI > 0.0:
            notes.say("bending", line=row.number, name=name, value=EI)
        for column, key in ((10, "Cl"), (11, "dF"), (12, "cF")):
            if column < count and notes.number(row, column, key) > 0.0:
                notes.say("vortex", line=row.number, key=key, value=row.words[column])
    order = ("Ca", "CaAx", "Cd", "CdAx") if first else ("Cd", "Ca", "CdAx", "CaAx")
    start = 5 if first else 6
    drag = {key: notes.number(row, start + k, key, at_least=0.0) for k, key in enumerate(order)}
    in_order = (drag["Cd"], drag["CdAx"], drag["Ca"], drag["CaAx"])
    return LineType(row.number, diameter, mass, EA, None, in_order)


def _stiffness(row: Row, notes: Notes) -> float:
    word = row.words[3]
    if not re.match(r"[-+.\d]", word):
        allowed = "a table of strain and tension has no case; give EA one number, at the tension"
        notes.refuse(row.number, f"EA {word}", allowed)
        return math.nan
    first, *others = word.split("|")
    if others:
        notes.say("static_stiffness", line=row.number, value=word, taken=first)
    return notes.value(row.number, first, "EA", above=0.0)


def _bodies(rows: list[Row], notes: Notes) -> Iterator[tuple[str, Point]]:
    for row in rows:
        word = row.words[1].lower().rstrip("0123456789") if len(row.words) > 1 else ""
        end = _ENDS.get(word)
        if len(row.words) < 8 or end not in ("fixed", "coupled"):
            allowed = (
                "a body that moves by itself has no case; put its points in as Coupled, where "
                "they are at rest"
            )
            notes.refuse(row.number, f"body {' '.join(row.words[:2])}", allowed)
            continue
        x, y, z, *turned = (notes.number(row, 2 + k, "XYZrpy"[k]) for k in range(6))
        if any(turned):
            allowed = "a body that is turned has no case; give its points as they are, Coupled"
            notes.refuse(row.number, f"{turned[0]:g} {turned[1]:g} {turned[2]:g} deg", allowed)
        if end == "coupled":
            notes.say("body", line=row.number, name=row.words[0])
        yield row.words[0], Point(row.number, row.words[0], end, x, y, z)


def _point(row: Row, depth: float, bodies: Mapping[str, Point], notes: Notes) -> Point:
    name, kind = row.words[0], row.words[1].lower() if len(row.words) > 1 else ""
    stem = kind.rstrip("0123456789")
    body = bodies.get(kind.removeprefix("body")) if stem == "body" else None
    end = body.end if body else _ENDS.get(stem)
    if end is None and stem != "body":
        allowed = "Fixed, Coupled or Free is wanted; lines to turbines of a farm have no case"
        notes.refuse(row.number, row.words[1] if kind else name, allowed)
    elif end is None:
        notes.refuse(row.number, row.words[1], "there is no such Fixed or Coupled body")
    word = row.words[4].lower() if len(row.words) > 4 else ""
    x, y = notes.number(row, 2, "X"), notes.number(row, 3, "Y")
    if word in _BED:
        notes.say("on_bed", line=row.number, word=word)
        z = -depth
    else:
        z = notes.number(row, 4, "Z")
    if body:
        x, y, z = x + body.x, y + body.y, z + body.z
    if len(row.words) not in (9, 12):
        notes.refuse(row.number, f"{len(row.words)} columns", "9 or 12 are wanted")
        return Point(row.number, name, end or "free", x, y, z)
    at = 7
    if len(row.words) == 12:
        at = 10
        if any(notes.number(row, k, "force") for k in (7, 8, 9)):
            allowed = "a constant force on a point has no case; give mass and volume instead"
            notes.refuse(row.number, " ".join(row.words[7:10]), allowed)
    columns = ((5, "Mass"), (6, "Volume"), (at, "CdA"), (at + 1, "Ca"))
    of_body = (notes.number(row, column, key, at_least=0.0) for column, key in columns)
    return Point(row.number, name, end or "free", x, y, z, *of_body)


def _piece(row: Row, notes: Notes, *, first: bool) -> Piece:
    """Read a line; version 1 has its length before its ends."""
    if len(row.words) < 6:
        allowed = "6 or 7 are wanted: number, type, ends, length, segments, outputs"
        notes.refuse(row.number, f"{len(row.words)} columns", allowed)
        return Piece(row.number, "", ("", ""), math.nan)
    at, ends = (2, row.words[4:6]) if first else (4, row.words[2:4])
    for end in ends:
        if re.match(r"[A-Za-z]", end):
            notes.refuse(row.number, end, _REFUSED["rods"])
    notes.say("segments")
    length = notes.number(row, at, "UnstrLen", above=0.0)
    return Piece(row.number, row.words[1], (ends[0], ends[1]), length)
