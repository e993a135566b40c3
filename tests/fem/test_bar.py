"""The bar on its own: patch, one weight between two bars, and bars that push."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.fem import solve_line
from catopt.model import Line, PointLoad, Segment

ROUNDING = 1e-12
"""Double precision over some hundred additions and the conditioning of a hundred bars."""


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
