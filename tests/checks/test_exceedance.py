"""The formulas of excess agree with demand and capacity, compiled as well as plain."""

from __future__ import annotations

import inspect
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from catopt.checks import kinds as exceedance
from catopt.checks.case import check_case
from catopt.checks.kinds import ROUNDING, CheckSource
from catopt.checks.result import CheckResult
from catopt.compiled import compiled
from catopt.model import Anchor, Buoy, Checks

from .lines import GROUNDED, LIFTED, asking

FUNCTIONS = [getattr(exceedance, name) for name in exceedance.__all__ if name != "ROUNDING"]
FACTOR = st.floats(1.0, 20.0)
BAND = 4.0 * ROUNDING
"""Beside the limit, as a part of it or of H, rounding may decide either way."""


@settings(max_examples=100, deadline=None)
@given(
    lifted=st.booleans(),
    checks=st.builds(
        Checks,
        safety_factor=st.floats(1.01, 50.0),
        accept=st.just(("safety_factor",)),
        proof_load_factor=FACTOR,
        max_anchor_uplift_angle=st.floats(0.0, 1.5),
        max_anchor_uplift_force=st.floats(0.0, 1e5),
        min_grounded_length=st.floats(0.1, 100.0),
        min_tension=st.floats(1.0, 2e5),
        max_span=st.floats(1.0, 200.0),
    ),
    reserve=st.floats(1e3, 1e6),
    weight=st.floats(1e3, 1e6),
    friction=st.floats(0.05, 2.0),
    factor=FACTOR,
    drags=st.booleans(),
)
def test_a_check_is_passed_exactly_when_demand_is_within_capacity(
    lifted: bool,
    checks: Checks,
    reserve: float,
    weight: float,
    friction: float,
    factor: float,
    drags: bool,
) -> None:
    anchor = (
        Anchor("drag", holding_capacity=weight, safety_factor=factor)
        if drags
        else Anchor("sinker", submerged_weight=weight, friction=friction, safety_factor=factor)
    )
    case = LIFTED if lifted else GROUNDED
    report = check_case(asking(case, checks, anchor=anchor, buoy=Buoy(reserve)))
    assert len(report.results) == 9
    for result in report.results:
        distance = abs(result.demand - result.capacity)
        if distance > BAND * max(result.demand, result.capacity, 30e3 * (result.unit == "N"), 1.0):
            assert result.passes == (result.demand < result.capacity), result.name
            assert (result.exceedance > 0.0) == (result.demand > result.capacity), result.name
        if result.capacity > 0.0:
            assert result.utilisation == result.demand / result.capacity
        else:
            assert result.utilisation is None
    assert report.passes == all(result.passes for result in report.results)


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: str(function.__name__))
def test_compiled_and_plain_are_one(function: object) -> None:
    assert callable(function)
    count = len(inspect.signature(function).parameters)
    fast = compiled(function)
    for values in ((3.0, 2.0, 0.5, 1.5), (0.25, 7.0, 11.0, 3.0), (-2.0, 5.0, 4.0, 1.0)):
        # The compiler may contract a product and a sum into one rounding.
        assert fast(*values[:count]) == pytest.approx(function(*values[:count]), rel=1e-15)


def test_what_is_not_asked_for_is_never_overrun() -> None:
    """With the numbers that `Limits` has for it."""
    assert exceedance.uplift_angle_exceedance(1.5, math.inf) < 0.0
    assert exceedance.uplift_force_exceedance(1e9, 1.0, math.inf) < 0.0
    assert exceedance.grounded_exceedance(0.0, 0.0) < 0.0
    assert exceedance.least_tension_exceedance(0.0, 0.0) < 0.0
    assert exceedance.ratio_exceedance(1e9, math.inf) < 0.0


def test_no_uplift_without_any_force_is_kept() -> None:
    """Where seabed friction holds the line, neither V nor H reaches the anchor."""
    assert exceedance.uplift_force_exceedance(0.0, 0.0, 0.0) == 0.0
    assert exceedance.uplift_force_exceedance(0.05, 0.05, 0.0) == 1.0


def test_the_old_name_of_the_exceedance_of_a_check_warns_for_one_version() -> None:
    result = CheckResult("name", "span", "load", 66.0, 60.0, "m", 0.1, CheckSource("user"))
    with pytest.warns(DeprecationWarning, match="exceedance"):
        assert result.excess == 0.1
    assert result.to_dict()["excess"] == 0.1
