"""Tables and figures of a moored body."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from catopt.casefile import read_case
from catopt.mooring.case import SystemReport, report_system
from catopt.report.plots.common import render
from catopt.report.plots.system import plan, restoring, watch_circle
from catopt.report.tables.system import body, frames, line_columns

CASE = Path(__file__).parents[2] / "cases" / "fso-rang-dong" / "case.toml"


@pytest.fixture(scope="module")
def report() -> SystemReport:
    return report_system(
        read_case(CASE),
        with_line_out=True,
        with_circle=True,
        directions=[math.pi, 0.5 * math.pi],
        levels=[-2.0, 2.0],
    )


def test_the_tables_say_what_was_computed_in_the_units_of_their_headings(
    report: SystemReport,
) -> None:
    made = frames(report)
    assert list(made) == [
        "body", "lines", "line_out", "watch_circle", "restoring_1", "restoring_2", "water_levels",
    ]  # fmt: skip
    assert made["body"]["Offset along x (m)"][0] == report.solution.offset[0]
    assert made["lines"]["Fairlead tension T (kN)"].tolist() == pytest.approx(
        [line.tension / 1e3 for line in report.solution.lines], rel=1e-15
    )
    assert made["lines"]["Azimuth (deg)"].tolist() == pytest.approx(
        [-3, 0, 3, 117, 120, 123, 237, 240, 243], abs=1e-12
    )
    assert made["line_out"]["Line out"].tolist() == [str(k) for k in range(1, 10)]
    assert made["restoring_1"]["Direction (deg)"].tolist() == [180.0] * 41
    assert made["water_levels"]["Water level (m)"].tolist() == [-2.0, 2.0]
    for frame in made.values():
        assert frame.columns.is_unique


def test_every_column_has_a_value_a_line(report: SystemReport) -> None:
    assert {len(values) for _, values in line_columns(report)} == {9}


def test_the_rule_of_practice_is_listed_only_where_it_applies(report: SystemReport) -> None:
    assert not any("rule" in entry.quantity.name for entry in body(report))


def test_the_plan_is_to_scale_and_shows_every_line(report: SystemReport) -> None:
    figure = plan(report)
    render(figure, "png")
    (axes,) = figure.axes
    box, (low, high), (bottom, top) = axes.get_window_extent(), axes.get_xlim(), axes.get_ylim()
    across, up = box.width / (high - low), box.height / (top - bottom)
    assert across == pytest.approx(up, rel=1e-6)  # pixels a metre, both ways
    for leg in report.solution.lines:
        x, y = leg.leg.anchor
        assert low < x < high
        assert bottom < y < top
    markers = [line for line in axes.get_lines() if line.get_marker() == "v"]
    assert len(markers) == 9
    assert {text.get_text() for text in axes.texts} >= {str(k) for k in range(1, 10)} | {"4281 kN"}


def test_the_watch_circle_closes_and_holds_every_place(report: SystemReport) -> None:
    assert report.circle is not None
    figure = watch_circle(report.circle, "Turret")
    offsets, tensions = figure.axes
    place = np.asarray(offsets.get_lines()[0].get_xydata())
    assert tuple(place[0]) == tuple(place[-1])
    assert max(place[:, 1]) == max(each.offset for each in report.circle.responses)
    values = np.asarray(tensions.get_lines()[0].get_ydata())
    assert values.max() == pytest.approx(
        max(each.largest_tension for each in report.circle.responses) / 1e3, rel=1e-12
    )


def test_each_restoring_curve_passes_through_the_zero_load_position(report: SystemReport) -> None:
    figure = restoring(report.curves, "Turret")
    curves = figure.axes[0].get_lines()[:2]
    assert [curve.get_label() for curve in curves] == ["180.0 deg", "90.0 deg"]
    for curve in report.curves:
        middle = len(curve.offset) // 2
        assert curve.offset[middle] == 0.0
        assert abs(curve.force[middle]) < 1e-3  # N, of some MN


def test_a_figure_is_the_same_bytes_each_time(report: SystemReport) -> None:
    assert render(plan(report), "svg") == render(plan(report), "svg")
    assert report.circle is not None
    assert render(watch_circle(report.circle, "$T$"), "png") == render(
        watch_circle(report.circle, "$T$"), "png"
    )
