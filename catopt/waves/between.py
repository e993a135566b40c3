"""The water within a step in time, from that at the step's two ends."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from catopt.arrays import Array
from catopt.compiled import packed
from catopt.waves.kinematics import Flow, fill_kinematics


@packed
class WaterEnds(NamedTuple):
    """The water about some points at the start (0) and the end (1) of a whole step."""

    velocity: Array  # (2, points, 3): m/s
    acceleration: Array  # (2, points, 3): m/s2
    surface: Array  # (2, points): height up to which there is water, m
    points: Array  # (points, 3): where they are expected at its end, m
    is_known: Array  # (1,): 1.0 once the water at its end is


def water_ends(points: int) -> WaterEnds:
    """Room for so many points."""
    return WaterEnds(
        velocity=np.zeros((2, points, 3)),
        acceleration=np.zeros((2, points, 3)),
        surface=np.zeros((2, points)),
        points=np.zeros((points, 3)),
        is_known=np.zeros(1),
    )


def keep_start(velocity: Any, acceleration: Any, surface: Any, ends: WaterEnds) -> None:
    """Begin a whole step with the water at hand."""
    for n in range(surface.shape[0]):
        ends.surface[0, n] = surface[n]
        for i in range(3):
            ends.velocity[0, n, i] = velocity[n, i]
            ends.acceleration[0, n, i] = acceleration[n, i]
    ends.is_known[0] = 0.0


def look_ahead(t: float, flow: Flow, ends: WaterEnds) -> None:
    """Find the water at the whole step's end t, s, at `ends.points`."""
    fill_kinematics(t, ends.points, flow, ends.velocity[1], ends.acceleration[1], ends.surface[1])
    ends.is_known[0] = 1.0


def fill_between(
    part: float, ends: WaterEnds, velocity: Any, acceleration: Any, surface: Any
) -> None:
    """Write the water after a part of the whole step, straight between its ends.

    Of a wave's motion it is off by (omega step)^2/8 at most, omega being its angular frequency.
    """
    before = 1.0 - part
    for n in range(surface.shape[0]):
        surface[n] = before * ends.surface[0, n] + part * ends.surface[1, n]
        for i in range(3):
            velocity[n, i] = before * ends.velocity[0, n, i] + part * ends.velocity[1, n, i]
            acceleration[n, i] = (
                before * ends.acceleration[0, n, i] + part * ends.acceleration[1, n, i]
            )
