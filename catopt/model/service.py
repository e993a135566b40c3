"""Service life and wear: what is left of a chain's or a wire's diameter at the end of it.

Wear is one rate, or by place in the water: tables of yearly loss, asked for by name.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, Any, Final, NamedTuple

from catopt.constants import YEAR
from catopt.errors import Problem, refused
from catopt.model.kinds import Checked, Findings, Measured, OneOf, WearRate
from catopt.units import Dimension
from catopt.words import Message

WEAR_ZONES: Final = ("splash", "catenary", "bottom", "wire")
"""Where a segment hangs or lies; "wire" is for wire rope wherever it is."""


class WearTable(NamedTuple):
    """Loss of nominal diameter by zone, m/s, with document, edition and place that it is from.

    Its confidence is as that of a component's figures; R is recalled and not verified.
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


@dataclass(frozen=True)
class Service(Checked):
    """How long the line is to last and how fast it wears."""

    life: Annotated[float, Measured(Dimension.TIME, at_least=0.0, example='"10 years"')]
    """Service life, s."""
    wear_rate: WearRate = 0.0
    """Loss of nominal diameter by corrosion and wear together, m/s. A segment may have its own."""
    wear_table: Annotated[str, OneOf(tuple(WEAR_TABLES), quoted=True)] | None = None
    """Instead, a key of `WEAR_TABLES`, which has the rate by each segment's `wear_zone`."""

    @property
    def table(self) -> WearTable | None:
        """Rates by zone, where they are asked for."""
        return None if self.wear_table is None else WEAR_TABLES[self.wear_table]

    def diameter_loss(self, wear_rate: float | None = None, wear_zone: str | None = None) -> float:
        """Loss of nominal diameter over the service life, m.

        `wear_rate`: a segment's own, m/s; `wear_zone`: where a segment without one hangs or lies,
        for the table. InputError: the table has no rate for that.
        """
        if wear_rate is None and self.table is not None:
            rates = self.table.rates
            if wear_zone is None or wear_zone not in rates:
                allowed = Message(
                    "refused_case.wear_table_has_or_give",
                    wear_table=self.wear_table,
                    rates=", ".join(rates),
                )
                found = "" if wear_zone is None else f'"{wear_zone}"'
                raise refused("wear_zone", found, allowed, "Service")
            wear_rate = rates[wear_zone]
        return self.life * (self.wear_rate if wear_rate is None else wear_rate)


def wear_misfits(
    service: Mapping[str, Any], segments: Sequence[Mapping[str, Any]]
) -> list[Problem]:
    """List where rates, tables and zones of a case do not go together.

    From what is given of ``wear_rate`` and ``wear_table`` of the service, and of ``wear_rate`` and
    ``wear_zone`` of each segment.
    """
    found = Findings()
    name = service.get("wear_table")
    table = WEAR_TABLES.get(name or "")
    if name and service.get("wear_rate"):
        found.add("service.wear_rate", "", Message("refused_case.one_wear_rate_wear_table"))
    for index, segment in enumerate(segments):
        zone, key = segment.get("wear_zone"), f"line.segments[{index}].wear_zone"
        if not zone:
            continue
        if not name:
            found.add(key, f'"{zone}"', Message("refused_case.goes_with_service_wear_table"))
        elif segment.get("wear_rate") is not None:
            found.add(key, f'"{zone}"', Message("refused_case.one_wear_rate_wear_zone"))
        elif table is not None and zone not in table.rates:
            allowed = Message("refused_case.has", name=name, rates=", ".join(table.rates))
            found.add(key, f'"{zone}"', allowed)
    return found.problems
