"""The diameter at which a worn segment no longer passes, by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt.checks.case import check_case
from catopt.checks.criteria import criteria_of
from catopt.checks.kinds import USER, Place
from catopt.checks.result import CheckReport, CheckResult
from catopt.checks.wear import least_diameters
from catopt.model import Case, Checks, Line, Load, Segment, Service, Site
from catopt.notes.line import Given, size_note
from catopt.notes.origin import Asked
from catopt.words import Message, is_said
from tests.sizing.at_rest import size_buoy


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


# ------------------------------------------------------------------ every check, and in motion

YEAR = 365.25 * 86400.0
FIVE_YEARS = Service(life=5.0 * YEAR, wear_rate=0.4e-3 / YEAR)  # 2 mm of 80: 78 at the end


def _moved(case: Case, pull: float) -> CheckReport:
    return CheckReport("", (_tension(pull, "load"),), (), case=case, is_in_motion=True)


@pytest.mark.parametrize(
    ("pull", "limit", "by"),
    [
        (1.0e6, 0.078, "no thinner line was run in motion"),  # by tension 80 sqrt(2/4) = 56.6
        (1.95e6, 0.08 * math.sqrt(0.975), "tension in motion"),  # 78.99, above 78
    ],
)
def test_in_motion_the_limit_is_no_thinner_than_what_was_run(
    pull: float, limit: float, by: str
) -> None:
    case = replace(_case(2.0), service=FIVE_YEARS)
    report = check_case(case)
    (found,) = least_diameters(report, criteria_of(case), case.line, case, _moved(case, pull))
    assert found.limit == pytest.approx(limit, rel=1e-9)
    assert found.reason == by


def test_what_fails_in_motion_when_new_has_no_limit() -> None:
    case = replace(_case(2.0), service=FIVE_YEARS)
    moved = _moved(case, 2.1e6)
    (found,) = least_diameters(check_case(case), criteria_of(case), case.line, case, moved)
    assert (found.limit, found.room) == (None, None)


def test_authorities_discard_chain_at_four_fifths() -> None:
    """NAVFAC MO-124 6.2.2: 64 of 80 mm, where the checks would let it wear to 40."""
    case = _case(2.0)
    (found,) = least_diameters(check_case(case), criteria_of(case), case.line, case)
    assert found.least == pytest.approx(0.04, rel=1e-9)
    assert found.limit == found.discard == pytest.approx(0.064)
    assert not found.is_by_checks


def test_a_note_and_its_advice_have_one_limit_at_which_every_check_passes() -> None:
    """The table had 11.3 mm, by tension alone, the advice 27.7, by uplift, of a chain of 30 mm."""
    of = size_buoy(buoy="pillar 1.8 m", depth="12 m")
    (row,) = size_note(of, Given(), Asked(verify=False)).sheet.least
    (said,) = (each for each in of.advice if is_said(each, "sizing.worn_to_check"))
    assert isinstance(said, Message)
    assert row.limit is not None
    assert said.values["diameter"] == pytest.approx(1e3 * row.limit, rel=1e-9)
    assert of.chain_life == pytest.approx((0.03 - row.limit) / (0.4e-3 / YEAR), rel=1e-3)
    worn = tuple(each for each in of.case.load_cases if each.condition == "worn")
    for share, is_enough in ((1.0 + 1e-6, True), (0.995, False)):
        service = Service(life=1.0, wear_rate=0.03 - share * row.limit)
        again = check_case(replace(of.case, design=None, load_cases=worn, service=service))
        assert again.passes is is_enough
        assert is_enough or again.failed[0].kind == "uplift_angle"
