"""What a row of ever finer meshes says: the observed order, and the value it runs to.

With an error c n^-p, three meshes of n, 2n and 4n bars give

    p = log2 |(q1 - q2)/(q2 - q3)|          observed order
    q = q3 + (q3 - q2)/(2^p - 1)            Richardson's estimate

The estimate is only worth something where the error falls as smoothly as theory says, p = 2.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

ORDER = 2.0
"""Of bars with half of their load at each end."""


def observed_order(values: Sequence[float], noise: float) -> float | None:
    """Order by which the last three values close up.

    Returns: None where there are fewer than three values or the last change is rounding; infinite
    never: a change that comes after none counts as order minus infinity, not smooth.
    """
    if len(values) < 3:
        return None
    first, second = values[-3] - values[-2], values[-2] - values[-1]
    if abs(second) <= noise:
        return None
    return math.log2(max(abs(first), noise) / abs(second))


def extrapolated(values: Sequence[float], order: float = ORDER) -> float:
    """Richardson's estimate from the last two values.

    `order`: by which the error falls.
    """
    gain = math.pow(2.0, order) - 1.0
    return values[-1] + (values[-1] - values[-2]) / gain
