"""Where a line comes to the bed and leaves it, by hand."""

from __future__ import annotations

import math

import pytest

from catopt import Line, PointLoad, Segment, solve


def test_a_grounded_line_has_one() -> None:
    # a = H / w = 10 m; what hangs is sqrt(h (h + 2 a)) long, and reaches a asinh(s / a).
    line = solve(Line([Segment(100.0, 100.0)]), height=20.0, horizontal_force=1e3)
    hangs = math.sqrt(20.0 * (20.0 + 20.0))
    (only,) = line.touchdowns
    assert (only.s, only.x, only.z) == pytest.approx((100.0 - hangs, 100.0 - hangs, 0.0))
    assert line.span == pytest.approx(only.x + 10.0 * math.asinh(hangs / 10.0))
    assert line.to_dict()["touchdowns"] == [{"s_m": only.s, "x_m": only.x, "z_m": only.z}]


def test_a_line_that_hangs_clear_has_none() -> None:
    line = solve(Line([Segment(30.0, 100.0)]), height=20.0, horizontal_force=1e4)
    assert line.touchdowns == ()


def test_a_buoy_that_lifts_the_middle_has_three() -> None:
    # Lying, lifted by the buoy, lying again, and up to the fairlead. The buoy lifts as much on
    # either side: each side hangs with V = 1 kN, 10 m of it.
    float_at_50 = PointLoad(position=50.0, submerged_weight=-2e3)
    line = solve(Line([Segment(200.0, 100.0)], [float_at_50]), height=20.0, horizontal_force=1e3)
    assert [each.s for each in line.touchdowns] == pytest.approx(
        [40.0, 60.0, 200.0 - math.sqrt(800.0)]
    )
