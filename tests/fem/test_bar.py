"""The bar on its own: tangent, rigid motion, patch, and one weight between two bars."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.fem import solve_line
from catopt.fem.bar import bar_force, bar_stiffness
from catopt.model import Line, PointLoad, Segment

ROUNDING = 1e-12
"""Double precision over some hundred additions and the conditioning of a hundred bars."""


@pytest.mark.parametrize("seed", range(20))
def test_tangent_is_the_derivative_of_the_force(seed: int) -> None:
    """Central differences with step h err by h**2 and by rounding over h: 1e-10 at best."""
    rng = np.random.default_rng(seed)
    x1, x2 = rng.normal(size=3), rng.normal(size=3)
    l0, EA, h = float(rng.uniform(0.5, 3.0)), 100.0, 1e-5
    K = bar_stiffness(x1, x2, l0, EA)
    steps = np.eye(3) * h
    slopes = [
        (bar_force(x1, x2 + step, l0, EA) - bar_force(x1, x2 - step, l0, EA)) / (2 * h)
        for step in steps
    ]
    assert np.abs(np.array(slopes).T - K).max() < 1e-8 * EA / l0
    back = [
        (bar_force(x1 + step, x2, l0, EA) - bar_force(x1 - step, x2, l0, EA)) / (2 * h)
        for step in steps
    ]
    assert np.abs(np.array(back).T + K).max() < 1e-8 * EA / l0
    assert np.array_equal(K, K.T)


@pytest.mark.parametrize("seed", range(5))
def test_rigid_motion_gives_no_force(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rotation, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    x1, x2, shift = rng.normal(size=(3, 3))
    l0, EA = float(np.linalg.norm(x2 - x1)), 1e8
    moved = bar_force(rotation @ x1 + shift, rotation @ x2 + shift, l0, EA)
    assert np.abs(moved).max() < 1e-14 * EA


def test_a_bar_that_does_not_push() -> None:
    x1, x2 = np.zeros(3), np.array([0.9, 0.0, 0.0])
    assert bar_force(x1, x2, 1.0, 10.0) == pytest.approx([-1.0, 0.0, 0.0], rel=1e-14)
    assert np.array_equal(bar_force(x1, x2, 1.0, 10.0, compression=False), np.zeros(3))


def test_patch_of_unequal_bars_stretches_evenly() -> None:
    """A weightless line stretched between two points has T = EA (S - L)/L in every bar."""
    segments = [Segment(length, 0.0, EA=2e6) for length in (3.0, 10.0, 0.5, 20.0)]
    line = Line(segments)
    solution = solve_line(line, height=20.0, span=30.0, elements=[3, 7, 1, 2])
    stretched = math.hypot(30.0, 20.0)
    expected = 2e6 * (stretched - line.length) / line.length
    assert solution.tension == pytest.approx(np.full(13, expected), rel=ROUNDING * 100)
    part = (solution.arc / line.length)[:, np.newaxis]
    assert np.abs(solution.nodes - part * np.array([30.0, 0.0, 20.0])).max() < 1e-11


@pytest.mark.parametrize("EA", [math.inf, 1e5])
def test_one_weight_between_two_bars(EA: float) -> None:
    """A weight W on a weightless line: each side is straight, T sin(a) + T sin(b) = W.

    The two bars' elongation closes the triangle; solved here by hand for equal sides.
    """
    half, weight, span = 5.0, 1000.0, 8.0
    line = Line([Segment(2 * half, 0.0, EA=EA)], [PointLoad(half, weight)])
    solution = solve_line(line, height=20.0, anchor_height=20.0, span=span, elements=2)
    T = 0.0
    for _ in range(200):  # T = W l / (2 sqrt(l^2 - (S/2)^2)), l = l0 (1 + T/EA)
        length = half * (1.0 + T / EA)
        T = weight * length / (2 * math.sqrt(length**2 - (span / 2) ** 2))
    assert solution.tension == pytest.approx([T, T], rel=ROUNDING)
    assert solution.nodes[1] == pytest.approx(
        [span / 2, 0.0, 20.0 - math.sqrt(length**2 - (span / 2) ** 2)], abs=1e-11
    )
    assert solution.fairlead.vertical_force == pytest.approx(weight / 2, rel=ROUNDING)


def test_bars_that_push_hold_up_an_arch() -> None:
    """With compression allowed, a weightless pair of bars shorter than the way pushes."""
    line = Line([Segment(10.2, 0.0, EA=1e5)])
    pushed = solve_line(line, height=10.0, anchor_height=10.0, span=10.0, elements=1,
                        carries_compression=True)  # fmt: skip
    assert pushed.tension == pytest.approx([1e5 * (10.0 - 10.2) / 10.2], rel=ROUNDING)
    slack = solve_line(line, height=10.0, anchor_height=10.0, span=10.0, elements=1)
    assert slack.tension == pytest.approx([0.0], abs=1e-9)
