"""Words, tables and figures of a verification."""

from __future__ import annotations

from dataclasses import replace

import pytest

import catopt
from catopt.answers.verification import (
    GAP,
    front_answer,
    front_sentence,
    verdict_sentence,
    verification_answer,
)
from catopt.figures.motion import comparison
from catopt.report.bundle import verification_pictures
from catopt.verify.case import Design, verify_case, verify_front
from catopt.verify.comparison import ROUNDING
from catopt.verify.motion_words import QUANTITY_OF, in_parts, name_of, part_sentence, rough_sentence
from catopt.verify.result import StaticComparison, Verification
from tests.cli.conftest import FSO
from tests.verify.cases import CASES

from .tables import tables_of


@pytest.fixture(scope="module")
def found() -> Verification:
    return verify_case(CASES["on the bed"])


@pytest.fixture(scope="module")
def system() -> Verification:
    return verify_case(catopt.read_case(FSO), elements=100)


def off(part: StaticComparison, quantity: str, by: float) -> StaticComparison:
    """Return a comparison whose closed form is off in one quantity."""
    return replace(
        part,
        quantities=tuple(
            replace(q, closed_form=(q.closed_form or 0.0) + by) if q.quantity == quantity else q
            for q in part.quantities
        ),
    )


def test_every_quantity_has_a_name_and_a_unit(found: Verification, system: Verification) -> None:
    for part in (*found.parts, *system.parts):
        for each in part.quantities:
            assert QUANTITY_OF[each.quantity].si_unit.replace("*", "") == each.unit


def test_a_difference_is_named_with_its_amount(found: Verification) -> None:
    part = off(found.static, "fairlead_tension", 1e3)
    assert part_sentence(part).startswith(
        "The two models DIFFER: fairlead tension by -1.0000 kN, 4.0e-03 of the tension; "
    )


def test_several_differences_are_named_and_the_rest_counted(system: Verification) -> None:
    part = off(system.static, "fairlead_tension", 1e3)
    words = part_sentence(part)
    assert "fairlead tension of line 1 by" in words
    assert "; and 5 more; the tolerance is 1e-04." in words
    assert name_of(part.of("position_x")) == "position of the body along x"


def test_what_is_not_smooth_is_named(found: Verification) -> None:
    part = found.static
    assert rough_sentence(part) == ""
    first, *others = part.quantities
    rough = replace(first, fem=(380.0, 380.2, 380.1))
    words = rough_sentence(replace(part, quantities=(rough, *others)))
    assert "without extrapolation" in words
    assert words.endswith("span (1.00).")


def test_rounding_is_shown_as_such() -> None:
    assert GAP.floor == ROUNDING
    assert [in_parts(value) for value in (0.0, 3e-14, 2.5e-7)] == ["<1e-10", "<1e-10", "2.5e-07"]


def test_several_load_cases_add_up_to_a_sentence(found: Verification) -> None:
    good, bad = found.static, off(found.static, "span", 1.0)
    case = found.case
    assert verdict_sentence(Verification(case, (good, good))) == (
        "The two models agree in all 2 load cases."
    )
    assert verdict_sentence(Verification(case, (good, bad))) == (
        "The two models do not agree in 1 of 2 load cases."
    )


def test_a_front_adds_up_to_a_sentence() -> None:
    too_short = replace(CASES["hanging"], fairlead_height=30.0)
    front = verify_front("F", [Design(1, CASES["hanging"]), Design(2, too_short)])
    assert front_sentence(front) == "For 1 of 2 designs the two models have no solution."
    designs = tables_of(front_answer(front))["designs"]
    assert designs["Verdict"].tolist() == ["agrees", "no answer"]


def test_shapes_stand_beside_each_other(found: Verification) -> None:
    shapes = tables_of(verification_answer(found))["shapes"]
    assert len(shapes) == 801
    assert shapes["Truss x (m)"].iloc[-1] == pytest.approx(
        found.static.of("span").fem[2], rel=1e-15
    )
    # Second order: what a bar of half a metre leaves.
    assert shapes["Closed form z (m)"].to_numpy() == pytest.approx(
        shapes["Truss z (m)"].to_numpy(), abs=1e-3
    )


@pytest.mark.slow
def test_a_figure_for_every_load_case(found: Verification) -> None:
    drawn = verification_pictures(found)
    assert {name for name in drawn if name.endswith("png")} == {"comparison.png"}
    two = Verification(found.case, (found.static, found.static))
    named = {name for name in verification_pictures(two) if name.endswith("svg")}
    assert named == {"comparison_1.svg", "comparison_2.svg"}


def test_the_figure_has_both_shapes_and_what_is_between_them(found: Verification) -> None:
    (pair,) = found.static.lines
    shape, tension, between, off_tension = comparison(pair)
    assert [each.role for each in shape.series] == ["mooring", "nodes"]
    assert [each.label for each in tension.series] == ["closed form", "truss model"]
    largest = found.static.of("shape").fem[2]
    for chart in (between, off_tension):
        assert chart.y.foot is not None
        assert len(chart.series) == 3
    assert max(v for v in between.series[-1].y if v == v) == pytest.approx(largest, rel=1e-9)
