"""Whether steps, waves, records and duration of a run go together: rules with their numbers."""

from __future__ import annotations

from typing import Final

import numpy as np

from catopt.model.kinds import Findings
from catopt.waves import Sea, breaking_warning, repetition_warning
from catopt.words import Message, term

_FEWEST: Final = 4.0
"""Steps in a period below which nothing is left of it."""
_WANTED: Final = 20.0
"""Steps in a period: average acceleration then lengthens it by 0.8 %, (omega h)^2/12."""
_FEWEST_SAMPLES: Final = 4.0
"""Samples in a period below which a cubic spline makes its own acceleration of it."""
_FASTEST_PART: Final = 0.01
"""Part of the waves' energy that may be faster than what the steps are compared with."""


def step_warnings(
    step: float, duration: float, periods: dict[str, float], sea: Sea | None
) -> list[str]:
    """Words about a step too long for what drives the run, and about its waves.

    `step`, `duration`: s; `periods`: what drives the run, with its shortest period, s. Raises
    InputError when a period has fewer than four steps.
    """
    driven = dict(periods)
    warnings = []
    if sea is not None and sea.waves is not None:
        driven[Message("motion.wave_energy")] = _shortest_period(sea)
        about = (breaking_warning(sea), repetition_warning(sea.waves, duration))
        warnings += [words for words in about if words is not None]
    found = Findings("TimeStepping")
    for name, period in driven.items():
        if step > period / _FEWEST:
            wanted = Message(
                "refused_motion.has_periods_down_s_s",
                name=name,
                period=period,
                period2=period / _WANTED,
            )
            found.add("step", f"{step:g} s", wanted)
        elif step > period / _WANTED * (1.0 + 1e-9):
            warnings.append(
                Message(
                    "motion.long_step",
                    step=step,
                    count=period / step,
                    what=term(name),
                    period=period,
                    wanted=_WANTED,
                )
            )
    found.raise_if_any()
    return warnings


def record_warnings(period: float, step: float) -> list[str]:
    """Words about a record whose samples do not resolve its own acceleration.

    `period`: that 99 % of its acceleration's variance exceeds, s; `step`: from sample to sample, s.
    """
    if period >= _FEWEST_SAMPLES * step * (1.0 - 1e-9):
        return []
    return [Message("motion.noisy_record", period=_FEWEST_SAMPLES * step, step=step)]


def _shortest_period(sea: Sea) -> float:
    """Return the period that 99 % of the waves' energy exceeds, s."""
    assert sea.waves is not None
    order = np.argsort(sea.waves.omega)[::-1]
    energy = np.cumsum(sea.waves.amplitude[order] ** 2)
    at = int(np.searchsorted(energy, _FASTEST_PART * energy[-1]))
    return float(2.0 * np.pi / sea.waves.omega[order[min(at, order.size - 1)]])
