"""A recorded surface as a sum of regular waves, by the discrete Fourier transform.

Of N samples at steps h, T = N h, the transform X_k = sum of eta_j exp(-2 pi i j k/N) gives the wave
of the frequency 2 pi k/T the amplitude 2 |X_k|/N, or |X_k|/N at k = N/2, and the phase -arg X_k.
All of them, with the mean, are the record again to rounding; T later they begin anew.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.model.validity import Findings
from catopt.waves.components import Waves
from catopt.words import Message

_FEWEST: Final = 8
_UNEVEN: Final = 0.01
"""Of a step: a time further than this from even steps is resampled; rounded times are not."""
_GAP: Final = 5.0
"""A step of time longer than this many of the usual ones is a gap."""
_LEFT_OUT: Final = 0.001
"""Part of the variance, of the fastest waves, left out where no shortest period is given."""


@dataclass(frozen=True, eq=False)
class ElevationRecord:
    """Heights of the surface at one place over time.

    Steps that differ by more than 1 % are evened out: the record is interpolated linearly at as
    many even steps.
    """

    times: Array  # (n,): rising, s, without gaps
    elevation: Array  # (n,): above any fixed level, m; the mean is taken off

    def __post_init__(self) -> None:
        for name in ("times", "elevation"):
            object.__setattr__(self, name, np.array(getattr(self, name), dtype=float))
        found = Findings("ElevationRecord")
        t, eta = self.times, self.elevation
        if t.ndim != 1 or t.shape != eta.shape or t.size < _FEWEST:
            wanted = Message("refused_motion.times_or_more_are_wanted", fewest=_FEWEST)
            found.add("times", f"{t.shape} and {eta.shape}", wanted)
        elif not (np.isfinite(t).all() and np.isfinite(eta).all()):
            found.add(
                "elevation",
                Message("refused_motion.nan"),
                Message("refused_motion.finite_numbers_are_wanted"),
            )
        else:
            self._check_steps(found)
            if not found.problems and float(np.ptp(eta)) == 0.0:
                found.add(
                    "elevation",
                    f"{eta[0]:g} m throughout",
                    Message("refused_motion.surface_moves_wanted"),
                )
        found.raise_if_any()

    def _check_steps(self, found: Findings) -> None:
        steps = np.diff(self.times)
        usual, at = float(np.median(steps)), int(np.argmax(steps))
        if not (steps > 0.0).all():
            at = int(np.argmax(steps <= 0.0))
            found.add(
                "times",
                f"{self.times[at + 1]:g} s after {self.times[at]:g} s",
                Message("refused_motion.must_rise"),
            )
        elif steps[at] > _GAP * usual:
            gap = f"a gap of {steps[at]:g} s after {self.times[at]:g} s"
            found.add("times", gap, Message("refused_motion.steps_about_s_are_wanted", usual=usual))

    @property
    def duration(self) -> float:
        """From the first sample to the last, s."""
        return float(self.times[-1] - self.times[0])

    @property
    def step(self) -> float:
        """Mean step of time, s."""
        return self.duration / (self.times.size - 1)

    @property
    def is_resampled(self) -> bool:
        """Whether its steps are uneven."""
        return bool((np.abs(self.times - self._even_times) > _UNEVEN * self.step).any())

    @property
    def mean(self) -> float:
        """Of the elevation at even steps, m."""
        return float(self._even.mean())

    @property
    def _even(self) -> Array:
        if not self.is_resampled:
            return self.elevation
        resampled: Array = np.interp(self._even_times, self.times, self.elevation)
        return resampled

    @property
    def _even_times(self) -> Array:
        even: Array = self.times[0] + self.step * np.arange(self.times.size)
        return even

    def waves(self, *, direction: float = 0.0, shortest_period: float | None = None) -> Waves:
        """Find the waves that the record is the sum of; its first sample is t = 0 at the origin.

        They travel to `direction`, rad from the x axis. Waves faster than `shortest_period`, s, are
        left out; InputError when none is left. Without it the fastest that together have no more
        than 0.1 % of the variance are.
        """
        N, T = self.times.size, self.times.size * self.step
        X = np.fft.rfft(self._even - self.mean)[1:]
        k = np.arange(1, X.size + 1, dtype=float)
        amplitude: Array = np.where(2 * k == N, 1.0, 2.0) * np.abs(X) / N
        if shortest_period is None:
            energy = np.cumsum(self._energy(amplitude))
            count = int(np.searchsorted(energy, (1.0 - _LEFT_OUT) * energy[-1])) + 1
        else:
            count = int((T / k >= shortest_period * (1.0 - 1e-9)).sum())
        if count == 0 or not amplitude[:count].any():
            found = Findings("ElevationRecord")
            found.add(
                "shortest_period",
                f"{shortest_period} s",
                Message("refused_motion.record_has_no_wave_so"),
            )
            found.raise_if_any()
        kept = slice(0, count)
        omega, phase = 2.0 * math.pi / T * k[kept], -np.angle(X[kept]).astype(float)
        along = np.full(count, float(direction))
        return Waves(amplitude[kept], omega, phase, along, repeats_after=T)

    def left_out(self, waves: Waves) -> float:
        """Part of the record's variance that is in none of the waves found in it."""
        variance = float(self._even.var())
        return max(0.0, 1.0 - float(self._energy(waves.amplitude).sum()) / variance)

    def _energy(self, amplitude: Array) -> Array:
        """Mean square over the samples of each wave, from the slowest; the last may be k = N/2."""
        energy: Array = 0.5 * amplitude**2
        if 2 * amplitude.size == self.times.size:
            energy[-1] *= 2.0
        return energy
