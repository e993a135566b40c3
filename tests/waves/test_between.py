"""Within a whole step the water is taken straight between that at its two ends."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.waves import Sea, regular_wave
from catopt.waves.kinematics import fill_between, keep_start, look_ahead, water_ends

OMEGA, STEP, START = 1.3, 0.05, 4.0


def test_the_water_within_a_step_is_off_by_no_more_than_the_step_allows() -> None:
    """Of a function with the second derivative omega^2 a the chord is off by omega^2 a h^2/8."""
    sea = Sea(30.0, regular_wave(2.0, 2.0 * math.pi / OMEGA), stretching="none")
    points = np.array([[0.0, 0.0, 29.0], [7.0, 0.0, 20.0], [15.0, 0.0, 5.0]])
    ends, here, there = water_ends(3), sea.kinematics(START, points), np.zeros((2, 3, 3))
    keep_start(here.velocity, here.acceleration, np.full(3, 30.0), ends)
    ends.points[:] = points
    assert ends.is_known[0] == 0.0
    look_ahead(START + STEP, sea.flow, ends)
    surface = np.zeros(3)
    largest = np.zeros(2)
    for part in (0.25, 0.5, 0.75):
        fill_between(part, ends, there[0], there[1], surface)
        exact = sea.kinematics(START + part * STEP, points)
        largest = np.maximum(
            largest,
            [
                np.abs(there[0] - exact.velocity).max(),
                np.abs(there[1] - exact.acceleration).max(),
            ],
        )
    speed = np.abs(sea.kinematics(START, points).velocity).max()
    crest = OMEGA / math.tanh(sea.flow.waves[0, 3] * 30.0)  # of a wave of 1 m, m/s
    bound = (OMEGA * STEP) ** 2 / 8.0
    assert speed <= crest
    assert largest[0] <= bound * crest
    assert largest[1] <= bound * crest * OMEGA
    assert largest[0] > 0.02 * bound * crest  # and it is not the sea itself


@pytest.mark.parametrize("part", [0.0, 1.0])
def test_at_both_ends_it_is_the_water_there(part: float) -> None:
    ends, found = water_ends(2), np.zeros((2, 2, 3))
    random = np.random.default_rng(5)
    ends.velocity[:], ends.acceleration[:] = random.normal(size=(2, 2, 2, 3))
    ends.surface[:] = random.normal(size=(2, 2))
    surface = np.zeros(2)
    fill_between(part, ends, found[0], found[1], surface)
    end = int(part)
    assert (found[0] == ends.velocity[end]).all()
    assert (found[1] == ends.acceleration[end]).all()
    assert (surface == ends.surface[end]).all()
