"""The fields of the page's forms: of a sizing from its table of inputs, of a case from here."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final, Literal

from catopt.catalogue import families
from catopt.sizing.inputs import Input, rows_of
from catopt.sizing.kinds import choices_of
from catopt.words import Message

__all__ = ["DOORS", "START", "Door", "Field", "fields_of"]

Door = Literal["line", "body", "buoy", "tanker"]

DOORS: Final[tuple[Door, ...]] = ("line", "body", "buoy", "tanker")


@dataclass(frozen=True)
class Field:
    """One field of a form."""

    key: str
    """In the file, as errors name it."""
    label: str
    hint: str = ""
    """What is taken when it is left empty, or an example."""
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
        return tuple(_of_input(each) for each in rows_of(door) if each.takes != "FILE")
    own = _LOAD if door == "line" else _AROUND
    return tuple(_of_case(key, how) for key, how in (_LINE | own | _REST).items())


def _of_case(key: str, how: str) -> Field:
    return Field(
        key,
        Message("inputs.title" if key == "title" else f"desk.{key}"),
        _EXAMPLES.get(key, ""),
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


def _of_input(each: Input) -> Field:
    shown = each.example if isinstance(each.example, tuple) else (each.example,)
    return Field(
        each.key,
        Message(f"inputs.{each.name}"),
        each.default or "; ".join(map(str, shown)),
        choices_of(each),
        each.asked or each.required or each.name == "prefer",
        several=each.several,
        is_text=each.takes in ("TEXT", "NAME", "WHICH"),
    )
