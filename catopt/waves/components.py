"""Waves as a sum of regular ones: made, recorded, and whether they repeat."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from catopt.arrays import Array, Flags
from catopt.errors import InputError, Problem
from catopt.model.array_inputs import array_in_si
from catopt.model.kinds import Findings
from catopt.words import Listed, Message

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
        found = Findings("Waves")
        for name in _ARRAYS:
            values = getattr(self, name)
            if values.ndim != 1 or values.shape != np.shape(self.omega):
                shape = Message("refused_motion.shape", shape=values.shape)
                found.add(name, shape, Message("refused_motion.one_number_a_wave"))
            elif not np.isfinite(values).all():
                allowed = Message("refused_motion.finite_numbers_are_wanted")
                found.add(name, Message("refused_motion.nan"), allowed)
        if not found.problems and self.omega.size == 0:
            found.add(
                "omega", Message("refused_motion.no_wave"), Message("refused_motion.one_wave")
            )
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
        found = Findings("ElevationRecord")
        for name, unit in (("times", "s"), ("elevation", "m")):
            read = np.array(array_in_si(found, name, getattr(self, name), unit))
            object.__setattr__(self, name, read)
        found.raise_if_any()
        t, eta = self.times, self.elevation
        if t.ndim != 1 or t.shape != eta.shape or t.size < _FEWEST:
            wanted = Message("refused_motion.times_or_more_are_wanted", fewest=_FEWEST)
            found.add("times", Listed((f"{t.shape}", f"{eta.shape}"), "and"), wanted)
        elif not (np.isfinite(t).all() and np.isfinite(eta).all()):
            wanted = Message("refused_motion.finite_numbers_are_wanted")
            found.add("elevation", Message("refused_motion.nan"), wanted)
        else:
            self._check_steps(found)
            if not found.problems and float(np.ptp(eta)) == 0.0:
                wanted = Message("refused_motion.surface_moves_wanted")
                still = Message("refused_motion.throughout", height=eta[0])
                found.add("elevation", still, wanted)
        found.raise_if_any()

    def _check_steps(self, found: Findings) -> None:
        steps = np.diff(self.times)
        usual, at = float(np.median(steps)), int(np.argmax(steps))
        if not (steps > 0.0).all():
            at = int(np.argmax(steps <= 0.0))
            said = Message("refused_motion.after", one=self.times[at + 1], other=self.times[at])
            found.add("times", said, Message("refused_motion.must_rise"))
        elif steps[at] > _GAP * usual:
            gap = Message("refused_motion.a_gap", gap=steps[at], after=self.times[at])
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
        return np.asarray(np.interp(self._even_times, self.times, self.elevation))

    @property
    def _even_times(self) -> Array:
        return np.asarray(self.times[0] + self.step * np.arange(self.times.size))

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
            allowed = Message("refused_motion.record_has_no_wave_so")
            problem = Problem("shortest_period", f"{shortest_period} s", allowed)
            raise InputError([problem], "ElevationRecord")
        omega, phase = 2.0 * math.pi / T * k[:count], -np.angle(X[:count]).astype(float)
        along = np.full(count, float(direction))
        return Waves(amplitude[:count], omega, phase, along, repeats_after=T)

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
