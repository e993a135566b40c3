"""Tables of checks: units of the field, what is not known left empty."""

from __future__ import annotations

import math

import pytest

from catopt.answers.check import (
    check_answer,
    governing_sentence,
    load_case_words,
    verdict_sentence,
)
from catopt.checks.case import check_case
from catopt.checks.kinds import CHECK_KINDS, QUANTITY_OF
from catopt.checks.result import CheckReport
from catopt.model import Checks, Load, LoadCase
from catopt.render.workbook import workbook

from .results import buoy_case
from .tables import tables_of


@pytest.fixture
def report() -> CheckReport:
    """Check the buoy of S1: T = 4.377 kN and 230 kN / 5 = 46 kN; lifted off its bed."""
    checks = Checks(5.0, max_anchor_uplift_angle=0.0, max_span=20.0)
    return check_case(buoy_case(checks=checks))


def test_checks_are_in_the_units_of_the_field(report: CheckReport) -> None:
    frame = tables_of(check_answer(report))["checks"]
    assert list(frame["Unit"]) == ["kN", "deg", "m"]
    first, angle, span = report.results
    assert frame["Demand (unit of the row)"][0] == first.demand / 1e3
    assert frame["Capacity (unit of the row)"][0] == 46.0
    # One rounding of the conversion either way.
    assert frame["Demand (unit of the row)"][1] == pytest.approx(
        math.degrees(angle.demand), rel=1e-15
    )
    assert frame["Demand (unit of the row)"][2] == span.demand
    assert math.isnan(frame["Utilisation (-)"][1])
    assert list(frame["Passes"]) == ["yes", "no", "yes"]
    assert list(frame["Source"]) == ["case file"] * 3
    assert list(frame["Code"]) == ["user"] * 3


def test_every_kind_of_check_has_a_unit() -> None:
    assert set(QUANTITY_OF) == set(CHECK_KINDS)


def test_load_cases_have_a_row_each(report: CheckReport) -> None:
    frame = tables_of(check_answer(report))["load_cases"]
    assert list(frame["Load case"]) == ["load"]
    assert list(frame["Kind"]) == ["extreme"]
    # S1 prints 17.43 m and 0.4463 tf.
    assert round(frame["Span S (m)"][0], 2) == 17.43
    assert round(frame["Fairlead tension T (kN)"][0] / 9.80665, 4) == 0.4463


def test_sentences() -> None:
    """230 kN / 5 = 46 kN; 4.377 / 46 = 0.095."""
    passing = check_case(buoy_case())
    assert verdict_sentence(passing) == "The one check passes."
    assert governing_sentence(passing) == (
        "Governing: tension, segment 1 (chain) in load case load, utilisation 0.095 (case file)."
    )
    nothing = check_case(buoy_case(checks=Checks()))
    assert verdict_sentence(nothing) == "Nothing was checked."
    assert governing_sentence(nothing) == ""
    assert tables_of(check_answer(nothing))["checks"].empty
    assert workbook(check_answer(nothing)).startswith(b"PK")


def test_a_load_case_is_named_with_its_force() -> None:
    states = (LoadCase("storm", 3363.68), LoadCase("low", 1e3, -1.0, "reference"))
    report = check_case(buoy_case(load=None, load_cases=states))
    assert load_case_words(report, 1) == (
        "Load case low (reference): horizontal force 1.000 kN, fairlead height 8.5 m"
    )
    alone = check_case(buoy_case(load=Load(1e3)))
    assert load_case_words(alone, 0).startswith("Load case load: ")
