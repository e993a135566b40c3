"""The largest of several values, where rounding does not choose between those that are alike.

Lines of a symmetric system, load cases of the same force, two quantities that differ by the same
error: which of them is larger in the last digit hangs on the processor. Of such the first counts.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Final, TypeVar

RESOLVED: Final = 1e-9
"""Part of the largest value within which others are as large: a thousand times solvers' error."""

Item = TypeVar("Item")


def first_largest(values: Sequence[float], resolved: float = 0.0) -> int:
    """Return the index of the first value that is the largest but for rounding; none is nan.

    A difference of `resolved`, in their unit, means nothing though the values be smaller.
    """
    most = max(values)
    least = most - max(RESOLVED * abs(most), resolved) if math.isfinite(most) else most
    return next(index for index, value in enumerate(values) if value >= least)


def largest(items: Iterable[Item], key: Callable[[Item], float], resolved: float = 0.0) -> Item:
    """Return the first item whose value, by `key`, is the largest but for rounding."""
    listed = list(items)
    return listed[first_largest([key(item) for item in listed], resolved)]
