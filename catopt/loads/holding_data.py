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
    """Ultimate holding capacity H = HR (m/mR)^b.

    Attributes
    ----------
    anchor, soil : str
        Kind of anchor and of soil.
    data : {"UFC", "DTOcean", "Vryhof"}
        Data set.
    reference_capacity : float
        HR, N.
    reference_mass : float
        mR, kg.
    exponent : float
        b.
    source : LoadSource
        Of HR and b.
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
_DTO_SOURCE = LoadSource(DTOCEAN, "drag anchors", "C")
_MK6_SOURCE = LoadSource(MOORPY, "Stevpris Mk6", "C")

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
_MK6: Final[_Rows] = {
    "soft clay": (509.96, 0.93),
    "medium clay": (701.49, 0.93),
    "sand": (904.21, 0.92),
}


def _curves() -> tuple[HoldingCurve, ...]:
    found: list[HoldingCurve] = []

    def add(
        anchor: str,
        rows: _Rows,
        data: DataSet,
        unit: float,
        mass: float,
        source: LoadSource,
    ) -> None:
        for soil, (reference, exponent) in rows.items():
            found.append(HoldingCurve(anchor, soil, data, reference * unit, mass, exponent, source))

    for anchor, rows in _UFC.items():
        add(anchor, rows, "UFC", _KIP, _UFC_MASS, _UFC_SOURCE)
    for anchor, rows in _DTO.items():
        add(anchor, rows, "DTOcean", _TONNE * STANDARD_GRAVITY, _TONNE, _DTO_SOURCE)
    add("Stevpris Mk6", _MK6, "Vryhof", 1e3, _TONNE, _MK6_SOURCE)
    return tuple(found)


CURVES: Final = _curves()
"""Every curve."""

ANCHORS: Final = tuple(dict.fromkeys(curve.anchor for curve in CURVES))
"""Every kind of anchor."""
