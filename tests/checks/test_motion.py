"""Tensions of lines in motion beside calculations by hand.

A segment with an MBL of 3000 kN carries 900 kN at most and 300 kN in the mean, a third of it.
"""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt.checks.case import Carried, LineInMotion, Pull, check_motion, check_strengths
from catopt.checks.result import CheckReport
from catopt.errors import InputError
from catopt.model import (
    Anchor,
    Body,
    Case,
    Checks,
    Dynamics,
    Line,
    Load,
    LoadCase,
    Motion,
    Segment,
    Site,
    System,
)
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
    assert not said(judged("DNV-OS-E301-2008-CC2"), "checks.motion_no_mean")
    no_mean = judged("API-RP-2SK", moved=replace(MOVED, mean=None))
    assert not said(no_mean, "checks.motion_no_mean")


def test_the_number_of_the_case_holds_and_no_code_is_said() -> None:
    report = judged(safety_factor=3.0)
    (result,) = report.results
    assert result.utilisation == pytest.approx(0.9, rel=CLOSE)
    assert said(report, "checks.motion_no_code")
    assert not said(judged("API-RP-2SK"), "checks.motion_no_code")


def test_a_number_of_the_case_beside_a_code_is_no_code() -> None:
    """Nor is what is no tension: API RP 2SK's factor on a sinker is for no analysis."""
    sinker = Anchor("sinker", submerged_weight=1e6, friction=0.5)
    asked = Checks(codes=("API-RP-2SK",), safety_factor=3.0)
    report = check_motion(replace(ALONE, checks=asked, anchor=sinker), [MOVED])
    assert [each.source.code for each in report.results] == ["user", "API-RP-2SK"]
    assert not said(report, "checks.motion_at_rest")


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


def test_each_segment_by_its_own_tension_and_mean() -> None:
    """E301, class 2, of 0.95 x 3000 and 0.95 x 1000 kN: 1.4 on the mean and 2.1 on the rest.

    Below 800 kN, 200 in the mean: 200 x 1.4 + 600 x 2.1 = 1540; above 400, all of it mean: 560 kN.
    """
    line = Line([Segment(60.0, 1000.0, MBL=3000e3), Segment(60.0, 1000.0, MBL=1000e3)])
    moved = LineInMotion(line, (800e3, 400e3), (200e3, 400e3), "load")
    below, above = judged("DNV-OS-E301-2008-CC2", moved=moved).results
    assert below.utilisation == pytest.approx(1540.0 / 2850.0, rel=CLOSE)
    assert above.utilisation == pytest.approx(560.0 / 950.0, rel=CLOSE)
    assert [each.place.segment for each in (below, above)] == [1, 2]
    assert [str(each.name) for each in (below, above)] == [
        "tension, segment 1",
        "tension, segment 2",
    ]


def test_a_mean_above_the_largest_is_all_there_is_and_a_slack_line_carries_nothing() -> None:
    """The mean of a line at rest may be above what a short run has: 900 x 1.4 = 1260 kN."""
    above = judged("DNV-OS-E301-2008-CC2", moved=replace(MOVED, mean=(1000e3,)))
    assert above.results[0].utilisation == pytest.approx(1260.0 / 2850.0, rel=CLOSE)
    slack = judged("DNV-OS-E301-2008-CC2", moved=replace(MOVED, largest=(0.0,), mean=(0.0,)))
    assert slack.results[0].utilisation == 0.0
    assert slack.results[0].capacity == pytest.approx(2850e3 / 2.1, rel=CLOSE)


def test_a_strength_that_is_missing_is_told_before_a_run() -> None:
    bare = Line([Segment(120.0, 1000.0)])
    asked = replace(ALONE, checks=Checks(codes=("API-RP-2SK",)))
    check_strengths(asked)
    with pytest.raises(InputError, match=r"line\.segments\[0\]\.MBL: missing"):
        check_strengths(replace(asked, line=bare))
    check_strengths(replace(ALONE, line=bare))
    day = (LoadCase("day", 1e5, kind="reference"),)
    with pytest.raises(InputError, match="LR-linkspans-2022 needs it"):
        check_strengths(
            replace(
                ALONE,
                line=bare,
                checks=Checks(codes=("LR-linkspans-2022",)),
                load=None,
                load_cases=day,
            )
        )


@pytest.mark.parametrize("broken", [None, 2])
@pytest.mark.parametrize("code", ["API-RP-2SK", "DNV-OS-E301-2008-CC2"])
def test_the_strengths_of_a_body_s_lines_are_those_of_the_state_it_is_run_in(
    code: str, broken: int | None
) -> None:
    """As a line parts E301 has no factor, so that it needs no strength."""
    bare = Line([Segment(120.0, 1000.0)])
    system = System.around(bare, azimuths=[0.0, 2.0, 4.0], anchor_radius=110.0, fairlead_height=20)
    dynamics = Dynamics(24.0) if broken is None else Dynamics(24.0, broken_line=2, broken_at=12.0)
    case = Case(
        Site(20.0), LINE, None, 20.0, system=system, body=Body(1e5, force_file="force.csv"),
        dynamics=dynamics, checks=Checks(codes=(code,)),
    )  # fmt: skip
    if broken is not None and code.startswith("DNV"):
        check_strengths(case)
    else:
        with pytest.raises(InputError, match=r"line\.segments\[0\]\.MBL: missing"):
            check_strengths(case)


def test_normal_and_extreme_factors_in_motion_go_by_the_load_case() -> None:
    """Lloyd's linkspans: 900 kN by 3.0 normal and 2.0 extreme of 3000 kN."""
    cases = (LoadCase("day", 1e5, kind="reference"), LoadCase("storm", 3e5))
    case = replace(ALONE, checks=Checks(codes=("LR-linkspans-2022",)), load=None, load_cases=cases)
    report = check_motion(case, [replace(MOVED, load_case=each.name) for each in cases])
    assert [each.utilisation for each in report.results] == pytest.approx([0.9, 0.6], rel=CLOSE)


def test_the_state_of_a_load_case_is_judged_by_its_own_factor() -> None:
    """API RP 2SK, dynamic analysis: 1.67 of a whole mooring, 1.25 with a line out, of 3000 kN."""
    cases = (LoadCase("whole", 3e5), LoadCase("damaged", 3e5, state="one_line_out"))
    case = replace(ALONE, checks=Checks(codes=("API-RP-2SK",)), load=None, load_cases=cases)
    report = check_motion(case, [replace(MOVED, load_case=each.name) for each in cases])
    used = [900.0 * 1.67 / 3000.0, 900.0 * 1.25 / 3000.0]
    assert [each.utilisation for each in report.results] == pytest.approx(used, rel=CLOSE)
    assert [each.place.state for each in report.results] == ["intact", "one_line_out"]


@pytest.mark.parametrize("line_out", [None, 1.5])
def test_the_case_s_factor_holds_as_a_line_breaks(line_out: float | None) -> None:
    """The factor with one line out is of the state after it; 2,900 kN by 3 of 3,000 kN is 2.9."""
    system = System.around(LINE, azimuths=[0.0, 2.0, 4.0], anchor_radius=110.0, fairlead_height=20)
    case = Case(
        Site(20.0), LINE, None, 20.0, system=system, body=Body(1e5, force_file="force.csv"),
        dynamics=Dynamics(24.0, broken_line=2, broken_at=12.0),
        checks=Checks(safety_factor=3.0, safety_factor_line_out=line_out),
    )  # fmt: skip
    moved = [LineInMotion(LINE, (2900e3,), (300e3,), "load", number=each) for each in (1, 2, 3)]
    report = check_motion(case, moved)
    assert [each.utilisation for each in report.results] == pytest.approx([2.9, 2.9], rel=CLOSE)


def test_what_is_no_tension_is_judged_by_its_least_favourable_value() -> None:
    """Pulled up by 30 kN at 6 deg, 17.2 m left on the bed, 118 m from end to end, 80 kN down.

    Of 10 kN that are required at the fairlead 8 kN were there at the least.
    """
    carried = Carried(
        Pull(290e3, 30e3, math.radians(6.0)),
        Pull(0.0, 80e3, 0.0),
        grounded_length=17.2,
        span=118.0,
        least_tension=8e3,
    )
    asked = Checks(
        max_anchor_uplift_angle=math.radians(5.0),
        min_grounded_length=27.4,
        max_span=120.0,
        min_tension=10e3,
    )
    anchor = Anchor("drag", holding_capacity=500e3, safety_factor=2.0)
    case = replace(ALONE, checks=asked, anchor=anchor)
    report = check_motion(case, [replace(MOVED, carried=carried)])
    used = {each.kind: (each.utilisation, each.passes) for each in report.results}
    assert used["uplift_angle"][0] == pytest.approx(6.0 / 5.0, rel=CLOSE)
    assert used["uplift_angle"][1] is False
    assert used["grounded_length"][0] == pytest.approx(27.4 / 17.2, rel=CLOSE)
    assert used["grounded_length"][1] is False
    assert used["span"][0] == pytest.approx(118.0 / 120.0, rel=CLOSE)
    assert used["span"][1] is True
    assert used["least_tension"][0] == pytest.approx(10.0 / 8.0, rel=CLOSE)
    assert used["least_tension"][1] is False
    assert used["holding"][0] == pytest.approx(2.0 * 290.0 / 500.0, rel=CLOSE)
    assert used["holding"][1] is False
    assert all(each.kind == "tension" for each in check_motion(case, [MOVED]).results)


# ------------------------------------------------------------------ judged by another code

SINKER = Anchor(
    "sinker", submerged_weight=50e3, friction=0.5, mass=9000.0, safety_factor=1.5, max_slide=1.0
)
CARRIED = Carried(Pull(20e3, 5e3, 0.2), Pull(20e3, 30e3, 1.0), 0.0, 100.0, 1e3, slide=0.25)


def test_a_code_that_has_no_factors_for_motion_leaves_it_to_another_one() -> None:
    """CALMAR's own 5 on the proof load and its line tangent at the sinker are for rest."""
    line = Line([replace(LINE.segments[0], proof_load=1500e3)])
    case = replace(
        ALONE, line=line, checks=Checks(codes=("IALA-CALMAR",), motion_code="API-RP-2SK")
    )
    moved = replace(MOVED, line=line, carried=CARRIED)
    report = check_motion(case, [moved])
    (tension,) = report.results
    assert tension.source.code == "API-RP-2SK"
    assert tension.capacity == pytest.approx(3000e3 / 1.67, rel=CLOSE)
    (told,) = said(report, "checks.motion_by_other")
    assert "IALA-CALMAR" in told
    assert "API-RP-2SK" in told
    # Without, its factors for rest are held against motion, and that is said.
    alone = check_motion(replace(case, checks=Checks(codes=("IALA-CALMAR",))), [moved])
    assert {each.kind for each in alone.results} == {"tension", "uplift_angle"}
    assert said(alone, "checks.motion_at_rest")


def test_a_code_with_factors_for_motion_is_not_replaced() -> None:
    checks = Checks(codes=("DNV-OS-E301-2008-CC2",), motion_code="API-RP-2SK")
    report = check_motion(replace(ALONE, checks=checks), [MOVED])
    assert {each.source.code for each in report.results} == {"DNV-OS-E301-2008-CC2"}
    assert not said(report, "checks.motion_by_other")


@pytest.mark.parametrize(
    ("code", "told"),
    [("UFC-4-159-03", "dynamic analysis is required: DNV"), ("API-2SK", "API-RP-2SK")],
)
def test_what_cannot_judge_motion_is_refused(code: str, told: str) -> None:
    with pytest.raises(InputError, match=f"checks.motion_code: found .*{told}"):
        judged("IALA-CALMAR", motion_code=code)  # type: ignore[arg-type]


@pytest.mark.parametrize(("way", "passes"), [(0.25, True), (1.0, True), (1.01, False)])
def test_a_sinker_may_slide_so_far_in_the_place_of_a_factor(way: float, passes: bool) -> None:
    moved = replace(MOVED, carried=CARRIED._replace(slide=way))
    (result,) = check_motion(replace(ALONE, anchor=SINKER), [moved]).results
    assert (result.kind, result.demand, result.capacity) == ("slide", way, 1.0)
    assert result.passes is passes
    assert result.unit == "m"
    # With a factor alone 5 kN + 1.5 x 20 kN / 0.5 of weight are required.
    held = replace(SINKER, max_slide=None)
    (result,) = check_motion(replace(ALONE, anchor=held), [moved]).results
    assert result.kind == "sliding"
    assert result.demand == pytest.approx(65e3, rel=CLOSE)


@pytest.mark.parametrize(
    ("given", "key"),
    [
        ({"kind": "drag", "holding_capacity": 1e5}, "max_slide"),
        ({"kind": "sinker", "submerged_weight": 1e4, "friction": 0.5}, "mass"),
    ],
)
def test_what_cannot_slide_is_refused(given: dict[str, object], key: str) -> None:
    with pytest.raises(InputError) as caught:
        Anchor(**given, max_slide=1.0)  # type: ignore[arg-type]
    assert [each.key for each in caught.value.problems] == [key]
