"""Holding capacity of drag anchors by mass: the catalogue's figures, as the sizing reads them.

Two sets cover the same anchors and disagree: UFC's table, as recalled, and DTOcean's database. The
first is mostly below the second, by 2 to 7 % in soft clay and about 15 % in sand, and far below or
above it for Moorfast and Stevin in sand. Each holds for the masses that are sold, and no other.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal, cast

from catopt.catalogue.anchors import AnchorType, Holding, anchor_types
from catopt.loads.source import DTOCEAN, MOORPY, UFC, LoadSource

Soil = Literal["soft clay", "medium clay", "sand"]
SOILS: Final = ("soft clay", "medium clay", "sand")

DataSet = Literal["UFC", "DTOcean", "Vryhof"]
DATA_SETS: Final = ("UFC", "DTOcean", "Vryhof")


@dataclass(frozen=True)
class HoldingCurve:
    """Ultimate holding capacity H = HR (m/mR)^b of a kind of anchor in a kind of soil.

    The reference capacity HR is in N, the reference mass mR in kg; b is the exponent, and the
    source that of HR and b. It holds for the masses, kg, and for a horizontal pull.
    """

    anchor: str
    soil: Soil
    data: DataSet
    reference_capacity: float
    reference_mass: float
    exponent: float
    source: LoadSource
    masses: tuple[float, float]
    """Smallest and largest that is sold."""

    def capacity(self, mass: float) -> float:
        """Give what an anchor of a mass in kg holds, N."""
        return float(self.reference_capacity * (mass / self.reference_mass) ** self.exponent)

    def mass(self, capacity: float) -> float:
        """Give the mass that holds a capacity in N, kg."""
        return float(
            self.reference_mass * (capacity / self.reference_capacity) ** (1.0 / self.exponent)
        )


_SOURCES: Final = {
    "UFC": (UFC, "eq. 26, page 105 (read); HR and b of table 5-3 recalled"),
    "DTOcean": (DTOCEAN, "drag anchors"),
    "Vryhof": (MOORPY, "Stevpris Mk6"),
}
"""Documents and clauses by data set."""


def _curve(of: AnchorType, holding: Holding) -> HoldingCurve:
    source = LoadSource(*_SOURCES[holding.data], holding.confidence)
    soil, data = cast("Soil", holding.soil), cast("DataSet", holding.data)
    figures = (holding.capacity, holding.of_mass, holding.exponent)
    return HoldingCurve(of.name, soil, data, *figures, source, of.range)


CURVES: Final = tuple(_curve(each, of) for each in anchor_types() for of in each.holdings)
"""Every curve."""

ANCHORS: Final = tuple(each.name for each in anchor_types())
"""Every kind of anchor."""


def masses_sold(anchor: str) -> tuple[float, ...]:
    """List the masses in which a kind of anchor is sold, kg, rising."""
    return next(each.masses for each in anchor_types() if each.name == anchor)
