"""Looks for implausible values in the tables of a file, each with its key and the way out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from catopt.casefile.document import FileSection, Finding
from catopt.casefile.schema import TableSchema, entries
from catopt.constants import STANDARD_GRAVITY
from catopt.model.kinds import Measured
from catopt.model.plausible_ranges import HEAVIER, SLACK, range_of
from catopt.words import Message


def plausibility_findings(section: FileSection, reported: Sequence[Finding] = ()) -> list[Finding]:
    """List the values of a document that are beyond the range of their quantity.

    Those that its ``accept`` names are taken; of those that are reported nothing more is said.
    """
    accepted = section.given.get("accept", ())
    names = accepted if isinstance(accepted, list | tuple) else ()
    told = {earlier.path for earlier in reported}
    found = [finding for name, finding in _findings(section) if name not in names]
    return [finding for finding in found if finding.path not in told]


def _findings(section: FileSection) -> Iterator[tuple[str, Finding]]:
    for key, entry in entries(section.schema).items():
        if key not in section:
            continue
        if entry.table is not None:
            below = section.tables(key) if entry.array else [section.table(key)]
            for inner in below:
                yield from _findings(inner)
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
    if any(not known.least <= number <= known.most for number in several):
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
    if weight > in_air * (1.0 + SLACK):
        unit = _si_unit(section.schema, keys[0])
        said = Message("refused_file.heavier_in_water", air=in_air, unit=unit, name=HEAVIER)
        yield HEAVIER, section.wrong(keys[0], said)


def _si_unit(schema: type[TableSchema], key: str) -> str:
    kind: Any = entries(schema)[key].kind
    return str(kind.si_unit)
