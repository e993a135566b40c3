"""Workbooks: laid out for a reader, opened by LibreOffice, the same to the last byte."""

from __future__ import annotations

import math
import re
import shutil
import subprocess
import tomllib
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from importlib.resources import files
from io import BytesIO
from pathlib import Path
from typing import Any

import openpyxl
import pytest
from openpyxl.utils import range_boundaries

from catopt.answers.blocks import Figure, Table
from catopt.answers.solution import solution_answer
from catopt.catenary.solution import Solution
from catopt.render.workbook import workbook
from catopt.words import LANGUAGES, Language
from tests.answers.results import buoy_case, report_with, solved, swarm

from .notes import answer_named, each_note, note_named, workbook_of

NOTES = ("leg", "slack", "states", "designed", "swarm", "harmonic", "arms", "idle", "six", "given")


@cache
def made(name: str, language: Language = "en") -> bytes:
    return workbook_of(note_named(name), language)


def opened(workbook: bytes, *, values: bool = False) -> Any:
    return openpyxl.load_workbook(BytesIO(workbook), data_only=values)


def cells_of(*sheets: Any) -> Iterator[Any]:
    return (cell for sheet in sheets for row in sheet.iter_rows() for cell in row)


def charts_of(workbook: bytes) -> list[str]:
    """Read the charts of a workbook, which are native."""
    with zipfile.ZipFile(BytesIO(workbook)) as package:
        names = sorted(name for name in package.namelist() if "charts/chart" in name)
        return [package.read(name).decode("utf-8") for name in names]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", each_note(NOTES))
def test_every_sheet_is_laid_out_for_a_reader(name: str, language: Language) -> None:
    for sheet in opened(made(name, language)):
        assert sheet.freeze_panes == "A2"
        assert sheet.page_setup.paperSize == 9
        assert sheet.page_setup.fitToWidth in (None, 1)
        assert sheet.sheet_properties.pageSetUpPr.fitToPage
        assert sheet.print_area
        area = sheet.print_area.rpartition("!")[2].replace("$", "")
        _, _, right, bottom = range_boundaries(area)
        for drawn in sheet._charts:
            assert drawn.anchor.to.col < right
            assert drawn.anchor.to.row < bottom


@pytest.mark.parametrize("name", each_note(NOTES))
def test_formulas_give_what_stands_beside_them(name: str) -> None:
    """No cell is an error, and a formula's own value is that of the cells that it names."""
    values = opened(made(name), values=True)
    count = 0
    for cell in cells_of(*opened(made(name))):
        there = values[cell.parent.title]
        assert there[cell.coordinate].data_type != "e", cell
        if cell.data_type == "f":
            found = re.fullmatch(r"=([A-Z]\d+)([/-])([A-Z]\d+)", str(cell.value))
            assert found is not None, cell.value
            a, b = there[found[1]].value, there[found[3]].value
            expected = a / b if found[2] == "/" else a - b
            assert there[cell.coordinate].value == pytest.approx(expected, rel=1e-13)
            count += 1
    tables = [each for each in answer_named(name).blocks if isinstance(each, Table)]
    computed = [each for table in tables for each in table.columns if each.formula is not None]
    assert count == sum(value is not None for each in computed for value in each.values)


@pytest.mark.parametrize("name", each_note(NOTES))
def test_charts_are_native(name: str) -> None:
    charts = charts_of(made(name))
    wanted = sum(isinstance(block, Figure) for block in answer_named(name).blocks)
    assert len(charts) == wanted > 0
    assert all("<c:scatterChart>" in chart for chart in charts)


def test_charts_read_cells_that_hold_the_figure() -> None:
    """The line in the water: its cells are the places of the chart, in the unit of the field."""
    answer = answer_named("leg")
    (chart,) = (b.chart for b in answer.blocks if isinstance(b, Figure) and b.chart.name == "line")
    sheet = opened(made("leg")).worksheets[-1]
    shown = {(row[0].value, row[1].value) for row in sheet.iter_rows(max_col=2)}
    series = next(iter(chart.series))
    places = set(zip(map(float, series.x), map(float, series.y), strict=True))
    assert {(float(f"{x:.16g}"), float(f"{y:.16g}")) for x, y in places} <= shown


def of_the_buoy(solution: Solution) -> bytes:
    return workbook(solution_answer(buoy_case(), solution))


def test_charts_of_a_swarm_read_their_cells() -> None:
    shape, _, fitness, _ = charts_of(of_the_buoy(swarm()))
    assert "'Line shape'!$B$2:$B$102" in shape
    assert "'Line shape'!$C$2:$C$102" in shape
    logarithmic = ["logBase" in chart for chart in charts_of(of_the_buoy(swarm()))]
    assert logarithmic == [False, False, True, False]
    assert "Swarm!$B$2:$B$8" in fitness
    still = replace(swarm(), swarm=report_with((0.0, 0.0)))
    assert "logBase" not in charts_of(of_the_buoy(still))[2]


def test_numbers_are_numbers_in_the_format_of_their_unit() -> None:
    book = opened(of_the_buoy(solved()))
    formats = {row[0].value: row[1].number_format for row in book["Results"].iter_rows(max_col=2)}
    assert formats["Fairlead tension T (kN)"] == "0.000"
    assert formats["Fairlead tension T (tf)"] == "0.0000"
    assert formats["Inclination at the anchor theta0 (deg)"] == "0.00"
    assert formats["Residual of the span (m)"] == "0.00E+00"
    values = [cell.value for cell in cells_of(book["Inputs"])]
    assert "inextensible" in values
    assert 230.0 in values  # MBL, kN


def test_the_same_note_gives_the_same_bytes() -> None:
    assert workbook_of(note_named("leg")) == made("leg")


SOFFICE = shutil.which("soffice") or shutil.which("libreoffice")
ALWAYS_RECALCULATE = """<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry">
<item oor:path="/org.openoffice.Office.Calc/Formula/Load"><prop oor:name="OOXMLRecalcMode"
oor:op="fuse"><value>0</value></prop></item>
</oor:items>
"""
FIFTEEN_DIGITS = 1e-14


def converted(folder: Path, target: str) -> Path:
    """Let LibreOffice open the workbooks of a folder, recalculate and write them anew."""
    profile = folder / "profile"
    (profile / "user").mkdir(parents=True, exist_ok=True)
    (profile / "user" / "registrymodifications.xcu").write_text(ALWAYS_RECALCULATE, "utf-8")
    made = folder / "made"
    settings = ["--headless", f"-env:UserInstallation={profile.as_uri()}"]
    asked = ["--convert-to", target, "--outdir", str(made)]
    books = map(str, sorted(folder.glob("*.xlsx")))
    subprocess.run(
        [str(SOFFICE), *settings, *asked, *books], check=True, capture_output=True, timeout=300
    )
    return made


@pytest.mark.slow
@pytest.mark.skipif(SOFFICE is None, reason="needs LibreOffice Calc (libreoffice-calc)")
def test_libreoffice_opens_recalculates_and_prints_it(tmp_path: Path) -> None:
    """No cell is an error there, its numbers are ours, and every sheet has a page."""
    names = ("leg", "states", "designed", "arms", "six", "harmonic")
    for name in names:
        (tmp_path / f"{name}.xlsx").write_bytes(made(name))
    for target in ("xlsx", "pdf"):
        written = converted(tmp_path, target)
    for name in names:
        ours = opened(made(name), values=True)
        theirs = opened((written / f"{name}.xlsx").read_bytes(), values=True)
        assert theirs.sheetnames == ours.sheetnames
        for cell in cells_of(*ours):
            there = theirs[cell.parent.title][cell.coordinate]
            assert there.data_type != "e", (name, cell)
            if isinstance(cell.value, int | float):
                assert math.isclose(there.value, cell.value, rel_tol=FIFTEEN_DIGITS), (name, cell)
        pages = (written / f"{name}.pdf").read_bytes()
        assert len(re.findall(rb"/Type\s*/Page\b", pages)) >= len(ours.sheetnames)


@pytest.mark.parametrize("language", LANGUAGES)
def test_headings_of_notes_fit_a_tab_whole(language: Language) -> None:
    """Excel takes 31 letters."""
    folder = files("catopt.words.texts")
    for name in ("note", "note_first", "note_sheet", "note_size", "note_system", "note_motion"):
        texts = tomllib.loads(folder.joinpath(f"{name}.toml").read_text("utf-8"))
        found = [of[language] for key, of in texts.items() if key.endswith("_heading")]
        assert [heading for heading in found if len(heading) > 31] == []
