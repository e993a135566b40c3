"""Names for the kinds of numpy arrays that the parts hand to each other."""

from __future__ import annotations

import math
from typing import Any, Final, TypeVar, cast

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Codes = npt.NDArray[np.int64]
Flags = npt.NDArray[np.bool_]

_Some = TypeVar("_Some", bound=npt.NDArray[Any])

_DIGITS: Final = 10
"""That a solved system of equations keeps, of its largest value: its last ones hang on the
processor and on the number of threads, and a line that snaps enlarges them."""


def without_last_digits(values: _Some) -> _Some:
    """Round to the tenth digit of the largest; complex ones by part.

    Examples
    --------
    >>> import numpy as np
    >>> from catopt.arrays import without_last_digits
    >>> float(without_last_digits(np.array([1.00000000004, 200.0]))[0])
    1.0
    """
    largest = float(np.abs(values).max(initial=0.0))
    if largest == 0.0 or not math.isfinite(largest):
        return values
    return cast("_Some", np.round(values, _DIGITS - 1 - math.floor(math.log10(largest))))
