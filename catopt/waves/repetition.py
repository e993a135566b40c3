"""Whether a sum of waves says the same thing twice within a run.

Waves at frequencies that are multiples of one step repeat after 2 pi/step. Random frequencies never
repeat exactly, but few of them nearly do. The measure is the envelope of the surface's correlation
with itself a time tau later,

    R(tau) = |sum of a_i² exp(j omega_i tau)| / (sum of a_i²),

1 where it repeats. For n waves of equal energy R² is about exponentially distributed with the mean
1/n once the waves have come apart, so that the greatest of m independent values is about
sqrt(ln(m)/n).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from catopt.model.validity import Findings
from catopt.waves.components import Waves
from catopt.words import Message

_APART: Final = 10.0
"""In mean periods: after these the waves of even the narrowest spectrum here have come apart."""

_SAMPLES: Final = 8.0
"""Lags looked at in a turn of the fastest wave relative to the slowest."""

_BLOCK: Final = 1024

_LIMIT: Final = 0.5
"""R from which a run is warned about: a quarter of the variance is then foretold by the first."""

_WANTED: Final = 0.25


@dataclass(frozen=True)
class Return:
    """When a sum of waves comes closest to repeating itself."""

    lag: float  # s after which; 0 for a run too short to tell
    correlation: float  # R there: 1 is a repetition, 0 none


def strongest_return(waves: Waves, duration: float) -> Return:
    """Find the greatest R(tau) for tau from ten mean periods up to the run's duration.

    Parameters
    ----------
    duration : float
        Of the run, s; InputError unless above 0.
    """
    found = Findings("strongest_return")
    found.number("duration", duration, "s", above=0.0)
    found.raise_if_any()
    start = _APART * waves.mean_period
    if duration <= start:
        return Return(0.0, 0.0)
    spread = max(float(np.ptp(waves.omega)), 2.0 * math.pi / duration)
    step = 2.0 * math.pi / (_SAMPLES * spread)
    share = waves.amplitude**2 / (waves.amplitude**2).sum()
    ahead = np.exp(1j * np.outer(waves.omega, step * np.arange(_BLOCK)))
    best = Return(0.0, 0.0)
    for first in np.arange(start, duration, step * _BLOCK):
        turned = share * np.exp(1j * waves.omega * first)
        # Not by BLAS: its threads would keep the other cores busy for nothing.
        correlation = np.abs(np.einsum("i,ij->j", turned, ahead))
        inside = correlation[: max(1, min(_BLOCK, math.ceil((duration - first) / step)))]
        at = int(inside.argmax())
        if inside[at] > best.correlation:
            best = Return(float(first + at * step), float(inside[at]))
    return best


def waves_needed(duration: float, mean_period: float, correlation: float = _WANTED) -> int:
    """How many waves of equal energy keep R below `correlation` over a run: ln(m)/R².

    m, the number of independent lags, is taken as the number of mean periods in the run.

    Parameters
    ----------
    duration, mean_period : float
        s, above 0.
    correlation : float
        R, above 0, at most 1. InputError beyond these ranges.
    """
    found = Findings("waves_needed")
    found.number("duration", duration, "s", above=0.0)
    found.number("mean_period", mean_period, "s", above=0.0)
    found.number("correlation", correlation, "", above=0.0, at_most=1.0)
    found.raise_if_any()
    return max(1, math.ceil(math.log(max(duration / mean_period, 1.0)) / correlation**2))


def repetition_warning(waves: Waves, duration: float) -> str | None:
    """Say that a run has too few waves for its duration, with the numbers; None when it has not.

    One regular wave is meant to repeat and passes; a record passes up to its own length. `duration`
    of the run, s.
    """
    if waves.count == 1:
        return None
    if math.isfinite(waves.repeats_after):
        if duration <= waves.repeats_after * (1.0 + 1e-9):
            return None
        return Message("motion.record_repeats", length=waves.repeats_after, duration=duration)
    worst = strongest_return(waves, duration)
    if worst.correlation < _LIMIT:
        return None
    needed = waves_needed(duration, waves.mean_period)
    counts = {"count": waves.count, "needed": needed, "wanted": _WANTED}
    return Message("motion.waves_repeat", duration=duration, **vars(worst), **counts)
