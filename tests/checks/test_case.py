"""Whole cases: what governs, what is warned of, what stops a check."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import product

import jsonschema
import pytest

from catopt import check_case, schemas
from catopt.checks.case import check_line
from catopt.checks.criteria import Limits, criteria_of
from catopt.errors import InputError, NoEquilibriumError
from catopt.model import Anchor, Buoy, Case, Checks, Find, Line, Load, LoadCase

from .lines import CLOSE, GROUNDED, LIFTED, PLAIN, asking

STATES = (LoadCase("storm", 30e3), LoadCase("day", 10e3, kind="reference"))
EVERYTHING = asking(
    checks=Checks(
        safety_factor=2.0,
        codes=("LR-linkspans-2022", "IALA-CALMAR"),
        max_anchor_uplift_force=1e3,
        min_grounded_length=10.0,
        max_span=60.0,
        max_anchor_uplift_angle=0.1,
    ),
    anchor=Anchor("sinker", submerged_weight=100e3, friction=0.5),
    buoy=Buoy(50e3),
    load=None,
    load_cases=STATES,
)


def test_the_highest_utilisation_governs_what_passes() -> None:
    """Tension 50 / 100 = 0.5, span 52.96 / 100 = 0.53; no uplift of 0 is no measure."""
    checks = Checks(safety_factor=2.0, max_span=100.0, max_anchor_uplift_angle=0.0)
    report = check_case(asking(checks=checks))
    assert report.passes
    assert report.failed == ()
    assert report.governing is not None
    assert report.governing.kind == "span"


def test_the_worst_failure_governs() -> None:
    """Tension 0.5 fails by 0.25, grounded length by half of the 40 m wanted."""
    report = check_case(asking(checks=Checks(safety_factor=5.0, min_grounded_length=40.0)))
    assert [result.kind for result in report.failed] == ["grounded_length", "tension"]
    assert report.governing == report.failed[0]
    assert not report.passes


def test_no_criterion_is_warned_of() -> None:
    report = check_case(GROUNDED)
    assert (report.results, report.governing, report.passes) == ((), None, True)
    assert "no check was requested" in report.warnings[0]


def test_a_load_case_without_equilibrium_is_named() -> None:
    """At 41 m above the bed 60 m of line still reach; at 61 m they do not."""
    states = (*STATES, LoadCase("surge", 30e3, 41.0))
    with pytest.raises(NoEquilibriumError, match=r'^load case "surge": ') as caught:
        check_case(asking(checks=Checks(2.0), load=None, load_cases=states))
    assert (caught.value.quantity, caught.value.missing > 0.0) == ("length", True)


def test_an_anchor_needs_a_factor() -> None:
    anchor = Anchor("sinker", submerged_weight=100e3, friction=0.5)
    with pytest.raises(InputError, match=r"anchor\.safety_factor: missing; give the factor"):
        check_case(asking(checks=Checks(codes=("break/5",)), anchor=anchor))


def test_the_load_alone_is_an_extreme_load_case() -> None:
    """LR: 2.0 extreme, 50 kN beside 100 kN; a given span or tension is a load, too."""
    for load in (Load(30e3), Load(fairlead_tension=50e3)):
        report = check_case(asking(checks=Checks(codes=("LR-linkspans-2022",)), load=load))
        (result,) = report.results
        assert (result.load_case, result.capacity) == ("load", 100e3)
        assert result.demand == pytest.approx(50e3, rel=1e-9)  # the solver's tolerance on T


def test_what_is_sought_is_found_and_then_checked() -> None:
    """The shortest line that is level at its anchor is 40 m: nothing is left on the bed."""
    case = asking(
        checks=Checks(max_anchor_uplift_angle=0.0, min_grounded_length=1.0),
        find=Find("length", anchor_angle=0.0),
    )
    angle, grounded = check_case(case).results
    assert angle.passes
    # In m; the length is found to rounding.
    assert grounded.capacity == pytest.approx(0.0, abs=1e-9)
    assert not grounded.passes


def test_another_line_in_the_place_of_the_case_s_own() -> None:
    """MBL 400 kN: 50 / 200 = 0.25; a drag anchor of 60 kN / 2 = 30 kN is just used up."""
    line = Line([replace(PLAIN, MBL=400e3)])
    anchor = Anchor("drag", holding_capacity=60e3, safety_factor=2.0)
    tension, _, holding = check_line(line, asking(checks=Checks(2.0)), anchor).results
    assert tension.utilisation == pytest.approx(0.25, rel=CLOSE)
    assert holding.utilisation == pytest.approx(1.0, rel=CLOSE)
    assert holding.passes


def test_every_load_case_has_every_check() -> None:
    report = check_case(EVERYTHING)
    assert [name for name, _ in report.solutions] == ["storm", "day"]
    kinds = [
        [result.kind for result in report.results if result.load_case == state.name]
        for state in STATES
    ]
    assert kinds[0] == kinds[1] == [
        "tension", "tension", "tension", "uplift_angle", "uplift_angle", "uplift_force",
        "grounded_length", "span", "buoyancy", "sliding",
    ]  # fmt: skip


def test_the_document() -> None:
    report = check_case(EVERYTHING)
    document = report.to_dict()
    jsonschema.Draft202012Validator(schemas.schema("catopt.check/1")).validate(document)
    assert [each["kind"] for each in document["load_cases"]] == ["extreme", "reference"]
    governing = document["checks"][document["governing"]]
    assert report.governing is not None
    assert governing["name"] == report.governing.name
    jsonschema.Draft202012Validator(schemas.schema("catopt.check/1")).validate(
        check_case(GROUNDED).to_dict()
    )


def test_the_plain_numbers_of_a_search_are_the_strictest() -> None:
    """IALA keeps the angle at 0 where the case allows 0.1 rad; its sinker's factor is 1.5."""
    criteria = criteria_of(EVERYTHING)
    assert criteria.limits("extreme") == Limits(
        uplift_angle=0.0,
        uplift_force=1e3,
        grounded_length=10.0,
        span=60.0,
        reserve_buoyancy=50e3,
        sliding_factor=1.5,
    )
    assert criteria_of(GROUNDED).limits("reference") == Limits()


@pytest.mark.parametrize(("kind", "least"), [("extreme", 100e3 / 5.0), ("reference", 100e3 / 5.0)])
def test_the_allowed_tension_is_the_least(kind: str, least: float) -> None:
    """MBL 200 kN: / 2 = 100, LR / 2 = 100 or / 3 = 66.7; IALA: proof load 100 / 5 = 20 kN."""
    criteria = criteria_of(EVERYTHING)
    allowed = criteria.allowed_tension(PLAIN, kind)  # type: ignore[arg-type]
    assert allowed.tension == pytest.approx(least, rel=CLOSE)
    assert allowed.criterion is not None
    assert allowed.criterion.source.code == "IALA-CALMAR"
    again = criteria.allowed_tension(criteria.strength(PLAIN), kind)  # type: ignore[arg-type]
    assert again == allowed


def test_factors_by_kind_of_load_case_reach_the_allowed_tension() -> None:
    criteria = criteria_of(asking(checks=Checks(codes=("LR-linkspans-2022",))))
    assert criteria.allowed_tension(PLAIN, "extreme").tension == 100e3
    assert criteria.allowed_tension(PLAIN, "reference").tension == pytest.approx(
        200e3 / 3.0, rel=CLOSE
    )


def test_nothing_asked_for_allows_any_tension() -> None:
    allowed = criteria_of(GROUNDED).allowed_tension(PLAIN, "extreme")
    assert allowed == (math.inf, None)


@pytest.mark.parametrize(("case", "factor"), [*product((GROUNDED, LIFTED), (1.5, 5.0))])
def test_report_and_search_agree_on_every_tension(case: Case, factor: float) -> None:
    """The least capacity of the report is the allowed tension of the search."""
    asked = asking(case, Checks(safety_factor=factor, codes=("IALA-CALMAR", "UFC-4-159-03")))
    tensions = [r.capacity for r in check_case(asked).results if r.kind == "tension"]
    segment = asked.line.segments[0]
    assert min(tensions) == criteria_of(asked).allowed_tension(segment, "extreme").tension
