"""A hanging line against the formulas of a textbook, written out here on their own."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.fem import mesh_line, solve_line
from catopt.model import Line, Segment

W, HEIGHT, LENGTH, H = 1000.0, 60.0, 100.0, 80e3
LINE = Line([Segment(LENGTH, W)])


def inextensible(H: float) -> tuple[float, float, float]:
    """Span, fairlead tension and anchor inclination of a suspended line that does not stretch.

    V at the anchor from the height: h = a (cosh-free form) sqrt(1 + (L/a + t)^2) - sqrt(1 + t^2).
    """
    a = H / W
    low, high = -10.0, 10.0
    for _ in range(200):
        t = 0.5 * (low + high)
        rise = a * (math.hypot(1.0, LENGTH / a + t) - math.hypot(1.0, t))
        low, high = (t, high) if rise < HEIGHT else (low, t)
    span = a * (math.asinh(LENGTH / a + t) - math.asinh(t))
    return span, H * math.hypot(1.0, LENGTH / a + t), math.atan(t)


def errors(elements: int) -> np.ndarray:
    solution = solve_line(LINE, height=HEIGHT, horizontal_force=H, mesh=mesh_line(LINE, elements))
    span, tension, angle = inextensible(H)
    return np.array(
        [
            solution.span / span - 1.0,
            solution.fairlead.tension / tension - 1.0,
            solution.anchor.angle - angle,
        ]
    )


def test_error_falls_with_the_square_of_the_bar_length() -> None:
    """Order 2, and two meshes put together (Richardson) reach the formula's digits."""
    found = np.array([errors(elements) for elements in (20, 40, 80, 160)])
    order = np.log2(np.abs(found[:-1] / found[1:]))
    assert order == pytest.approx(np.full((3, 3), 2.0), abs=0.1)
    richardson = (4.0 * found[3] - found[2]) / 3.0
    # The next term of the error is of fourth order: 160**-4 is 2e-9.
    assert np.abs(richardson).max() < 2e-9


def test_tension_within_the_line() -> None:
    """At half its length V has grown by w L/2; a bar has the tension of its middle."""
    solution = solve_line(LINE, height=HEIGHT, horizontal_force=H, elements=101)
    _, _, angle = inextensible(H)
    middle = math.hypot(H, H * math.tan(angle) + W * LENGTH / 2)
    # One bar is a hundredth of the line: its share of the second-order error is 1e-5.
    assert solution.tension[50] == pytest.approx(middle, rel=1e-5)
    assert solution.end_tension[:-1, 1] == pytest.approx(solution.end_tension[1:, 0], rel=1e-12)
    assert solution.segment_max_tension()[0] == pytest.approx(solution.fairlead.tension, rel=1e-14)


def test_stiff_line_approaches_the_inextensible_one() -> None:
    """What is left is T/EA; EA needs no ceiling, and infinity is no special case."""
    rigid = solve_line(LINE, height=HEIGHT, horizontal_force=H, elements=50)
    for EA in (1e9, 1e12, 1e15):
        stiff = Line([Segment(LENGTH, W, EA=EA)])
        solution = solve_line(stiff, height=HEIGHT, horizontal_force=H, elements=50)
        assert solution.residual < 1e-11
        # dS/S is a few T/EA; beside it double precision.
        assert abs(solution.span / rigid.span - 1.0) < 5.0 * 1.3e5 / EA + 1e-13


def test_shallow_line_is_a_parabola() -> None:
    """Small sag: H = w S^2 / (8 f); the parabola itself is off by (f/S)^2."""
    line = Line([Segment(100.0, 10.0, EA=1e7)])
    solution = solve_line(line, height=50.0, anchor_height=50.0, span=99.99, elements=64)
    sag = 50.0 - solution.nodes[:, 2].min()
    parabola = 10.0 * 99.99**2 / (8.0 * sag)
    assert solution.horizontal_force == pytest.approx(parabola, rel=5.0 * (sag / 99.99) ** 2)
    assert sag / 99.99 < 0.02


def test_hand_over_of_units() -> None:
    """The same line in other units of length and force is the same line."""
    small = solve_line(LINE, height=HEIGHT, span=70.0, elements=30)
    scale, force = 1e-3, 1e4
    line = Line([Segment(LENGTH * scale, W * force / scale)])
    other = solve_line(line, height=HEIGHT * scale, span=70.0 * scale, elements=30)
    # Rounding, magnified by the sensitivity of tension to span.
    assert other.tension / force == pytest.approx(small.tension, rel=1e-10)
