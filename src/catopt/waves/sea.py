"""A sea: depth, waves and current, and how far up and down the waves are taken to act."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple, get_args

import numpy as np
import numpy.typing as npt

from catopt.compiled import compiled
from catopt.model.validity import Findings
from catopt.waves.components import Waves
from catopt.waves.current import (
    Current,
    PowerLawCurrent,
    TableCurrent,
    WindCurrent,
    power_rows,
    table_rows,
)
from catopt.waves.dispersion import fill_wave_numbers
from catopt.waves.kinematics import (
    NEGLIGIBLE,
    Flow,
    fill_elevation,
    fill_kinematics,
)

__all__ = ["Kinematics", "Reach", "Sea", "Stretching"]

Array = npt.NDArray[np.float64]

Stretching = Literal["none", "wheeler"]
"""``"none"``: the formulas up to still water, and no water above it, under a crest or not.
``"wheeler"``: water up to the moving surface, the profile stretched to reach from the bed to it."""

Reach = Literal["bed", "half-wavelength"]
"""How far down waves act: ``"bed"``, all the way as the formulas say, or ``"half-wavelength"``, as
S4 has it: nothing of a wave further below still water than half its own length."""


class Kinematics(NamedTuple):
    """The water's motion at points.

    Attributes
    ----------
    velocity, acceleration : ndarray, shape (n, 3)
        m/s and m/s², along x, y and up.
    surface : ndarray, shape (n,)
        Height above the bed up to which there is water over each point, m.
    """

    velocity: Array
    acceleration: Array
    surface: Array


@dataclass(frozen=True, eq=False)
class Sea:
    """Waves and current in water of one depth.

    Attributes
    ----------
    depth : float
        From still water to the bed, m.
    waves : Waves, optional
        None for still water.
    current : sequence of current profiles
        Their sum flows.
    stretching : {"none", "wheeler"}
        What holds between still water and the moving surface.
    reach : {"bed", "half-wavelength"}
        How far down waves act.
    ramp_time : float
        s over which the waves grow smoothly from nothing at t = 0; the current does not. 0 for
        waves at once.
    """

    depth: float
    waves: Waves | None = None
    current: Sequence[Current] = ()
    stretching: Stretching = "none"
    reach: Reach = "bed"
    ramp_time: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("Sea")
        found.number("depth", self.depth, "m", above=0.0)
        found.number("ramp_time", self.ramp_time, "s", at_least=0.0)
        if self.waves is not None and not isinstance(self.waves, Waves):
            found.add("waves", repr(self.waves), "a Waves value or None is wanted")
        if isinstance(self.current, (PowerLawCurrent, WindCurrent, TableCurrent)):
            object.__setattr__(self, "current", (self.current,))
        object.__setattr__(self, "current", tuple(self.current))
        for key, allowed in (("stretching", Stretching), ("reach", Reach)):
            if getattr(self, key) not in get_args(allowed):
                wanted = f"must be one of {', '.join(get_args(allowed))}"
                found.add(key, repr(getattr(self, key)), wanted)
        found.raise_if_any()

    @cached_property
    def wave_numbers(self) -> Array:
        """Wave number of each wave, rad/m."""
        omega = np.empty(0) if self.waves is None else self.waves.omega
        k = np.empty(omega.size)
        compiled(fill_wave_numbers)(omega, float(self.depth), k)
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
        )

    def kinematics(self, t: float, points: npt.ArrayLike) -> Kinematics:
        """Velocity and acceleration of the water at points.

        Parameters
        ----------
        t : float
            s.
        points : array_like, shape (n, 3)
            x, y, and height z above the bed, m.
        """
        at = np.ascontiguousarray(points, dtype=float)
        result = Kinematics(np.empty(at.shape), np.empty(at.shape), np.empty(at.shape[0]))
        compiled(fill_kinematics)(float(t), at, self.flow, *result)
        return result

    def elevation(self, t: npt.ArrayLike, x: npt.ArrayLike = 0.0, y: npt.ArrayLike = 0.0) -> Array:
        """Height of the surface above still water, m; times and places broadcast."""
        at = np.broadcast_arrays(*(np.asarray(value, dtype=float) for value in (t, x, y)))
        eta = np.empty(at[0].size)
        compiled(fill_elevation)(*(np.ascontiguousarray(a).ravel() for a in at), self.flow, eta)
        return eta.reshape(at[0].shape)
