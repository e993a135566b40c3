"""S4's rule of load sharing; its sums by hand are in tests/mooring/test_load_sharing.py."""

from __future__ import annotations

import pytest

from catopt.reproduce import reproduce


def test_the_three_printed_factors_reproduce() -> None:
    study = reproduce("load_sharing").studies[0]
    assert [item.quantity for item in study.items] == [
        "FT_over_F_6_lines",
        "FT_over_F_8_lines",
        "FT_over_F_10_lines",
    ]
    # N/4; sums of at most five terms of order 1 in double precision.
    assert [item.computed for item in study.items] == pytest.approx([1.5, 2.0, 2.5], rel=1e-15)
    assert [item.printed.text for item in study.items] == ["1.5", "2.0", "2.5"]
    assert [item.verdict for item in study.items] == ["reproduces"] * 3
    assert [item.unit for item in study.items] == ["-"] * 3
    assert "not an equilibrium of catenaries" in study.findings[1]
