"""Whether a buoy floats while it is laid or lifted: with chain and sinker hung on it.

What chain holds that lies on the bed: its weight in water times a friction by the bed.
"""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, Literal, get_args

from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.component import LoadSource
from catopt.model.kinds import Findings
from catopt.shown import Tabled
from catopt.words import Message

_DDJ = LoadSource(
    "D. Djokic, Mooring-Line-Properties at 703fd47", "friction.md, starting and sliding", "C"
)
_DTO = LoadSource("DTOcean moorings", "sample_data/soilprops.txt, seaflrfriccoef of clays", "C")


@dataclass(frozen=True)
class BedFriction:
    """Friction of chain on a bed: to start it, and of chain that slides, which counts."""

    bed: str
    starting: float
    sliding: float
    source: LoadSource
    """Of the sliding one."""


CHAIN_ON_BED: Final = MappingProxyType(
    {
        each.bed: each
        for each in (
            BedFriction("sand", 0.98, 0.74, _DDJ),
            BedFriction("mud with sand", 0.92, 0.69, _DDJ),
            BedFriction("firm mud", 1.01, 0.62, _DDJ),
            BedFriction("soft mud", 0.90, 0.56, _DDJ),
            # Djokic has 0.81 for clay that slides; DTOcean's 0.5 is the lower.
            BedFriction("clay", 1.25, 0.50, _DTO),
        )
    }
)
"""Beds by name; of two sources the lower sliding friction."""


def chain_holding(bed: str, submerged_weight: float) -> tuple[float, LoadSource]:
    """Horizontal pull that chain on a bed holds, N, by its weight in water there, N.

    The sliding friction counts: an anchor that gives takes the chain with it.
    """
    found = Findings("chain on the bed")
    found.word("bed", bed, tuple(CHAIN_ON_BED))
    found.number("submerged_weight", submerged_weight, "N", at_least=0.0)
    found.raise_if_any()
    row = CHAIN_ON_BED[bed]
    return row.sliding * submerged_weight, row.source


Medium = Literal["water", "air"]

LAYING_SOURCE: Final = LoadSource(
    "worked example of a navigation buoy on 110 m of 32 mm chain (Indonesia)",
    "it floats with all chain and the sinker hung on it",
    "C",
)


@dataclass(frozen=True)
class LayingCheck(Tabled):
    """Weight of buoy, chain and sinker beside the buoyancy that the buoy has, N."""

    name: str
    demand: float
    capacity: float
    chain_in: Medium
    """In what the chain is weighed: water, or air as the worked example does, on the safe side."""
    source: LoadSource = LAYING_SOURCE

    @property
    def utilisation(self) -> float:
        """Demand over capacity: it floats at 1 or below."""
        return self.demand / self.capacity


def laying_check(
    shape: BuoyShape,
    chain_weight: float,
    sinker_weight: float,
    *,
    chain_in: Medium = "water",
    freeboard: float = 0.0,
    water_density: float = SEA_WATER_DENSITY,
) -> LayingCheck:
    """Hang the whole chain and the sinker on a buoy.

    Parameters
    ----------
    chain_weight : float
        Of the whole chain, in the medium of `chain_in`, N.
    sinker_weight : float
        In water, N.
    chain_in : {"water", "air"}
        In what the chain is weighed; the worked example takes it in air.
    freeboard : float
        That the buoy is to keep, m.
    water_density : float
        kg/m3.
    """
    found = Findings("laying check")
    found.number("chain_weight", chain_weight, "N", at_least=0.0)
    found.number("sinker_weight", sinker_weight, "N", at_least=0.0)
    found.word("chain_in", chain_in, get_args(Medium))
    found.number("freeboard", freeboard, "m", at_least=0.0, at_most=shape.deck)
    found.number("water_density", water_density, "kg/m3", at_least=900.0, at_most=1100.0)
    found.raise_if_any()
    return LayingCheck(
        Message(f"loads.laying_chain_in_{chain_in}"),
        STANDARD_GRAVITY * shape.total_mass + chain_weight + sinker_weight,
        STANDARD_GRAVITY * water_density * shape.displaced_at(freeboard),
        chain_in,
    )
