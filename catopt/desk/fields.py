"""The fields of the page's forms: of a sizing from its table of inputs, of a case from here."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final, Literal

from catopt.catalogue import families
from catopt.sizing.inputs import INPUTS, Input, rows_of
from catopt.sizing.kinds import choices_of
from catopt.words import Message, term

__all__ = ["DOORS", "START", "Door", "Field", "fields_of"]

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

_FIRST: Final[dict[Door, tuple[str, ...]]] = {
    "buoy": (
        *("buoy.name", "site.water_depth", "environment.wind"),
        *("environment.current", "environment.hs"),
    ),
    "tanker": (
        *("ship.deadweight", "site.water_depth", "environment.wind"),
        *("environment.current", "environment.hs"),
    ),
}
"""What is asked for at once of a sizing."""
_UNITS: Final = {
    "LENGTH": ("m", "ft", "fathom", "mm"),
    "SPEED": ("m/s", "knots", "km/h"),
    "MASS": ("t", "kg", "lb"),
    "FORCE": ("kN", "tf", "kgf", "kip"),
    "TIME": ("s", "min", "years"),
}
"""Units that are offered for a dimension; any other may be written."""
_OF_KEY: Final = {
    **dict.fromkeys(("water_depth", "length", "anchor_radius", "fairlead_radius"), "LENGTH"),
    "horizontal_force": "FORCE",
}
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
def fields_of(door: Door) -> tuple[Field, ...]:
    """List the fields of a door's form, in their order."""
    if door in ("buoy", "tanker"):
        first = _FIRST[door]
        found = [_of_input(each, door) for each in rows_of(door) if each.takes != "FILE"]
        return tuple(sorted(found, key=lambda each: (*first, each.key).index(each.key)))
    own = _LOAD if door == "line" else _AROUND
    return tuple(_of_case(key, how) for key, how in (_LINE | own | _REST).items())


def _of_case(key: str, how: str) -> Field:
    return Field(
        key,
        Message("inputs.title" if key == "title" else f"desk.{key}"),
        _such_as(_EXAMPLES.get(key, "")),
        _EXAMPLES.get(key, ""),
        _UNITS.get(_OF_KEY.get(key.rpartition(".")[2], ""), ()),
        _components() if key.endswith("component") else (),
        "first" in how,
        "slides" in how,
        "several" in how,
        how == "text",
    )


def _components() -> tuple[str, ...]:
    return tuple(
        f"{each.name} {grade or ''}".rstrip()
        for each in families()
        for grade in each.grades or (None,)
    )


def _such_as(example: str) -> str:
    return Message("desk.such_as", example=example) if example else ""


def _of_input(each: Input, door: Door) -> Field:
    shown = each.example if isinstance(each.example, tuple) else (each.example,)
    example = "; ".join(map(str, shown))
    return Field(
        each.key,
        Message(f"inputs.{each.name}"),
        _taken(each) or _such_as(example),
        each.default or example,
        _UNITS.get(each.takes, ()),
        choices_of(each),
        each.key in _FIRST[door],
        several=each.several,
        is_text=each.takes in ("TEXT", "NAME", "WHICH"),
    )


def _taken(each: Input) -> str:
    """Say what is taken in its place when it is left out."""
    if each.left_out:
        return Message(each.left_out, **{row.name: Message(f"inputs.{row.name}") for row in INPUTS})
    return Message("desk.taken", value=term(each.default)) if each.default else ""
