"""Tables and the figure of the front of a design search."""

from __future__ import annotations

from functools import cache
from io import BytesIO
from typing import Any, cast

import openpyxl
import pandas as pd
import pytest

import catopt
from catopt.answers.check import check_answer
from catopt.answers.design import design_answer, listed_designs
from catopt.checks.kinds import CHECK_KINDS
from catopt.design.result import DesignResult, clump_weight_words, segment_words
from catopt.figures.sizing import ends, front, front_lines
from catopt.render.workbook import workbook
from catopt.words import Message
from tests.cli.conftest import CASES

from .tables import tables_of


@cache
def result_of(name: str) -> DesignResult:
    return catopt.design_case(catopt.read_case(CASES / name / "case.toml"))


@cache
def tables(name: str) -> dict[str, pd.DataFrame]:
    return tables_of(design_answer(result_of(name)))


@pytest.fixture(params=["design-buoy-9.5m", pytest.param("design-leg-56m", marks=pytest.mark.slow)])
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


def test_the_front_has_a_row_a_design(name: str) -> None:
    result, frame = result_of(name), tables(name)["front"]
    assert list(frame["Design"]) == list(range(1, len(result.front) + 1))
    assert list(frame.index[frame["Recommended"] == "yes"]) == [result.recommended - 1]
    for row, point in zip(frame.to_dict("records"), result.front, strict=True):
        assert row["Mass in air (t)"] == pytest.approx(point.objectives["mass_kg"] / 1e3, rel=1e-15)
        assert row["Largest span S (m)"] == point.objectives["offset_m"]
        used = (each.utilisation for each in point.checks.results if each.kind == "tension")
        assert row["Tension utilisation (-)"] == max(value for value in used if value is not None)
        assert point.governing is not None
        assert row["Governing check (load case)"] == point.governing.in_case


@pytest.mark.slow
def test_a_line_in_words() -> None:
    result = result_of("design-leg-56m")
    point = result.best
    words = segment_words(point.line)
    for text, segment in zip(words, point.line.segments, strict=True):
        assert segment.nominal_diameter is not None
        assert text.endswith(f"{segment.nominal_diameter * 1e3:g} mm, {segment.length:g} m")
        assert text.startswith(segment.component)
    (load,) = point.line.point_loads
    assert load.mass is not None
    assert clump_weight_words(point.line) == [f"{load.mass / 1e3:g} t at {load.position:g} m"]


def test_checks_of_a_design_are_those_of_the_command_check(name: str) -> None:
    """One heading, one unit, whichever command wrote ``checks.csv``."""
    result, frame = result_of(name), tables(name)["checks"]
    assert len(frame) == sum(len(point.checks.results) for point in result.front)
    assert set(frame["Passes"]) == {"yes"}
    for number, point in enumerate(result.front, start=1):
        alone = tables_of(check_answer(point.checks))["checks"]
        found = frame[frame["Design"] == number].drop(columns="Design").reset_index(drop=True)
        pd.testing.assert_frame_equal(found, alone, check_exact=True)


def test_every_segment_and_every_step_around_the_recommended_design_has_a_row(name: str) -> None:
    result, frame = result_of(name), tables(name)["components"]
    lengths = [s.length for point in result.front for s in point.line.segments]
    assert list(frame["Length L (m)"]) == lengths
    assert not frame["Minimum breaking load MBL (kN)"].isna().any()
    frame = tables(name)["neighbours"]
    steps = (*result.neighbours, result.present)
    assert len(frame) == len(steps) > 1
    assert frame["Verdict"].str.len().min() > 0
    known = frame["Mass in air (t)"].notna()
    assert list(known) == [step.point is not None for step in steps]


def test_the_workbook_has_a_sheet_a_section(name: str) -> None:
    book = openpyxl.load_workbook(BytesIO(workbook(design_answer(result_of(name)))))
    assert book.sheetnames == ["Front", "Recommended", "Components", "Checks", "Search"]
    # A chart of single points: the front has no line between its designs.
    assert len(cast(Any, book["Front"])._charts) == 1


def test_the_figure_shows_front_and_three_lines(name: str) -> None:
    result = result_of(name)
    document = result.to_dict()
    above, below = front(document), front_lines(result, document)
    drawn = [(mark.x, mark.y) for mark in above.marks]
    first, second = result.objectives[:2]
    places = [(each.objectives[first], each.objectives[second]) for each in result.front]
    assert drawn[: len(places)] == places
    chosen = [result.recommended - 1, *ends(document)]
    numbers = [str(k + 1) for k in (*ends(document), result.recommended - 1)]
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


def test_which_designs_of_a_front_people_see() -> None:
    assert listed_designs(25, 7) == tuple(range(25))
    # Every second of 26, the last, and the one that is named.
    assert listed_designs(26, 7) == (0, 2, 4, 6, 7, *range(8, 26, 2), 25)
    assert {0, 41, 998, 999} <= set(listed_designs(1000, 41, 998))
    assert len(listed_designs(1000, 41, 998)) <= 25 + 3


def test_every_check_that_a_design_can_pass_has_its_column() -> None:
    for kind in set(CHECK_KINDS) - {
        "equilibrium",
        "slide",
        "heel",
    }:  # no design of a front does
        assert Message(f"columns.{kind}_utilisation")
