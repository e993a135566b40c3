"""Which values a file may have of a quantity, each range with a name by which it is set aside.

``accept = ["friction"]`` at the top of a file takes values beyond the range of that name.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Final, NamedTuple

from catopt.casefile.document import FileSection, Finding
from catopt.casefile.schema import TableSchema, entries
from catopt.constants import STANDARD_GRAVITY
from catopt.model.kinds import Measured
from catopt.words import Message


class Range(NamedTuple):
    """Least and largest plausible value of some keys, in SI; a key may have its table before it."""

    name: str
    least: float
    most: float
    keys: str


RANGES: Final = (
    Range("friction", 0.0, 2.0, "seabed_friction friction"),
    Range("water_density", 950.0, 1100.0, "water_density"),
    Range("body_density", 20.0, 20_000.0, "density"),
    Range("drag", 0.0, 10.0, "drag_normal drag_axial drag_coefficient"),
    Range("added_mass", 0.0, 10.0, "added_mass_normal added_mass_axial added_mass_coefficient"),
    Range(
        "damping",
        0.0,
        2.0,
        "surge_damping sway_damping yaw_damping roll_damping pitch_damping line_damping",
    ),
    Range("safety_factor", 1.0, 20.0, "safety_factor safety_factor_line_out proof_load_factor"),
    Range("water_depth", 0.05, 12_000.0, "water_depth low_water"),
    Range("diameter", 0.0005, 1.0, "diameter diameters diameter_min diameter_max"),
    Range(
        "wave_height", 0.0, 40.0, "waves.height trains.height sea_states.height hs hmax max_height"
    ),
    Range("wave_period", 0.3, 60.0, "waves.period trains.period sea_states.period peak_period"),
    Range("current_speed", -10.0, 10.0, "current.speed current.speeds environment.current"),
    Range("wind_speed", 0.0, 100.0, "wind_speed environment.wind"),
)
"""Beyond what ports, ships, chain and the sea have, so that what is refused is a slip."""

HEAVIER: Final = "weight_in_water"
"""Name by which a weight in water above that in air is accepted."""
_SLACK: Final = 1e-3
"""Part by which a weight in water may exceed that in air: rounding of the two figures."""
_OF_KEY: Final = {key: each for each in RANGES for key in each.keys.split()}


def plausibility_findings(section: FileSection, reported: Sequence[Finding] = ()) -> list[Finding]:
    """List the values of a document that are beyond the range of their quantity.

    Those that its ``accept`` names are taken; of those that are reported nothing more is said.
    """
    accepted = section.given.get("accept", ())
    names = accepted if isinstance(accepted, list | tuple) else ()
    told = {each.path for each in reported}
    found = [finding for name, finding in _findings(section) if name not in names]
    return [finding for finding in found if finding.path not in told]


def range_of(path: Sequence[object]) -> Range | None:
    """Find the range of a key by the names in its path."""
    names = [part for part in path if isinstance(part, str)]
    return _OF_KEY.get(".".join(names[-2:])) or _OF_KEY.get(names[-1])


def _findings(section: FileSection) -> Iterator[tuple[str, Finding]]:
    for key, entry in entries(section.schema).items():
        if key not in section:
            continue
        if entry.table is not None:
            below = section.tables(key) if entry.array else [section.table(key)]
            for each in below:
                yield from _findings(each)
        elif isinstance(entry.kind, Measured):
            yield from _of_value(section, key)
    yield from _heavier(section)


def _of_value(section: FileSection, key: str) -> Iterator[tuple[str, Finding]]:
    known = range_of((*section.path, key))
    value = None if known is None else section.value(key)
    if known is None or value is None:
        return
    unit = _si_unit(section.schema, key)
    several = value if isinstance(value, list) else [value]
    if any(not known.least <= each <= known.most for each in several):
        most = f"{known.most:g} {unit}".rstrip()
        bounds = {"least": known.least, "most": most, "name": known.name}
        yield known.name, section.wrong(key, Message("refused_file.implausible", **bounds))


def _heavier(section: FileSection) -> Iterator[tuple[str, Finding]]:
    """Find what weighs more in water than in air."""
    keys = ("submerged_weight", "mass")
    if not all(key in section and key in entries(section.schema) for key in keys):
        return
    weight, mass = (section.number(key) for key in keys)
    if weight is None or mass is None or "volume" in section or "density" in section:
        return
    in_air = mass * STANDARD_GRAVITY
    if weight > in_air * (1.0 + _SLACK):
        unit = _si_unit(section.schema, keys[0])
        said = Message("refused_file.heavier_in_water", air=in_air, unit=unit, name=HEAVIER)
        yield HEAVIER, section.wrong(keys[0], said)


def _si_unit(schema: type[TableSchema], key: str) -> str:
    kind: Any = entries(schema)[key].kind
    return str(kind.si_unit)
