"""Load curves: points by the scalar solve, marks by formula."""

from __future__ import annotations

import numpy as np
import pytest

from catopt.catenary.curve import load_curve
from catopt.catenary.solve import solve
from catopt.errors import InputError, NoEquilibriumError
from catopt.model import Line, Segment

TANKER = Line([Segment(55.0, 2100.0, MBL=1e6)])


def test_points_are_those_of_the_scalar_solve() -> None:
    curve = load_curve(TANKER, height=20.0, over="horizontal_force", start=2e4, stop=4e5, points=20)
    for index, force in enumerate(np.linspace(2e4, 4e5, 20)):
        one = solve(TANKER, height=20.0, horizontal_force=float(force))
        assert curve.span[index] == pytest.approx(one.span, rel=1e-13)
        assert curve.regime[index] == one.regime


def test_the_change_of_regime_is_marked_where_the_formula_has_it() -> None:
    """H_1 = (w/2)(L2/h - h) = 137.8125 kN, found to 1e-9 of itself."""
    curve = load_curve(
        TANKER, height=20.0, over="span", start=40.0, stop=51.0, points=30, safety_factor=5.0
    )
    change = next(mark for mark in curve.marks if "->" in mark.event)
    assert change.event == "grounded -> suspended"
    assert change.horizontal_force == pytest.approx(137812.5, rel=1e-9)
    limit = next(mark for mark in curve.marks if "MBL" in mark.event)
    assert limit.fairlead_tension == pytest.approx(1e6 / 5.0, rel=1e-9)


def test_stiffness_is_the_slope_of_the_curve() -> None:
    """Central differences, order 2: halving the step quarters the error."""
    errors = []
    for points in (41, 81):
        curve = load_curve(TANKER, height=20.0, over="span", start=40.0, stop=49.0, points=points)
        slope = np.gradient(curve.horizontal_force, curve.span)
        middle = points // 2
        errors.append(abs(slope[middle] / curve.stiffness[middle] - 1.0))
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.1)


def test_a_range_beyond_the_line_says_so() -> None:
    with pytest.raises(NoEquilibriumError, match="too short"):
        load_curve(TANKER, height=20.0, over="span", start=40.0, stop=60.0)


def test_an_empty_range_is_refused() -> None:
    with pytest.raises(InputError, match="2 errors"):
        load_curve(TANKER, height=20.0, over="span", start=50.0, stop=40.0, points=1)
