"""What chain holds that lies on the bed: its weight in water times a friction by the bed."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from catopt.loads.source import LoadSource
from catopt.model.validity import Findings

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
