"""Factors by state and analysis, each beside a calculation by hand.

A line by itself is that of tests/checks/lines.py: T = 50 kN, MBL 200 kN, proof load 100 kN.

TWO is a body on two such lines side by side, pushed away from their anchors with 60 kN. Intact each
carries H = 30 kN and T = H + w h = 30 + 20 = 50 kN. With one out the other carries H = 60 kN, so
that a = 60 m; sqrt(20 (20 + 120)) = 52.9 m hang, 7.1 m of its 60 m lie, and T = 60 + 20 = 80 kN.
"""

from __future__ import annotations

import math
from dataclasses import replace

import jsonschema
import pytest

from catopt import check_case, schemas
from catopt.checks.criteria import allowed_by, criteria_of
from catopt.checks.result import CheckReport, CheckResult
from catopt.errors import InputError
from catopt.model import Anchor, Buoy, Case, Checks, Line, Load, Segment, Service, Site, System

from .lines import CLOSE, GROUNDED, LIFTED, PLAIN, asking, only

SOLVED = 1e-9
"""Relative: the balance of the body is met to so much of its force."""


def body(lines: int = 2, checks: Checks | None = None, **parts: object) -> Case:
    """Make TWO, or a body on another number of the same lines, each of which carries its share."""
    line = Line([replace(PLAIN, **parts)])  # type: ignore[arg-type]
    system = System.around(
        line,
        azimuths=[0.0] * lines,
        anchor_radius=40.0,
        fairlead_height=20.0,
        force=(-60e3, 0.0),
    )
    return Case(Site(20.0), line, None, 20.0, checks=checks or Checks(), system=system)


def by(*codes: str, allow_recalled: bool = False) -> Checks:
    return Checks(codes=codes, allow_recalled=allow_recalled)


def tensions(report: CheckReport, state: str) -> list[CheckResult]:
    return [e for e in report.results if e.kind == "tension" and e.place.state == state]


ALONE = {
    "break/5": 50.0 * 5.0 / 200.0,  # 1.25
    "IALA-CALMAR": 50.0 * 5.0 / 100.0,  # on the proof load: 2.5
    "UFC-4-159-03": 50.0 * 3.0 / 200.0,  # 0.75
    "LR-linkspans-2022": 50.0 * 2.0 / 200.0,  # 0.5
    "DNV-OS-E301-2008-CC1": 50.0 * 1.7 / (0.95 * 200.0),  # 0.447
    "DNV-OS-E301-2008-CC2": 50.0 * 2.5 / (0.95 * 200.0),  # 0.658
    "DNV-OS-E301-2008-CC1-SPM": 50.0 * 1.7 * 1.2 / (0.95 * 200.0),  # 0.537
    "DNV-OS-E301-2008-CC2-SPM": 50.0 * 2.5 * 1.2 / (0.95 * 200.0),  # 0.789
    "API-RP-2SK": 50.0 * 2.0 / 200.0,  # 0.5
    "ISO-19901-7": 50.0 * 2.0 / 200.0,  # 0.5
}


@pytest.mark.parametrize("code", ALONE)
def test_the_factor_of_each_code_on_a_line_at_rest(code: str) -> None:
    results = check_case(asking(checks=by(code, allow_recalled=True))).results
    (tension,) = [each for each in results if each.kind == "tension"]
    assert tension.utilisation == pytest.approx(ALONE[code], rel=CLOSE)


R3_34 = Case(
    site=Site(50.0),
    line=Line([Segment(600.0, 210.0, component="chain studless R3", nominal_diameter=0.034)]),
    load=Load(600e3),
    fairlead_height=50.0,
)
"""34 mm of R3: MBL = 0.0223 * 34^2 * (44 - 0.08 * 34) = 1064.15 kN. H = 600 kN, a = 2857 m;
sqrt(50 (50 + 5714)) = 537 m of 600 m hang, so that T = H + w h = 600 + 0.21 * 50 = 610.5 kN."""


@pytest.mark.parametrize(
    ("code", "shown", "before"),
    [("DNV-OS-E301-2008-CC1", 1.027, 0.975), ("API-RP-2SK", 1.147, 0.958)],
)
def test_what_passed_by_half_of_a_code_fails_by_all_of_it(
    code: str, shown: float, before: float
) -> None:
    """E301: 610.5 * 1.7 / (0.95 * 1064.15) = 1.027; without 0.95 it would be 0.975.

    API: 610.5 * 2.00 / 1064.15 = 1.147; by 1.67, which is for dynamic analysis, 0.958.
    """
    MBL = 0.0223 * 34.0**2 * (44.0 - 0.08 * 34.0)
    full, half = {
        "DNV-OS-E301-2008-CC1": (610.5 * 1.7 / (0.95 * MBL), 610.5 * 1.7 / MBL),
        "API-RP-2SK": (610.5 * 2.0 / MBL, 610.5 * 1.67 / MBL),
    }[code]
    assert (round(full, 3), round(half, 3)) == (shown, before)
    result = only(asking(R3_34, by(code)))
    assert result.utilisation == pytest.approx(full, rel=CLOSE)
    assert not result.passes


def test_what_went_into_the_capacity_says_the_part_of_the_strength() -> None:
    assert only(asking(checks=by("DNV-OS-E301-2008-CC1"))).note == "0.95 MBL 200 kN / 1.7"


def test_break_tests_take_the_place_of_a_part_of_the_mbl() -> None:
    """A mean of 210 kN, c = 0.05: 210 (1 - 0.05 (3 - 0.3)) = 210 * 0.865 = 181.65 kN.

    50 kN by 1.7: 50 * 1.7 / 181.65 = 0.468, beside 50 * 1.7 / 190 = 0.447 by 0.95 MBL; worn from
    100 to 90 mm, times 0.81.
    """
    tested = replace(PLAIN, MBL=None, MBL_mean=210e3, MBL_cov=0.05)
    case = asking(checks=by("DNV-OS-E301-2008-CC1"), line=Line([tested]))
    result = only(case)
    assert result.capacity == pytest.approx(181.65e3 / 1.7, rel=CLOSE)
    assert result.utilisation == pytest.approx(50.0 * 1.7 / 181.65, rel=CLOSE)
    assert "by break tests" in str(result.note)
    worn = only(replace(case, service=Service(life=10.0, wear_rate=1e-3)))
    assert worn.capacity == pytest.approx(0.81 * 181.65e3 / 1.7, rel=CLOSE)


def test_break_tests_that_no_code_takes_are_refused() -> None:
    tested = Line([replace(PLAIN, MBL_mean=210e3, MBL_cov=0.05)])
    with pytest.raises(InputError, match=r"line\.segments\[0\]\.MBL_mean: found 210000 N; leave"):
        check_case(asking(checks=by("API-RP-2SK"), line=tested))
    with pytest.raises(InputError, match="MBL_cov: missing; MBL_mean and MBL_cov go together"):
        replace(PLAIN, MBL_mean=210e3)
    with pytest.raises(InputError, match=r"MBL_cov: found 0\.3"):
        replace(PLAIN, MBL_mean=210e3, MBL_cov=0.3)


def test_factors_for_dynamic_analysis_are_on_no_tension_at_rest() -> None:
    for code in ALONE:
        case = asking(checks=by(code, allow_recalled=True))
        assert {each.analysis for each in criteria_of(case).all} == {"quasi-static"}
    dynamic = criteria_of(asking(checks=by("API-RP-2SK")), analysis="dynamic")
    assert [e.value for e in dynamic.of("tension", "extreme", "intact")] == [1.67]
    assert [e.value for e in dynamic.of("tension", "extreme", "transient")] == [1.05]


def test_a_factor_on_the_mean_and_one_on_what_is_dynamic() -> None:
    """E301, class 1: T_mean 60 and T_dyn 40 kN of 0.95 * 200 = 190 kN.

    1.10 * 60 + 1.50 * 40 = 126 kN, so that 100 * 190 / 126 = 150.79 kN of that kind are allowed;
    by D202 1.3 * 100 = 130 kN, 146.15 kN allowed. Class 2: 1.40 * 60 + 2.10 * 40 = 168 kN,
    113.10 kN. Single point moorings, D203: 1.2 times 126 and 168 kN.
    """
    strength = criteria_of(GROUNDED).strength(PLAIN)
    for code, expected in (
        ("DNV-OS-E301-2008-CC1", [100.0 * 190.0 / 126.0, 190.0 / 1.3]),
        ("DNV-OS-E301-2008-CC2", [100.0 * 190.0 / 168.0]),
        ("DNV-OS-E301-2008-CC1-SPM", [100.0 * 190.0 / (1.2 * 126.0)]),
        ("DNV-OS-E301-2008-CC2-SPM", [100.0 * 190.0 / (1.2 * 168.0)]),
        ("API-RP-2SK", [200.0 / 1.67]),
    ):
        criteria = criteria_of(asking(checks=by(code)), analysis="dynamic")
        allowed = [
            allowed_by(each, strength, "segment", 0.6) / 1e3
            for each in criteria.of("tension", "extreme")
        ]
        assert allowed == pytest.approx(expected, rel=CLOSE)


@pytest.mark.parametrize(
    ("code", "intact", "damaged"),
    [
        ("API-RP-2SK", 50.0 * 2.0 / 200.0, 80.0 * 1.43 / 200.0),  # 0.5, 0.572
        ("ISO-19901-7", 50.0 * 2.0 / 200.0, 80.0 * 1.43 / 200.0),
        ("DNV-OS-E301-2008-CC1", 50.0 * 1.7 / 190.0, 80.0 * 1.1 / 190.0),  # 0.447, 0.463
        ("DNV-OS-E301-2008-CC2", 50.0 * 2.5 / 190.0, 80.0 * 1.35 / 190.0),  # 0.658, 0.568
    ],
)
def test_each_state_by_its_own_factor(code: str, intact: float, damaged: float) -> None:
    report = check_case(body(checks=by(code, allow_recalled=True)))
    assert [e.place.line for e in tensions(report, "intact")] == [1, 2]
    assert [(e.place.line, e.place.missing) for e in tensions(report, "one_line_out")] == [
        (2, 1),
        (1, 2),
    ]
    for state, used in (("intact", intact), ("one_line_out", damaged)):
        for each in tensions(report, state):
            assert each.utilisation == pytest.approx(used, rel=SOLVED)
    assert report.used() == pytest.approx(intact, rel=SOLVED)
    assert report.used(missing=1, line=2) == pytest.approx(damaged, rel=SOLVED)
    assert report.used(missing=1, line=1) is None


def test_a_design_that_fails_with_one_line_out_fails() -> None:
    """MBL 105 kN by API: 50 * 2.00 / 105 = 0.952 intact, 80 * 1.43 / 105 = 1.090 with one out."""
    report = check_case(body(checks=by("API-RP-2SK"), MBL=105e3))
    assert all(each.passes for each in tensions(report, "intact"))
    assert not report.passes
    assert report.governing is not None
    assert report.governing.load_case == "line 1 out"
    assert report.governing.utilisation == pytest.approx(80.0 * 1.43 / 105.0, rel=SOLVED)


def test_the_numbers_of_the_case_hold_in_both_states() -> None:
    """50 * 2 / 200 = 0.5, 80 * 2 / 200 = 0.8; with a factor of its own 80 * 1.25 / 200 = 0.5."""
    same = check_case(body(checks=Checks(safety_factor=2.0)))
    own = check_case(body(checks=Checks(safety_factor=2.0, safety_factor_line_out=1.25)))
    for report, damaged in ((same, 0.8), (own, 0.5)):
        assert tensions(report, "intact")[0].utilisation == pytest.approx(0.5, rel=SOLVED)
        assert [e.utilisation for e in tensions(report, "one_line_out")] == pytest.approx(
            [damaged, damaged], rel=SOLVED
        )


def test_a_code_without_a_factor_for_one_line_out_judges_the_intact_body_and_says_so() -> None:
    alone = check_case(body(checks=by("break/5")))
    assert {each.place.state for each in alone.results} == {"intact"}
    assert any("no criterion for one line damaged" in each for each in alone.warnings)
    both = check_case(body(checks=by("break/5", "API-RP-2SK")))
    assert {e.source.code for e in tensions(both, "one_line_out")} == {"API-RP-2SK"}
    assert (
        "break/5 has no criterion for one line damaged: only the intact state is checked by it"
        in both.warnings
    )


def test_the_transient_state_is_not_judged_at_rest_and_that_is_said() -> None:
    """API RP 2SK has 1.18 and 1.05 for it; E301 has nothing."""
    by_both = by("API-RP-2SK", "DNV-OS-E301-2008-CC1")
    for case in (body(checks=by_both), asking(checks=by_both)):
        told = [str(e) for e in check_case(case).warnings if "the transient state" in e]
        assert len(told) == 1
        assert told[0].startswith("API-RP-2SK: the transient state, while a line parts, is not")
    assert not any("transient" in e for e in check_case(body(checks=by("break/5"))).warnings)


def test_a_body_that_cannot_do_without_its_line_fails_by_the_codes_for_that() -> None:
    """H = 60 kN on one line: T = 80 kN, 80 * 1.7 / 190 = 0.716 intact."""
    report = check_case(body(1, by("DNV-OS-E301-2008-CC1")))
    tension, lost = report.results
    assert tension.passes
    assert tension.utilisation == pytest.approx(80.0 * 1.7 / 190.0, rel=SOLVED)
    assert (lost.kind, lost.passes, lost.load_case) == ("equilibrium", False, "line 1 out")
    assert lost.note == "no line is left"
    assert (lost.demand, lost.capacity, lost.exceedance, lost.utilisation) == (1.0, 0.0, 1.0, None)
    assert (lost.place.state, lost.place.missing) == ("one_line_out", 1)
    assert report.governing == lost
    assert not any("has no criterion for one line damaged" in each for each in report.warnings)
    single = check_case(body(1, by("DNV-OS-E301-2008-CC1-SPM")))
    assert single.passes
    assert any("the body is moored by one line" in each for each in single.warnings)


def test_a_number_for_every_state_does_not_ask_a_body_to_lose_its_one_line() -> None:
    """80 * 2 / 200 = 0.8 intact; what a case asks in both states is no code for one line out."""
    report = check_case(body(1, Checks(safety_factor=2.0)))
    (tension,) = report.results
    assert tension.utilisation == pytest.approx(0.8, rel=SOLVED)
    assert tension.place.state == "intact"
    assert any("the body is moored by one line" in each for each in report.warnings)


def test_wear_anchor_span_and_buoyancy_of_every_line() -> None:
    """Worn from 100 to 90 mm the MBL is 200 * 0.81 = 162 kN: 50 * 2 / 162 and 80 * 2 / 162.

    A drag anchor of 90 kN with a factor of 1.2 holds 75 kN: 30 / 75 and 60 / 75. The lines pull
    down with V = 40 kN each, with one out with sqrt(80^2 - 60^2) = 52.915 kN.
    """
    case = replace(
        body(checks=Checks(safety_factor=2.0, max_span=60.0)),
        service=Service(life=10.0, wear_rate=1e-3),
        anchor=Anchor("drag", holding_capacity=90e3, safety_factor=1.2),
        buoy=Buoy(100e3),
    )
    report = check_case(case)
    used = {
        (each.kind, each.place.state): each.utilisation
        for each in report.results
        if each.utilisation is not None
    }
    assert used == pytest.approx(
        {
            ("tension", "intact"): 50.0 * 2.0 / 162.0,
            ("tension", "one_line_out"): 80.0 * 2.0 / 162.0,
            ("span", "intact"): (20.0 + 30.0 * math.log(3.0)) / 60.0,
            ("span", "one_line_out"): used["span", "one_line_out"],
            ("holding", "intact"): 0.4,
            ("holding", "one_line_out"): 0.8,
            ("buoyancy", "intact"): 0.8,
            ("buoyancy", "one_line_out"): math.sqrt(2800.0) / 100.0,
        },
        rel=1e-8,  # of the span: the force to SOLVED, and what it moves the fairlead
    )
    # Lying 60 - sqrt(2800) m, hanging 60 arcosh(1 + 20 / 60).
    out = 60.0 - math.sqrt(2800.0) + 60.0 * math.acosh(4.0 / 3.0)
    assert used["span", "one_line_out"] == pytest.approx(out / 60.0, rel=1e-8)
    uplift = [each for each in report.results if each.kind == "uplift_angle"]
    assert [each.passes for each in uplift] == [True] * 4


def test_a_factor_of_the_anchor_for_one_line_out() -> None:
    """90 kN with 1.5 intact and 1.2 with a line out: 30 * 1.5 / 90 and 60 * 1.2 / 90."""
    anchor = Anchor("drag", holding_capacity=90e3, safety_factor=1.5, safety_factor_line_out=1.2)
    case = replace(body(checks=Checks(safety_factor=2.0)), anchor=anchor)
    report = check_case(case)
    used = {e.place.state: e.utilisation for e in report.results if e.kind == "holding"}
    assert used == pytest.approx({"intact": 0.5, "one_line_out": 0.8}, rel=SOLVED)
    coded = replace(case, checks=by("UFC-4-159-03"), anchor=replace(anchor, safety_factor=None))
    held = [e for e in check_case(coded).results if e.kind == "holding"]
    assert next((e.place.state, e.source.code) for e in held) == ("intact", "UFC-4-159-03")
    assert {e.place.state for e in held[2:]} == {"one_line_out"}
    with pytest.raises(InputError, match=r"anchor\.safety_factor_line_out: found 1\.2; leave it"):
        asking(anchor=anchor)


def test_a_factor_of_the_anchor_is_cited_by_what_it_is_from() -> None:
    anchor = Anchor(
        "drag", holding_capacity=90e3, safety_factor=1.5, factor_source="UFC 4-159-03, table 3-7"
    )
    for told, wanted in ((anchor, "UFC 4-159-03, table 3-7"),
                         (replace(anchor, factor_source=""), "case file")):  # fmt: skip
        (held,) = [e for e in check_case(asking(anchor=told)).results if e.kind == "holding"]
        assert str(held.source.text) == wanted
    with pytest.raises(InputError, match="goes with safety_factor, which is missing"):
        replace(anchor, safety_factor=None)


def test_keys_that_a_body_cannot_keep_are_refused_as_those_of_a_line() -> None:
    with pytest.raises(InputError, match=r'checks\.codes\[0\]: found "NONSENSE"'):
        check_case(body(checks=by("NONSENSE")))
    with pytest.raises(InputError, match=r"line\.segments\[0\]\.MBL: missing"):
        check_case(body(checks=by("API-RP-2SK"), MBL=None))
    with pytest.raises(InputError, match=r"checks\.safety_factor_line_out: found 1\.5; leave it"):
        asking(checks=Checks(safety_factor_line_out=1.5))


def test_the_document_says_line_and_state() -> None:
    document = check_case(body(checks=by("API-RP-2SK"))).to_dict()
    jsonschema.Draft202012Validator(schemas.schema("catopt.check/1")).validate(document)
    keys = ("state", "line", "missing_line")
    assert [tuple(each[key] for key in keys) for each in document["load_cases"]] == [
        ("intact", 1, None),
        ("intact", 2, None),
        ("one_line_out", 2, 1),
        ("one_line_out", 1, 2),
    ]
    assert [tuple(each[key] for key in keys) for each in document["checks"]] == [
        tuple(each[key] for key in keys) for each in document["load_cases"]
    ]


# ------------------------------------------------------------------ what nobody checks


def test_an_anchor_that_is_pulled_up_unchecked_is_told() -> None:
    """At the anchor of LIFTED V = 22.5 kN, and the line rises at arctan 0.75 = 36.87 deg."""
    (told,) = [each for each in check_case(LIFTED).warnings if "pulls its anchor up" in each]
    assert "at 36.87 deg (22.500 kN)" in told
    sinker = Anchor("sinker", submerged_weight=1e6, friction=0.5, safety_factor=1.5)
    for quiet in (
        GROUNDED,
        asking(LIFTED, Checks(max_anchor_uplift_force=30e3)),
        asking(LIFTED, anchor=sinker),
        asking(LIFTED, by("IALA-CALMAR")),
    ):
        assert not any("anchor" in each and "deg" in each for each in check_case(quiet).warnings)


def test_a_drag_anchor_that_is_lifted_as_far_as_allowed_is_told() -> None:
    anchor = Anchor("drag", holding_capacity=1e6, safety_factor=1.5)
    allowed = asking(LIFTED, Checks(max_anchor_uplift_angle=0.7), anchor=anchor)
    (told,) = [each for each in check_case(allowed).warnings if "drag anchor" in each]
    assert "at 36.87 deg (22.500 kN)" in told


def test_the_old_name_of_the_largest_span_is_read_with_a_warning() -> None:
    old, new = asking(checks=Checks(max_offset=60.0)), asking(checks=Checks(max_span=60.0))
    assert check_case(old).results == check_case(new).results
    assert only(new).kind == "span"
    (told,) = set(check_case(old).warnings) - set(check_case(new).warnings)
    assert told.startswith("max_offset = 60 m limits the span")
    with pytest.raises(
        InputError, match=r"max_offset: found 60 m; leave it out, max_span is given"
    ):
        Checks(max_offset=60.0, max_span=50.0)
