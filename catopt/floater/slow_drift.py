"""Slow drift of a ship in waves over time and heading, and the headings at which she stays."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import Final, NamedTuple

import numpy as np

from catopt.arrays import Array
from catopt.floater.ship_in_weather import ShipInWeather
from catopt.floater.slow_ship import HEADINGS
from catopt.waves import Waves
from catopt.waves.random_surface import wave_numbers

SLOW_STEP: Final = 1.0
"""s: a thirtieth of the fastest slow motion that counts."""
_CHUNK: Final = 2000
_SERIES: Final = 40
"""Series of slow drift that are kept, some 2 MB an hour each."""
_WHOLE_SERIES: Final = 6
"""Of all headings, some 6 MB an hour each."""
_AROUND: Final = 8
"""Headings to either side of the one at rest that are summed at first."""
_ROUNDS: Final = 60
_TURN: Final = 2.0 * math.pi


class Sector(NamedTuple):
    """Headings of which slow drift is summed: the first, of `HEADINGS` all round, and how many."""

    first: int
    size: int


ALL_ROUND: Final = Sector(0, HEADINGS)


def sector_around(heading: float) -> Sector:
    """Give the headings about one, rad, that a ship on her lines seldom leaves."""
    middle = round(heading / _TURN * HEADINGS)
    return Sector((middle - _AROUND) % HEADINGS, 2 * _AROUND + 1)


def wave_numbers_of(waves: Waves, depth: float) -> Array:
    """Wave number of each wave in water of a depth, m; 1/m."""
    return wave_numbers(waves.omega, depth)


def _all(_: slice) -> slice:
    return slice(None)


def summed_waves(
    waves: Waves, time: Array, sized: Array, columns: Callable[[slice], slice] = _all
) -> Iterator[tuple[slice, Array]]:
    """Yield real parts of sums over waves of exp(-i omega t) times columns, some times at once.

    `sized` (waves, n) is complex; `columns` says which of them some times ask for. The times are
    evenly spaced: later ones are the first ones turned on, so that
    sines and cosines of these alone are taken.
    """
    angle = np.outer(time[:_CHUNK] - time[0], waves.omega)
    turn = np.hstack([np.cos(angle), np.sin(angle)])
    for start in range(0, time.size, _CHUNK):
        at = slice(start, min(start + _CHUNK, time.size))
        on = np.exp(-1j * waves.omega * time[start])[:, np.newaxis] * sized[:, columns(at)]
        yield at, turn[: at.stop - start] @ np.vstack([on.real, on.imag])


@lru_cache(maxsize=_SERIES)
def _of_hull(hull: ShipInWeather, waves: Waves) -> Array:
    """Mean drift of each wave over the square of its amplitude, (headings, waves, 3)."""
    headings = np.arange(HEADINGS, dtype=np.float64) * (_TURN / HEADINGS)
    return hull.drift(waves, wave_numbers_of(waves, hull.depth), headings)


def drift_all_round(ship: ShipInWeather, waves: Waves) -> Array:
    """Mean drift of all waves by headings all round, (headings, 3), in the ship's axes."""
    mean = np.einsum("khi,h->ki", _of_hull(ship.hull, waves), waves.amplitude**2)
    return np.asarray(ship.drift_factor * mean)


def mean_drift(ship: ShipInWeather, waves: Waves) -> Callable[[float], Array]:
    """Give the mean drift of all waves by the ship's heading."""
    mean = drift_all_round(ship, waves)

    def drift(heading: float) -> Array:
        place = heading / _TURN % 1.0 * HEADINGS
        left = int(place) % HEADINGS
        part = place - int(place)
        return np.asarray((1.0 - part) * mean[left] + part * mean[(left + 1) % HEADINGS])

    return drift


@lru_cache(maxsize=64)
def stable_headings(ship: ShipInWeather, waves: Waves) -> tuple[float, ...] | None:
    """List headings at which a turn of a ship that turns freely is turned back; the firmest first.

    None where nothing turns it.
    """
    drift, count = mean_drift(ship, waves), 10 * HEADINGS

    def turned(heading: float) -> float:
        return float(ship.steady(heading, drift(heading))[2])

    # Off the round degrees: a root on a sample would be one of rounding.
    at = [-math.pi + (k - 0.3819660113) * _TURN / count for k in range(count + 1)]
    moment = [turned(each) for each in at]
    if not any(moment):
        return None
    stable = []
    for k in range(count):
        if moment[k] > 0.0 >= moment[k + 1]:
            low, high = at[k], at[k + 1]
            for _ in range(_ROUNDS):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if turned(middle) > 0.0 else (low, middle)
            heading = math.remainder(0.5 * (low + high), _TURN)
            stable.append((moment[k] - moment[k + 1], heading))
    return tuple(heading for _, heading in sorted(stable, reverse=True))


def grown_share(samples: int, ramp: float) -> Array:
    """Part of what varies that has grown at each sample of slow motion; the ramp in s."""
    time = SLOW_STEP * np.arange(samples, dtype=np.float64)
    share = np.ones(samples) if ramp == 0.0 else np.clip(time / ramp, 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


def drift_series(
    ship: ShipInWeather, waves: Waves, samples: int, ramp: float, sector: Sector = ALL_ROUND
) -> Array:
    """Slow drift over time and heading, (n, headings, 3): mean, and what varies as it grows.

    Whatever holds the ship and blows on her it is the same: lines of a search share it.
    """
    kept = _whole_series if sector == ALL_ROUND else _series
    return np.asarray(ship.drift_factor * kept(ship.hull, waves, samples, ramp, sector))


def _summed_series(
    hull: ShipInWeather, waves: Waves, samples: int, ramp: float, sector: Sector
) -> Array:
    headings = np.arange(sector.first, sector.first + sector.size) % HEADINGS
    of, grown = _of_hull(hull, waves)[headings], grown_share(samples, ramp)
    time = SLOW_STEP * np.arange(samples, dtype=np.float64)
    phased = waves.amplitude * np.exp(1j * waves.phase)
    sized = (of * phased[:, np.newaxis]).transpose(1, 0, 2).reshape(waves.omega.size, -1)
    mean = np.einsum("khi,h->ki", of, waves.amplitude**2).ravel()
    out = np.empty((samples, mean.size))
    parts = np.column_stack([sized, phased])
    for at, summed in summed_waves(waves, time, np.hstack([parts, -1j * parts])):
        real, imaginary = np.hsplit(summed, 2)
        both = real[:, :-1] * real[:, -1:] + imaginary[:, :-1] * imaginary[:, -1:]
        out[at] = mean + grown[at, np.newaxis] * (both - mean)
    return out.reshape(samples, sector.size, 3)


_series = lru_cache(maxsize=_SERIES)(_summed_series)
_whole_series = lru_cache(maxsize=_WHOLE_SERIES)(_summed_series)
