"""The water at the nodes of a line that moves, taken once a step where the nodes are expected."""

from __future__ import annotations

from typing import Any

from catopt.compiled import inlined
from catopt.fem.moving import WaterAt
from catopt.waves.kinematics import Flow, fill_kinematics


def fill_water(
    t: float, x: Any, start: Any, flow: Flow, early: float, before: Any, water: WaterAt
) -> None:
    """Write the water's motion at a step's end t, s, where the nodes are expected, x, m.

    `start`: first bar of each line; `before` (nodes, 3): acceleration at the step's start, m/s2.
    """
    fill_kinematics(t, x, flow, water.velocity, water.latest, water.surface)
    for n in range(x.shape[0]):
        for i in range(3):
            water.acceleration[n, i] = (1.0 - early) * water.latest[n, i] + early * before[n, i]
    for k in range(start.shape[0] - 1):
        for e in range(start[k], start[k + 1]):
            a, b = e + k, e + k + 1
            below_a, below_b = water.surface[a] - x[a, 2], water.surface[b] - x[b, 2]
            middle = 0.5 * (below_a + below_b)
            water.wet[e, 0] = wet_part(below_a, middle)
            water.wet[e, 1] = wet_part(middle, below_b)


@inlined
def wet_part(one: float, other: float) -> float:
    """Part of a straight piece that is in the water, its ends being so far below the surface."""
    high, low = max(one, other), min(one, other)
    if low >= 0.0:
        return 1.0
    if high <= 0.0:
        return 0.0
    return high / (high - low)
