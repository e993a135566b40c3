"""Main dimensions of a ship of which only kind and deadweight are known."""

from __future__ import annotations

import math
from bisect import bisect_left
from types import MappingProxyType
from typing import Final, Literal, NamedTuple, TypeAlias, get_args

from catopt.model.validity import Findings
from catopt.words import Message

ShipKind = Literal["tanker", "bulk carrier", "general cargo", "barge"]
"""A barge or a pontoon has square ends."""

DIMENSIONS_SOURCE: Final = "PIANC 2002 / ROM 3.1 [R]"
"""Recalled, read in neither; checked by their block coefficients (0.71 to 0.84)."""

_TONNE: Final = 1000.0
_Row: TypeAlias = tuple[float, float, float, float]


class ShipDimensions(NamedTuple):
    """Length over all, breadth, moulded depth and full draught, m."""

    length: float
    breadth: float
    moulded_depth: float
    draught: float


# Averages by deadweight in t: length over all, breadth, depth, full draught, m.
_TABLE: Final = MappingProxyType(
    {
        "tanker": {
            3e3: (90.0, 13.0, 7.2, 6.0),
            5e3: (110.0, 15.0, 8.6, 7.0),
            10e3: (145.0, 19.0, 10.0, 7.8),
            20e3: (174.0, 24.5, 12.6, 9.8),
            30e3: (188.0, 28.0, 14.2, 10.8),
            40e3: (200.0, 30.0, 15.4, 11.8),
            50e3: (210.0, 32.2, 16.4, 12.6),
            60e3: (217.0, 36.0, 17.0, 13.0),
            100e3: (250.0, 43.0, 19.8, 15.1),
            150e3: (285.0, 49.5, 22.0, 16.9),
            200e3: (310.0, 55.0, 24.0, 18.5),
            300e3: (350.0, 63.0, 27.0, 21.0),
        },
        "bulk carrier": {
            10e3: (130.0, 18.0, 10.0, 7.5),
            20e3: (160.0, 23.5, 12.6, 9.3),
            40e3: (195.0, 29.0, 16.3, 11.5),
            60e3: (220.0, 33.5, 18.2, 12.8),
            100e3: (255.0, 39.0, 20.8, 15.3),
            150e3: (290.0, 44.0, 23.3, 17.5),
            200e3: (315.0, 48.5, 25.0, 19.0),
            300e3: (350.0, 56.0, 28.1, 21.8),
        },
        "general cargo": {
            5e3: (105.0, 15.8, 8.5, 6.4),
            10e3: (133.0, 19.8, 11.2, 8.0),
            20e3: (166.0, 24.8, 13.8, 10.0),
            30e3: (188.0, 27.7, 16.0, 11.3),
            40e3: (209.0, 30.0, 18.0, 12.5),
        },
    }
)


def ship_dimensions(kind: str, deadweight: float) -> ShipDimensions:
    """Estimate main dimensions from the deadweight, kg, between the rows of a table of averages.

    Between two rows the logarithms are interpolated, so that a dimension goes with a power of the
    deadweight there. Another kind of ship and a deadweight beyond the table are refused.

    Examples
    --------
    >>> from catopt.loads.ship_dimensions import ship_dimensions
    >>> ship_dimensions("tanker", 50e6)
    ShipDimensions(length=210.0, breadth=32.2, moulded_depth=16.4, draught=12.6)
    """
    found = Findings("ship dimensions")
    found.word("kind", kind, get_args(ShipKind))
    if kind == "barge":
        allowed = Message("refused_sizing.no_table_barges_pontoons_was")
        found.add("deadweight", f"{deadweight / _TONNE:.6g} t", allowed)
    found.raise_if_any()
    rows = _TABLE[kind]
    tonnes, known = deadweight / _TONNE, sorted(rows)
    if not known[0] <= tonnes <= known[-1]:
        found.add(
            "deadweight",
            f"{tonnes:.6g} t",
            Message(
                "refused_sizing.dimensions_are_known_from_t",
                kind=kind,
                value=known[0],
                value2=known[-1],
            ),
        )
    found.raise_if_any()
    if tonnes in rows:
        return ShipDimensions(*rows[tonnes])
    upper = bisect_left(known, tonnes)
    low, high = known[upper - 1], known[upper]
    return _between(rows[low], rows[high], math.log(tonnes / low) / math.log(high / low))


def _between(low: _Row, high: _Row, part: float) -> ShipDimensions:
    """Interpolate by a power law, and round as the table is: lengths to 1 m, the rest to 0.1 m."""
    length, *others = (a * (b / a) ** part for a, b in zip(low, high, strict=True))
    return ShipDimensions(float(round(length)), *(round(each, 1) for each in others))
