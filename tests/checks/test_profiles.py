"""Each number of a profile against the row it was read from, and how profiles are asked for."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt import catalogue
from catopt.checks.case import check_case
from catopt.checks.criteria import criteria_of
from catopt.checks.kinds import Criterion
from catopt.checks.profiles import parse_profiles, profiles
from catopt.errors import InputError
from catopt.model import Anchor, Checks, LoadCase, Segment

from .lines import CLOSE, GROUNDED, PLAIN, asking

Row = tuple[str, str, float, str, str, str]


def tension(value: float, state: str, confidence: str, analysis: str = "quasi-static") -> Row:
    """Row of a factor on the MBL."""
    return "tension", "MBL", value, state, analysis, confidence


def other(check: str, value: float, confidence: str, state: str = "intact") -> Row:
    """Row of what is no tension."""
    return check, "", value, state, "", confidence


INTACT, OUT, TRANSIENT = "intact", "one_line_out", "transient"

PRINTED: dict[str, list[Row]] = {
    # S3: [T] = T_break / 5.
    "break/5": [tension(5.0, INTACT, "A")],
    # CALMAR technical reference: 8.1.6 proof load over largest tension "ought to be > 5";
    # the line just tangent at the sinker at the largest load; 6.2.6 "IALA recommended" 1.5.
    "IALA-CALMAR": [
        ("tension", "proof_load", 5.0, INTACT, "quasi-static", "A"),
        other("uplift_angle", 0.0, "A"),
        other("sliding", 1.5, "A"),
    ],
    # UFC 4-159-03 (2005), Table 3-7: chain straight 3.0, wire 3.0, synthetic 3.0, high-efficiency
    # drag anchors 2.0. Table 3-18: one shot (27.4 m) on the bottom, load kept horizontal.
    "UFC-4-159-03": [
        tension(3.0, INTACT, "A"),
        other("holding", 2.0, "A"),
        other("grounded_length", 27.4, "A"),
        other("uplift_angle", 0.0, "A"),
    ],
    # Table 7.6.1: chain and rope 3.0 normal, 2.0 extreme.
    "LR-linkspans-2022": [tension(3.0, INTACT, "A"), tension(2.0, INTACT, "A")],
    # DNV-OS-E301, October 2008, Table D1 (ULS) and D2 (ALS), class 1: quasi-static 1.70 and 1.10,
    # dynamic 1.10 on the mean and 1.50 on what is dynamic, 1.00 and 1.10.
    "DNV-OS-E301-2008-CC1": [
        tension(1.7, INTACT, "B"),
        tension(1.1, OUT, "B"),
        tension(1.5, INTACT, "B", "dynamic"),
        tension(1.3, INTACT, "C", "dynamic"),  # D202
        tension(1.1, OUT, "B", "dynamic"),
    ],
    # Class 2: quasi-static 2.50 and 1.35, dynamic 1.40 and 2.10, 1.00 and 1.25.
    "DNV-OS-E301-2008-CC2": [
        tension(2.5, INTACT, "B"),
        tension(1.35, OUT, "C"),
        tension(2.1, INTACT, "B", "dynamic"),
        tension(1.25, OUT, "B", "dynamic"),
    ],
    # D203: 1.2 times 1.70 and 2.50, and times 1.50 and 2.10.
    "DNV-OS-E301-2008-CC1-SPM": [
        tension(2.04, INTACT, "C"),
        tension(1.8, INTACT, "C", "dynamic"),
    ],
    "DNV-OS-E301-2008-CC2-SPM": [
        tension(3.0, INTACT, "C"),
        tension(2.52, INTACT, "C", "dynamic"),
    ],
    # API RP 2SK, 3rd edition (2005): 2.00/1.67 intact, 1.43/1.25 damaged, 1.18/1.05 transient;
    # gravity anchors, permanent, lateral: 1.6 intact, 1.2 damaged.
    "API-RP-2SK": [
        tension(2.0, INTACT, "B"),
        tension(1.67, INTACT, "B", "dynamic"),
        tension(1.43, OUT, "C"),
        tension(1.25, OUT, "B", "dynamic"),
        tension(1.18, TRANSIENT, "C"),
        tension(1.05, TRANSIENT, "C", "dynamic"),
        other("sliding", 1.6, "B"),
        other("sliding", 1.2, "B", OUT),
    ],
    "ISO-19901-7": [
        tension(2.0, INTACT, "R"),
        tension(1.67, INTACT, "R", "dynamic"),
        tension(1.43, OUT, "R"),
        tension(1.25, OUT, "R", "dynamic"),
    ],
}

MEAN_FACTORS = {
    "DNV-OS-E301-2008-CC1": {INTACT: 1.1, OUT: 1.0},
    "DNV-OS-E301-2008-CC2": {INTACT: 1.4, OUT: 1.0},
    "DNV-OS-E301-2008-CC1-SPM": {INTACT: 1.32},
    "DNV-OS-E301-2008-CC2-SPM": {INTACT: 1.68},
}
"""E301, Tables D1 and D2: gamma_mean of dynamic analysis; no other code splits the tension."""


@pytest.mark.parametrize("name", PRINTED)
def test_the_printed_numbers(name: str) -> None:
    (found,) = [each for each in profiles() if each.name == name]
    assert [row_of(criterion) for criterion in found.criteria] == PRINTED[name]
    assert all(
        c.source.code == name and c.source.document and c.source.clause for c in found.criteria
    )
    assert found.title
    assert found.note


def row_of(criterion: Criterion) -> Row:
    (state,) = criterion.states
    analysis = criterion.analysis if criterion.of else ""
    confidence = criterion.source.confidence
    assert confidence is not None
    return criterion.check, criterion.of, criterion.value, state, analysis, confidence


@pytest.mark.parametrize("name", PRINTED)
def test_the_strength_and_the_factors_on_the_mean(name: str) -> None:
    """S_C is 0.95 MBS in E301, and the MBL itself in every other code."""
    (found,) = [each for each in profiles() if each.name == name]
    tensions = [each for each in found.criteria if each.check == "tension"]
    assert {each.part for each in tensions} == {0.95 if "E301" in name else 1.0}
    split = {e.states[0]: e.mean_factor for e in tensions if e.mean_factor is not None}
    assert split == MEAN_FACTORS.get(name, {})
    assert all(e.analysis == "dynamic" for e in tensions if e.mean_factor is not None)


def test_there_are_no_others() -> None:
    assert [each.name for each in profiles()] == list(PRINTED)


@pytest.mark.parametrize(
    ("before", "now"),
    [
        ("API-RP-2SK-qs", "API-RP-2SK"),
        ("DNV-OS-E301-qs-CC1", "DNV-OS-E301-2008-CC1"),
        ("DNV-OS-E301-qs-CC2", "DNV-OS-E301-2008-CC2"),
    ],
)
def test_names_that_profiles_had_before_are_read(before: str, now: str) -> None:
    (result,) = check_case(asking(checks=asks(before))).results
    assert result.source.code == now


def asks(*codes: str, allow_recalled: bool = False) -> Checks:
    return Checks(codes=codes, allow_recalled=allow_recalled)


def refused(*codes: str) -> list[tuple[str, str, str]]:
    with pytest.raises(InputError) as caught:
        check_case(asking(checks=asks(*codes)))
    return [(each.key, each.found, each.allowed) for each in caught.value.problems]


def test_unknown_names_are_told_all_at_once_with_the_nearest() -> None:
    first, second, third = refused("UFC-4-159-3", "IALA", "nothing like it")
    assert first[:2] == ("checks.codes[0]", '"UFC-4-159-3"')
    assert first[2].startswith("did you mean UFC-4-159-03? there are break/5, IALA-CALMAR")
    assert second[2].startswith("did you mean IALA-CALMAR?")
    assert third[2].startswith("there are break/5")


def test_capitals_do_not_matter() -> None:
    found = criteria_of(asking(checks=asks("iala-calmar")))
    assert {each.source.code for each in found.all} == {"IALA-CALMAR"}


def test_a_profile_named_twice_counts_once() -> None:
    assert len(criteria_of(asking(checks=asks("break/5", "BREAK/5"))).all) == 1


def test_recalled_profiles_are_off_unless_allowed_and_marked_where_they_are() -> None:
    (problem,) = refused("ISO-19901-7")
    assert "checks.allow_recalled = true" in problem[2]
    report = check_case(asking(checks=asks("ISO-19901-7", allow_recalled=True)))
    (result,) = report.results
    assert result.source.text.endswith("[R]")
    # 50 kN beside 200 / 2.0 = 100 kN.
    assert result.utilisation == pytest.approx(0.5, rel=CLOSE)
    assert report.warnings == (
        "ISO-19901-7: recalled, read in no document: its line factors equal those of API RP 2SK",
        "ISO-19901-7: the criteria for one line damaged do not apply to a single line; give all "
        "lines as [system]",
    )


def test_normal_and_extreme_factors_go_by_the_kind_of_load_case() -> None:
    """Lloyd's linkspans: 50 kN beside 200 / 2 = 100 kN extreme, 200 / 3 = 66.7 kN normal."""
    states = (LoadCase("storm", 30e3), LoadCase("day", 30e3, kind="reference"))
    extreme, normal = check_case(
        asking(checks=asks("LR-linkspans-2022"), load_cases=states, load=None)
    ).results
    assert (extreme.load_case, normal.load_case) == ("storm", "day")
    assert extreme.utilisation == pytest.approx(0.5, rel=CLOSE)
    assert normal.utilisation == pytest.approx(0.75, rel=CLOSE)
    assert normal.source.clause.endswith("normal")


def test_iala_is_for_chain() -> None:
    """A wire is not measured by its proof load; that nothing covers it is said."""
    wire = Segment(60.0, 1000.0, MBL=200e3, component="wire spiral-strand", nominal_diameter=0.1)
    report = check_case(asking(checks=asks("IALA-CALMAR"), line=type(GROUNDED.line)([wire])))
    assert [result.kind for result in report.results] == ["uplift_angle"]
    assert report.warnings[1] == (
        "no criterion limits the tension of segment 1 (wire spiral-strand 100 mm)"
    )


def test_a_line_of_unknown_kind_has_to_meet_what_is_for_any() -> None:
    report = check_case(asking(checks=asks("IALA-CALMAR")))
    assert [result.kind for result in report.results] == ["tension", "uplift_angle"]


@pytest.mark.parametrize(
    ("family", "ratio"), [("chain stud-link U3", 7.07), ("chain open-link 3D Q3", 10.0)]
)
def test_five_on_the_proof_load_is_seven_or_ten_on_the_breaking_load(
    family: str, ratio: float
) -> None:
    """CALMAR 7.2: break over proof load is 1.414 of stud-link and 2.0 of open-link chain.

    The catalogue's loads of stud-link chain are fits that stand in a ratio of 1.4283.
    """
    chain = catalogue.component(family, 0.04)
    assert chain.MBL is not None
    segment = chain.segment(1.0)
    criteria = criteria_of(asking(checks=asks("IALA-CALMAR")))
    own = Segment(
        1.0, segment.submerged_weight, component=family, nominal_diameter=0.04, MBL=chain.MBL
    )
    allowed = criteria.allowed_tension(own, "extreme").tension
    assert chain.MBL / allowed == pytest.approx(ratio, rel=0.011)


def test_the_high_efficiency_factor_is_the_default_and_the_case_may_have_its_own() -> None:
    """UFC: 100 kN / 2.0 = 50 kN; 1.5 for a stockless anchor gives 66.7 kN."""
    anchor = Anchor("drag", holding_capacity=100e3)
    stockless = Anchor("drag", holding_capacity=100e3, safety_factor=1.5)
    for each, capacity in ((anchor, 50e3), (stockless, 100e3 / 1.5)):
        results = check_case(asking(checks=asks("UFC-4-159-03"), anchor=each)).results
        (holding,) = [result for result in results if result.kind == "holding"]
        assert holding.capacity == pytest.approx(capacity, rel=CLOSE)


def test_a_sinker_takes_the_factor_of_the_code() -> None:
    """IALA: 0 + 1.5 * 30 / 0.6 = 75 kN needed."""
    anchor = Anchor("sinker", submerged_weight=100e3, friction=0.6)
    results = check_case(asking(checks=asks("IALA-CALMAR"), anchor=anchor)).results
    assert results[-1].demand == pytest.approx(75e3, rel=CLOSE)


def test_the_user_s_factor_is_one_more_criterion() -> None:
    report = check_case(asking(checks=Checks(codes=("break/5",), safety_factor=6.0)))
    assert [result.source.code for result in report.results] == ["user", "break/5"]
    assert [result.passes for result in report.results] == [False, False]
    assert report.governing == report.results[0]


def test_wrong_files_are_told_by_key() -> None:
    text = """
schema = "catopt.profiles/1"
[[profile]]
name = "x"
title = "x"
document = "x"
[[profile.criterion]]
check = "tensoin"
value = "5"
clause = "x"
confidence = "D"
[[profile.criterion]]
check = "sliding"
of = "MBL"
value = 1.5
clause = "x"
confidence = "A"
kinds = ["storm"]
part = 0.95
"""
    with pytest.raises(InputError) as caught:
        parse_profiles(text, "mine")
    assert {each.key for each in caught.value.problems} == {
        "profile[0].criterion[0].check",
        "profile[0].criterion[0].value",
        "profile[0].criterion[0].confidence",
        "profile[0].criterion[1].of",
        "profile[0].criterion[1].kinds",
        "profile[0].criterion[1].part",
    }


def test_all_that_a_file_of_profiles_may_say_of_a_criterion_is_read() -> None:
    text = """
schema = "catopt.profiles/1"
[[profile]]
name = "x"
title = "x"
document = "y"
edition = "2001"
[[profile.criterion]]
check = "tension"
of = "MBL"
value = 1.5
part = 0.05
mean_factor = 0.05
analysis = "dynamic"
lines = ["wire", "chain"]
kinds = ["extreme", "reference"]
states = ["transient", "one_line_out", "intact"]
clause = "z"
confidence = "A"
"""
    (profile,) = parse_profiles(text)
    (found,) = profile.criteria
    assert (found.value, found.part, found.mean_factor) == (1.5, 0.05, 0.05)
    assert (found.analysis, found.lines) == ("dynamic", ("chain", "wire"))
    assert found.kinds == ("extreme", "reference")
    assert found.states == ("intact", "one_line_out", "transient")
    assert found.source.text == "y (2001), z [A]"


def test_a_strength_that_is_missing_is_told_with_the_way_out() -> None:
    bare = Segment(30.0, 1000.0)
    case = asking(
        checks=Checks(codes=("IALA-CALMAR",), safety_factor=2.0),
        line=type(GROUNDED.line)([bare, PLAIN, bare]),
    )
    with pytest.raises(InputError) as caught:
        check_case(case)
    assert [(each.key, each.allowed.rpartition(" (")[2]) for each in caught.value.problems] == [
        ("line.segments[0].MBL", "safety_factor needs it)"),
        ("line.segments[0].proof_load", "IALA-CALMAR needs it)"),
        ("line.segments[2].MBL", "safety_factor needs it)"),
        ("line.segments[2].proof_load", "IALA-CALMAR needs it)"),
    ]
    assert "component of the catalogue" in caught.value.problems[0].allowed


def test_the_page_has_every_criterion_as_it_is() -> None:
    """The table of docs/checks.md, row by row: profile, check, number, state, analysis, grade."""
    page = (Path(__file__).parents[2] / "docs" / "checks.md").read_text("utf-8")
    table = page.partition("| profile | document |")[2].partition("\n\n")[0]
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines()[2:]]
    found: dict[str, list[Row]] = {}
    for name, _, check, number, state, analysis, _, confidence in rows:
        if name:
            current = found.setdefault(name.strip("`"), [])
        what = check.partition(",")[0]
        of = {"on MBL": "MBL", "on 0.95 MBL": "MBL", "on proof load": "proof_load"}.get(
            what.partition(" ")[2], ""
        )
        kind = "tension" if of else what.replace(" ", "_")
        value = float(number.rpartition(" and ")[2].removesuffix(" m"))
        current.append((kind, of, value, state.replace(" ", "_"), analysis, confidence))
    assert found == PRINTED
