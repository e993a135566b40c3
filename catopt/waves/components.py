"""Waves as a sum of regular ones.

    eta(x, y, t) = sum of a_i cos(k_i (x cos b_i + y sin b_i) - omega_i t + phi_i)      S4 [2.63]

Wave numbers are not held here: they come with the water depth (`Sea`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from catopt.arrays import Array, Flags
from catopt.model.validity import Findings
from catopt.words import Message

_ARRAYS: Final = ("amplitude", "omega", "phase", "direction")


@dataclass(frozen=True, eq=False)
class Waves:
    """Regular waves that add up; every array has the shape (n,) and cannot be written to."""

    amplitude: Array  # a, m
    omega: Array  # angular frequency, rad/s
    phase: Array  # phi, rad: at the origin at t = 0 the wave stands at a cos(phi)
    direction: Array  # b, rad: where the wave travels to, counter-clockwise from the x axis
    # s after which a surface taken from a record begins anew; inf where that is not known:
    repeats_after: float = field(default=math.inf, kw_only=True)

    def __post_init__(self) -> None:
        for name in _ARRAYS:
            values = np.array(getattr(self, name), dtype=float)
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        self._check()

    def _check(self) -> None:
        found = Findings("Waves")
        for name in _ARRAYS:
            values = getattr(self, name)
            if values.ndim != 1 or values.shape != np.shape(self.omega):
                shape = Message("refused_motion.shape", shape=values.shape)
                found.add(name, shape, Message("refused_motion.one_number_a_wave"))
            elif not np.isfinite(values).all():
                found.add(
                    name,
                    Message("refused_motion.nan"),
                    Message("refused_motion.finite_numbers_are_wanted"),
                )
        if not found.problems and self.omega.size == 0:
            given = Message("refused_motion.no_wave")
            found.add("omega", given, Message("refused_motion.one_wave"))
        if not (self.omega > 0.0).all():
            least = repr(float(self.omega.min()))
            found.add("omega", least, Message("refused_motion.zero_radians"))
        if not (self.amplitude >= 0.0).all():
            least = repr(float(self.amplitude.min()))
            found.add("amplitude", least, Message("refused_motion.zero_metres_or_more"))
        found.number("repeats_after", self.repeats_after, "s", above=0.0, infinite=True)
        found.raise_if_any()

    @property
    def count(self) -> int:
        """How many waves."""
        return self.omega.size

    @property
    def variance(self) -> float:
        """m0, the mean square of the surface over all time, m²."""
        return float(0.5 * (self.amplitude**2).sum())

    @property
    def significant_height(self) -> float:
        """4 sqrt(m0) of these waves, m."""
        return 4.0 * math.sqrt(self.variance)

    @property
    def mean_period(self) -> float:
        """2 pi m0/m1 of these waves, s."""
        energy = self.amplitude**2
        return float(2.0 * math.pi * energy.sum() / (energy * self.omega).sum())

    def only(self, which: Flags) -> Waves:
        """Return those of the waves for which `which`, shape (n,), is true."""
        return Waves(*(getattr(self, name)[which] for name in _ARRAYS))

    def with_others(self, *others: Waves) -> Waves:
        """Return these waves and others together."""
        all_of = (self, *others)
        return Waves(*(np.concatenate([getattr(w, name) for w in all_of]) for name in _ARRAYS))


def regular_wave(
    height: float, period: float, *, direction: float = 0.0, phase: float = 0.0
) -> Waves:
    """One regular wave.

    Parameters
    ----------
    height, period : float
        From trough to crest, m: twice the amplitude; s. InputError unless above 0.
    direction, phase : float
        Where it travels to, rad from the x axis; rad: 0 puts a crest over the origin at t = 0.
    """
    found = Findings("regular_wave")
    found.number("height", height, "m", above=0.0)
    found.number("period", period, "s", above=0.0)
    found.number("direction", direction, "rad")
    found.number("phase", phase, "rad")
    found.raise_if_any()
    omega = 2.0 * math.pi / period
    return Waves(*(np.array([value]) for value in (0.5 * height, omega, phase, direction)))
