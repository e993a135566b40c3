"""Holding capacity of drag anchors by mass: the figures, each with its source.

Two sets cover the same anchors and disagree: UFC's table, as recalled, and DTOcean's database. The
first is mostly below the second, by 2 to 7 % in soft clay and about 15 % in sand, and far below or
above it for Moorfast and Stevin in sand.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal, TypeAlias

from catopt.constants import STANDARD_GRAVITY
from catopt.loads.source import DTOCEAN, MOORPY, UFC, LoadSource

Soil = Literal["soft clay", "medium clay", "sand"]
SOILS: Final = ("soft clay", "medium clay", "sand")

DataSet = Literal["UFC", "DTOcean", "Vryhof"]
DATA_SETS: Final = ("UFC", "DTOcean", "Vryhof")

_Rows: TypeAlias = dict[Soil, tuple[float, float]]

_KIP: Final = 4448.2216152605
_UFC_MASS: Final = 4536.0
_TONNE: Final = 1000.0


@dataclass(frozen=True)
class HoldingCurve:
    """Ultimate holding capacity H = HR (m/mR)^b of a kind of anchor in a kind of soil.

    The reference capacity HR is in N, the reference mass mR in kg; b is the exponent, and the
    source that of HR and b.
    """

    anchor: str
    soil: Soil
    data: DataSet
    reference_capacity: float
    reference_mass: float
    exponent: float
    source: LoadSource

    def capacity(self, mass: float) -> float:
        """Give what an anchor of a mass in kg holds, N."""
        return float(self.reference_capacity * (mass / self.reference_mass) ** self.exponent)

    def mass(self, capacity: float) -> float:
        """Give the mass that holds a capacity in N, kg."""
        return float(
            self.reference_mass * (capacity / self.reference_capacity) ** (1.0 / self.exponent)
        )


_UFC_SOURCE = LoadSource(UFC, "eq. 26, page 105 (read); HR and b of table 5-3 recalled", "R")

# HR in kips for 10 000 lbf, and b.
_UFC: Final[dict[str, _Rows]] = {
    "stockless": {"soft clay": (46.0, 0.92), "sand": (70.0, 0.80)},
    "Danforth, LWT, AC-14": {"soft clay": (87.0, 0.92), "sand": (126.0, 0.80)},
    "Bruce cast": {"soft clay": (32.0, 0.92), "sand": (250.0, 0.80)},
    "Stevin": {"soft clay": (139.0, 0.92), "sand": (165.0, 0.80)},
    "Moorfast": {"soft clay": (117.0, 0.92), "sand": (60.0, 0.80)},
    "NAVMOOR": {"soft clay": (210.0, 0.94), "sand": (270.0, 0.94)},
}

# tf for 1 t, and b.
_DTO: Final[dict[str, _Rows]] = {
    "stockless": {"soft clay": (5.5, 0.92), "sand": (11.1, 0.80)},
    "Danforth, LWT, AC-14": {"soft clay": (10.5, 0.92), "sand": (20.0, 0.80)},
    "Moorfast": {"soft clay": (10.5, 0.92), "sand": (20.0, 0.80)},
    "Bruce cast": {"soft clay": (3.9, 0.92), "sand": (39.6, 0.80)},
    "Stevin": {"soft clay": (16.0, 0.92), "sand": (31.0, 0.94)},
    "Stevpris Mk5": {"soft clay": (42.5, 0.92), "sand": (70.0, 0.92)},
    "Bruce FFTS Mk4": {"soft clay": (42.5, 0.92), "sand": (47.0, 0.94)},
}

# kN for 1 t, and b.
_VRYHOF: Final[dict[str, _Rows]] = {
    "Stevpris Mk6": {
        "soft clay": (509.96, 0.93),
        "medium clay": (701.49, 0.93),
        "sand": (904.21, 0.92),
    },
}

_SETS: Final[tuple[tuple[DataSet, dict[str, _Rows], float, float, LoadSource], ...]] = (
    ("UFC", _UFC, _KIP, _UFC_MASS, _UFC_SOURCE),
    ("DTOcean", _DTO, _TONNE * STANDARD_GRAVITY, _TONNE, LoadSource(DTOCEAN, "drag anchors", "C")),
    ("Vryhof", _VRYHOF, 1e3, _TONNE, LoadSource(MOORPY, "Stevpris Mk6", "C")),
)
"""Rows of each data set, the unit of their capacities, N, the mass they are for, kg, the source."""

CURVES: Final = tuple(
    HoldingCurve(anchor, soil, data, capacity * unit, mass, exponent, source)
    for data, anchors, unit, mass, source in _SETS
    for anchor, rows in anchors.items()
    for soil, (capacity, exponent) in rows.items()
)
"""Every curve."""

ANCHORS: Final = tuple(dict.fromkeys(curve.anchor for curve in CURVES))
"""Every kind of anchor."""
