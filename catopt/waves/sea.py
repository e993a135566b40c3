"""A sea: depth, waves and current, and where Airy's theory no longer describes it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Final, Literal, NamedTuple, get_args

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array
from catopt.compiled import compiled
from catopt.model.kinds import Findings
from catopt.waves.components import Waves
from catopt.waves.current import (
    Current,
    CurrentSeries,
    PowerLawCurrent,
    TableCurrent,
    WindCurrent,
    power_rows,
    table_rows,
)
from catopt.waves.kinematics import NEGLIGIBLE, Flow, fill_elevation, fill_kinematics
from catopt.waves.spectrum import fill_wave_numbers, wave_number
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
            waves[:] = np.stack(
                [w.omega, k * cos, k * sin, k, w.phase, cos, sin, w.amplitude], axis=1
            )
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
