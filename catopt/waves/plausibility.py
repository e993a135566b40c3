"""Where Airy's theory no longer describes a sea: waves that would break."""

from __future__ import annotations

import math
from typing import Final

from catopt.model.validity import Findings
from catopt.waves.dispersion import wave_number
from catopt.waves.sea import Sea
from catopt.words import Message

_STEEPEST: Final = 0.142
"""Height over length of the steepest regular wave in deep water, Miche (1944)."""


def breaking_height(period: float, depth: float) -> float:
    """Height at which a regular wave breaks, m: 0.142 lambda tanh(k d), Miche (1944).

    Parameters
    ----------
    period, depth : float
        s, and water depth, m; InputError unless above 0.
    """
    found = Findings("breaking_height")
    found.number("period", period, "s", above=0.0)
    found.number("depth", depth, "m", above=0.0)
    found.raise_if_any()
    k = wave_number(2.0 * math.pi / period, depth)
    return _STEEPEST * 2.0 * math.pi / k * math.tanh(k * depth)


def breaking_warning(sea: Sea) -> str | None:
    """Say that a sea's waves are higher than they can be, with the numbers; None when they are not.

    A regular wave is held by its height. A sum of waves is held by its significant height, at the
    mean period: single waves in it are up to twice as high and break first.
    """
    if sea.waves is None:
        return None
    height, key = sea.waves.significant_height, "motion.waves_break"
    if sea.waves.count == 1:
        height, key = 2.0 * float(sea.waves.amplitude[0]), "motion.wave_breaks"
    period = sea.waves.mean_period
    limit = breaking_height(period, sea.depth)
    if height <= limit:
        return None
    return Message(key, height=height, limit=limit, period=period, depth=sea.depth)
