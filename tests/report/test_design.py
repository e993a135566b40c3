"""The figure of the front of a design search."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

import catopt
from catopt.design.document import design_document
from catopt.design.result import DesignResult
from catopt.figures.front import ends, front, front_lines

CASES = Path(__file__).parents[2] / "cases"


@cache
def result_of(name: str) -> DesignResult:
    return catopt.design_case(catopt.read_case(CASES / name / "case.toml"))


@pytest.fixture(params=["design-buoy-9.5m", pytest.param("design-leg-56m", marks=pytest.mark.slow)])
def result(request: pytest.FixtureRequest) -> DesignResult:
    return result_of(str(request.param))


def test_the_figure_shows_front_and_three_lines(result: DesignResult) -> None:
    document = design_document(result)
    above, below = front(document), front_lines(result, document)
    drawn = [(mark.x, mark.y) for mark in above.marks]
    first, second = result.objectives[:2]
    places = [(each.objectives[first], each.objectives[second]) for each in result.front]
    assert drawn[: len(places)] == places
    chosen = [result.recommended, *ends(document)]
    numbers = [str(k + 1) for k in (*ends(document), result.recommended)]
    signs = {mark.role: mark for mark in above.marks[len(places) :]}
    assert [mark.label.split()[-1] for mark in above.marks[len(places) :]][:3] == numbers
    present = result.present.point
    assert present is not None
    own = present.objectives
    assert (signs["present"].x, signs["present"].y) == (own[first], own[second])
    assert ("fails" in str(signs["present"].label)) is not present.checks.passes
    named = [str(series.label).split(":")[0] for series in below.series]
    assert named == [f"design {k + 1}" for k in chosen]
    spans = [max(solution.span for _, solution in result.front[k].checks.solutions) for k in chosen]
    assert below.series[0].x[-1] == spans[0]
