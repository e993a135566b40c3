"""Moored bodies without an oracle: what must not change when the same is said in another way.

Turned, mirrored, with lines in another order, with every force scaled, with a segment cut in two:
the watch circle with all lines and with any one out stays what it is; more load takes it farther.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from catopt.model import Line, Segment
from catopt.model.system import Leg, System
from catopt.mooring.restoring import watch_circle

pytestmark = pytest.mark.slow

SEEDS = range(12)
DIRECTIONS = 6


def drawn(seed: int) -> System:
    """Three to six lines of one or two segments, of one kind each, in uneven directions."""
    rng = np.random.default_rng([11, seed])
    count = int(rng.integers(3, 7))
    height = float(rng.uniform(15.0, 80.0))
    azimuths = np.cumsum(rng.uniform(0.7, 1.3, count))
    azimuths *= math.tau / azimuths[-1]
    legs = []
    for azimuth in azimuths:
        length = height * float(rng.uniform(3.0, 8.0))
        parts = [length] if rng.random() < 0.5 else [0.4 * length, 0.6 * length]
        weight = 10.0 ** float(rng.uniform(2.5, 3.3))
        line = Line([Segment(part, weight * (1.0 + 0.5 * k), EA=1e5 * weight)
                     for k, part in enumerate(parts)])  # fmt: skip
        radius = math.sqrt(length**2 - height**2) * float(rng.uniform(0.9, 0.985))
        legs.append(Leg(line, float(azimuth), radius, height))
    weight = float(np.mean([leg.line.submerged_weight for leg in legs]))
    force = weight * float(rng.uniform(0.1, 0.6))
    return System(tuple(legs), (force, 0.0), seabed_friction=float(rng.choice([0.0, 0.5])))


def turned(system: System, angle: float, mirror: float = 1.0) -> System:
    """Turn a system about its origin, after it was mirrored at the x axis (mirror -1)."""
    c, s = math.cos(angle), math.sin(angle)
    legs = tuple(
        replace(leg, azimuth=angle + mirror * leg.azimuth, fairlead_azimuth=math.nan)
        for leg in system.legs
    )
    x, y = system.force
    return replace(system, legs=legs, force=(c * x - s * mirror * y, s * x + c * mirror * y))


def circles(system: System) -> np.ndarray:
    """Offsets by force in six directions (rows) with all lines and with each out (columns), m."""
    force = math.hypot(*system.force)
    every = [system, *(system.without([k]) for k in range(len(system.legs)))]
    found = [watch_circle(each, force=force, directions=DIRECTIONS).responses for each in every]
    return np.array([[each.offset for each in responses] for responses in found]).T


@pytest.mark.parametrize("seed", SEEDS)
def test_what_is_said_in_another_way_is_the_same(seed: int) -> None:
    system = drawn(seed)
    due = circles(system)
    digits = 1e-7 * max(leg.line.length for leg in system.legs)

    def same(found: np.ndarray, expected: np.ndarray = due) -> None:
        assert found == pytest.approx(expected, abs=digits)

    same(circles(turned(system, math.tau / DIRECTIONS)), np.roll(due, 1, axis=0))
    same(circles(turned(system, 0.0, -1.0)), np.roll(due[::-1], 1, axis=0))
    order = list(np.random.default_rng(seed).permutation(len(system.legs)))
    permuted = replace(system, legs=tuple(system.legs[k] for k in order))
    same(circles(permuted), due[:, [0, *(1 + k for k in order)]])

    def with_segments(change: Callable[[Segment], list[Segment]]) -> tuple[Leg, ...]:
        return tuple(
            replace(leg, line=Line([new for part in leg.line.segments for new in change(part)]))
            for leg in system.legs
        )

    heavier = with_segments(
        lambda part: [replace(part, submerged_weight=7.0 * part.submerged_weight, EA=7.0 * part.EA)]
    )
    same(circles(replace(system, legs=heavier, force=(7.0 * system.force[0], 0.0))))
    cut = with_segments(
        lambda part: [replace(part, length=share * part.length) for share in (0.3, 0.7)]
    )
    same(circles(replace(system, legs=cut)))


@pytest.mark.parametrize("seed", SEEDS)
def test_more_load_takes_it_farther_along_the_load(seed: int) -> None:
    """The energy of the lines is convex: x rises with the force along x, with any line out."""
    system = drawn(seed)
    for each in (system, *(system.without([k]) for k in range(len(system.legs)))):
        x = [
            watch_circle(each, force=part * system.force[0], directions=3).responses[0].x
            for part in (0.25, 0.5, 1.0)
        ]
        assert x[0] < x[1] < x[2]
