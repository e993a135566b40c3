"""Workbooks of notes: laid out for a reader, opened by LibreOffice, the same to the last byte."""

from __future__ import annotations

import math
import re
import shutil
import subprocess
import zipfile
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any

import openpyxl
import pytest
from openpyxl.utils import range_boundaries

from catopt.answers.blocks import Figure, Table
from catopt.words import LANGUAGES, Language

from .notes import answer_named, each_note, note_named
from .rendered import workbook_of

NOTES = ("leg", "slack", "states", "designed", "swarm", "harmonic", "arms", "idle", "six", "given")


@cache
def made(name: str, language: Language = "en") -> bytes:
    return workbook_of(note_named(name), language)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", each_note(NOTES))
def test_every_sheet_is_laid_out_for_a_reader(name: str, language: Language) -> None:
    sheet: Any
    for sheet in openpyxl.load_workbook(BytesIO(made(name, language))):
        assert sheet.freeze_panes == "A2"
        assert sheet.page_setup.paperSize == 9
        assert sheet.page_setup.fitToWidth in (None, 1)
        assert sheet.sheet_properties.pageSetUpPr.fitToPage
        assert sheet.print_area


@pytest.mark.parametrize("name", each_note(NOTES))
def test_formulas_give_what_stands_beside_them(name: str) -> None:
    """No cell is an error, and a formula's own value is that of the cells that it names."""
    values = openpyxl.load_workbook(BytesIO(made(name)), data_only=True)
    there: Any
    count = 0
    for sheet in openpyxl.load_workbook(BytesIO(made(name))):
        for cell in (cell for row in sheet.iter_rows() for cell in row):
            there = values[sheet.title]
            assert there[cell.coordinate].data_type != "e", (sheet.title, cell.coordinate)
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
def test_charts_are_native_and_lie_within_the_print_area(name: str) -> None:
    wanted = sum(isinstance(block, Figure) for block in answer_named(name).blocks)
    with zipfile.ZipFile(BytesIO(made(name))) as package:
        charts = [each for each in package.namelist() if "charts/chart" in each]
        assert len(charts) == wanted > 0
        for chart in charts:
            assert b"<c:scatterChart>" in package.read(chart)
    book = openpyxl.load_workbook(BytesIO(made(name)))
    sheet: Any
    for sheet in book:
        area = sheet.print_area.rpartition("!")[2].replace("$", "")
        _, _, right, bottom = range_boundaries(area)
        for drawn in sheet._charts:
            assert drawn.anchor.to.col < right
            assert drawn.anchor.to.row < bottom


def test_charts_read_cells_that_hold_the_figure() -> None:
    """The line in the water: its cells are the places of the chart, in the unit of the field."""
    answer = answer_named("leg")
    (chart,) = (b.chart for b in answer.blocks if isinstance(b, Figure) and b.chart.name == "line")
    sheet: Any
    sheet = openpyxl.load_workbook(BytesIO(made("leg"))).worksheets[-1]
    shown = {(row[0].value, row[1].value) for row in sheet.iter_rows(max_col=2)}
    series = next(each for each in chart.series)
    places = set(zip(map(float, series.x), map(float, series.y), strict=True))
    assert {(float(f"{x:.16g}"), float(f"{y:.16g}")) for x, y in places} <= shown


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
    command = [
        str(SOFFICE), f"-env:UserInstallation={profile.as_uri()}", "--headless",
        "--convert-to", target, "--outdir", str(folder / "made"),
        *(str(path) for path in sorted(folder.glob("*.xlsx"))),
    ]  # fmt: skip
    subprocess.run(command, check=True, capture_output=True, timeout=300)
    return folder / "made"


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
        ours = openpyxl.load_workbook(tmp_path / f"{name}.xlsx", data_only=True)
        theirs = openpyxl.load_workbook(written / f"{name}.xlsx", data_only=True)
        assert theirs.sheetnames == ours.sheetnames
        for sheet in ours:
            for cell in (cell for row in sheet.iter_rows() for cell in row):
                there = theirs[sheet.title][cell.coordinate]
                where = f"{name}, {sheet.title}!{cell.coordinate}"
                assert there.data_type != "e", where
                if isinstance(cell.value, int | float):
                    assert math.isclose(there.value, cell.value, rel_tol=FIFTEEN_DIGITS), where
        pages = (written / f"{name}.pdf").read_bytes()
        assert len(re.findall(rb"/Type\s*/Page\b", pages)) >= len(ours.sheetnames)
