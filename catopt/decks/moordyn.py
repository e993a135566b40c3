"""Reads MoorDyn's input, version 1 and 2, as its C++ and Fortran editions and MoorPy take it.

Sections are found by a line with ``---`` and a key word, columns by their heads, or by their number
where the heads are none that are known.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from catopt import tables
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.decks.deck import (
    Deck,
    DeckPiece,
    End,
    Limits,
    LineType,
    Notes,
    Point,
    Row,
    along_axes,
    refusal,
)
from catopt.documents import read_text
from catopt.errors import InputError
from catopt.model.line import StrainTable
from catopt.words import Message

_SECTIONS = (
    (r"SYROPE", "syrope_ic"),
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

_REFUSED = {"control": "control", "external loads": "external_loads"}
"""Sections that change the answer, with the keys of their refusals."""

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
_HEADS = {
    "types": "name=type,linetype diam=d,dia,diameter massden=mass,massdeninair ea "
    "ba=ba/-zeta,cintdamp ei cd=cdn ca=can cdax=cdt caax=cat cl df cf",
    "points": "id=node,point attachment=type,kind x y z mass=m volume=v,vol fx fy fz cda ca",
    "lines": "id=line linetype=type attacha=a,enda,nodea,nodeanch attachb=b,endb,nodeb,nodefair "
    "unstrlen=l,length",
}
"""How decks head the columns that are read, in lower case: the name in here, and what else."""
_NAMED = {
    section: {
        word: name
        for name, _, others in (head.partition("=") for head in heads.split())
        for word in (name, *filter(None, others.split(",")))
    }
    for section, heads in _HEADS.items()
}
_V1 = "name diam massden ea ba ca caax cd cdax"
_V2 = "name diam massden ea ba ei cd ca cdax caax"
_LAYOUTS = {
    "types": {9: _V1, 10: _V2, 11: f"{_V2} cl", 13: f"{_V2} cl df cf"},
    "points": {
        9: "id attachment x y z mass volume cda ca",
        12: "id attachment x y z mass volume fx fy fz cda ca",
    },
}
"""Columns by their number, where the heads are none that are known."""
_LINES = "id linetype attacha attachb unstrlen", "id linetype unstrlen ? attacha attachb"
"""Of LINES, in version 2 and 1."""


def parse_moordyn(text: str, notes: Notes, given: Mapping[str, float]) -> Deck:
    """Read a deck; what is wrong with it is noted.

    `given`: ``gravity``, ``density`` and ``depth`` where the user gives them, SI. A point of a
    turbine of a farm counts from the place of that turbine, which `notes` has of the user.
    """
    sections, heads = _sections(text, notes)
    for name, key in _REFUSED.items():
        for row in sections.get(name, ()):
            found = f"{name.upper()}: {' '.join(row.words)[:40]}"
            notes.refuse(row.number, found, key)
    for name in ("outputs", "failures", "syrope_ic"):
        if sections.get(name):
            notes.say(name, line=sections[name][0].number)
    for row in sections.get("rod types", ()):
        notes.say("rod_type", line=row.number, name=row.words[0])
    joints = sections.get("points") or sections.get("rods", [])
    notes.require(sections | {"points": joints})
    options = _options(sections.get("options", []), notes, given)
    first = sections["types"][0] if sections.get("types") else Row(0, ())
    of_types = _columns("types", first, heads, notes)
    is_first_version = bool(of_types) and "ei" not in of_types
    notes.say("version", version=1 if is_first_version else 2)
    bodies = dict(_bodies(sections.get("bodies", []), notes))
    gravity, density, depth, friction = (
        options[k] for k in ("gravity", "density", "depth", "friction")
    )
    types = {row: _type(row, heads, notes) for row in sections.get("types", ())}
    points = {row: _point(row, heads, depth, bodies, notes) for row in sections.get("points", ())}
    rods = {
        Row(row.number, (f"R{row.words[0].upper().removeprefix('R')}",)): point
        for row in sections.get("rods", ())
        if (point := _rod(row, bodies, notes)) is not None
    }
    names = {row.words[0] for row in rods}
    pieces = [
        _piece(row, heads, notes, names, first=is_first_version)
        for row in sections.get("lines", ())
    ]
    if friction > 0.0:
        notes.say("friction_at_rest", friction=friction)
    named = notes.by_name(types), notes.by_name(points | rods)
    return Deck(gravity, density, depth, *named, pieces, friction)


def _sections(text: str, notes: Notes) -> tuple[dict[str, list[Row]], dict[str, Row]]:
    """Cut the file into the rows of each section and the heads of its columns."""
    found: dict[str, list[Row]] = {}
    heads: dict[str, Row] = {}
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
            if heading == 2 and not is_count:
                heads.setdefault(name, Row(number, words))
            heading -= not is_count
        elif words[:1] == ("END",) and name == "outputs":
            name = ""
        elif words and name.startswith("?"):
            notes.refuse(number, refusal("section", name=name[1:]), "not_known")
            name = ""
        elif words and name:
            if "\t" in line.rstrip() and name != "outputs":
                notes.say("tab", line=number)
            found[name].append(Row(number, words))
    return found, heads


def _columns(
    section: str, row: Row, heads: Mapping[str, Row], notes: Notes, v: int = 2
) -> Mapping[str, int]:
    """Return where the columns of a row stand, from 0: by their heads, or by their number.

    Heads count where all that are required are there; where they contradict the place, it is said.
    """
    layout = _LAYOUTS.get(section, {}).get(len(row.words), _LINES[2 - v])
    by_place = {name: k for k, name in enumerate(layout.split())}
    head = heads.get(section, Row(0, ()))
    words = [word.lower() for word in head.words]
    by_head: dict[str, int] = {}
    for k, word in enumerate(words):
        by_head.setdefault(_NAMED[section].get(word, "?"), k)
    wanted = {"types": _V1, "points": _LAYOUTS["points"][9], "lines": _LINES[0]}[section]
    fits = section == "lines" or len(words) == len(row.words)
    if not fits or set(wanted.split()) - by_head.keys():
        known = len(row.words) in _LAYOUTS.get(section, {len(row.words): ""})
        return by_place if known else {}
    apart = [name for name, k in by_head.items() if by_place.get(name, k) != k and name != "?"]
    if apart:
        listed = ", ".join(f"{head.words[by_head[name]]} ({by_head[name] + 1})" for name in apart)
        notes.say("heads", line=head.number, columns=listed)
    return by_head


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
            notes.refuse(row.number, row.words[0], "value_and_key")
            continue
        value, key = row.words[0], row.words[1]
        meaning = _NAMES.get(key.lower(), "")
        if meaning in ("gravity", "density", "depth", "friction"):
            _option(row, meaning, found, notes)
        elif meaning == "bathymetry":
            notes.refuse(row.number, f"{key} {value}", "level_bed_for_WtrDpth")
        elif meaning == "run":
            run.setdefault(key, row.number)
        elif meaning != "water" or value != "0":
            notes.say(meaning or "option", line=row.number, key=key, value=value)
    if run:
        listed = ", ".join(f"{key} ({number})" for key, number in run.items())
        notes.say("run", keys=listed)
    return with_defaults(found, notes, given)


def _option(row: Row, meaning: str, found: dict[str, float], notes: Notes) -> None:
    value, key = row.words[:2]
    if meaning == "depth" and not re.match(r"[-+.\d]", value):
        notes.refuse(row.number, f"{key} {value}", "level_bed_for_depth")
        return
    if meaning in found:
        notes.say("twice", line=row.number, key=key, value=value)
    low: Limits = {"at_least": 0.0} if meaning == "friction" else {"above": 0.0}
    found[meaning] = notes.value(row.number, value, key, **low)


def with_defaults(
    found: dict[str, float], notes: Notes, given: Mapping[str, float]
) -> dict[str, float]:
    """Put in what the user gives, and what MoorDyn takes where the deck says nothing.

    `found`, `given`: gravity, density, depth and friction as far as the deck and the user have
    them, SI; `notes`: takes problems and remarks.
    """
    for key, value in given.items():
        if key in found:
            notes.refuse(0, f"--{key} {value:g}", "deck_has", value=found[key])
        found[key] = value
    for key, own, remark in (
        ("gravity", STANDARD_GRAVITY, "no_gravity"),
        ("density", SEA_WATER_DENSITY, "no_density"),
    ):
        if key not in found:
            found[key] = own
            notes.say(remark, value=own)
    if "depth" not in found:
        notes.refuse(0, "", "depth_is_missing")
    return {"depth": math.nan, "friction": 0.0} | found


def _type(row: Row, heads: Mapping[str, Row], notes: Notes) -> LineType:
    at = _columns("types", row, heads, notes)
    if not at:
        notes.refuse(row.number, refusal("columns", count=len(row.words)), "type_columns")
        return LineType(row.number, math.nan, math.nan, math.nan)
    name = row.words[at["name"]]
    diameter = notes.number(row, at["diam"], "Diam", above=0.0)
    mass = notes.number(row, at["massden"], "MassDen", above=0.0)
    EA = _stiffness(row, at["ea"], notes)
    damping = row.words[at["ba"]]
    if damping.split("|")[0] not in ("0", "0.0"):
        notes.say("damping", line=row.number, value=damping)
    if "ei" in at:
        EI = notes.number(row, at["ei"], "EI", at_least=0.0)
        if EI > 0.0:
            notes.say("bending", line=row.number, name=name, value=EI)
    for key in ("Cl", "dF", "cF"):
        place = at.get(key.lower())
        if place is not None and notes.number(row, place, key) > 0.0:
            notes.say("vortex", line=row.number, key=key, value=row.words[place])
    across, along, added, added_along = (
        notes.number(row, at[key.lower()], key, at_least=0.0)
        for key in ("Cd", "CdAx", "Ca", "CaAx")
    )
    drag = (across, along, added, added_along)
    return LineType(row.number, diameter, mass, EA, None, drag)


def _stiffness(row: Row, place: int, notes: Notes) -> float | StrainTable:
    word = row.words[place]
    if not re.match(r"[-+.\d]", word):
        return _strain_table(row, word, notes)
    first, *others = word.split("|")
    if others:
        notes.say("static_stiffness", line=row.number, value=word, taken=first)
    return notes.value(row.number, first, "EA", above=0.0)


def _strain_table(row: Row, word: str, notes: Notes) -> float | StrainTable:
    """Read the file of strains and tensions, N, that stands beside the deck."""
    path = Path(notes.source).parent / word
    model, colon, _ = word.partition(":")
    if colon:
        key = "syrope" if model.upper() == "SYROPE" else "model_of_stiffness"
        notes.refuse(row.number, f"EA {word}", key, name=model)
        return math.nan
    if Path(word).name != word or not path.is_file():
        notes.refuse(row.number, f"EA {word}", "a_table_of_strain")
        return math.nan
    rows = [line.split() for line in read_text(path, str(path), kind="table").splitlines()]
    try:
        # Two lines of heads come first.
        strain, tension = zip(
            *((tables.number(a), tables.number(b)) for a, b in filter(None, rows[2:])), strict=True
        )
        return StrainTable(strain, tension)
    except (ValueError, InputError) as error:
        said = error.problems[0] if isinstance(error, InputError) else Message("refused.number")
        notes.refuse(row.number, f"EA {word}", "no_table_of_strain", said=f"{said}")
        return math.nan


@dataclass(frozen=True)
class _Body:
    """A body of the deck; `end` is None where it moves by itself, which is refused."""

    end: End | None
    at: tuple[float, float, float]
    turned: tuple[float, float, float]
    """About x, y and z, deg; no more than one is not 0."""

    def place(self, x: float, y: float, z: float) -> tuple[float, float, float]:
        """Return where a point of the body is that has these coordinates along its axes."""
        x, y, z = along_axes((x, y, z), self.turned)
        return self.at[0] + x, self.at[1] + y, self.at[2] + z


def _bodies(rows: list[Row], notes: Notes) -> Iterator[tuple[str, _Body]]:
    for row in rows:
        word = row.words[1].lower().rstrip("0123456789") if len(row.words) > 1 else ""
        end = _ENDS.get(word)
        if len(row.words) < 8 or end not in ("fixed", "coupled"):
            body = refusal("body", name=" ".join(row.words[:2]))
            notes.refuse(row.number, body, "a_body_that_moves")
            yield row.words[0], _Body(None, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
            continue
        x, y, z, *turned = (notes.number(row, 2 + k, "XYZrpy"[k]) for k in range(6))
        if sum(angle != 0.0 for angle in turned) > 1:
            found = f"{turned[0]:g} {turned[1]:g} {turned[2]:g} deg"
            notes.refuse(row.number, found, "turned_about_several")
        elif any(turned):
            about, angle = next((k, angle) for k, angle in enumerate(turned) if angle)
            notes.say("turned", line=row.number, name=row.words[0], angle=angle, axis="xyz"[about])
        if end == "coupled":
            notes.say("body", line=row.number, name=row.words[0])
        yield row.words[0], _Body(end, (x, y, z), (turned[0], turned[1], turned[2]))


def _point(
    row: Row, heads: Mapping[str, Row], depth: float, bodies: Mapping[str, _Body], notes: Notes
) -> Point:
    at = _columns("points", row, heads, notes)
    if not at:
        notes.refuse(row.number, refusal("columns", count=len(row.words)), "point_columns")
        return Point(row.number, row.words[0], "free", math.nan, math.nan, math.nan)
    name = row.words[at["id"]]
    end, body = _attached(row, row.words[at["attachment"]], bodies, notes)
    word = row.words[at["z"]].lower()
    x, y = notes.number(row, at["x"], "X"), notes.number(row, at["y"], "Y")
    if word in _BED:
        notes.say("on_bed", line=row.number, word=word)
        z = -depth
    else:
        z = notes.number(row, at["z"], "Z")
    if body:
        x, y, z = body.place(x, y, z)
    force = [notes.number(row, at[key], key.upper()) for key in ("fx", "fy", "fz") if key in at]
    if any(force) and end == "free":
        given = " ".join(f"{part:g}" for part in force)
        notes.refuse(row.number, given, "force_without_unit")
    keys = ("Mass", "Volume", "CdA", "Ca")
    mass, volume, area, added = (
        notes.number(row, at[key.lower()], key, at_least=0.0) for key in keys
    )
    return Point(row.number, name, end or "free", x, y, z, mass, volume, area, added)


def _attached(
    row: Row, word: str, bodies: Mapping[str, _Body], notes: Notes
) -> tuple[End | None, _Body | None]:
    """Say how a point or a rod is held, and by which body or turbine, if any."""
    kind = word.lower()
    stem = kind.rstrip("0123456789")
    body = bodies.get(kind.removeprefix("body")) if stem == "body" else None
    if stem in ("turbine", "t") and kind != stem:
        body = _turbine(row, int(kind.removeprefix(stem)), notes)
    end = body.end if body else _ENDS.get(stem)
    if end is None and stem != "body":
        notes.refuse(row.number, word, "attachment")
    elif body is None and stem == "body":
        notes.refuse(row.number, word, "no_such_body")
    return end, body


_PINNED = ("pinned", "pin")
_OF_RODS = {"ves": "vessel", "coupled": "coupled", "cpld": "coupled", "": "fixed"}
"""What a pinned rod is held by: ``VesPin``, ``CoupledPinned``, ``CpldPin``, ``Pinned``."""


def _rod(row: Row, bodies: Mapping[str, _Body], notes: Notes) -> Point | None:
    """Read a rod of no length as a point; one that has a length is refused."""
    if len(row.words) < 9:
        notes.refuse(row.number, refusal("columns", count=len(row.words)), "rod_columns")
        return None
    ends = [notes.number(row, k, "XYZ"[k % 3]) for k in range(3, 9)]
    has_none = len(row.words) > 9 and row.words[9] == "0"
    if ends[:3] != ends[3:] and not has_none:
        notes.refuse(row.number, f"RODS: {' '.join(row.words)[:40]}", "rods")
        return None
    word = row.words[2].lower()
    for pinned in _PINNED:
        if word.endswith(pinned):
            word = _OF_RODS.get(word.removesuffix(pinned), word.removesuffix(pinned))
    end, body = _attached(row, word, bodies, notes)
    place = (ends[0], ends[1], ends[2])
    notes.say("rod", line=row.number, name=row.words[0])
    return Point(
        row.number,
        f"R{row.words[0].upper().removeprefix('R')}",
        end or "free",
        *(body.place(*place) if body else place),
    )


def _turbine(row: Row, number: int, notes: Notes) -> _Body:
    """Hold a turbine of a farm, counted from 1, where the user has it."""
    if not 1 <= number <= len(notes.turbines):
        found = refusal("turbine", number=number)
        notes.refuse(row.number, found, "place_of_turbine", count=len(notes.turbines))
        return _Body("coupled", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    x, y = notes.turbines[number - 1]
    notes.say("turbine", number=number, x=x, y=y)
    return _Body("coupled", (x, y, 0.0), (0.0, 0.0, 0.0))


def _end(word: str, rods: Collection[str]) -> str:
    """Name the point of a line's end: both ends of a rod of no length are one."""
    name = word.upper().rstrip("AB")
    return name if name in rods else word


def _piece(
    row: Row, heads: Mapping[str, Row], notes: Notes, rods: Collection[str], *, first: bool
) -> DeckPiece:
    """Read a line; version 1 has its length before its ends, which may be a rod's, ``R1A``."""
    at = _columns("lines", row, heads, notes, v=1 if first else 2) if len(row.words) > 5 else {}
    if not at:
        notes.refuse(row.number, refusal("columns", count=len(row.words)), "line_columns")
        return DeckPiece(row.number, "", ("", ""), math.nan)
    first_end, last_end = (_end(row.words[at[key]], rods) for key in ("attacha", "attachb"))
    ends = first_end, last_end
    for end in ends:
        if re.match(r"[A-Za-z]", end) and end not in rods:
            notes.refuse(row.number, end, "rods")
    notes.say("segments")
    length = notes.number(row, at["unstrlen"], "UnstrLen", above=0.0)
    return DeckPiece(row.number, row.words[at["linetype"]], ends, length)
