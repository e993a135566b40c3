"""What leads the ends of lines: motions and forces over time, with their first two derivatives.

A series is a sum of harmonics, or values at given times joined by a cubic spline, whose velocity
and acceleration are its derivatives and thus go with it. It grows smoothly from nothing.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array
from catopt.compiled import compiled, packed
from catopt.errors import refused
from catopt.model.array_inputs import array_in_si
from catopt.model.kinds import Findings
from catopt.units import is_quantity
from catopt.waves.kinematics import cos_sin, row_at
from catopt.words import Message

Complex = npt.NDArray[np.complex128]

_GAP = 5.0
"""A step of time longer than this many of the usual ones is taken for a gap in the record."""
_FASTEST_PART = 0.01
"""Part of the variance of a record's acceleration that may be faster than its shortest period."""
_ROUNDING = 64.0 * float(np.finfo(float).eps)
"""Of an acceleration by differences, over the largest value and the square of the step."""


@dataclass(frozen=True)
class Harmonic:
    """a cos(2 pi t/T + phase) along each axis, summed over any number of periods."""

    period: float | Sequence[float]  # T, s; one or (n,)
    amplitude: Any  # (3,) or (n, 3): a along x, y and z: m of a motion, N of a force
    phase: Any = (0.0, 0.0, 0.0)  # (3,) or (n, 3): rad; -pi/2 makes a sine

    def __post_init__(self) -> None:
        found = Findings("Harmonic")
        for name, unit in (("period", "s"), ("amplitude", ""), ("phase", "rad")):
            given = getattr(self, name)
            read = array_in_si(found, name, given, unit)
            if is_quantity(given) or np.asarray(given).dtype.kind not in "iuf":
                object.__setattr__(self, name, read)
        found.raise_if_any()
        for number, period in enumerate(np.atleast_1d(np.asarray(self.period, dtype=float))):
            found.number(f"period[{number}]", float(period), "s", above=0.0)
        count = np.size(self.period)
        for name in ("amplitude", "phase"):
            shape = np.shape(getattr(self, name))
            if shape not in ((3,), (count, 3)):
                wanted = Message("refused_motion.shape_three_or_n", count=count)
                found.add(name, Message("refused_motion.shape", shape=shape), wanted)
            elif not np.isfinite(np.asarray(getattr(self, name), dtype=float)).all():
                wanted = Message("refused_motion.finite_numbers_are_wanted")
                found.add(name, Message("refused_motion.nan"), wanted)
        found.raise_if_any()

    @cached_property
    def rows(self) -> Array:
        """Rows of omega, a cos(phase) and a sin(phase) along each axis; shape (n, 7)."""
        omega = 2.0 * math.pi / np.atleast_1d(np.asarray(self.period, dtype=float))
        size = (omega.size, 3)
        amplitude = np.broadcast_to(np.asarray(self.amplitude, dtype=float), size)
        phase = np.broadcast_to(np.asarray(self.phase, dtype=float), size)
        return np.column_stack([omega, amplitude * np.cos(phase), amplitude * np.sin(phase)])

    @property
    def amplitudes(self) -> Complex:
        """Complex amplitudes of exp(-i omega t), whose real parts add up to it; shape (n, 3)."""
        found: Complex = self.rows[:, 1:4] - 1j * self.rows[:, 4:7]
        return found

    @property
    def shortest_period(self) -> float:
        """Of the fastest harmonic, s."""
        return float(np.min(self.period))


@dataclass(frozen=True, eq=False)
class Sampled:
    """Values at given times, joined by a cubic spline (not-a-knot); constant before and after."""

    times: Any  # (n,): rising, s; at least four, and without gaps
    values: Any  # (n, 3): along x, y and z: m of a motion, N of a force

    def __post_init__(self) -> None:
        found = Findings("Sampled")
        times = array_in_si(found, "times", self.times, "s")
        values = array_in_si(found, "values", self.values, "")
        found.raise_if_any()
        if times.ndim != 1 or times.size < 4:
            shape = Message("refused_motion.shape", shape=times.shape)
            found.add("times", shape, Message("refused_motion.four_times"))
        elif values.shape != (times.size, 3):
            shape = Message("refused_motion.shape", shape=values.shape)
            found.add("values", shape, Message("refused_motion.shape_n", count=times.size))
        elif not (np.isfinite(times).all() and np.isfinite(values).all()):
            bad = ~(np.isfinite(times) & np.isfinite(values).all(axis=1))
            first = Message("refused_motion.nan_in_row", row=np.flatnonzero(bad)[0])
            found.add("values", first, Message("refused_motion.no_gap"))
        else:
            _check_times(times, found)
        found.raise_if_any()
        object.__setattr__(self, "times", times)
        object.__setattr__(self, "values", values)

    @cached_property
    def spline(self) -> Any:
        """Of all three axes over time."""
        from scipy.interpolate import CubicSpline

        return CubicSpline(self.times, self.values)

    @property
    def coefficients(self) -> Array:
        """Of (t - t_i)^3 down to 1, shape (n - 1, 3, 4)."""
        return np.ascontiguousarray(np.moveaxis(self.spline.c, 0, 2))

    @property
    def usual_step(self) -> float:
        """Median of the times from one sample to the next, s."""
        return float(np.median(np.diff(self.times)))

    @cached_property
    def shortest_period(self) -> float:
        """Return the period that 99 % of the variance of the acceleration exceeds, s.

        By its spectrum under Hann's window, in which a wave is up to two lines of 1/length wide:
        of a record of few waves it comes out shorter. The record's length where nothing is
        accelerated.
        """
        length = float(self.times[-1] - self.times[0])
        count = max(round(length / self.usual_step), 4)
        middle = (np.arange(count) + 0.5) / count
        rate = self.spline(self.times[0] + length * middle, 2)
        rate -= rate.mean(axis=0)
        if np.abs(rate).max() <= _ROUNDING * np.abs(self.values).max() / self.usual_step**2:
            return length
        window = np.sin(math.pi * middle) ** 2
        power = (np.abs(np.fft.rfft(rate * window[:, np.newaxis], axis=0)) ** 2).sum(axis=1)[1:]
        faster = np.cumsum(power[::-1])[::-1]
        lines = 1 + np.flatnonzero(faster > _FASTEST_PART * faster[0])
        return length / float(lines[-1])


@dataclass(frozen=True, eq=False)
class Together:
    """Harmonics and values at given times, added up: such as waves and a slow drift."""

    harmonic: Harmonic
    sampled: Sampled

    @property
    def shortest_period(self) -> float:
        """The shorter one of both, s."""
        return min(self.harmonic.shortest_period, self.sampled.shortest_period)


Series = Harmonic | Sampled | Together


@packed
class SeriesRows(NamedTuple):
    """Series of one or more ends as the kernels read them."""

    base: Array  # (ends, 3): value at rest, before the series has begun
    harmonics: Array  # (ends, n, 7): as of `Harmonic.rows`
    times: Array  # (m,): of the spline; empty without one
    spline: Array  # (ends, m - 1, 3, 4): its coefficients
    ramp_time: float  # s over which it grows as (1 - cos(pi t/T))/2


def series_rows(base: Array, series: Sequence[Series | None], ramp_time: float) -> SeriesRows:
    """Lay out the series of all ends, (ends, 3) at rest; those sampled must share their times."""
    ends = len(series)
    regular = [s.harmonic if isinstance(s, Together) else s for s in series]
    measured = [s.sampled if isinstance(s, Together) else s for s in series]
    most = max([s.rows.shape[0] for s in regular if isinstance(s, Harmonic)], default=0)
    harmonics = np.zeros((ends, most, 7))
    sampled = [s for s in measured if isinstance(s, Sampled)]
    times = sampled[0].times if sampled else np.zeros(0)
    if any(not np.array_equal(s.times, times) for s in sampled):
        given, allowed = (
            Message("refused_motion.different_ones"),
            Message("refused_motion.times_alike"),
        )
        raise refused("times", given, allowed, "motion")
    spline = np.zeros((ends, max(times.size - 1, 0), 3, 4))
    for k, (waves, record) in enumerate(zip(regular, measured, strict=True)):
        if isinstance(waves, Harmonic):
            harmonics[k, : waves.rows.shape[0]] = waves.rows
        if isinstance(record, Sampled):
            spline[k] = record.coefficients
    first = np.array(base, dtype=float, order="C")
    return SeriesRows(first, harmonics, times, spline, float(ramp_time))


_A_VALUE = 1e-4
"""Time that a value of a series takes as plain Python, s."""


def series_values(rows: SeriesRows, times: Array) -> Array:
    """Value of the first end's series at each time, shape (times, 3)."""
    values = np.zeros((times.size, 3))
    compiled(_fill_values, _A_VALUE * times.size)(times, rows, np.zeros((3, 3)), values)
    return values


def _fill_values(times: Any, rows: SeriesRows, room: Any, to: Any) -> None:
    for k in range(times.shape[0]):
        fill_series(times[k], rows, 0, room)
        for i in range(3):
            to[k, i] = room[0, i]


def fill_series(t: float, rows: SeriesRows, end: int, out: Any) -> None:
    """Write rows of value, first and second derivative along x, y and z at a time t, s."""
    for i in range(3):
        out[0, i] = out[1, i] = out[2, i] = 0.0
    for n in range(rows.harmonics.shape[1]):
        row = rows.harmonics[end, n]
        omega = row[0]
        cos, sin = cos_sin(omega * t)
        for i in range(3):
            value = row[1 + i] * cos - row[4 + i] * sin
            rate = row[1 + i] * sin + row[4 + i] * cos
            out[0, i] += value
            out[1, i] -= omega * rate
            out[2, i] -= omega * omega * value
    if rows.times.shape[0] > 0:
        _add_spline(t, rows.times, rows.spline[end], out)
    r, r_1, r_2 = _ramp(t, rows.ramp_time)
    for i in range(3):
        d, d_1, d_2 = out[0, i], out[1, i], out[2, i]
        out[0, i] = rows.base[end, i] + r * d
        out[1, i] = r_1 * d + r * d_1
        out[2, i] = r_2 * d + 2.0 * r_1 * d_1 + r * d_2


def _add_spline(t: float, times: Any, pieces: Any, out: Any) -> None:
    last = times.shape[0] - 1
    inside = min(max(t, times[0]), times[last])
    row = min(max(row_at(times, inside), 0), last - 1)
    s = inside - times[row]
    moves = 1.0 if inside == t else 0.0
    for i in range(3):
        a, b, c, d = pieces[row, i, 0], pieces[row, i, 1], pieces[row, i, 2], pieces[row, i, 3]
        out[0, i] += ((a * s + b) * s + c) * s + d
        out[1, i] += moves * ((3.0 * a * s + 2.0 * b) * s + c)
        out[2, i] += moves * (6.0 * a * s + 2.0 * b)


def _ramp(t: float, ramp_time: float) -> tuple[float, float, float]:
    """(1 - cos(pi t/T))/2 with its rate and second derivative."""
    if t >= ramp_time:
        return 1.0, 0.0, 0.0
    if t <= 0.0:
        return 0.0, 0.0, 0.0
    rate = math.pi / ramp_time
    cos, sin = math.cos(rate * t), math.sin(rate * t)
    return 0.5 * (1.0 - cos), 0.5 * rate * sin, 0.5 * rate * rate * cos


def _check_times(times: Array, found: Findings) -> None:
    steps = np.diff(times)
    if not (steps > 0.0).all():
        row = int(np.flatnonzero(steps <= 0.0)[0])
        said = Message("refused_motion.then", one=times[row], other=times[row + 1])
        found.add("times", said, Message("refused_motion.must_rise"))
        return
    usual = float(np.median(steps))
    if steps.max() > _GAP * usual:
        row = int(steps.argmax())
        gap = Message("refused_motion.nothing_between", begin=times[row], end=times[row + 1])
        found.add("times", gap, Message("refused_motion.gap_usual_step_s_fill", usual=usual))
