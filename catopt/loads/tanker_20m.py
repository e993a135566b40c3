"""S3's tanker: the force of the weather printed there, by every method, beside S3's 450 kN.

S3 prints no derivation. Nothing is tuned to the printed sum: the coefficients are those of the
sources and the estimates of the ship are stated.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from catopt.display import Tabled
from catopt.loads.component import Loads
from catopt.loads.environment import SeaState, SurfaceCurrent, Wind
from catopt.loads.ship import Condition, Ship, estimated_tanker, estimates
from catopt.loads.ship_loads import METHODS, DriftWave, ship_loads
from catopt.words import Message, Sentence

PRINTED_FORCE: Final = 450e3
"""N, from wind, waves and current; S3 prints no derivation."""

WIND: Final = Wind(20.0)
CURRENT: Final = SurfaceCurrent(1.2)
SEA: Final = SeaState(8.0, maximum_height=3.5)
WATER_DEPTH: Final = 20.0

AGREEMENT: Final = 10.0
"""%, within which two estimates of steady loads are said to agree."""

_LENGTH: Final = 234.0
_BREADTH: Final = 31.3
_MOULDED_DEPTH: Final = 16.0
_DRAUGHTS: Final = {"loaded": 12.4, "ballast": 3.2}


@dataclass(frozen=True)
class TankerComparison(Tabled):
    """Computed beside printed, N."""

    loads: Loads
    printed: float
    estimates: tuple[str, ...]
    """What S3 does not print of the ship, and what was taken."""

    @property
    def ratio(self) -> float:
        """Computed over printed."""
        return self.loads.horizontal_force / self.printed

    @property
    def statement(self) -> Sentence:
        """What comes of it, in one sentence."""
        computed = self.loads.horizontal_force / 1e3
        printed = self.printed / 1e3
        difference = 100.0 * (self.ratio - 1.0)
        agreement = "agrees" if abs(difference) <= AGREEMENT else "differs"
        side = "above" if difference > 0.0 else "below"
        values = {"computed": computed, "printed": printed, "share": abs(difference)}
        return Sentence(Message(f"loads.{agreement}_{side}", **values))


def tanker(condition: Condition = "loaded") -> Ship:
    """S3's ship of 50,000 DWT at a draught of 12.4 or 3.2 m, with what is not printed estimated."""
    return estimated_tanker(
        f"tanker of 50,000 DWT, {condition}",
        _LENGTH,
        _BREADTH,
        _DRAUGHTS[condition],
        moulded_depth=_MOULDED_DEPTH,
        condition=condition,
    )


def compare_tanker(
    condition: Condition = "loaded",
    drift: DriftWave = "sea state",
    method: str = METHODS[0],
) -> TankerComparison:
    """Compute the force on S3's tanker, head to everything, beside the printed 450 kN.

    The drift is that of the sea whose Hmax is 3.5 m, or of regular waves of that height; the method
    one of `catopt.loads.METHODS`: by 22TCN 222-95 it is wind and current alone.
    """
    loads = ship_loads(
        tanker(condition),
        WIND,
        CURRENT,
        SEA,
        WATER_DEPTH,
        wind_on=f"tanker {condition}",
        method=method,
        drift=drift,
    )
    size = {"length": _LENGTH, "breadth": _BREADTH, "depth": _MOULDED_DEPTH}
    said = (Message("loads.printed_size", **size), *estimates(_LENGTH))
    return TankerComparison(loads, PRINTED_FORCE, said)
