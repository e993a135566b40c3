"""What names and texts of a file may hold, and what becomes of them in files that are written."""

from __future__ import annotations

import csv
import io
import os
import sys
import warnings
from pathlib import Path

import openpyxl
import pytest

from .conftest import BUOY, Run, changed, fits


def named(tmp_path: Path, name: str, title: str = "Marker buoy, 9.5 m") -> Path:
    changes = (('name = "chain"', f'name = "{name}"'), ("Marker buoy, 9.5 m", title))
    return changed(BUOY, tmp_path, *changes)


@pytest.mark.parametrize("name", ["=1+1", "+cmd", "-cmd", "@SUM(A1)", "\\t=1"])
def test_no_cell_is_a_formula(run: Run, tmp_path: Path, name: str) -> None:
    assert run("solve", named(tmp_path, name), "--out", tmp_path / "out").status == 0
    written = name.replace("\\t", "\t")
    found = 0
    for path in (tmp_path / "out").glob("*.csv"):
        for row in csv.reader(io.StringIO(path.read_text("utf-8"))):
            assert not any(cell.startswith(("=", "@", "\t", "+", "-c")) for cell in row)
            found += f"'{written}" in row
    assert found >= 1
    book = openpyxl.load_workbook(tmp_path / "out" / "solution.xlsx")
    assert not [c for sheet in book for row in sheet for c in row if c.data_type == "f"]


def test_a_font_without_a_letter_is_no_warning(run: Run, tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ran = run(
            "solve", named(tmp_path, "chain", "Phao \U0001f6df 浮标"), "--out", tmp_path / "o"
        )
    assert (ran.status, ran.err.count("\n")) == (0, 1)


def test_a_long_name_without_a_space_is_not_cut_off(run: Run, tmp_path: Path) -> None:
    name = "ý" * 150
    ran = run("solve", changed(BUOY, tmp_path, ('name = "chain"', f'name = "{name}"')))
    assert (ran.status, fits(ran.out)) == (0, True)
    assert ran.out.count("ý") == 2 * 150  # in the table of the given and in that of results


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere names of files are always text")
def test_a_name_that_is_no_text_is_replaced(run: Run, tmp_path: Path) -> None:
    """As after unpacking what was packed on an old Windows."""
    case = Path(os.fsdecode(os.fsencode(tmp_path) + b"/phao s\xf4.toml"))
    case.write_bytes(BUOY.read_bytes())
    ran = run("report", case, "--no-verify", "--date", "ng\udce0y 1", "--out", tmp_path / "note")
    assert ran.status == 0, ran.err
    (page,) = (tmp_path / "note").glob("*.html")
    assert "phao s?.toml" in page.read_text("utf-8")
    assert "ng?y 1" in page.read_text("utf-8")
    assert run("export", case, "--to", "dxf").status == 0
