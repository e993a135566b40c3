"""By how much a limit is overrun: the one formula of each check.

The report of a line and the search for designs call the same functions, the search compiled and
millions of times. Each gives a pure number: 0 at the limit, negative inside it, and of the size of
1 for a line that is far off, so that the excesses of different checks may be compared. A check is
passed when its excess is at most `ROUNDING`.
"""

from __future__ import annotations

import math
from typing import Final

from catopt.compiled import inlined

__all__ = [
    "ROUNDING",
    "grounded_excess",
    "holding_excess",
    "ratio_excess",
    "uplift_angle_excess",
    "uplift_force_excess",
]

ROUNDING: Final = 1e-9
"""What rounding may add to an excess: a thousand times the error of a solved line."""


@inlined
def ratio_excess(demand: float, capacity: float) -> float:
    """Demand beside capacity, in one unit.

    Of a segment's tension and strength over factor, span and limit, pull at the fairlead and
    reserve buoyancy, the weight that a sinker needs (`sinker_needed` of model) and its own.
    """
    return demand / capacity - 1.0


@inlined
def uplift_angle_excess(angle: float, limit: float) -> float:
    """Inclination at the anchor beside the largest allowed one; rad, and the excess per rad."""
    return angle - limit


@inlined
def uplift_force_excess(vertical: float, horizontal: float, limit: float) -> float:
    """Vertical pull at the anchor beside the largest allowed one; N.

    Measured by the limit or by the horizontal force, whichever is larger, for the limit may be 0.
    No limit is an infinite one.
    """
    if math.isinf(limit):
        return -1.0
    scale = max(limit, horizontal)
    return (vertical - limit) / scale if scale > 0.0 else vertical


@inlined
def grounded_excess(grounded: float, wanted: float) -> float:
    """Length on the bed short of what is wanted, by what is wanted; m. 0 wants nothing."""
    if wanted == 0.0:
        return -1.0
    return 1.0 - grounded / wanted


@inlined
def holding_excess(horizontal: float, factor: float, capacity: float) -> float:
    """Pull on a drag anchor times its factor beside its ultimate holding capacity; N."""
    return factor * horizontal / capacity - 1.0
