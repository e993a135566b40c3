"""The branchless exp, sin and cos against the library's."""

from __future__ import annotations

import math

import numpy as np

from catopt.waves.kinematics import cos_sin, exp_both_ways


def test_exp() -> None:
    """Thirteen operations on a sum near 1, each right to 1.1e-16, and the reduction's rounding."""
    x = np.concatenate([-np.geomspace(1e-12, 37.0, 3000), np.linspace(-40.0, 0.0, 3001)])
    both = [(v, exp_both_ways(float(v))) for v in x]
    worst = max(
        max(abs(up / math.exp(v) - 1.0), abs(down / math.exp(-v) - 1.0)) for v, (up, down) in both
    )
    assert worst < 1e-15
    assert exp_both_ways(0.0) == (1.0, 1.0)


def test_cos_and_sin() -> None:
    """Absolute error below 1e-15 for angles up to 10,000 turns, exact in the reduction."""
    angles = np.concatenate([np.linspace(-7.0, 7.0, 3001), np.linspace(-6e4, 6e4, 5001)])
    multiples = 0.25 * math.pi * np.arange(-40, 41)
    for angle in np.concatenate([angles, multiples]):
        cos, sin = cos_sin(float(angle))
        assert abs(cos - math.cos(angle)) < 1e-15, angle
        assert abs(sin - math.sin(angle)) < 1e-15, angle


def test_angles_of_a_long_storm_keep_the_accuracy_of_the_angle_itself() -> None:
    """At 1e7 rad neighbouring numbers are 2e-9 apart, and so may the results be."""
    for angle in (1e6 + 0.3, -3.3e6, 1e7):
        assert np.allclose(cos_sin(angle), (math.cos(angle), math.sin(angle)), rtol=0, atol=2e-9)
