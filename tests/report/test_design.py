"""The front of a design search as tables, workbook and figure."""

from __future__ import annotations

from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any, cast

import numpy as np
import openpyxl
import pandas as pd
import pytest

import catopt
from catopt.design.result import DesignResult
from catopt.report.plots.design import chosen_three, design_front
from catopt.report.tables import design
from catopt.report.wording.design import (
    clump_weight_words,
    governing_words,
    segment_words,
    tightest,
)
from catopt.report.workbook.books import design_workbook

CASES = Path(__file__).parents[2] / "cases"


@cache
def result_of(name: str) -> DesignResult:
    return catopt.design_case(catopt.read_case(CASES / name / "case.toml"))


@pytest.fixture(params=["design-buoy-9.5m", "design-leg-56m"])
def result(request: pytest.FixtureRequest) -> DesignResult:
    return result_of(str(request.param))


def test_the_front_has_a_row_a_design(result: DesignResult) -> None:
    frame = design.front(result)
    assert list(frame["Design"]) == list(range(1, len(result.front) + 1))
    assert list(frame.index[frame["Recommended"] == "yes"]) == [result.recommended]
    for row, point in zip(frame.to_dict("records"), result.front, strict=True):
        assert row["Mass in air (t)"] == point.objectives["mass_kg"] / 1e3
        assert row["Largest span S (m)"] == point.objectives["offset_m"]
        worst = tightest(point.checks, "tension")
        assert worst is not None
        assert row["Tension utilisation (-)"] == worst.utilisation
        assert row["Governing check (load case)"] == governing_words(point.governing)


def test_a_line_in_words() -> None:
    point = result_of("design-leg-56m").front[result_of("design-leg-56m").recommended]
    words = segment_words(point.line)
    for text, segment in zip(words, point.line.segments, strict=True):
        assert segment.nominal_diameter is not None
        assert text.endswith(f"{segment.nominal_diameter * 1e3:g} mm, {segment.length:g} m")
        assert text.startswith(segment.component)
    (load,) = point.line.point_loads
    assert load.mass is not None
    assert clump_weight_words(point.line) == [f"{load.mass / 1e3:g} t at {load.position:g} m"]


def test_every_check_of_every_design_has_a_row(result: DesignResult) -> None:
    frame = design.design_checks(result)
    assert len(frame) == sum(len(point.checks.results) for point in result.front)
    assert set(frame["Passes"]) == {"yes"}


def test_every_segment_has_a_row(result: DesignResult) -> None:
    frame = design.components(result)
    lengths = [s.length for point in result.front for s in point.line.segments]
    assert list(frame["Length L (m)"]) == lengths
    assert not frame["Minimum breaking load MBL (kN)"].isna().any()


def test_the_steps_around_the_recommended_design(result: DesignResult) -> None:
    frame = design.neighbours(result)
    steps = (*result.neighbours, result.present)
    assert len(frame) == len(steps) > 1
    assert frame["Verdict"].str.len().min() > 0
    known = frame["Mass in air (t)"].notna()
    assert list(known) == [step.point is not None for step in steps]


def test_the_workbook_holds_the_tables(result: DesignResult) -> None:
    book = openpyxl.load_workbook(BytesIO(design_workbook(result)))
    assert book.sheetnames == ["Front", "Recommended", "Components", "Checks", "Search"]
    frame = design.front(result)
    rows = list(book["Front"].iter_rows(values_only=True))
    assert list(rows[0][: len(frame.columns)]) == list(frame.columns)
    for values, expected in zip(rows[1:], frame.itertuples(index=False), strict=False):
        for value, want in zip(values, expected, strict=False):
            if isinstance(want, float) and not pd.isna(want):
                assert value == pytest.approx(want, rel=1e-15)  # 16 digits are written
    # A chart of single points: the front has no line between its designs.
    assert len(cast(Any, book["Front"])._charts) == 1


def test_the_figure_shows_front_and_three_lines(result: DesignResult) -> None:
    figure = design_front(result)
    above, below = figure.axes[:2]
    places = np.asarray(above.collections[0].get_offsets())
    assert len(places) == len(result.front)
    labels = [str(line.get_label()) for line in below.lines]
    drawn = [label.split(":")[0] for label in labels if label.startswith("Design ")]
    assert drawn == [f"Design {index + 1}" for index in chosen_three(result)]
    # To scale: as many metres to the inch across as up.
    width, height = (
        below.get_position().width * figure.get_figwidth(),
        below.get_position().height * figure.get_figheight(),
    )
    across, up = below.get_xlim(), below.get_ylim()
    scale = (across[1] - across[0]) / width, (up[1] - up[0]) / height
    assert scale[0] == pytest.approx(scale[1], rel=1e-12)  # a few roundings


def test_nothing_of_the_figure_is_cut_off(result: DesignResult) -> None:
    figure = design_front(result)
    figure.canvas.draw()
    box = figure.get_tightbbox()
    assert box.x0 >= -0.01
    assert box.y0 >= -0.01
    assert box.x1 <= figure.get_figwidth() + 0.01  # inches
    assert box.y1 <= figure.get_figheight() + 0.01
