"""The fields of the page's forms, and the way between them and the text of a file."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from itertools import pairwise
from typing import Any, Final, Literal

from catopt.casefile.document import parts
from catopt.catalogue.finding import component_names
from catopt.documents import parse_toml
from catopt.errors import refused
from catopt.sizing.inputs import INPUTS, Input, rows_of
from catopt.sizing.kinds import choices_of
from catopt.units import bare_number, units_like
from catopt.words import Message, term

Door = Literal["line", "body", "buoy", "tanker"]

DOORS: Final[tuple[Door, ...]] = ("buoy", "tanker", "line", "body")


@dataclass(frozen=True)
class Field:
    """One field of a form."""

    key: str
    """In the file, as errors name it."""
    label: str
    hint: str = ""
    """What is taken when it is left empty; of what has to be given, an example."""
    example: str = ""
    """As it is written."""
    units: tuple[str, ...] = ()
    """That are offered."""
    choices: tuple[str, ...] = ()
    """That are offered; a text of one's own may stand there, too."""
    is_first: bool = False
    """Whether it is shown at once, or among the further ones."""
    slides: bool = False
    """Whether a slider changes it."""
    several: bool = False
    """Whether it has several values, with ``;`` between them."""
    is_text: bool = False


START: Final[dict[Door, dict[str, str]]] = {
    "line": {
        "title": "Chain in 20 m",
        "site.water_depth": "20 m",
        "line.segments[0].component": "chain studless R3",
        "line.segments[0].diameter": "46 mm",
        "line.segments[0].length": "150 m",
        "load.horizontal_force": "150 kN",
        "checks.safety_factor": "3",
        "checks.max_anchor_uplift_angle": "0 deg",
    },
    "body": {
        "title": "Buoy on six lines",
        "site.water_depth": "30 m",
        "line.segments[0].component": "chain studless R3",
        "line.segments[0].diameter": "76 mm",
        "line.segments[0].length": "200 m",
        "system.anchor_radius": "200 m",
        "system.fairlead_radius": "5 m",
        "system.azimuths": "0 deg; 60 deg; 120 deg; 180 deg; 240 deg; 300 deg",
        "system.force": "400 kN; 0 kN",
        "checks.safety_factor": "2",
    },
    "buoy": {"buoy.name": "pillar 1.8 m", "site.water_depth": "12 m"},
    "tanker": {
        "ship.deadweight": "50000 t",
        "site.water_depth": "22 m",
        "environment.wind": "25 m/s",
        "environment.current": "1 m/s",
    },
}
"""What the form of each door begins with."""

_PLACE: Final = ("site.water_depth", "environment.wind", "environment.current", "environment.hs")
_FIRST: Final[dict[Door, tuple[str, ...]]] = {
    "buoy": ("buoy.name", *_PLACE),
    "tanker": ("ship.deadweight", *_PLACE),
}
"""What is asked for at once of a sizing."""
_LINE: Final = {
    "title": "text",
    "site.water_depth": "first slides",
    "line.segments[0].component": "first",
    "line.segments[0].diameter": "first slides",
    "line.segments[0].length": "first slides",
}
_LOAD: Final = {
    "load.horizontal_force": "first slides",
    "load.span": "",
    "load.fairlead_tension": "",
}
_AROUND: Final = {
    "system.anchor_radius": "first slides",
    "system.fairlead_radius": "first",
    "system.azimuths": "first several",
    "system.force": "first several",
}
_EXAMPLES: Final = {
    "load.span": "110 m",
    "load.fairlead_tension": "180 kN",
    "checks.max_anchor_uplift_angle": "0 deg",
    "checks.code": "IALA-CALMAR",
    "site.seabed_friction": "0",
    "line.fairlead_height": "18 m",
    "line.segments[0].submerged_weight": "400 N/m",
    "line.segments[0].mass": "46 kg/m",
    "line.segments[0].EA": "190 MN",
    "line.segments[0].MBL": "2000 kN",
}
_REST: Final = {
    "checks.safety_factor": "first",
    **{key: "" for key in _EXAMPLES if not key.startswith("load.")},
}


@cache
def can_run() -> bool:
    """Whether lines can be run in time here: a browser has not the part that does so."""
    return find_spec("catopt.fem") is not None


def of_runs(each: Input) -> bool:
    """Whether an input says how lines are run in time, or that they are."""
    return "in_motion" in (each.name, each.only_with) or each.key.startswith("motion.")


def at_rest_of(door: Door, text: str) -> str:
    """Leave out of a file for a sizing what it says of runs in time."""
    document = parse_toml(text, "")
    for row in rows_of(door):
        if of_runs(row):
            _put(document, row.path, None)
    return "".join(_tables(document, ())).lstrip("\n")


def fields_of(door: Door, *, runs: bool | None = None) -> tuple[Field, ...]:
    """List the fields of a door's form, in their order.

    Those of `runs` in time are left out where there are none; by what is here when left out.
    """
    return _fields(door, can_run() if runs is None else runs)


@cache
def _fields(door: Door, runs: bool) -> tuple[Field, ...]:
    if door in ("buoy", "tanker"):
        first = _FIRST[door]
        found = [
            _of_input(row, door)
            for row in rows_of(door)
            if row.takes != "FILE" and (runs or not of_runs(row))
        ]
        return tuple(sorted(found, key=lambda each: (*first, each.key).index(each.key)))
    own = _LOAD if door == "line" else _AROUND
    return tuple(_of_case(key, how) for key, how in (_LINE | own | _REST).items())


def _of_case(key: str, how: str) -> Field:
    begins = next((values[key] for values in START.values() if key in values), "")
    return Field(
        key,
        Message("inputs.title" if key == "title" else f"desk.{key}"),
        _such_as(_EXAMPLES.get(key, "")),
        _EXAMPLES.get(key, ""),
        () if how == "text" else _units(begins or _EXAMPLES.get(key, "")),
        component_names() if key.endswith("component") else (),
        "first" in how,
        "slides" in how,
        "several" in how,
        how == "text",
    )


def _units(example: str) -> tuple[str, ...]:
    """List the units that are offered beside a value: that of its example, or of its first one."""
    number, _, unit = example.partition(";")[0].strip().partition(" ")
    return units_like(unit) if unit and not isinstance(bare_number(number), str) else ()


def _such_as(example: str) -> str:
    return Message("desk.such_as", example=example) if example else ""


def _of_input(each: Input, door: Door) -> Field:
    shown = each.example if isinstance(each.example, tuple) else (each.example,)
    example = "; ".join(map(_shown, shown))
    hint: str = _such_as(example)
    if each.left_out:  # what is taken in its place
        hint = Message(each.left_out, **{row.name: Message(f"inputs.{row.name}") for row in INPUTS})
    elif each.default:
        hint = Message("desk.taken", value=term(each.default))
    return Field(
        each.key,
        Message(f"inputs.{each.name}"),
        hint,
        each.default or example,
        _units(example) if each.is_measure else (),
        choices_of(each),
        each.key in _FIRST[door],
        several=each.several,
        is_text=each.takes in ("TEXT", "NAME", "WHICH"),
    )


_OTHERS: Final = (
    ("workbook", re.compile(r"PK\x03\x04")),
    ("picture", re.compile(r"(?is).PNG|GIF8|.{0,24}(JFIF|Exif)|RIFF.{4,9}WEBP|\s*<svg")),
    ("pdf", re.compile(r"%PDF")),
    ("note", re.compile(r"(?i)\s*<(!doctype )?html")),
    ("deck", re.compile(r"(?m)^(%YAML|-{3}|\s*-{3,}.*[A-Z]{4}|\w+:(\s|$))")),
    ("no_text", re.compile("[\0\ufffd]")),
)
"""What else is opened, by how it begins or, of the last two, by what stands in it."""


_OF_TOML: Final = re.compile(r"(?m)^\w[\w.]* *= *\S|^\[")


def refuse_other(text: str) -> None:
    """Raise InputError for a file that is no case, with what it is and what to do with it.

    A case with a mistake in it is none of these.
    """
    if _OF_TOML.search(text) and "\0" not in text:
        return
    for name, pattern in _OTHERS:
        found = (pattern.search if name in ("deck", "no_text") else pattern.match)(text)
        if found:
            raise refused("file", Message(f"desk.is_{name}"), Message(f"desk.with_{name}"))


def door_of(document: Mapping[str, Any]) -> Door:
    """Say which door a document is for; InputError for lines between points, which have none."""
    from catopt.casefile.reading import moored_of

    if "points" in document:
        raise refused("points", "[[points]]", Message("desk.no_points"))
    return moored_of(dict(document)) or ("body" if "system" in document else "line")


def text_of(door: Door, values: Mapping[str, str], base: str = "") -> str:
    """Write the TOML file that the fields of a form come to.

    `values` are by key, as they stand in the fields; what is empty is left out. `base` is the file
    that was opened: what no field has is kept of it, but for comments.

    Examples
    --------
    >>> print(text_of("line", {"site.water_depth": "9,5", "line.segments[0].length": "20 m"}))
    [site]
    water_depth = "9.5 m"
    <BLANKLINE>
    [line]
    <BLANKLINE>
    [[line.segments]]
    length = "20 m"
    <BLANKLINE>
    """
    document = parse_toml(base, "")
    for field in fields_of(door):
        _put(document, parts(field.key), _value(field, values.get(field.key, ""), door))
    return "".join(_tables(document, ())).lstrip("\n")


def values_of(door: Door, text: str) -> dict[str, str]:
    """Read the fields of a form out of a file; those that it leaves out are not there."""
    document = parse_toml(text, "")
    found = ((field.key, _at(document, parts(field.key))) for field in fields_of(door))
    return {key: _shown(value) for key, value in found if value is not None}


def _value(field: Field, text: str, door: Door) -> object:
    """Take what stands in a field as a file has it; a bare number gets the unit of the field."""
    one = [value.strip() for value in text.split(";")] if field.several else [text.strip()]
    taken = [_one(field, value, door) for value in one if value]
    if not taken:
        return None
    return taken if field.several else taken[0]


def _one(field: Field, text: str, door: Door) -> object:
    if field.is_text:
        return text
    if text in ("true", "false"):
        return text == "true"
    number = bare_number(text)
    example = (START[door].get(field.key) or field.example).partition(";")[0]
    _, _, unit = example.partition(" ")
    is_measure = unit and isinstance(bare_number(example.split(" ")[0]), int | float)
    return f"{number} {unit}" if is_measure and not isinstance(number, str) else number


def _put(document: dict[str, Any], path: tuple[str | int, ...], value: object) -> None:
    """Put a value into its table, which is made where there is none; None takes it out."""
    place: Any = document
    for part, below in pairwise(path):
        is_there = part < len(place) if isinstance(part, int) else part in place
        if not is_there:
            if value is None:
                return
            if isinstance(part, int):
                place.append({})
            else:
                place[part] = [] if isinstance(below, int) else {}
        place = place[part]
        if not isinstance(place, dict | list):
            return
    if value is None:
        place.pop(path[-1], None)
    else:
        place[path[-1]] = value


def _at(document: Any, path: tuple[str | int, ...]) -> Any:
    for part in path:
        try:
            document = document[part]
        except (KeyError, IndexError, TypeError):
            return None
    return document


def _shown(value: object) -> str:
    if isinstance(value, list):
        return "; ".join(map(_shown, value))
    return str(value).lower() if isinstance(value, bool) else str(value)


def _tables(table: Mapping[str, Any], path: tuple[str, ...]) -> Iterator[str]:
    """Write a table: its own keys, then the tables below it."""
    for key, value in table.items():
        if not _is_below(value):
            yield f"{_key(key)} = {_written(value)}\n"
    for key, value in table.items():
        if isinstance(value, dict) and value:
            yield f"\n[{'.'.join(map(_key, (*path, key)))}]\n"
            yield from _tables(value, (*path, key))
        elif _is_below(value):
            for row in value:
                yield f"\n[[{'.'.join(map(_key, (*path, key)))}]]\n"
                yield from _tables(row, (*path, key))


def _is_below(value: Any) -> bool:
    if isinstance(value, list):
        return bool(value) and all(isinstance(row, dict) for row in value)
    return isinstance(value, dict)


def _key(key: str) -> str:
    return key if key.replace("_", "").replace("-", "").isalnum() and key.isascii() else _text(key)


def _written(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return f"[{', '.join(map(_written, value))}]"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{_key(k)} = {_written(v)}' for k, v in value.items())}}}"
    return _text(value) if isinstance(value, str) else str(value)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
