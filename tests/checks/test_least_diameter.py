"""The diameter at which a worn segment no longer passes, by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt.checks.case import check_case
from catopt.checks.criteria import criteria_of
from catopt.checks.least_diameter import least_diameters
from catopt.model import Case, Checks, Line, Load, Segment, Site


def _case(factor: float) -> Case:
    """Make a chain without a component: its strength goes with the square of d."""
    chain = Segment(300.0, 1000.0, MBL=4.0e6, nominal_diameter=0.08, name="chain")
    return Case(
        site=Site(50.0),
        line=Line([chain]),
        load=Load(fairlead_tension=5.0e5),
        fairlead_height=50.0,
        checks=Checks(safety_factor=factor),
    )


def _least(case: Case) -> float | None:
    report = check_case(case)
    (found,) = least_diameters(report, criteria_of(case), case.line)
    assert (found.segment, found.diameter, found.end_diameter) == (1, 0.08, 0.08)
    return found.least


def test_strength_goes_with_the_square() -> None:
    """T = 500 kN times 2 is 1,000 kN, a quarter of 4,000 kN: half of 80 mm."""
    assert _least(_case(2.0)) == pytest.approx(0.04, rel=1e-9)


def test_a_component_wears_by_its_formula() -> None:
    """R3 studless: c d^2 (44 - 0.08 d), c cancels: d^2 (44 - 0.08 d) = that of 80 mm / 4."""
    case = _case(2.0)
    chain = replace(case.line.segments[0], component="chain studless R3")
    least = _least(replace(case, line=Line([chain])))
    wanted = 80.0**2 * (44.0 - 0.08 * 80.0) / 4.0
    assert least is not None
    d = 1e3 * least
    assert d * d * (44.0 - 0.08 * d) == pytest.approx(wanted, rel=1e-9)
    assert d < 40.0  # the formula falls more slowly than the square


def test_what_fails_when_new_has_none() -> None:
    assert _least(_case(9.0)) is None


def test_nothing_limits_a_tension_without_a_criterion() -> None:
    case = _case(1.0)
    assert least_diameters(check_case(case), criteria_of(case), case.line) == ()
    assert math.isfinite(case.fairlead_height)
