"""From a Case to a case file."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from catopt.model import Case, Find, Load, PointLoad, Segment

__all__ = ["write_case"]

_ESCAPES = {
    '"': '\\"',
    "\\": "\\\\",
    "\b": "\\b",
    "\t": "\\t",
    "\n": "\\n",
    "\f": "\\f",
    "\r": "\\r",
}


def write_case(case: Case) -> str:
    """Write a case as TOML, in SI with its units.

    Parameters
    ----------
    case : Case
        What to write.

    Returns
    -------
    str
        Text that `parse_case` reads back as an equal case, to the last digit. What has no value
        (an EA of an inextensible segment, an unknown mass) is left out.
    """
    sections: list[tuple[str, Iterable[str]]] = [
        ("[site]", _site(case)),
        ("[line]", _ends(case)),
        *(("[[line.segments]]", _segment(segment)) for segment in case.line.segments),
        *(("[[line.point_loads]]", _point_load(load)) for load in case.line.point_loads),
        *((("[load]", _load(case.load)),) if case.load else ()),
        *((("[find]", _find(case.find)),) if case.find else ()),
        ("[checks]", _checks(case)),
        ("[pso]", _swarm(case)),
    ]
    head = [*_text("title", case.title), *_text("source", case.source)]
    blocks = [head] if head else []
    blocks += [[opening, *lines] for opening, lines in sections]
    return "\n\n".join("\n".join(block) for block in blocks) + "\n"


def _site(case: Case) -> Iterator[str]:
    yield from _measured("water_depth", case.site.water_depth, "m")
    yield from _measured("seabed_friction", case.site.seabed_friction)
    yield from _measured("water_density", case.site.water_density, "kg/m^3")


def _ends(case: Case) -> Iterator[str]:
    yield from _measured("fairlead_height", case.fairlead_height, "m")
    yield from _measured("anchor_height", case.anchor_height, "m")


def _segment(segment: Segment) -> Iterator[str]:
    yield from _text("name", segment.name)
    yield from _measured("length", segment.length, "m")
    yield from _measured("submerged_weight", segment.submerged_weight, "N/m")
    yield from _measured("mass", segment.mass, "kg/m")
    if math.isfinite(segment.EA):
        yield from _measured("EA", segment.EA, "N")
    yield from _measured("MBL", segment.MBL, "N")


def _point_load(load: PointLoad) -> Iterator[str]:
    yield from _text("name", load.name)
    yield from _measured("position", load.position, "m")
    yield from _measured("submerged_weight", load.submerged_weight, "N")
    yield from _measured("mass", load.mass, "kg")


def _load(load: Load) -> Iterator[str]:
    yield from _measured("horizontal_force", load.horizontal_force, "N")
    yield from _measured("span", load.span, "m")
    yield from _measured("fairlead_tension", load.fairlead_tension, "N")


def _find(find: Find) -> Iterator[str]:
    yield from _text("quantity", find.quantity)
    yield from _whole("segment", find.segment)
    yield from _whole("point_load", find.point_load)
    yield from _measured("anchor_angle", find.anchor_angle, "rad")
    yield from _measured("grounded_length", find.grounded_length, "m")


def _checks(case: Case) -> Iterator[str]:
    yield from _measured("safety_factor", case.checks.safety_factor)
    yield from _measured("max_anchor_uplift_angle", case.checks.max_anchor_uplift_angle, "rad")


def _swarm(case: Case) -> Iterator[str]:
    swarm = case.swarm
    for key in ("particles", "iterations", "runs", "seed"):
        yield from _whole(key, getattr(swarm, key))
    yield from _measured("cognitive", swarm.cognitive)
    yield from _measured("social", swarm.social)
    yield from _measured("inertia", swarm.inertia)
    yield from _text("boundary", swarm.boundary)


def _measured(key: str, value: float | None, unit: str = "") -> Iterator[str]:
    if value is not None:
        digits = repr(float(value))  # the shortest text that reads back as the same number
        yield f'{key} = "{digits} {unit}"' if unit else f"{key} = {digits}"


def _whole(key: str, value: int | None) -> Iterator[str]:
    if value is not None:
        yield f"{key} = {int(value)}"


def _text(key: str, text: str) -> Iterator[str]:
    if text:
        yield f'{key} = "{"".join(_escaped(character) for character in text)}"'


def _escaped(character: str) -> str:
    if character in _ESCAPES:
        return _ESCAPES[character]
    return character if character >= " " and character != "\x7f" else f"\\u{ord(character):04x}"
