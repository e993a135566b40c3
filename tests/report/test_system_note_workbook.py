"""The note of a moored body as a workbook: its numbers are the document's, and it opens."""

from __future__ import annotations

import math
import re
import zipfile
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any

import openpyxl
import pytest
from openpyxl.utils import range_boundaries

from catopt.render.texts import LANGUAGES, Language
from catopt.report.workbook.note_system import system_note_workbook

from .system_page_cases import EVERY, TURRET, known_note
from .test_note_workbook import (
    FIFTEEN_DIGITS,
    SOFFICE,
    UNITS,
    Found,
    assert_holds,
    converted,
    same,
    table,
)

KILO, DEGREE = 1e3, math.pi / 180.0
CERTAIN = ["Summary", "Inputs", "Components", "Lines", "Line out", "Verification"]


@cache
def workbook(name: str, language: Language = "en") -> Any:
    """Read the workbook of a case back, once."""
    data = system_note_workbook(known_note(name), language)
    return openpyxl.load_workbook(BytesIO(data), data_only=True)


# ------------------------------------------------------------------ the numbers


OF_THE_BODY = {
    "Force on the body, along x": ["force_N[0]"],
    "Force on the body, along y": ["force_N[1]"],
    "Moment on the body": ["moment_Nm"],
    "Zero-load position x": ["zero_load_position.x_m"],
    "Zero-load position y": ["zero_load_position.y_m"],
    "Zero-load yaw": ["zero_load_position.yaw_rad"],
    "Position under the load x": ["position.x_m"],
    "Position under the load y": ["position.y_m"],
    "Yaw under the load": ["position.yaw_rad"],
    "Offset along x": ["offset_m[0]"],
    "Offset along y": ["offset_m[1]"],
    "Stiffness kxx": ["stiffness_N_per_m[0][0]", "stiffness_with_yaw[0][0]"],
    "Stiffness kxy": [
        "stiffness_N_per_m[0][1]", "stiffness_N_per_m[1][0]",
        "stiffness_with_yaw[0][1]", "stiffness_with_yaw[1][0]",
    ],
    "Stiffness kyy": ["stiffness_N_per_m[1][1]", "stiffness_with_yaw[1][1]"],
    "Stiffness of x against yaw": ["stiffness_with_yaw[0][2]", "stiffness_with_yaw[2][0]"],
    "Stiffness of y against yaw": ["stiffness_with_yaw[1][2]", "stiffness_with_yaw[2][1]"],
    "Stiffness in yaw": ["stiffness_with_yaw[2][2]"],
    "Residual of the balance of forces": ["residual_N"],
    "Residual of the balance of moments": ["residual_moment_Nm"],
}  # fmt: skip
RESPONSE = {
    "x (m)": ("x_m", 1.0),
    "y (m)": ("y_m", 1.0),
    "Yaw (deg)": ("yaw_rad", DEGREE),
    "Offset (m)": ("offset_m", 1.0),
    "Largest tension (kN)": ("largest_tension_N", KILO),
    "In line": ("most_loaded_line", 1.0),
    "Largest anchor tension (kN)": ("largest_anchor_tension_N", KILO),
    "Largest vertical force on an anchor (kN)": ("largest_anchor_vertical_force_N", KILO),
    "Shortest grounded length (m)": ("least_grounded_length_m", 1.0),
}
OF_A_LINE = {
    "Line": ("line", 1.0),
    "Azimuth (deg)": ("azimuth_rad", DEGREE),
    "Direction of the pull (deg)": ("direction_rad", DEGREE),
    "Horizontal force (kN)": ("horizontal_force_N", KILO),
    "Fairlead tension (kN)": ("fairlead_tension_N", KILO),
    "Fairlead vertical force (kN)": ("fairlead_vertical_force_N", KILO),
    "Anchor tension (kN)": ("anchor_tension_N", KILO),
    "Anchor horizontal force (kN)": ("anchor_horizontal_force_N", KILO),
    "Anchor vertical force (kN)": ("anchor_vertical_force_N", KILO),
    "Span (m)": ("span_m", 1.0),
    "Grounded length (m)": ("grounded_length_m", 1.0),
    "Utilisation": ("utilisation", 1.0),
}


def in_summary(book: Any) -> Found:
    found: Found = {"moment_Nm": 0.0, "position.yaw_rad": 0.0, "zero_load_position.yaw_rad": 0.0}
    for row in table(book["Summary"], "Quantity"):
        for path in OF_THE_BODY.get(row["Quantity"], ()):
            found[path] = row["Value in SI"]
        if row["Quantity"] == "Most loaded line":
            found["most_loaded_line"] = row["Value"]
        if row["Quantity"].endswith("by the rule of practice"):
            found["sharing_rule.horizontal_force_N"] = row["Value in SI"]
            found["sharing_rule.line"] = float(row["Quantity"].split()[4])
    return found


def in_sheets(book: Any) -> Found:
    """Find what the sheets say of the lines, of one line out, the watch circle and the curves."""
    found: Found = {}

    def put(path: str, row: dict[str, Any], columns: dict[str, tuple[str, float]]) -> None:
        for heading, (key, unit) in columns.items():
            value = row[heading]
            found[f"{path}.{key}"] = None if value is None else value * unit

    for index, row in enumerate(table(book["Lines"], "Line")):
        put(f"lines[{index}]", row, OF_A_LINE)
    for index, row in enumerate(table(book["Line out"], "Line gone")):
        put(f"one_line_out[{index}].response", row, RESPONSE)
        found[f"one_line_out[{index}].missing_line"] = row["Line gone"]
    if "Watch circle" in book.sheetnames:
        for index, row in enumerate(table(book["Watch circle"], "Force towards (deg)")):
            found[f"watch_circle.directions_rad[{index}]"] = row["Force towards (deg)"] * DEGREE
            put(f"watch_circle.responses[{index}]", row, RESPONSE)
    rows = table(book["Restoring"], "Direction (deg)") if "Restoring" in book.sheetnames else []
    directions = list(dict.fromkeys(row["Direction (deg)"] for row in rows))
    for number, direction in enumerate(directions):
        path = f"restoring_curves[{number}]"
        found[f"{path}.direction_rad"] = direction * DEGREE
        own = [row for row in rows if row["Direction (deg)"] == direction]
        for index, row in enumerate(own):
            for heading, key, unit in (
                ("Offset along the direction (m)", "offset_m", 1.0),
                ("Force along it (kN)", "force_N", KILO),
                ("Force across it (kN)", "force_across_N", KILO),
                ("Largest tension (kN)", "largest_tension_N", KILO),
                ("In line", "most_loaded_line", 1.0),
            ):
                found[f"{path}.{key}[{index}]"] = row[heading] * unit
    return found


@pytest.mark.slow
@pytest.mark.parametrize("name", EVERY)
def test_every_number_of_the_report_s_document(name: str) -> None:
    note = known_note(name)
    book = workbook(name)
    document = note.report.to_dict()
    if note.report.circle is not None:
        # The size of the force stands below the table, in words.
        told = [cell.value for row in book["Watch circle"].iter_rows() for cell in row]
        assert (
            f"A force of {document['watch_circle'].pop('force_N') / 1e3:.3f} kN from all sides"
            in told
        )
    assert_holds(in_summary(book) | in_sheets(book), document)


@pytest.mark.parametrize("name", EVERY)
def test_the_summary_is_the_same_in_both_units(name: str) -> None:
    units = UNITS | {"kN/m": KILO, "N": 1.0, "kN*m": KILO, "N*m": 1.0, "kN/rad": KILO}
    units |= {"kN*m/rad": KILO}
    shown = [row for row in table(workbook(name)["Summary"], "Quantity") if row["Unit"]]
    assert len(shown) >= 12
    for row in shown:
        assert same(row["Value"] * units[row["Unit"]], row["Value in SI"]), row


@pytest.mark.parametrize("name", EVERY)
def test_how_far_the_others_are_used_with_a_line_gone(name: str) -> None:
    rows = table(workbook(name)["Line out"], "Line gone")
    for row, used in zip(rows, known_note(name).left, strict=True):
        assert row["Utilisation"] is used is None or same(row["Utilisation"], used or math.nan)


@pytest.mark.parametrize("name", ["arms", "pulled"])
def test_every_number_of_the_checks(name: str) -> None:
    results = known_note(name).checks.results
    rows = table(workbook(name)["Checks"], "Line")
    assert len(rows) == len(results)
    for row, check in zip(rows, results, strict=True):
        unit = {"N": KILO, "m": 1.0, "rad": DEGREE}[check.unit]
        assert row["Check"] == check.name
        assert same(row["Demand"] * unit, check.demand)
        assert same(row["Capacity"] * unit, check.capacity)
        assert row["Verdict"].startswith("passes" if check.passes else "FAILS")
    marked = [row["Verdict"].endswith(" *") for row in rows]
    assert marked.count(True) == 1


@pytest.mark.parametrize("name", EVERY)
def test_every_number_of_the_verification(name: str) -> None:
    verification = known_note(name).verification
    assert verification is not None
    document = verification.to_dict()["static"]
    units = UNITS | {"kN*m": KILO}
    rows = table(workbook(name)["Verification"], "Line")
    assert len(rows) == len(document["quantities"])
    for row, each in zip(rows, document["quantities"], strict=True):
        unit = units[row["Unit"]]
        assert same(row["Closed form"] * unit, each["closed_form"])
        assert same(row["Truss model, extrapolated"] * unit, each["extrapolated"])
        for mesh, value in zip(document["meshes"], each["fem"], strict=True):
            assert same(row[f"Truss of {mesh['elements']} bars"] * unit, value)
        assert row["Verdict"] == ("agrees" if each["agrees"] else "DIFFERS")


def test_inputs_are_numbers_in_si() -> None:
    rows = {row["Key"]: row for row in table(workbook(TURRET)["Inputs"], "Key")}
    assert rows["system.anchor_radius"]["SI"] == 1056.0
    assert rows["system.force[0]"]["SI"] == -4281e3
    assert same(rows["system.azimuths[0]"]["SI"], -3.0 * DEGREE)


# ------------------------------------------------------------------ the look


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", EVERY)
def test_every_sheet_is_laid_out_for_a_reader(name: str, language: Language) -> None:
    note, book = known_note(name), workbook(name, language)
    if language == "en":
        assert [each for each in CERTAIN if each not in book.sheetnames] == []
        assert ("Watch circle" in book.sheetnames) == (note.report.circle is not None)
        assert ("Restoring" in book.sheetnames) == bool(note.report.curves)
        assert ("Checks" in book.sheetnames) == bool(note.checks.results)
        assert ("Catalogue" in book.sheetnames) == (name == "arms")
    else:
        assert not set(book.sheetnames) & set(workbook(name).sheetnames)
    for sheet in book:
        assert sheet.freeze_panes == "A2"
        assert sheet.page_setup.paperSize == 9
        assert sheet.sheet_properties.pageSetUpPr.fitToPage
        assert sheet.print_area


@pytest.mark.parametrize("name", EVERY)
def test_no_cell_is_an_error_or_a_stray_formula(name: str) -> None:
    formulas = openpyxl.load_workbook(BytesIO(system_note_workbook(known_note(name))))
    for sheet in workbook(name):
        for row in sheet.iter_rows():
            for cell in row:
                assert cell.data_type != "e", (sheet.title, cell.coordinate)
                assert not re.match(r"#[A-Z]", str(cell.value)), (sheet.title, cell.coordinate)
                shown = formulas[sheet.title][cell.coordinate]
                if shown.data_type == "f":
                    assert re.fullmatch(r"=C\d+/D\d+", shown.value)
                    assert sheet.title == "Checks"


@pytest.mark.parametrize("name", EVERY)
def test_charts_are_native_and_lie_within_the_print_area(name: str) -> None:
    note = known_note(name)
    data = system_note_workbook(note)
    wanted = 1 + bool(note.report.curves) + 2 * (note.report.circle is not None)
    with zipfile.ZipFile(BytesIO(data)) as package:
        charts = [each for each in package.namelist() if "charts/chart" in each]
        assert len(charts) == wanted
        for chart in charts:
            assert b"<c:scatterChart>" in package.read(chart)
    seen = 0
    sheet: Any
    for sheet in openpyxl.load_workbook(BytesIO(data)):
        area = sheet.print_area.rpartition("!")[2].replace("$", "")
        _, _, right, bottom = range_boundaries(area)
        for drawn in sheet._charts:
            seen += 1
            assert drawn.anchor.to.col < right
            assert drawn.anchor.to.row < bottom
    assert seen == wanted


def test_the_same_note_gives_the_same_bytes() -> None:
    note = known_note(TURRET)
    assert system_note_workbook(note) == system_note_workbook(note)


@pytest.mark.parametrize("name", EVERY)
def test_both_languages_have_the_same_numbers_and_other_headings(name: str) -> None:
    same_in_both = {"SI", "", "x (m)", "y (m)", known_note(name).title}
    for ours, theirs in zip(workbook(name), workbook(name, "vi"), strict=True):
        for row, other in zip(ours.iter_rows(), theirs.iter_rows(), strict=True):
            for cell, there in zip(row, other, strict=True):
                if isinstance(cell.value, int | float):
                    assert there.value == cell.value
                elif isinstance(cell.value, str) and cell.font.b and cell.value not in same_in_both:
                    assert there.value != cell.value, (ours.title, cell.coordinate)


@pytest.mark.slow
@pytest.mark.skipif(SOFFICE is None, reason="needs LibreOffice Calc (libreoffice-calc)")
def test_libreoffice_opens_recalculates_and_prints_it(tmp_path: Path) -> None:
    """No cell is an error there, its numbers are ours, and every sheet has a page."""
    names = (TURRET, "arms")
    for name in names:
        (tmp_path / f"{name}.xlsx").write_bytes(system_note_workbook(known_note(name)))
    for target in ("xlsx", "pdf"):
        made = converted(tmp_path, target)
    for name in names:
        ours = openpyxl.load_workbook(tmp_path / f"{name}.xlsx", data_only=True)
        theirs = openpyxl.load_workbook(made / f"{name}.xlsx", data_only=True)
        assert theirs.sheetnames == ours.sheetnames
        for sheet in ours:
            for cell in (cell for row in sheet.iter_rows() for cell in row):
                there = theirs[sheet.title][cell.coordinate]
                where = f"{name}, {sheet.title}!{cell.coordinate}"
                assert there.data_type != "e", where
                if isinstance(cell.value, int | float):
                    assert math.isclose(there.value, cell.value, rel_tol=FIFTEEN_DIGITS), where
        pages = (made / f"{name}.pdf").read_bytes()
        assert len(re.findall(rb"/Type\s*/Page\b", pages)) >= len(ours.sheetnames)
