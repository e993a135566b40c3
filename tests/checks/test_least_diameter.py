"""The diameter at which a worn segment no longer passes, by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt.checks.case import check_case, least_diameters
from catopt.checks.criteria import criteria_of
from catopt.checks.kinds import USER, Place
from catopt.checks.result import CheckReport, CheckResult
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


def _tension(pull: float, load_case: str = "a", segment: int = 1) -> CheckResult:
    """Make a check of a tension that is allowed 2,000 kN."""
    exceedance, place = pull / 2e6 - 1.0, Place(segment=segment)
    return CheckResult(
        "tension", "tension", load_case, pull, 2e6, "N", exceedance, USER, place=place
    )


def _found(*results: CheckResult) -> float | None:
    """Least diameter of a chain of 80 mm and 4,000 kN with a factor of 2 under these tensions."""
    case = _case(2.0)
    report = CheckReport("", results, ())
    (found,) = least_diameters(report, criteria_of(case), case.line)
    return found.least


def test_the_largest_pull_counts_whichever_comes_first() -> None:
    """500 kN times 2 is a quarter of 4,000 kN: half of 80 mm; 200 kN would leave 25.3 mm."""
    small, large = _tension(2e5, "a"), _tension(5e5, "b")
    for results in ((large, small), (small, large)):
        assert _found(*results) == pytest.approx(0.04, rel=1e-9)


def test_neither_another_segment_nor_another_check_counts() -> None:
    """1,900 kN of segment 2, and a check of 1,900 that is no tension."""
    other = replace(_tension(1.9e6), kind="span", name="span")
    found = _found(_tension(5e5), _tension(1.9e6, segment=2), other)
    assert found == pytest.approx(0.04, rel=1e-9)


def test_what_just_passes_may_not_wear_at_all() -> None:
    """2,000 kN times 2 is all of 4,000 kN."""
    assert _found(_tension(2e6)) == pytest.approx(0.08, rel=1e-9)
    assert _found(_tension(2.001e6)) is None


def test_a_fibre_rope_and_a_segment_without_a_diameter_have_none() -> None:
    case = _case(2.0)
    (chain,) = case.line.segments
    rope = replace(chain, component="polyester", proof_load=2e6)
    for other in (rope, replace(chain, nominal_diameter=None)):
        assert least_diameters(check_case(case), criteria_of(case), Line([other])) == ()
    both = Line([replace(chain, nominal_diameter=None), chain])
    report = check_case(replace(case, line=both))
    assert [each.segment for each in least_diameters(report, criteria_of(case), both)] == [2]


@pytest.mark.parametrize(("over", "is_enough"), [(5e-10, True), (2e-9, False)])
def test_what_the_check_takes_for_rounding_is_rounding_here(over: float, is_enough: bool) -> None:
    """A tension of 500 kN at a factor of 8 is the MBL of 4,000 kN itself."""
    case = _case(8.0 * (1.0 + over))
    assert check_case(case).passes == is_enough
    least = _least(case)
    assert (least is not None) == is_enough
    assert least is None or least == pytest.approx(0.08, rel=1e-8)
