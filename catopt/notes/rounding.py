"""What rounding leaves in the place of a zero, kept out of what is read."""

from __future__ import annotations

import math

_NOTHING = 1e-9
"""In SI: metres, newtons and radians below it are rounding; over a size, a part of it."""


def without_rounding(value: float) -> float:
    """Round to what means something in SI: a 4e-14 m becomes 0."""
    return round(value, 9) + 0.0


def heading_of(x: float, y: float) -> float:
    """Direction of a vector, rad; a part along x or y that is rounding beside the other is 0."""
    size = math.hypot(x, y)
    x, y = (0.0 if abs(each) <= _NOTHING * size else each for each in (x, y))
    return math.atan2(y, x)
