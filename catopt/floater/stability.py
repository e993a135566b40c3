"""Whether a ship on her lines stays where the mean weather would have her, or swings from it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.errors import NoEquilibriumError
from catopt.floater.line_tables import no_tables
from catopt.floater.slow_ship import SlowShip, rates
from catopt.mooring.net import Net, room_for
from catopt.mooring.under_loads import as_arrays

_STEPS: Final = (0.05, 0.05, 1e-3, 1e-3, 1e-3, 1e-5)
"""Of place, yaw and speeds, from which slopes are taken: m, rad, m/s and rad/s."""


@dataclass(frozen=True)
class SwingMode:
    """A motion of the linearised ship that grows or dies away as exp(rate t)."""

    rate: float  # 1/s: above 0 it grows
    period: float | None  # s; None: without swinging


def period_of(series: Array, step: float) -> float | None:
    """Take the mean time between rises through the mean, s; None of fewer than two."""
    off = series - series.mean()
    rises = np.flatnonzero((off[:-1] < 0.0) & (off[1:] >= 0.0))
    return float(rises[-1] - rises[0]) * step / (rises.size - 1) if rises.size > 1 else None


def linearised(ship: SlowShip, net: Net, rest: tuple[float, float, float]) -> Array:
    """Take slopes of the rates of the state where the ship rests, (6, 6), by differences.

    NoEquilibriumError where a line does not reach so near.
    """
    net, known, tables = map(as_arrays, (net, room_for(net), no_tables()))
    matrix = np.empty((6, 6))
    for k, step in enumerate(_STEPS):
        both = []
        for side in (step, -step):
            state, out = np.zeros(6), np.empty(6)
            state[:3] = rest
            state[k] += side
            if rates(0.0, state, ship, net, tables, known, out) >= 0:
                raise NoEquilibriumError("", "length", math.nan)
            both.append(out)
        matrix[:, k] = (both[0] - both[1]) / (2.0 * step)
    return matrix


def swing_mode(matrix: Array) -> SwingMode:
    """Pick the motion that grows the most, or dies away the slowest, of those that swing at all."""
    values = np.linalg.eigvals(matrix)
    most = max(values.tolist(), key=lambda each: (each.real, each.imag))
    turn = abs(most.imag)
    return SwingMode(most.real, 2.0 * math.pi / turn if turn > 1e-9 else None)
