"""The form of a sizing in a workbook: filled in it is the same question as options are."""

from __future__ import annotations

import contextlib
import datetime
import random
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
from catopt.sizing.form import form, read_form
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
    named = {each.key: each for each in inputs_of(moored).values()}
    offered = {f"{rule.sqref}": rule.formula1 for rule in sheet.data_validations.dataValidation}
    for row, key in enumerate(keys, start=4):
        units = offered.get(f"C{row}", '""').strip('"').split(",")
        assert all(to_si(f"1 {e}", Dimension[named[key].takes]) > 0.0 for e in units if e)
    assert "knots" in offered[f"C{4 + keys.index('environment.wind')}"]
    assert offered[f"C{4 + keys.index('line.diameter_min')}"] == '"mm,cm,in"'


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


def test_an_error_of_a_fleet_names_sheet_row_and_column(tmp_path: Path) -> None:
    path = fill(tmp_path / "form.xlsx", FILLED)
    book = openpyxl.load_workbook(path)
    keys = [cell.value for cell in book["Fleet"][3]]
    column = 1 + keys.index("site.water_depth")
    for row, depth in enumerate((9, -14), start=4):
        book["Fleet"].cell(row, column, depth)
    book.save(path)
    place = f"Fleet!{book['Fleet'].cell(5, column).coordinate}"
    with pytest.raises(InputError, match=rf"{place} site\.water_depth: found \"-14 m\""):
        known_of(path)
    with pytest.raises(InputError, match=r"Form!B\d+ environment\.hs: found"):
        known_of(fill(tmp_path / "other.xlsx", {**FILLED, "environment.hs": (-1, "m")}))


@pytest.mark.parametrize("moored", ["buoy", "tanker"])
def test_a_form_prints_on_two_pages_without_its_keys(moored: Moored) -> None:
    sheet = openpyxl.load_workbook(BytesIO(form(moored)))["Form"]
    rows = 3 + len({each.key for each in inputs_of(moored).values()})
    assert sheet.print_area == f"'Form'!$A$1:$D${rows}"
    setup = sheet.page_setup
    assert (setup.fitToWidth, setup.fitToHeight, setup.paperSize) == (1, 2, 9)
    pages = sheet.sheet_properties.pageSetUpPr
    assert pages is not None
    assert pages.fitToPage
    assert sheet.print_title_rows == "$1:$3"


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

    filled = fill(tmp_path / "form.xlsx", {**FILLED, "motion.left_out": ("yes", None)})
    convert(filled.name, "ods")
    filled.unlink()
    convert("form.ods", "xlsx")
    (file,) = read_form(filled)
    own = size_buoy("pillar 1.8 m", depth="12 m", current="1 m/s", hs="1.5 m", at_rest=True)
    assert sized(file).to_dict() == own.to_dict()


FLAG = next(
    f"B{row[4].row}"
    for row in openpyxl.load_workbook(BytesIO(form("buoy")))["Form"].iter_rows(min_row=4)
    if {each.key: each for each in inputs_of("buoy").values()}[f"{row[4].value}"].takes == "FLAG"
)
"""The first cell that takes yes or no."""

CHANGES: dict[str, tuple[str, str, Any, str]] = {
    # what is changed in a form that has Hs = 4 m in row 12: sheet, cell, value, what is said
    "a key changed": ("Form", "E12", "environment.hsx", "Form!E12: .*did you mean environment.hs"),
    "a key taken out": ("Form", "E12", None, "Form!E12: there is a value without its key"),
    "a key twice": ("Form", "E13", "environment.hs", "Form!E13: .*in row 12 already"),
    "another key": ("Form", "E12", "environment.current", r"Form!E\d+: .*already"),
    "no unit": ("Form", "C12", None, "Form!B12: found 4; its unit is missing"),
    "a strange unit": ("Form", "C12", "kN", "environment.hs: found"),
    "a column beyond": ("Form", "F12", 3, "Form!F12: found 3; a form has the columns A to E"),
    "a far cell": ("Form", "B1048576", "x", "Form!E1048576: there is a value without its key"),
    "a far corner": ("Form", "XFD1048576", "x", "Form!XFD1048576"),
    "a date": ("Form", "B12", datetime.date(2026, 8, 10), "Form!B12: found a date"),
    "an error": ("Form", "B12", "#N/A", "Form!B12: found #N/A"),
    "a heading of the fleet": ("Fleet", "A3", "line.max_swng", "Fleet!A3: .*did you mean"),
    "none": ("Fleet", "A3", None, "Fleet!A3: there is a value without its key"),
    "a heading without unit": ("Fleet", "A2", "Swinging", "Fleet!A4: .*its unit is missing"),
    "another sheet": (
        "Fleet (2)",
        "A4",
        9,
        r"Fleet \(2\)!A4: found 9; only the sheets Form and Fleet",
    ),
    "not yes, not no": ("Form", FLAG, "perhaps", f"Form!{FLAG}: .*yes or no is required"),
    "a unit of a text": ("Form", "C5", "kN", "Form!B5: found .kN.; .*no unit"),
}


def changed(path: Path, sheet: str, cell: str, value: Any) -> Path:
    """Write a form with Hs = 4 m and a mooring in its fleet, and change one cell of it."""
    fill(path, {**FILLED, "environment.hs": (4, "m")})
    book = openpyxl.load_workbook(path)
    assert book["Form"]["E12"].value == "environment.hs"
    assert book["Fleet"]["A3"].value == "line.max_swing"
    book["Fleet"]["A4"] = 60
    if sheet not in book.sheetnames:
        book.create_sheet(sheet)
    book[sheet][cell] = value
    book.save(path)
    return path


@pytest.mark.parametrize("change", CHANGES)
def test_no_value_of_a_form_is_lost(tmp_path: Path, change: str) -> None:
    sheet, cell, value, said = CHANGES[change]
    path = changed(tmp_path / "form.xlsx", sheet, cell, value)
    with pytest.raises(InputError, match=said):
        known_of(path)


def known_of(path: Path) -> None:
    for file in read_form(path):
        with file.reporting():
            file.known()


def test_a_heading_of_the_fleet_has_its_unit_and_yes_is_said_in_both_languages(
    tmp_path: Path,
) -> None:
    path = changed(tmp_path / "form.xlsx", "Fleet", "A2", "Room (of one line) (ft)")
    (file,) = read_form(path)
    assert file.document["line"]["max_swing"] == "60 ft"
    path = changed(tmp_path / "form.xlsx", "Form", FLAG, "Có")
    (file,) = read_form(path)
    assert True in [value for table in file.document.values() for value in table.values()]


def test_a_number_typed_as_text_has_the_unit_beside_it(tmp_path: Path) -> None:
    (file,) = read_form(changed(tmp_path / "form.xlsx", "Form", "B12", "1,5"))
    assert file.document["environment"]["hs"] == "1,5 m"  # a decimal comma: 1.5 m


def test_a_damaged_workbook_is_no_workbook(tmp_path: Path) -> None:
    whole = fill(tmp_path / "form.xlsx", FILLED).read_bytes()
    rng = random.Random(5)
    for number in range(200):
        data = bytearray(whole)
        for _ in range(rng.choice((1, 3, 30))):
            data[rng.randrange(len(data))] = rng.randrange(256)
        cut = data[: rng.randrange(len(data))] if number % 5 == 0 else data
        path = tmp_path / "damaged.xlsx"
        path.write_bytes(bytes(cut))
        with contextlib.suppress(InputError):
            read_form(path)


def test_a_workbook_has_a_budget(tmp_path: Path) -> None:
    path = fill(tmp_path / "form.xlsx", FILLED)
    with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr("xl/worksheets/sheet9.xml", b" " * 6_000_000)
    with pytest.raises(InputError, match="at most 5 MB"):
        read_form(path)
