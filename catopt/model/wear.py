"""Wear by place in the water: tables of yearly loss of diameter, asked for by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Final

from catopt.constants import YEAR
from catopt.errors import Problem

WEAR_ZONES: Final = ("splash", "catenary", "bottom", "wire")
"""Where a segment hangs or lies; "wire" is for wire rope wherever it is."""


@dataclass(frozen=True)
class WearTable:
    """Loss of nominal diameter by zone.

    Attributes
    ----------
    source : str
        Document, edition and place.
    confidence : {"A", "B", "C", "R"}
        Of the figures, as of a component's; R is recalled and not verified.
    rates : mapping of str to float
        By zone, m/s.
    """

    source: str
    confidence: str
    rates: Mapping[str, float]


def _table(source: str, confidence: str, **rates: float) -> WearTable:
    """Build a table from rates in mm a year."""
    in_si = {zone: rate * 1e-3 / YEAR for zone, rate in rates.items()}
    return WearTable(source, confidence, MappingProxyType(in_si))


_E301 = "DNV-OS-E301 (2008), corrosion allowance"

WEAR_TABLES: Mapping[str, WearTable] = MappingProxyType(
    {
        "E301": _table(
            f"{_E301}, no regular inspection", "C", splash=0.4, catenary=0.3, bottom=0.4
        ),
        "E301-inspected": _table(
            f"{_E301}, regular inspection", "C", splash=0.2, catenary=0.2, bottom=0.3
        ),
        "E301-Norway": _table(
            f"{_E301}, Norwegian continental shelf", "C", splash=0.8, catenary=0.2, bottom=0.2
        ),
        "S4": _table("S4, Table 4.3", "A", splash=1.0, catenary=1.0, bottom=0.3, wire=0.3),
        "tropical": _table("tropical waters", "R", splash=1.0, catenary=0.3, bottom=0.4),
    }
)
"""Tables by the name that a case file asks for."""


def wear_misfits(
    service: Mapping[str, Any], segments: Sequence[Mapping[str, Any]]
) -> list[Problem]:
    """List where rates, tables and zones of a case do not go together.

    From what is given of ``wear_rate`` and ``wear_table`` of the service, and of ``wear_rate`` and
    ``wear_zone`` of each segment.
    """
    problems = []
    name = service.get("wear_table")
    if name and service.get("wear_rate"):
        problems.append(Problem("service.wear_rate", "", "one of wear_rate and wear_table"))
    for index, segment in enumerate(segments):
        zone, key = segment.get("wear_zone"), f"line.segments[{index}].wear_zone"
        if not zone:
            continue
        table = WEAR_TABLES.get(name or "")
        if not name:
            problems.append(Problem(key, f'"{zone}"', "goes with service.wear_table, not given"))
        elif segment.get("wear_rate") is not None:
            problems.append(Problem(key, f'"{zone}"', "one of wear_rate and wear_zone"))
        elif table is not None and zone not in table.rates:
            problems.append(Problem(key, f'"{zone}"', f"{name} has {', '.join(table.rates)}"))
    return problems
