"""Drag anchors as they are sold: masses, soils, and what they hold within the range of a source."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from types import MappingProxyType
from typing import Final

from catopt.catalogue.components import Confidence, Source
from catopt.catalogue.fittings import cited, read_own
from catopt.catalogue.table import TomlTable
from catopt.constants import STANDARD_GRAVITY

SCHEMA: Final = "catopt.anchors/1"

_UNITS: Final = MappingProxyType(
    {"kip": 4448.2216152605, "tf": 1e3 * STANDARD_GRAVITY, "kN": 1e3, "N": 1.0}
)


@dataclass(frozen=True)
class Holding:
    """Ultimate holding H = HR (m/mR)^b of a horizontal pull in a soil, by one data set."""

    soil: str
    data: str
    capacity: float
    """HR, N."""
    of_mass: float
    """mR, kg."""
    exponent: float
    sources: tuple[Source, ...]
    place: str
    confidence: Confidence


@dataclass(frozen=True)
class AnchorType:
    """A kind of drag anchor in the masses that are sold."""

    name: str
    title: str
    also: tuple[str, ...]
    masses: tuple[float, ...]
    """kg, rising. A list of sizes is no figure of strength: a recalled one is used, and says so."""
    sources: tuple[Source, ...]
    """Of the masses, at `place`."""
    place: str
    confidence: Confidence
    holdings: tuple[Holding, ...]
    price_per_mass: float
    """Material only, USD/kg of 2024."""
    note: str = ""

    @property
    def range(self) -> tuple[float, float]:
        """Smallest and largest mass that is sold, kg: nothing is said of any beyond."""
        return self.masses[0], self.masses[-1]


@cache
def anchor_types() -> tuple[AnchorType, ...]:
    """List the kinds of drag anchor, in the order of the file."""
    document, findings, sources = read_own("anchors.toml", SCHEMA, ("price", "anchor"))
    price = document.table("price")
    per_mass = (price.number("per_mass", above=0.0) if price else None) or 0.0
    read = tuple(_anchor(table, sources, per_mass) for table in document.tables("anchor"))
    findings.raise_if_any()
    return read


def _anchor(table: TomlTable, sources: dict[str, Source], per_mass: float) -> AnchorType:
    return AnchorType(
        name=table.text("name") or "",
        title=table.said("title") or "",
        also=table.texts("also"),
        masses=table.rising("masses_kg"),
        **cited(table, sources),
        holdings=tuple(_holding(each, sources) for each in table.tables("holding")),
        price_per_mass=per_mass,
        note=table.said("note", required=False) or "",
    )


def _holding(table: TomlTable, sources: dict[str, Source]) -> Holding:
    unit = table.word("unit", tuple(_UNITS)) or "N"
    return Holding(
        soil=table.text("soil") or "",
        data=table.text("data") or "",
        capacity=(table.number("capacity", above=0.0) or 0.0) * _UNITS[unit],
        of_mass=table.number("of_mass_kg", above=0.0) or 0.0,
        exponent=table.number("exponent", above=0.0) or 0.0,
        **cited(table, sources),
    )
