"""The form of a sizing in a workbook: filled in it is the same question as options are."""

from __future__ import annotations

import shutil
import subprocess
import zipfile
from io import BytesIO
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from catopt.casefile.reading import Moored
from catopt.errors import InputError
from catopt.sizing.form import UNITS, form, read_form
from catopt.sizing.inputs import inputs_of
from catopt.units import Dimension, to_si

FILLED = {
    "buoy.name": ("pillar 1.8 m", None),
    "site.water_depth": (12, "m"),
    "environment.current": (1.0, "m/s"),
    "environment.hs": (150, "cm"),
}
"""By key: what is put in, and its unit."""


def fill(path: Path, given: dict[str, tuple[Any, str | None]], moored: Moored = "buoy") -> Path:
    """Write a form with values in it."""
    book = openpyxl.load_workbook(BytesIO(form(moored)))
    sheet = book["Form"]
    for row in sheet.iter_rows(min_row=4):
        key = f"{row[4].value}"
        if key in given:
            row[1].value, unit = given[key]
            row[2].value = unit or row[2].value
    book.save(path)
    return path


@pytest.mark.parametrize("moored", ["buoy", "tanker"])
def test_every_input_has_its_row_and_every_unit_offered_is_read(moored: Moored) -> None:
    sheet = openpyxl.load_workbook(BytesIO(form(moored, "vi")))["Form"]
    keys = [f"{row[4]}" for row in sheet.iter_rows(min_row=4, values_only=True)]
    assert sorted(keys) == sorted({each.key for each in inputs_of(moored).values()})
    for name, units in UNITS.items():
        assert all(to_si(f"1 {unit}", Dimension[name]) > 0.0 for unit in units)


def test_what_is_filled_in_is_what_a_file_would_say(tmp_path: Path) -> None:
    (file,) = read_form(fill(tmp_path / "form.xlsx", FILLED))
    assert file.findings == ()
    assert file.document == {
        "buoy": {"name": "pillar 1.8 m"},
        "site": {"water_depth": "12 m"},
        "environment": {"current": "1 m/s", "hs": "150 cm"},
    }


def test_a_fleet_is_a_row_a_mooring(tmp_path: Path) -> None:
    path = fill(tmp_path / "form.xlsx", FILLED)
    book = openpyxl.load_workbook(path)
    keys = [cell.value for cell in book["Fleet"][3]]
    for row, depth in enumerate((9, 14), start=4):
        book["Fleet"].cell(row, 1 + keys.index("site.water_depth"), depth)
    book.save(path)
    depths = [each.document["site"]["water_depth"] for each in read_form(path)]
    assert depths == ["9 m", "14 m"]


def test_formulas_macros_and_what_is_no_form_are_refused(tmp_path: Path) -> None:
    path = fill(tmp_path / "form.xlsx", {"site.water_depth": ("=6+6", None)})
    with pytest.raises(InputError, match="a formula"):
        read_form(path)
    with_macros = fill(tmp_path / "macros.xlsx", FILLED)
    with zipfile.ZipFile(with_macros, "a") as packed:
        packed.writestr("xl/vbaProject.bin", b"")
    with pytest.raises(InputError, match="macros"):
        read_form(with_macros)
    (tmp_path / "text.xlsx").write_text("no workbook")
    with pytest.raises(InputError, match="a workbook"):
        read_form(tmp_path / "text.xlsx")
    openpyxl.Workbook().save(tmp_path / "other.xlsx")
    with pytest.raises(InputError, match="catopt new buoy"):
        read_form(tmp_path / "other.xlsx")


SOFFICE = shutil.which("soffice") or shutil.which("libreoffice")


@pytest.mark.slow
@pytest.mark.skipif(SOFFICE is None, reason="needs LibreOffice Calc (libreoffice-calc)")
def test_a_form_that_libreoffice_wrote_gives_the_commands_answer(tmp_path: Path) -> None:
    """Its own flat file is filled in, and written as a workbook by it."""
    from catopt.sizing.file import sized
    from catopt.sizing.keywords import size_buoy

    (tmp_path / "form.xlsx").write_bytes(form("buoy"))

    def convert(name: str, target: str) -> None:
        profile = f"-env:UserInstallation={(tmp_path / 'profile').as_uri()}"
        asked = ["--headless", profile, "--convert-to", target, "--outdir", str(tmp_path)]
        command = [str(SOFFICE), *asked, str(tmp_path / name)]
        subprocess.run(command, check=True, capture_output=True, timeout=300)

    filled = fill(tmp_path / "form.xlsx", FILLED)
    convert(filled.name, "ods")
    filled.unlink()
    convert("form.ods", "xlsx")
    (file,) = read_form(filled)
    own = size_buoy("pillar 1.8 m", depth="12 m", current="1 m/s", hs="1.5 m")
    assert sized(file).to_dict() == own.to_dict()
