"""The workbook: native charts, frozen headings, and text that stays text."""

from __future__ import annotations

import zipfile
from dataclasses import replace
from io import BytesIO

import openpyxl

from catopt.answers.solution import solution_answer
from catopt.catenary.solution import Solution
from catopt.model import Case, Line
from catopt.render.workbook import workbook

from .conftest import buoy_case, report_with


def _workbook(case: Case, solution: Solution) -> bytes:
    return workbook(solution_answer(case, solution))


def test_charts_are_native_and_read_their_cells(case: Case, swarm: Solution) -> None:
    with zipfile.ZipFile(BytesIO(_workbook(case, swarm))) as package:
        names = sorted(name for name in package.namelist() if "charts/chart" in name)
        charts = [package.read(name).decode("utf-8") for name in names]
    assert len(charts) == 4
    assert "'Line shape'!$B$2:$B$102" in charts[0]
    assert "'Line shape'!$C$2:$C$102" in charts[0]
    assert ["logBase" in chart for chart in charts] == [False, False, True, False]
    assert "Swarm!$B$2:$B$8" in charts[2]


def test_a_history_of_zeros_has_no_logarithmic_axis(case: Case, swarm: Solution) -> None:
    still = replace(swarm, swarm=report_with((0.0, 0.0)))
    with zipfile.ZipFile(BytesIO(_workbook(case, still))) as package:
        assert b"logBase" not in package.read("xl/charts/chart3.xml")


def test_numbers_are_numbers_in_the_format_of_their_unit(case: Case, buoy: Solution) -> None:
    sheet = openpyxl.load_workbook(BytesIO(_workbook(case, buoy)))["Results"]
    formats = {row[0].value: row[1].number_format for row in sheet.iter_rows(max_col=2)}
    assert formats["Fairlead tension T (kN)"] == "0.000"
    assert formats["Fairlead tension T (tf)"] == "0.0000"
    assert formats["Inclination at the anchor theta0 (deg)"] == "0.00"
    assert formats["Residual of the span (m)"] == "0.00E+00"


def test_an_inextensible_segment_says_so() -> None:
    case = buoy_case()
    assert case.line == Line(case.line.segments)
    from catopt.catenary.case import solve_case

    book = openpyxl.load_workbook(BytesIO(_workbook(case, solve_case(case))))
    values = [cell.value for row in book["Inputs"] for cell in row]
    assert "inextensible" in values
    assert 230.0 in values  # MBL, kN
