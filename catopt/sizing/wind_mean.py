"""The mean speed of a wind over another time, by the profile of gusts of NPD and ISO."""

from __future__ import annotations

import math
from typing import Final

from catopt.model.validity import Findings

LONGEST_MEAN: Final = 3600.0
"""s: the mean that the profile starts from."""

_TURBULENCE, _WITH_SPEED, _GUST = 0.06, 0.043, 0.41
"""Of Iu = 0.06 (1 + 0.043 U0) at 10 m and U(t) = U0 (1 - 0.41 Iu ln(t/3600)), in m and s."""


def mean_over(speed: float, given: float, wanted: float) -> float:
    """Convert a wind speed at 10 m from one averaging time to another.

    U(t) = U0 [1 - 0.41 Iu ln(t/3600)] with Iu = 0.06 (1 + 0.043 U0), U0 the mean of an hour
    (NPD/ISO 19901-1, B: read in two programs). U0 is the root of a quadratic equation.

    Parameters
    ----------
    speed : float
        m/s.
    given, wanted : float
        Averaging times, s, of 1 s to an hour.

    Raises
    ------
    InputError
        For an averaging time beyond these.

    Examples
    --------
    >>> from catopt.sizing.wind_mean import mean_over
    >>> round(mean_over(25.0, 600.0, 30.0), 2)
    28.5
    """
    found = Findings("wind mean")
    for key, time in (("given", given), ("wanted", wanted)):
        found.number(key, time, "s", at_least=1.0, at_most=LONGEST_MEAN)
    found.raise_if_any()
    if given == wanted:
        return speed
    gust = _gust(given)
    a, b = gust * _WITH_SPEED, 1.0 + gust
    hourly = 2.0 * speed / (b + math.sqrt(b * b + 4.0 * a * speed))
    gust = _gust(wanted)
    return hourly * (1.0 + gust * (1.0 + _WITH_SPEED * hourly))


def _gust(time: float) -> float:
    return -_GUST * _TURBULENCE * math.log(time / LONGEST_MEAN)
