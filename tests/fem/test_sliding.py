"""Blocks that slide on the bed, beside what a rigid block does by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.arrays import Array
from catopt.fem.march import SLIDING, slide

MASS, WEIGHT, FRICTION = 2000.0, 11e3, 0.5
HELD = FRICTION * WEIGHT


def slides(pulls: list[tuple[float, float, float]], h: float = 1e-3) -> Array:
    """Pull a block for so long, s, with a horizontal force and one upwards, N, one by one."""
    state, blocks = np.zeros((1, 1, SLIDING)), np.array([[MASS, WEIGHT, FRICTION, math.inf]])
    for time, along, up in pulls:
        ends = np.zeros((1, 2, 3))
        ends[0, 0] = 0.6 * along, -0.8 * along, up
        for _ in range(round(time / h)):
            slide(h, ends, ends, blocks, state)
    found: Array = state[0, 0]
    return found


def by_hand(time: float, along: float, up: float = 0.0) -> float:
    """0.5 a t^2 under the pull, then v^2/(2 a') until friction has stopped it."""
    faster = (along - FRICTION * max(WEIGHT - up, 0.0)) / MASS
    speed = faster * time
    return 0.5 * faster * time**2 + 0.5 * speed**2 / (HELD / MASS)


def test_it_does_not_move_up_to_its_friction() -> None:
    assert not slides([(5.0, HELD, 0.0), (5.0, 0.0, 0.0)]).any()


@pytest.mark.parametrize("up", [0.0, 5e3, 20e3])
def test_a_pulse_moves_it_as_far_as_by_hand(up: float) -> None:
    found = slides([(0.2, 40e3, up), (10.0, 0.0, 0.0)])
    way = by_hand(0.2, 40e3, up)
    assert found[2] == pytest.approx(way, rel=1e-9)
    assert found[3] == pytest.approx(way**2, rel=1e-9)
    assert found[[0, 1, 4]].tolist() == [0.0, 0.0, 1.0]


def test_on_clay_it_is_held_by_no_more_than_its_base() -> None:
    """40 kN for 0.2 s against 3 kN: 18.5 m/s2, then 3 kN stop 2 t from 3.7 m/s."""
    state, blocks = np.zeros((1, 1, SLIDING)), np.array([[MASS, WEIGHT, FRICTION, 3e3]])
    for along in 200 * [40e3] + 10_000 * [0.0]:
        ends = np.zeros((1, 2, 3))
        ends[0, 0, 0] = along
        slide(1e-3, ends, ends, blocks, state)
    way = 0.5 * 18.5 * 0.2**2 + 0.5 * 3.7**2 / 1.5
    assert state[0, 0, 2] == pytest.approx(way, rel=1e-9)


def test_slides_are_counted_one_by_one() -> None:
    found = slides([(0.1, 30e3, 0.0), (8.0, 1e3, 0.0), (0.2, 20e3, 0.0), (8.0, 0.0, 0.0)])
    ways = []
    for time, along, left in ((0.1, 30e3, 1e3), (0.2, 20e3, 0.0)):
        speed = (along - HELD) / MASS * time
        ways.append(0.5 * speed * time + 0.5 * speed**2 / ((HELD - left) / MASS))
    assert found[4] == 2.0
    assert found[2] == pytest.approx(sum(ways), rel=1e-9)
    assert found[3] == pytest.approx(sum(each**2 for each in ways), rel=1e-9)


def test_a_peak_that_passes_within_steps_needs_no_finer_ones() -> None:
    """Half a sine of 60 kN over 0.2 s in 20 and in 2,000 steps."""
    found = []
    for count in (20, 2000):
        state, blocks = np.zeros((1, 1, SLIDING)), np.array([[MASS, WEIGHT, FRICTION, math.inf]])
        h = 0.2 / count
        for k in range(20 * count):
            ends = np.zeros((2, 1, 2, 3))
            for j in (0, 1):
                if (k + j) * h <= 0.2:
                    ends[j, 0, 0, 0] = 60e3 * math.sin(math.pi * (k + j) / count)
            slide(h, ends[0], ends[1], blocks, state)
        found.append(float(state[0, 0, 2]))
    assert found[0] == pytest.approx(found[1], rel=0.02)
