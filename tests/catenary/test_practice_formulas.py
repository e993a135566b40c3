"""S4, chapter 1: the formulas of practice hold for what catopt solves.

A slack line with its vertex on the bed, [1.1] to [1.7]; with stretch, [1.8] to [1.12]; the safety
factor, [1.17]. The forms are not always S4's own.
"""

from __future__ import annotations

import math

import pytest

import catopt
from catopt.catenary.find import find_length

LINES = [  # submerged weight N/m, height m, horizontal force N
    (93.163, 9.5, 1.0e3),
    (1000.0, 200.0, 300e3),
    (2100.0, 20.0, 100e3),
    (2100.0, 20.0, 2000e3),
    (298.0, 71.4, 900e3),
]

DOUBLE = 1e-11
"""Rounding of double precision, times what small differences of large lengths make of it."""


@pytest.mark.parametrize(("weight", "height", "force"), LINES)
def test_a_slack_line_with_its_vertex_on_the_bed(
    weight: float, height: float, force: float
) -> None:
    """L_min = sqrt(h2 + 2 a h), T = H + q z wherever it hangs, S = L - L_min + a acosh(1 + h/a)."""
    a = force / weight
    hanging = math.sqrt(height**2 + 2.0 * a * height)
    line = catopt.Line([catopt.Segment(1.5 * hanging, weight)])
    solution = catopt.solve(line, height=height, horizontal_force=force)
    assert solution.suspended_length == pytest.approx(hanging, rel=DOUBLE)
    assert solution.span == pytest.approx(
        0.5 * hanging + a * math.acosh(1.0 + height / a), rel=DOUBLE
    )
    profile = solution.profile()
    for z, tension in zip(profile.z, profile.tension, strict=True):
        assert tension == pytest.approx(force + weight * z, rel=DOUBLE)


@pytest.mark.parametrize("ratio", [1e2, 1e3, 1e5])
@pytest.mark.parametrize(("weight", "height", "force"), LINES)
def test_the_shortest_line_that_stretches_and_pulls_level_at_its_anchor(
    weight: float, height: float, force: float, ratio: float
) -> None:
    """From h = (T - H)/w + (T2 - H2)/(2 EA w), quadratic in T; L_min = sqrt(T2 - H2)/w."""
    EA = ratio * (force + weight * height)
    tension = EA * (math.sqrt((1.0 + force / EA) ** 2 + 2.0 * weight * height / EA) - 1.0)
    shortest = math.sqrt(tension**2 - force**2) / weight
    found = find_length(
        catopt.Line([catopt.Segment(height, weight, EA=EA)]),
        height=height,
        horizontal_force=force,
        anchor_angle=0.0,
    )
    # T - EA loses the digits of EA/T, up to 1e5: double precision leaves 1e-11, and T2 - H2 a part.
    assert found.solution.fairlead.tension == pytest.approx(tension, rel=1e-9)
    assert found.value == pytest.approx(shortest, rel=1e-8)
    # It stretches, so that less of it reaches as high.
    assert found.value < math.sqrt(height**2 + 2.0 * force / weight * height)


def test_the_breaking_load_is_at_least_the_safety_factor_times_the_tension() -> None:
    """T_break >= SF T is the utilisation at or below 1; T = H + q h = 142 kN of S3's Table 1."""
    for breaking_load, enough in ((5.0 * 142e3 * 1.0001, True), (5.0 * 142e3 * 0.9999, False)):
        line = catopt.Line([catopt.Segment(55.0, 2100.0, MBL=breaking_load)])
        solution = catopt.solve(line, height=20.0, horizontal_force=100e3)
        used = solution.segments[0].utilisation(5.0)
        assert used is not None
        assert (used <= 1.0) is enough
