"""Each number of a profile against the row it was read from, and how profiles are asked for."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt import catalogue
from catopt.checks.case import check_case
from catopt.checks.criteria import criteria_of
from catopt.checks.profiles import parse_profiles, profiles
from catopt.errors import InputError
from catopt.model import Anchor, Checks, LoadCase, Segment

from .lines import CLOSE, GROUNDED, PLAIN, asking

PRINTED = {
    # S3: [T] = T_break / 5.
    "break/5": [("tension", "MBL", 5.0, "A")],
    # CALMAR technical reference: 8.1.6 proof load over largest tension "ought to be > 5";
    # the line just tangent at the sinker at the largest load; 6.2.6 "IALA recommended" 1.5.
    "IALA-CALMAR": [
        ("tension", "proof_load", 5.0, "A"),
        ("uplift_angle", "", 0.0, "A"),
        ("sliding", "", 1.5, "A"),
    ],
    # UFC 4-159-03 (2005), Table 3-7: chain straight 3.0, wire 3.0, synthetic 3.0, high-efficiency
    # drag anchors 2.0. Table 3-18: one shot (27.4 m) on the bottom, load kept horizontal.
    "UFC-4-159-03": [
        ("tension", "MBL", 3.0, "A"),
        ("holding", "", 2.0, "A"),
        ("grounded_length", "", 27.4, "A"),
        ("uplift_angle", "", 0.0, "A"),
    ],
    # Table 7.6.1: chain and rope 3.0 normal, 2.0 extreme.
    "LR-linkspans-2022": [("tension", "MBL", 3.0, "A"), ("tension", "MBL", 2.0, "A")],
    # DTOcean examples/fairhead.py, lines 111 and 112: ULS 1.7.
    "DNV-OS-E301-qs-CC1": [("tension", "MBL", 1.7, "C")],
    # Cited in several repositories: intact 1.67; gravity anchors 1.6 lateral, permanent, intact.
    "API-RP-2SK": [("tension", "MBL", 1.67, "C"), ("sliding", "", 1.6, "B")],
    "API-RP-2SK-qs": [("tension", "MBL", 2.0, "R")],
    "DNV-OS-E301-qs-CC2": [("tension", "MBL", 2.5, "R")],
}


@pytest.mark.parametrize("name", PRINTED)
def test_the_printed_numbers(name: str) -> None:
    (found,) = [each for each in profiles() if each.name == name]
    criteria = [(c.check, c.of, c.value, c.source.confidence) for c in found.criteria]
    assert criteria == PRINTED[name]
    assert all(
        c.source.code == name and c.source.document and c.source.clause for c in found.criteria
    )
    assert found.title
    assert found.note


def test_there_are_no_others() -> None:
    assert [each.name for each in profiles()] == list(PRINTED)


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
    (problem,) = refused("DNV-OS-E301-qs-CC2")
    assert "checks.allow_recalled = true" in problem[2]
    report = check_case(asking(checks=asks("DNV-OS-E301-qs-CC2", allow_recalled=True)))
    (result,) = report.results
    assert result.source.text.endswith("[R]")
    # 50 kN beside 200 / 2.5 = 80 kN.
    assert result.utilisation == pytest.approx(0.625, rel=CLOSE)
    assert report.warnings == ("DNV-OS-E301-qs-CC2: recalled, read in no document",)


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
        "no criterion is on the tension of segment 1 (wire spiral-strand 100 mm)"
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
states = ["storm"]
"""
    with pytest.raises(InputError) as caught:
        parse_profiles(text, "mine")
    assert {each.key for each in caught.value.problems} == {
        "profile[0].criterion[0].check",
        "profile[0].criterion[0].value",
        "profile[0].criterion[0].confidence",
        "profile[0].criterion[1].of",
        "profile[0].criterion[1].states",
    }


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
    """The table of docs/checks.md, row by row: profile, check, number, confidence."""
    page = (Path(__file__).parents[2] / "docs" / "checks.md").read_text("utf-8")
    table = page.partition("| profile | document |")[2].partition("\n\n")[0]
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines()[2:]]
    found: dict[str, list[tuple[str, str, float, str]]] = {}
    for name, _, check, number, _, confidence in rows:
        if name:
            current = found.setdefault(name.strip("`"), [])
        what = check.partition(",")[0]
        of = {"on MBL": "MBL", "on proof load": "proof_load"}.get(what.partition(" ")[2], "")
        kind = "tension" if of else what.replace(" ", "_")
        current.append((kind, of, float(number.removesuffix(" m")), confidence))
    assert found == PRINTED
