"""Wind, current and sea that push, from where they come, and drag."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np

from catopt.arrays import Array
from catopt.constants import STANDARD_GRAVITY
from catopt.loads.component import Axis, LoadComponent, LoadSource, Number
from catopt.loads.ship import Ship
from catopt.model.kinds import Angle, Findings, exceeds
from catopt.words import Message

_N: Final = 0.468
_HEIGHT: Final = 10.0


def npd_spectrum(frequency: Array, speed: float, height: float = _HEIGHT) -> Array:
    """Spectral density of the wind's speed along its direction, m2/s (B).

    S = 320 (U/10)^2 (z/10)^0.45 / (1 + F^n)^(5/(3 n)), F = 172 f (z/10)^(2/3) (U/10)^-0.75, n =
    0.468: f in Hz, U the mean of one hour at 10 m, m/s, z the height, m. Read in two programs that
    have it.
    """
    found = Findings("npd_spectrum")
    found.number("speed", speed, "m/s", above=0.0)
    found.number("height", height, "m", above=0.0)
    found.raise_if_any()
    over, up = speed / 10.0, height / _HEIGHT
    F = 172.0 * frequency * up ** (2.0 / 3.0) * over**-0.75
    return np.asarray(320.0 * over**2 * up**0.45 / (1.0 + F**_N) ** (5.0 / (3.0 * _N)))


def gust_series(speed: float, samples: int, step: float, generator: np.random.Generator) -> Array:
    """Draw the wind's speed beside its mean at 10 m, m/s: so many samples, a step (s) apart.

    The sum of waves of the spectrum's energy at all frequencies that fit into the series, each with
    a random phase.
    """
    frequency = np.arange(1, samples // 2 + 1) / (samples * step)
    size = np.sqrt(2.0 * npd_spectrum(frequency, speed) / (samples * step))
    phase = generator.uniform(0.0, 2.0 * math.pi, frequency.size)
    parts = np.zeros(samples // 2 + 1, dtype=complex)
    parts[1:] = 0.5 * samples * size * np.exp(1j * phase)
    return np.fft.irfft(parts, samples)


ALONG: Final = 1e-9
"""Of an angle, rad, or of its sine: below it a stream is along the axis of the ship."""


@dataclass(frozen=True)
class Headings:
    """Angles from the bow to where wind, current and waves come from, rad: 0 from ahead.

    From -pi to pi; positive to one side, negative to the other.
    """

    wind: Angle = 0.0
    """That the wind comes from; of a ship that does not weathervane, off the bow."""
    current: Angle = 0.0
    """Of the current."""
    waves: Angle = 0.0
    """Of the waves."""

    def __post_init__(self) -> None:
        found = Findings("Headings")
        for key in ("wind", "current", "waves"):
            found.number(key, getattr(self, key), "rad", at_least=-math.pi, at_most=math.pi)
        found.raise_if_any()

    def seen_at(self, heading: float) -> Headings:
        """Turn directions that are counted from any one line into angles from a bow.

        The heading of the bow counts from the same line, rad.

        Examples
        --------
        >>> Headings(wind=0.0, current=0.5).seen_at(0.2).current
        0.3
        """
        every = (self.wind, self.current, self.waves)
        return Headings(*(math.remainder(each - heading, 2.0 * math.pi) for each in every))

    @property
    def head_on(self) -> bool:
        """Whether everything comes from ahead."""
        return max(abs(self.wind), abs(self.current), abs(self.waves)) < ALONG


HEAD_ON: Final = Headings()
"""The collinear case of a weathervaning ship."""


def drag(density: float, speed: float, area: float, coefficient: float) -> float:
    """Drag 1/2 rho C A V^2, N, of kg/m3, m/s and m2, which the coefficient is referred to."""
    return 0.5 * density * speed * speed * coefficient * area


def drag_component(
    name: str,
    kind: Literal["wind", "current"],
    stream: tuple[float, float],
    area: Number,
    coefficient: Number,
    source: LoadSource,
    *,
    axis: Axis = "along",
    sign: float = 1.0,
    note: str = "",
) -> LoadComponent:
    """Make the component of a drag.

    The stream is its density, kg/m3, and its speed, m/s; the coefficient is referred to the area,
    m2; the sign is that of the force along its axis. The rest is as of `LoadComponent`.
    """
    density, speed = stream
    force = sign * drag(density, speed, area.value, coefficient.value)
    medium = "loads.air_density" if kind == "wind" else "loads.water_density"
    numbers = (
        Number("rho", density, "kg/m3", Message(medium)),
        Number("V", speed, "m/s", Message("loads.speed")),
        area,
        coefficient,
    )
    factors = ("1/2", "{rho}", "{V:2}", f"{{{area.symbol}}}", f"{{{coefficient.symbol}}}")
    return LoadComponent(name, kind, axis, factors, numbers, force, source, note)


Referred = tuple[str, str, float, LoadSource]
"""Symbols of an area and of its coefficient, the coefficient itself and where it comes from."""


def wind_on_ship(
    ship: Ship, wind: Wind, air_density: float, along: Referred, across: Referred, note: str
) -> tuple[LoadComponent, LoadComponent]:
    """Make the wind along a ship, on its frontal area, and across it, on the lateral one."""

    def component(name: str, axis: Axis, area: float, meaning: str, of: Referred) -> LoadComponent:
        symbol, letter, coefficient, source = of
        return drag_component(
            Message(name),
            "wind",
            (air_density, wind.speed),
            Number(symbol, area, "m2", Message(meaning)),
            Number(letter, coefficient, "", Message("loads.coefficient_here")),
            source,
            axis=axis,
            note=note,
        )

    frontal, lateral = ship.frontal_area, ship.lateral_area
    return (
        component("loads.wind_along", "surge", frontal, "loads.frontal_area", along),
        component("loads.wind_across", "sway", lateral, "loads.lateral_area", across),
    )


HMAX_OVER_HS: Final = 1.85
"""Largest wave over significant wave height, as IALA's CALMAR has it."""

_STRONGEST_WIND: Final = 100.0
_FASTEST_CURRENT: Final = 10.0
_DEEPEST: Final = 12_000.0
_HIGHEST_WAVE: Final = 40.0
_LONGEST_PERIOD: Final = 30.0
_STEEPEST: Final = 0.14
_DEPTH_LIMIT: Final = 0.78
_DEEP_WATER_LENGTH: Final = 1.56


@dataclass(frozen=True)
class Wind:
    """Wind at a height above the water, m."""

    speed: float
    """m/s, of the averaging time that the formula wants: 30 s for a ship after UFC 4-159-03."""
    height: float = 10.0

    def __post_init__(self) -> None:
        found = Findings("Wind")
        found.number("speed", self.speed, "m/s", at_least=0.0)
        found.number("height", self.height, "m", above=0.0)
        if not found.problems and exceeds(self.speed, _STRONGEST_WIND):
            strong = Message("refused_sizing.above_m_s_more_than", strongest_wind=_STRONGEST_WIND)
            found.add("speed", f"{self.speed:g} m/s", strong)
        found.raise_if_any()

    def at(self, height: float, exponent: float = 0.12) -> float:
        """Speed at another height, m, by a power law (exponent 0.12 in DTOcean, C); m/s."""
        found = Findings("Wind.at")
        found.number("height", height, "m", above=0.0)
        found.number("exponent", exponent, "", at_least=0.0, at_most=0.5)
        found.raise_if_any()
        return float(self.speed * (height / self.height) ** exponent)


@dataclass(frozen=True)
class SurfaceCurrent:
    """Tidal current at the surface, m/s, without what the wind and the waves add."""

    speed: float

    def __post_init__(self) -> None:
        found = Findings("SurfaceCurrent")
        found.number("speed", self.speed, "m/s", at_least=0.0)
        if not found.problems and exceeds(self.speed, _FASTEST_CURRENT):
            key = "refused_sizing.above_m_s_faster_than"
            fast = Message(key, fastest_current=_FASTEST_CURRENT)
            found.add("speed", f"{self.speed:g} m/s", fast)
        found.raise_if_any()


@dataclass(frozen=True)
class SeaState:
    """Waves by height and period."""

    period: float
    """Of the waves that count, s: the peak period, or that of the largest wave."""
    significant_height: float | None = None
    """Hs, m; None: `maximum_height` / 1.85."""
    maximum_height: float | None = None
    """Hmax from trough to crest, m; None: 1.85 Hs (IALA CALMAR, A)."""

    def __post_init__(self) -> None:
        found = Findings("SeaState")
        found.number("period", self.period, "s", above=0.0, at_most=_LONGEST_PERIOD)
        heights = ("significant_height", "maximum_height")
        found.numbers(self, "m", *heights, at_least=0.0, at_most=_HIGHEST_WAVE)
        hs, hmax = self.significant_height, self.maximum_height
        if hs is None and hmax is None:
            missing = Message("refused_sizing.missing_or_maximum_height_wanted")
            found.add("significant_height", "", missing)
        found.raise_if_any()
        if hs is not None and hmax is not None and exceeds(hs, hmax):
            low = Message("refused_sizing.below_significant_height_m", hs=hs)
            found.add("maximum_height", f"{hmax:g} m", low)
        found.raise_if_any()

    @property
    def hs(self) -> float:
        """Significant height, m."""
        if self.significant_height is not None:
            return self.significant_height
        assert self.maximum_height is not None
        return self.maximum_height / HMAX_OVER_HS

    @property
    def hmax(self) -> float:
        """Height of the largest wave, m, before any limit by breaking."""
        if self.maximum_height is not None:
            return self.maximum_height
        assert self.significant_height is not None
        return self.significant_height * HMAX_OVER_HS

    def breaking_height(self, depth: float) -> float:
        """Height above which a wave of this period breaks, m (IALA CALMAR, A).

        The lower of 0.14 x 1.56 T^2 (steepness) and 0.78 of the water depth, m. CALMAR takes the
        second only for waves that keep the first; both limit a wave, and so they do here.
        """
        return min(self._steepest, _DEPTH_LIMIT * depth)

    @property
    def _steepest(self) -> float:
        return _STEEPEST * _DEEP_WATER_LENGTH * self.period * self.period

    def breaking_at(self, levels: WaterLevels) -> float:
        """Height at which the largest wave breaks by CALMAR 6.3.1, m (A).

        Its depth reaches from the bed to the crest at high water: H = 0.78 (high + H/2), unless the
        steepness is the lower limit.
        """
        shallow = _DEPTH_LIMIT * levels.high / (1.0 - 0.5 * _DEPTH_LIMIT)
        return min(self._steepest, shallow)

    def breaks(self, levels: WaterLevels) -> bool:
        """Whether the largest wave reaches the height at which it breaks by CALMAR 6.3.1."""
        return self.hmax >= self.breaking_at(levels)

    def height_in(self, depth: float) -> float:
        """Height of the largest wave that does not break in water of a depth, m."""
        return min(self.hmax, self.breaking_height(depth))

    def wave_number(self, depth: float) -> float:
        """Wave number in water of a depth, rad/m."""
        from catopt.waves.random_surface import wave_number

        return wave_number(2.0 * math.pi / self.period, depth)

    @property
    def deep_water_velocity(self) -> float:
        """Velocity that CALMAR takes a sea for, pi Hs/T, m/s: deep water, amplitude Hs/2.

        CALMAR 5.1.5 names Hs, the period and Morison's equation; the form is that of its manuals'
        printed results.
        """
        return math.pi * self.hs / self.period

    def surface_velocity(self, depth: float) -> float:
        """Largest horizontal velocity at the still water level of water of a depth (m), m/s.

        Of a linear wave of the height `height_in`: u = (pi H/T) / tanh(k d).
        """
        height = self.height_in(depth)
        omega = 2.0 * math.pi / self.period
        # omega^2 = g k tanh(k d), so that 1/tanh(k d) is g k/omega^2.
        over_tanh = STANDARD_GRAVITY * self.wave_number(depth) / (omega * omega)
        return 0.5 * omega * height * over_tanh


@dataclass(frozen=True)
class WaterLevels:
    """Depth of the still water at low and at high water, m."""

    low: float
    high: float

    def __post_init__(self) -> None:
        found = Findings("WaterLevels")
        for key in ("low", "high"):
            found.number(key, getattr(self, key), "m", above=0.0, at_most=_DEEPEST)
        if not found.problems and exceeds(self.low, self.high):
            below = Message("refused_sizing.below_low_water_m", low=self.low)
            found.add("high", f"{self.high:g} m", below)
        found.raise_if_any()

    @classmethod
    def steady(cls, depth: float) -> WaterLevels:
        """Water without a tide, m."""
        return cls(depth, depth)

    def deepest(self, sea: SeaState) -> float:
        """Depth under the largest crest at high water: high + Hmax/2, m (IALA CALMAR, A).

        A wave that would break is as high as it can be, `SeaState.breaking_at`.
        """
        return self.high + 0.5 * min(sea.hmax, sea.breaking_at(self))
