"""Several criteria of one kind: the strictest holds, for its own load case, state and line."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catopt import solve_case
from catopt.checks.case import check_case, is_of_load
from catopt.checks.criteria import SEARCHED, Criteria, Limits, allowed_by, criteria_of
from catopt.checks.evaluation import Lifted, evaluate, in_load_case, of_uplift
from catopt.checks.kinds import CheckKind, CheckSource, Criterion, Place
from catopt.checks.result import CheckReport, CheckResult
from catopt.errors import FloatsUpError, InputError
from catopt.model import Anchor, CatalogueChoice, Checks, Line, LoadCase, PointLoad
from catopt.words import Message, say

from .lines import CLOSE, GROUNDED, LIFTED, PLAIN, asking

SOURCE = CheckSource("code")


def keeping(*asked: Criterion) -> Criteria:
    return Criteria(asked, None, CatalogueChoice())


def limit(check: CheckKind, value: float) -> Criterion:
    return Criterion(check, value, SOURCE)


STRICT: dict[CheckKind, tuple[float, float]] = {
    "uplift_angle": (0.1, 0.2),
    "uplift_force": (1e3, 2e3),
    "grounded_length": (30.0, 20.0),
    "span": (50.0, 60.0),
    "buoyancy": (40e3, 50e3),
    "sliding": (1.6, 1.5),
    "holding": (2.0, 1.5),
    "least_tension": (20e3, 10e3),
}
"""Of each check the stricter of two numbers, first: a ceiling is strict where it is low, a length
on the bed, a least tension and a factor where they are high."""


@pytest.mark.parametrize("first", [0, 1])
def test_of_two_limits_the_stricter_counts_whichever_comes_first(first: int) -> None:
    assert set(STRICT) == set(SEARCHED) - {"tension", "equilibrium"}
    asked = [
        limit(check, values[first if index == 0 else 1 - first])
        for index in (0, 1)
        for check, values in STRICT.items()
    ]
    strictest = [values[0] for values in STRICT.values()]
    assert list(keeping(*asked).limits("extreme")) == strictest


def test_a_search_is_refused_under_a_check_that_it_does_not_keep() -> None:
    asked = [limit("span", 50.0), limit("new", 1.0)]  # type: ignore[arg-type]
    with pytest.raises(
        InputError, match="checks: new: found required by code; the search does not apply"
    ):
        keeping(*asked).limits("extreme")


def test_a_limit_of_another_state_or_load_case_does_not_count() -> None:
    span = limit("span", 50.0)
    asked = keeping(replace(span, kinds=("reference",), states=("one_line_out",)))
    assert asked.limits("extreme", "one_line_out") == Limits()
    assert asked.limits("reference", "intact") == Limits()
    assert asked.limits("reference", "one_line_out").span == 50.0


def test_the_factor_of_two_codes_on_a_sinker_is_the_larger() -> None:
    """CALMAR has 1.5 and API RP 2SK 1.6: 1.6 x 30/0.6 = 80 kN, and 75 kN."""
    anchor = Anchor("sinker", submerged_weight=100e3, friction=0.6)
    criteria = criteria_of(
        asking(checks=Checks(codes=("IALA-CALMAR", "API-RP-2SK")), anchor=anchor)
    )
    assert criteria.limits("extreme").sliding_factor == 1.6
    assert criteria.limits("extreme", "one_line_out").sliding_factor == 1.2


def test_the_length_on_the_bed_is_the_longer_of_the_code_s_and_the_case_s() -> None:
    """UFC: one shot, 27.4 m."""
    for own, wanted in ((30.0, 30.0), (20.0, 27.4)):
        checks = Checks(codes=("UFC-4-159-03",), min_grounded_length=own)
        assert criteria_of(asking(checks=checks)).limits("extreme").grounded_length == wanted


def test_of_factors_alike_the_first_is_named() -> None:
    """The case's own 2.0 comes before that of Lloyd's."""
    checks = Checks(safety_factor=2.0, codes=("LR-linkspans-2022",))
    allowed = criteria_of(asking(checks=checks)).allowed_tension(PLAIN, "extreme")
    assert allowed.tension == 100e3
    assert allowed.criterion is not None
    assert allowed.criterion.source.code == "user"


def test_at_rest_the_whole_tension_is_its_mean() -> None:
    """E301, class 1, dynamic, on a line at rest: 1.10 on all of 50 kN; D202 has 1.3 on it.

    Of 0.95 x 200 = 190 kN 190/1.10 = 172.7 kN and 190/1.3 = 146.2 kN are allowed.
    """
    case = asking(checks=Checks(codes=("DNV-OS-E301-2008-CC1",)))
    criteria = criteria_of(case, analysis="dynamic")
    strength = criteria.strength(PLAIN)
    by_hand = [190e3 / 1.1, 190e3 / 1.3]
    allowed = [allowed_by(e, strength, "segment") for e in criteria.of("tension", "extreme")]
    assert allowed == pytest.approx(by_hand, rel=CLOSE)
    solution = solve_case(GROUNDED)
    results = evaluate(solution, criteria, [strength], None, load_case="load", kind="extreme")
    assert [each.capacity for each in results] == pytest.approx(by_hand, rel=CLOSE)


# ------------------------------------------------------------------ what is missing


def test_every_strength_that_is_missing_is_told_for_the_load_cases_there_are() -> None:
    """Lloyd's wants the MBL in every load case, and IALA the proof load."""
    bare = Line([replace(PLAIN, MBL=None, proof_load=None)])
    for codes, keys in (
        (("LR-linkspans-2022",), ["MBL"]),
        (("LR-linkspans-2022", "IALA-CALMAR"), ["MBL", "proof_load"]),
    ):
        criteria = criteria_of(asking(checks=Checks(codes=codes)))
        with pytest.raises(InputError) as caught:
            criteria.strengths(bare, {"extreme"})
        found = [each.key for each in caught.value.problems]
        assert found == [f"line.segments[0].{key}" for key in keys]


def test_a_strength_that_no_load_case_asks_for_may_be_missing() -> None:
    """A factor for one line out, for another load case or for another kind of line."""
    bare = Line([replace(PLAIN, MBL=None)])
    factor = Criterion("tension", 2.0, SOURCE, of="MBL")
    for asked in (
        replace(factor, states=("one_line_out",)),
        replace(factor, kinds=("reference",)),
        replace(factor, lines=("chain",)),
    ):
        line = Line([replace(bare.segments[0], component="polyester", nominal_diameter=0.14)])
        known = bare if asked.lines != ("chain",) else line
        assert len(keeping(asked).strengths(known, {"extreme"}, {"intact"})) == 1
    with pytest.raises(InputError, match=r"line\.segments\[0\]\.MBL: missing"):
        keeping(factor).strengths(bare, {"extreme"}, {"intact"})


# ------------------------------------------------------------------ what is said of a load case


def test_what_is_said_of_the_load_alone_is_told_from_the_rest() -> None:
    assert is_of_load(in_load_case("load", said="x"))
    assert not is_of_load(in_load_case("storm", said="x"))
    assert not is_of_load("x")
    assert not is_of_load(Message("checks.none"))


def test_a_buoy_that_would_float_up_is_refused_by_the_name_of_its_load_case() -> None:
    """A lift of 150 kN at 20 m of a line whose other forces are 30 kN and 60 kN of weight."""
    line = Line([PLAIN], [PointLoad(40.0, -150e3, name="float")])
    case = asking(line=line, load=None, load_cases=(LoadCase("storm", 30e3),))
    with pytest.raises(FloatsUpError, match=r'^load case "storm": the buoy .*would float'):
        check_case(case)


def test_no_result_has_no_place_among_the_results() -> None:
    nothing = CheckReport("", (), ())
    assert nothing.brief.governing is None
    assert nothing.in_motion.to_dict()["governing"] is None
    assert nothing.in_motion.to_dict()["passes"] is None
    result = CheckResult("tension", "tension", "load", 50e3, 40e3, "N", 0.25, SOURCE)
    verdict = CheckReport("", (result,), ()).brief.to_dict()
    assert (verdict["checks"], verdict["failed"], verdict["passes"]) == (1, 1, False)
    assert verdict["governing"]["excess"] == 0.25
    moved = CheckReport("", (replace(result, exceedance=-0.1), result), ()).in_motion.to_dict()
    assert (moved["passes"], moved["governing"]) == (False, 1)


def test_a_case_without_load_cases_is_at_its_own_water_level() -> None:
    (alone,) = check_case(GROUNDED).to_dict()["load_cases"]
    assert (alone["water_level_m"], alone["kind"]) == (0.0, "extreme")
    tide = (LoadCase("tide", 10e3, 5.0, "reference"),)
    (other,) = check_case(asking(load_cases=tide, load=None)).to_dict()["load_cases"]
    assert (other["water_level_m"], other["kind"]) == (5.0, "reference")


@pytest.mark.parametrize(("exceedance", "passes"), [(1e-9, True), (1.001e-9, False), (0.0, True)])
def test_what_rounding_may_add_passes_and_no_more(exceedance: float, passes: bool) -> None:
    """At most 1e-9 of the limit."""
    result = CheckResult("span", "span", "load", 1.0 + exceedance, 1.0, "m", exceedance, SOURCE)
    assert result.passes is passes


def test_of_failures_alike_but_for_rounding_the_first_is_the_worst() -> None:
    """Half of the limit over it, and 2e-10 more."""
    made = [
        CheckResult("span", "span", f"case {k}", 1.5, 1.0, "m", exceedance, SOURCE)
        for k, exceedance in enumerate((0.5, 0.5 + 2e-10, 0.6))
    ]
    failed = CheckReport("", tuple(made), ()).failed
    assert [each.load_case for each in failed] == ["case 2", "case 0", "case 1"]


def test_a_limit_of_nothing_that_is_kept_governs_only_where_it_is_alone() -> None:
    """No uplift has no utilisation; a span at a twentieth of its limit has one."""
    uplift = CheckResult("uplift", "uplift_angle", "load", 0.0, 0.0, "rad", 0.0, SOURCE)
    span = CheckResult("span", "span", "load", 5.0, 100.0, "m", -0.95, SOURCE)
    assert CheckReport("", (uplift, span), ()).governing == span
    assert CheckReport("", (uplift,), ()).governing == uplift


def test_a_line_of_a_body_is_told_by_its_number() -> None:
    alone = CheckResult("span", "span", "storm", 1.0, 1.0, "m", 0.0, SOURCE)
    assert str(alone.where) == "storm"
    of_body = replace(alone, load_case="intact", place=Place(line=2))
    assert str(of_body.where) == "line 2, intact"
    assert str(of_body.in_case) == "span (line 2, intact)"


@pytest.mark.parametrize("kind", ["span", "tension"])
def test_the_tightest_of_a_kind_is_of_that_kind(kind: CheckKind) -> None:
    """Span 0.2 and 0.3 beyond, tension 0.9 and 0.8 within: each kind has its own."""
    exceedances: dict[CheckKind, tuple[float, float]] = {
        "span": (0.2, 0.3),
        "tension": (-0.9, -0.8),
    }
    results = tuple(
        CheckResult(name, name, f"case {k}", 1.0, 1.0, "", exceedance, SOURCE)
        for name, pair in exceedances.items()
        for k, exceedance in enumerate(pair)
    )
    found = CheckReport("", results, ()).tightest(kind)
    assert found is not None
    assert (found.kind, found.exceedance) == (kind, exceedances[kind][1])
    assert CheckReport("", results, ()).tightest("sliding") is None


def test_the_largest_utilisation_is_that_of_tensions_alone() -> None:
    """A span at 2.0 of its limit is no tension."""
    results = (
        CheckResult("t", "tension", "a", 50.0, 100.0, "N", -0.5, SOURCE),
        CheckResult("t", "tension", "b", 70.0, 100.0, "N", -0.3, SOURCE),
        CheckResult("s", "span", "a", 200.0, 100.0, "m", 1.0, SOURCE),
    )
    assert CheckReport("", results, ()).used() == 0.7
    assert CheckReport("", results[2:], ()).used() is None
    assert CheckReport("", results, ()).used(missing=1) is None


@pytest.mark.parametrize(("angle", "told"), [(0.0, 0), (1e-10, 0), (1e-6, 1)])
def test_an_anchor_that_is_lifted_by_rounding_is_not_told(angle: float, told: int) -> None:
    """In rad; solving a line leaves less than 1e-9."""
    solution = solve_case(LIFTED)
    at_anchor = replace(solution, anchor=replace(solution.anchor, angle=angle))
    lifted = Lifted("here", "intact", "extreme", at_anchor)
    assert len(list(of_uplift([lifted], keeping(), None))) == told


def test_of_two_lifted_lines_the_steeper_that_nothing_checks_is_told() -> None:
    """With a limit on the uplift of the intact mooring alone, the one with a line out counts."""
    solution = solve_case(LIFTED)
    flat, steep = (
        replace(solution, anchor=replace(solution.anchor, angle=angle)) for angle in (0.1, 0.2)
    )
    criteria = keeping(replace(limit("uplift_angle", 0.5), states=("intact",)))
    lines = (
        Lifted("whole", "intact", "extreme", steep),
        Lifted("damaged", "one_line_out", "extreme", flat),
    )
    (told,) = of_uplift(lines, criteria, None)
    assert told.key == "checks.uplift_unchecked"
    assert told.values["where"] == "damaged"
    (worst,) = of_uplift(lines, keeping(), None)
    assert worst.values["where"] == "whole"
    assert list(of_uplift(lines[:1], criteria, None)) == []


@pytest.mark.parametrize("check", [each for each in SEARCHED if each != "equilibrium"])
def test_a_front_can_say_that_it_ends_at_a_check(check: CheckKind) -> None:
    assert "storm" in say(Message(f"design.stop_{check}", load_case="storm"), "vi")
