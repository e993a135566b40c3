"""Tables of a moored body."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from catopt.answers.system import system_answer
from catopt.casefile import read_case
from catopt.checks.case import check_case
from catopt.mooring.case import SystemReport, report_system

from .tables import tables_of

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
    made = tables_of(system_answer(report, check_case(report.case)))
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
    assert made["line_out"]["Line out"].tolist() == list(range(1, 10))
    assert made["restoring_1"]["Direction (deg)"].tolist() == [180.0] * 41
    assert made["water_levels"]["Water level (m)"].tolist() == [-2.0, 2.0]
    for frame in made.values():
        assert frame.columns.is_unique


def test_the_rule_of_practice_is_listed_only_where_it_applies(report: SystemReport) -> None:
    assert not any(
        "rule" in str(heading)
        for heading in tables_of(system_answer(report, check_case(report.case)))["body"]
    )
