"""Tensions of lines in motion beside calculations by hand.

A segment with an MBL of 3000 kN carries 900 kN at most and 300 kN in the mean, a third of it.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from catopt.checks.motion import LineInMotion, check_motion
from catopt.checks.result import CheckReport
from catopt.model import Body, Case, Checks, Dynamics, Line, Load, Motion, Segment, Site, System
from catopt.words import is_said

from .lines import CLOSE

LINE = Line([Segment(120.0, 1000.0, MBL=3000e3)])
MOVED = LineInMotion(LINE, (900e3,), (300e3,), "load")
ALONE = Case(
    Site(20.0), LINE, Load(300e3), 20.0, motion=Motion(8.0), dynamics=Dynamics(24.0)
)  # fmt: skip


def judged(*codes: str, moved: LineInMotion = MOVED, **checks: float) -> CheckReport:
    asked = Checks(codes=codes, **checks)  # type: ignore[arg-type]
    return check_motion(replace(ALONE, checks=asked), [moved])


def said(report: CheckReport, key: str) -> list[str]:
    return [str(each) for each in report.warnings if is_said(each, key)]


@pytest.mark.parametrize(
    ("code", "used"),
    [
        ("API-RP-2SK", 900.0 * 1.67 / 3000.0),
        ("DNV-OS-E301-2008-CC2", (300.0 * 1.4 + 600.0 * 2.1) / (0.95 * 3000.0)),
        ("DNV-OS-E301-2008-CC1-SPM", 1.2 * (300.0 * 1.1 + 600.0 * 1.5) / (0.95 * 3000.0)),
        ("UFC-4-159-03", 900.0 * 3.0 / 3000.0),
    ],
)
def test_the_factor_of_a_code_for_dynamic_analysis(code: str, used: float) -> None:
    report = judged(code)
    (result,) = report.results
    assert result.utilisation == pytest.approx(used, rel=CLOSE)
    assert result.source.code == code
    assert bool(said(report, "checks.motion_at_rest")) == (code == "UFC-4-159-03")


def test_class_1_of_e301_is_judged_by_both_of_its_rules() -> None:
    """Table D1: 1.1 and 1.5; D202: 1.3 on the whole."""
    report = judged("DNV-OS-E301-2008-CC1")
    table, whole = (each.utilisation for each in report.results)
    assert table == pytest.approx((300.0 * 1.1 + 600.0 * 1.5) / (0.95 * 3000.0), rel=CLOSE)
    assert whole == pytest.approx(900.0 * 1.3 / (0.95 * 3000.0), rel=CLOSE)
    assert "1.1 on the mean, which is 33.3% of the tension" in str(report.results[0].note)


def test_without_a_mean_the_whole_takes_the_factor_on_what_is_dynamic() -> None:
    report = judged("DNV-OS-E301-2008-CC2", moved=replace(MOVED, mean=None))
    (result,) = report.results
    assert result.utilisation == pytest.approx(900.0 * 2.1 / (0.95 * 3000.0), rel=CLOSE)
    assert said(report, "checks.motion_no_mean")


def test_the_number_of_the_case_holds_and_no_code_is_said() -> None:
    report = judged(safety_factor=3.0)
    (result,) = report.results
    assert result.utilisation == pytest.approx(0.9, rel=CLOSE)
    assert said(report, "checks.motion_no_code")
    assert not said(judged("API-RP-2SK"), "checks.motion_no_code")


def test_a_maximum_in_doubt_passes_nothing_and_may_fail() -> None:
    passed = judged("API-RP-2SK")
    assert passed.verdict is True
    assert replace(passed, is_doubted=True).verdict is None
    failed = judged("API-RP-2SK", moved=replace(MOVED, largest=(2000e3,)))
    assert replace(failed, is_doubted=True).verdict is False
    assert judged().verdict is None


def test_a_run_in_which_a_line_breaks_is_judged_by_the_transient_factors() -> None:
    """API RP 2SK 1.05 on the two lines that are left; E301 has nothing for it."""
    system = System.around(LINE, azimuths=[0.0, 2.0, 4.0], anchor_radius=110.0, fairlead_height=20)
    case = Case(
        Site(20.0), LINE, None, 20.0, system=system, body=Body(1e5, force_file="force.csv"),
        dynamics=Dynamics(24.0, broken_line=2, broken_at=12.0),
        checks=Checks(codes=("API-RP-2SK", "DNV-OS-E301-2008-CC2")),
    )  # fmt: skip
    report = check_motion(case, [replace(MOVED, number=number) for number in (1, 2, 3)])
    assert [each.place.line for each in report.results] == [1, 3]
    for each in report.results:
        assert each.utilisation == pytest.approx(900.0 * 1.05 / 3000.0, rel=CLOSE)
        assert (each.place.state, each.place.missing) == ("transient", 2)
    assert said(report, "checks.motion_breaks")
    (silent,) = said(report, "checks.motion_not_transient")
    assert silent.startswith("DNV-OS-E301-2008-CC2: ")


def test_a_line_that_is_lost_itself_is_not_judged() -> None:
    lost = replace(
        ALONE, dynamics=Dynamics(24.0, broken_line=1, broken_at=9.0, broken_end="anchor")
    )
    report = check_motion(replace(lost, checks=Checks(codes=("API-RP-2SK",))), [MOVED])
    assert report.results == ()
    assert said(report, "checks.motion_all_lost")
