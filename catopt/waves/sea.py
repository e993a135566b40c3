"""A sea: depth, waves and current, and where Airy's theory no longer describes it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType
from typing import Final, Literal, NamedTuple, TypeAlias, get_args

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array
from catopt.compiled import compiled
from catopt.model.array_inputs import array_in_si
from catopt.model.kinds import Findings
from catopt.waves.components import Waves
from catopt.waves.kinematics import NEGLIGIBLE, Flow, fill_elevation, fill_kinematics
from catopt.waves.random_surface import fill_wave_numbers, wave_number
from catopt.words import Message

WindRule = Literal["S4", "CALMAR"]

WIND_SHARE = MappingProxyType({"S4": 0.01, "CALMAR": 0.015})
"""Surface current over wind speed where nothing was measured: 1 % of the hourly mean at 10 m (S4);
1.5 % (IALA's CALMAR)."""


def wind_driven_speed(wind_speed: float, rule: WindRule = "S4") -> float:
    """Speed of the wind-driven current at the surface, m/s, where it was not measured.

    Parameters
    ----------
    wind_speed : float
        Hourly mean at 10 m, m/s; InputError below 0.
    rule : {"S4", "CALMAR"}
        1 % or 1.5 % of it.
    """
    found = Findings("wind_driven_speed")
    found.number("wind_speed", wind_speed, "m/s", at_least=0.0)
    if rule not in get_args(WindRule):
        wanted = Message("refused.one_of", words=", ".join(get_args(WindRule)))
        found.add("rule", repr(rule), wanted)
    found.raise_if_any()
    return WIND_SHARE[rule] * wind_speed


@dataclass(frozen=True)
class PowerLawCurrent:
    """Tidal current V0 (z/d)^n at the height z above the bed in water of the depth d, S4 [2.77]."""

    surface_speed: float  # V0, m/s, 0 or more
    direction: float = 0.0  # where it flows to, rad from the x axis
    exponent: float = 1.0 / 7.0  # n, above 0; 1/7 in S4

    def __post_init__(self) -> None:
        found = _check_flow("PowerLawCurrent", self.surface_speed, self.direction)
        found.number("exponent", self.exponent, "", above=0.0)
        found.raise_if_any()


@dataclass(frozen=True)
class WindCurrent:
    """Wind-driven current, which falls linearly from V0 at still water to 0 at d0 below it, [2.78].

    d0 may exceed the water's depth.
    """

    surface_speed: float  # V0, m/s, 0 or more (`wind_driven_speed`)
    depth: float  # d0, m, above 0
    direction: float = 0.0  # where it flows to, rad from the x axis

    def __post_init__(self) -> None:
        found = _check_flow("WindCurrent", self.surface_speed, self.direction)
        found.number("depth", self.depth, "m", above=0.0)
        found.raise_if_any()


@dataclass(frozen=True)
class TableCurrent:
    """Current by depth, linear between the rows and constant beyond the first and the last."""

    depths: Sequence[float]  # below still water, m, from 0 up, each greater than the one before
    speeds: Sequence[float]  # m/s; negative where the water flows against `direction`
    direction: float = 0.0  # where it flows to, rad from the x axis
    directions: Sequence[float] = ()  # one for each of the depths, in place of `direction`, where
    # the current turns with depth; between the rows the speeds along x and y are linear

    def __post_init__(self) -> None:
        for key in ("depths", "speeds", "directions"):
            object.__setattr__(self, key, tuple(getattr(self, key)))
        found = Findings("TableCurrent")
        found.number("direction", self.direction, "rad")
        if not self.depths or len(self.depths) != len(self.speeds):
            found.add("speeds", self._sizes("speeds"), Message("refused.speeds_and_depths"))
        for i, (depth, speed) in enumerate(zip(self.depths, self.speeds, strict=False)):
            found.number(f"depths[{i}]", depth, "m", at_least=0.0)
            found.number(f"speeds[{i}]", speed, "m/s")
        if self.directions and len(self.directions) != len(self.depths):
            wanted = Message("refused_motion.many_directions_depths_are_wanted")
            found.add("directions", self._sizes("directions"), wanted)
        for i, direction in enumerate(self.directions):
            found.number(f"directions[{i}]", direction, "rad")
        found.raise_if_any()
        for i in range(1, len(self.depths)):
            if self.depths[i] <= self.depths[i - 1]:
                above = Message("refused_motion.must_be_below_row_before", value=self.depths[i - 1])
                found.add(f"depths[{i}]", repr(self.depths[i]), above)
        found.raise_if_any()

    def _sizes(self, key: str) -> Message:
        count = len(getattr(self, key))
        return Message("refused_case.depths_beside", depths=len(self.depths), count=count, key=key)


@dataclass(frozen=True, eq=False)
class CurrentSeries:
    """Current at the surface over time, by which the profiles of a sea are scaled and turned.

    Between its times the speeds along x and y are linear, so that the water accelerates evenly;
    before the first and after the last they are held.
    """

    times: npt.ArrayLike  # (n,): s, rising, 0 being the start of the run
    speeds: npt.ArrayLike  # (n,): at the surface, m/s
    directions: npt.ArrayLike | None = None  # (n,): where it flows to at the surface, rad from the
    # x axis; None: as the profiles do

    def __post_init__(self) -> None:
        found = Findings("CurrentSeries")
        for key, unit in (("times", "s"), ("speeds", "m/s"), ("directions", "rad")):
            if getattr(self, key) is not None:
                read = array_in_si(found, key, getattr(self, key), unit)
                object.__setattr__(self, key, read)
        found.raise_if_any()
        t = np.asarray(self.times, dtype=float)
        for key in ("times", "speeds", "directions"):
            if getattr(self, key) is None:
                continue
            values = np.asarray(getattr(self, key), dtype=float)
            if values.ndim != 1 or values.shape != t.shape or t.size == 0:
                shape = Message("refused_motion.shape", shape=values.shape)
                found.add(key, shape, Message("refused_motion.one_number_a_time"))
            elif not np.isfinite(values).all():
                wanted = Message("refused_motion.finite_numbers_are_wanted")
                found.add(key, Message("refused_motion.nan"), wanted)
        if not found.problems and not (np.diff(t) > 0.0).all():
            at = int(np.argmax(np.diff(t) <= 0.0))
            said = Message("refused_motion.after", one=t[at + 1], other=t[at])
            found.add("times", said, Message("refused_motion.must_rise"))
        found.raise_if_any()

    def rows(self, surface: complex) -> Array:
        """Rows of time, s, and the factor on the profiles, as a complex number in two parts.

        `surface`: what the profiles flow with there, along x and y, m/s; not 0.
        """
        speeds = np.asarray(self.speeds, dtype=float)
        if self.directions is None:
            factor = speeds / abs(surface) + 0j
        else:
            factor = speeds * np.exp(1j * np.asarray(self.directions, dtype=float)) / surface
        return np.column_stack([np.asarray(self.times, dtype=float), factor.real, factor.imag])


Current: TypeAlias = PowerLawCurrent | WindCurrent | TableCurrent


def power_rows(profiles: Sequence[Current]) -> Array:
    """Rows of V0 along x and y (m/s) and exponent, one for each power law."""
    rows = [
        (*_along(profile.direction, profile.surface_speed), profile.exponent)
        for profile in profiles
        if isinstance(profile, PowerLawCurrent)
    ]
    return np.array(rows, dtype=float).reshape(-1, 3)


def table_rows(profiles: Sequence[Current], water_depth: float) -> Array:
    """Rows of height above the bed (m), speed along x and y (m/s), from the bed up.

    All profiles of straight pieces make one such table: their sum is straight between all their
    breaks.
    """
    straight = [_table(p, water_depth) for p in profiles if not isinstance(p, PowerLawCurrent)]
    heights = {0.0, water_depth}.union(*(table[0] for table in straight))
    z = np.array(sorted(h for h in heights if 0.0 <= h <= water_depth))
    rows = np.zeros((z.size, 3))
    rows[:, 0] = z
    for height, *velocity in straight:
        for j, part in enumerate(velocity, start=1):
            rows[:, j] += np.interp(z, height, part)
    return rows


def _table(
    profile: WindCurrent | TableCurrent, water_depth: float
) -> tuple[list[float], list[float], list[float]]:
    """Heights above the bed, rising, with the speeds along x and y."""
    if isinstance(profile, WindCurrent):
        depths: Sequence[float] = (0.0, profile.depth)
        speeds: Sequence[float] = (profile.surface_speed, 0.0)
        directions: Sequence[float] = ()
    else:
        depths, speeds, directions = profile.depths, profile.speeds, profile.directions
    turned = directions or (profile.direction,) * len(depths)
    velocity = [_along(b, speed) for b, speed in zip(turned, speeds, strict=True)][::-1]
    heights = [water_depth - depth for depth in reversed(depths)]
    return heights, [x for x, _ in velocity], [y for _, y in velocity]


def _along(direction: float, speed: float) -> tuple[float, float]:
    return speed * math.cos(direction), speed * math.sin(direction)


def _check_flow(source: str, surface_speed: float, direction: float) -> Findings:
    found = Findings(source)
    found.number("surface_speed", surface_speed, "m/s", at_least=0.0)
    found.number("direction", direction, "rad")
    return found


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


Stretching = Literal["none", "wheeler"]
"""``"none"``: the formulas up to still water, and no water above it, under a crest or not.
``"wheeler"``: water up to the moving surface, the profile stretched to reach from the bed to it."""

Reach = Literal["bed", "half-wavelength"]
"""How far down waves act: ``"bed"``, all the way as the formulas say, or ``"half-wavelength"``, as
S4 has it: nothing of a wave further below still water than half its own length."""


class Kinematics(NamedTuple):
    """The water's motion at points."""

    velocity: Array  # (n, 3): along x, y and up, m/s
    acceleration: Array  # (n, 3): m/s²
    surface: Array  # (n,): height above the bed up to which there is water over each point, m


_A_WAVE = 1e-5
"""Time that a wave takes at one point as plain Python, s."""


@dataclass(frozen=True, eq=False)
class Sea:
    """Waves and current in water of one depth."""

    depth: float  # from still water to the bed, m
    waves: Waves | None = None  # None for still water
    current: Sequence[Current] = ()  # the sum of the profiles flows
    stretching: Stretching = "none"  # what holds between still water and the moving surface
    reach: Reach = "bed"  # how far down waves act
    ramp_time: float = 0.0  # s over which the waves grow smoothly from nothing at t = 0; the
    # current does not. 0 for waves at once
    current_series: CurrentSeries | None = None  # by which the current changes; steady without

    def __post_init__(self) -> None:
        found = Findings("Sea")
        found.number("depth", self.depth, "m", above=0.0)
        found.number("ramp_time", self.ramp_time, "s", at_least=0.0)
        if self.waves is not None and not isinstance(self.waves, Waves):
            found.add("waves", repr(self.waves), Message("refused_motion.waves_or_none"))
        if isinstance(self.current, (PowerLawCurrent, WindCurrent, TableCurrent)):
            object.__setattr__(self, "current", (self.current,))
        object.__setattr__(self, "current", tuple(self.current))
        for key, allowed in (("stretching", Stretching), ("reach", Reach)):
            if getattr(self, key) not in get_args(allowed):
                wanted = Message("refused.one_of", words=", ".join(get_args(allowed)))
                found.add(key, repr(getattr(self, key)), wanted)
        found.raise_if_any()
        if self.current_series is not None and self._surface_current == 0.0:
            wanted = Message("refused_motion.current_flows_at_surface_wanted")
            found.add("current_series", Message("refused_motion.without_a_current"), wanted)
        found.raise_if_any()

    @property
    def _surface_current(self) -> complex:
        """What the profiles flow with at still water, along x and y, m/s."""
        top = table_rows(self.current, float(self.depth))[-1]
        powers = power_rows(self.current).sum(axis=0)
        return complex(top[1] + powers[0], top[2] + powers[1])

    @cached_property
    def flow_at_rest(self) -> Flow:
        """The same before the run: without waves, in the current as it is at its start."""
        flow = replace(self, waves=None).flow
        t, *factor = flow.current_series.T
        start = [0.0, *(float(np.interp(0.0, t, part)) for part in factor)]
        return flow._replace(current_series=np.array([start]))

    @cached_property
    def wave_numbers(self) -> Array:
        """Wave number of each wave, rad/m."""
        omega = np.empty(0) if self.waves is None else self.waves.omega
        k = np.empty(omega.size)
        compiled(fill_wave_numbers, _A_WAVE * omega.size)(omega, float(self.depth), k)
        return k

    @cached_property
    def flow(self) -> Flow:
        """What the compiled kernels read."""
        k = self.wave_numbers
        waves, factors = np.zeros((k.size, 8)), np.zeros((k.size, 2))
        if self.waves is not None:
            w = self.waves
            cos, sin = np.cos(w.direction), np.sin(w.direction)
            columns = [w.omega, k * cos, k * sin, k, w.phase, cos, sin, w.amplitude]
            waves[:] = np.stack(columns, axis=1)
            mirror = np.exp(-2.0 * k * self.depth)
            speed = w.amplitude * w.omega / -np.expm1(-2.0 * k * self.depth)
            factors[:] = np.stack([mirror, speed], axis=1)
        return Flow(
            float(self.depth),
            self.stretching == "wheeler",
            NEGLIGIBLE if self.reach == "bed" else math.pi,
            float(self.ramp_time),
            waves,
            factors,
            power_rows(self.current),
            table_rows(self.current, float(self.depth)),
            np.array([[0.0, 1.0, 0.0]])
            if self.current_series is None
            else self.current_series.rows(self._surface_current),
        )

    def kinematics(self, t: float, points: npt.ArrayLike) -> Kinematics:
        """Motion of the water at t, s, and points (n, 3): x, y, and height z above the bed, m."""
        at = np.ascontiguousarray(points, dtype=float)
        result = Kinematics(np.empty(at.shape), np.empty(at.shape), np.empty(at.shape[0]))
        work = _A_WAVE * self.flow.waves.shape[0] * at.shape[0]
        compiled(fill_kinematics, work)(float(t), at, self.flow, *result)
        return result

    def elevation(self, t: npt.ArrayLike, x: npt.ArrayLike = 0.0, y: npt.ArrayLike = 0.0) -> Array:
        """Height of the surface above still water, m; times and places broadcast."""
        at = np.broadcast_arrays(*(np.asarray(value, dtype=float) for value in (t, x, y)))
        eta = np.empty(at[0].size)
        fill = compiled(fill_elevation, _A_WAVE * self.flow.waves.shape[0] * eta.size)
        fill(*(np.ascontiguousarray(a).ravel() for a in at), self.flow, eta)
        return eta.reshape(at[0].shape)
