"""From which values of an input a printed number follows."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from catopt.reproduce.printed import Printed


@dataclass(frozen=True)
class Interval:
    """All values between two bounds."""

    least: float
    largest: float

    def ends(self, decimals: int) -> tuple[str, str]:
        """Write the bounds, each rounded inwards: every value between them belongs to it."""
        scale = 10.0**decimals
        least = math.ceil(self.least * scale) / scale
        largest = math.floor(self.largest * scale) / scale
        return f"{least:.{decimals}f}", f"{largest:.{decimals}f}"


def interval(
    quantity: Callable[[float], float], printed: Printed, within: tuple[float, float]
) -> Interval:
    """Find the values of an input for which a quantity prints as it did.

    `quantity`: the printed quantity as a monotone function of the input; `within`: where to look;
    the quantity must pass both bounds of the print in between.
    """
    ends = sorted(_where(quantity, bound, within) for bound in printed.bounds)
    return Interval(ends[0], ends[1])


def _where(quantity: Callable[[float], float], value: float, within: tuple[float, float]) -> float:
    """Bisect for the input at which a monotone quantity takes a value, to double precision."""
    low, high = within
    rising = quantity(high) > quantity(low)
    if not min(quantity(low), quantity(high)) < value < max(quantity(low), quantity(high)):
        raise ValueError(f"the quantity does not pass {value:g} between {low:g} and {high:g}")
    while low < (middle := 0.5 * (low + high)) < high:
        if (quantity(middle) < value) == rising:
            low = middle
        else:
            high = middle
    return low
