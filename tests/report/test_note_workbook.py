"""The note as a workbook: its numbers are the documents', it prints on A4, and it opens."""

from __future__ import annotations

import math
import re
import shutil
import subprocess
import zipfile
from collections.abc import Iterator
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any

import openpyxl
import pytest
from openpyxl.utils import range_boundaries

from catopt.design.document import design_document
from catopt.notes.line import Note, read_note
from catopt.quantities import QUANTITIES
from catopt.words import LANGUAGES, Language

from .page_cases import CASES, EVERY, design_directory, known_note
from .rendered import workbook_of

ROUNDING = 1e-15
"""Relative: the workbook keeps 16 significant digits, JSON 17; plus one change of unit."""

CERTAIN = ["Summary", "Inputs", "Components", "Line"]
KILO, DEGREE = 1e3, math.pi / 180.0

Found = dict[str, float | None]


@cache
def workbook(name: str, language: Language = "en") -> Any:
    """Read the workbook of a case back, once."""
    return opened(known_note(name), language)


def opened(note: Note, language: Language = "en") -> Any:
    return openpyxl.load_workbook(BytesIO(workbook_of(note, language)), data_only=True)


def table(sheet: Any, first: str, number: int = 0) -> list[dict[str, Any]]:
    """Read a table by its first heading, down to the first empty cell below it.

    Parameters
    ----------
    sheet : Worksheet
        Of openpyxl.
    first : str
        Heading of its first column.
    number : int
        Which of several, from the top.
    """
    places = [cell for row in sheet.iter_rows() for cell in row if cell.value == first]
    top = places[number]
    headings = []
    for (cell,) in sheet.iter_cols(min_col=top.column, min_row=top.row, max_row=top.row):
        if cell.value is None:
            break
        headings.append(cell.value)
    rows = []
    for cells in sheet.iter_rows(
        min_row=top.row + 1, min_col=top.column, max_col=top.column + len(headings) - 1
    ):
        values = [cell.value for cell in cells]
        if not any(value is not None for value in values[1:]):
            break
        rows.append(dict(zip(headings, values, strict=True)))
    return rows


def numbers(document: Any, path: str = "") -> Iterator[tuple[str, float]]:
    """Yield every number of a document with its path; true and false are none."""
    if isinstance(document, dict):
        for key, value in document.items():
            yield from numbers(value, f"{path}.{key}".lstrip("."))
    elif isinstance(document, list):
        for index, value in enumerate(document):
            yield from numbers(value, f"{path}[{index}]")
    elif isinstance(document, int | float) and not isinstance(document, bool):
        yield path, float(document)


def same(first: float, second: float) -> bool:
    return math.isclose(first, second, rel_tol=ROUNDING, abs_tol=0.0)


def assert_holds(found: Found, document: dict[str, Any]) -> None:
    """Assert that every number of a document is in the workbook, and equal."""
    wanted = dict(numbers(document))
    assert sorted(set(wanted) - set(found)) == []
    for path, value in wanted.items():
        there = found[path]
        assert isinstance(there, int | float), path
        assert same(there, value), (path, there, value)


# ------------------------------------------------------------------ the numbers


OF_THE_LINE = {
    "Fairlead height": "fairlead_height_m",
    "Anchor height": "anchor_height_m",
    "Seabed friction μ": "seabed_friction",
    "Safety factor SF": "safety_factor",
    "Horizontal force H": "horizontal_force_N",
    "Span S": "span_m",
    "Fairlead tension T": "fairlead.tension_N",
    "Fairlead vertical force V": "fairlead.vertical_force_N",
    "Inclination at the fairlead θ₁": "fairlead.angle_rad",
    "Anchor tension": "anchor.tension_N",
    "Anchor horizontal force": "anchor.horizontal_force_N",
    "Anchor vertical force": "anchor.vertical_force_N",
    "Inclination at the anchor θ₀": "anchor.angle_rad",
    "Grounded length": "grounded_length_m",
    "Suspended length": "suspended_length_m",
    "Stretched length": "stretched_length_m",
    "Line mass in air": "line_mass_kg",
    "Residual of the height": "residual.height_m",
    "Residual of the span": "residual.span_m",
    "Force left open by rounding of the input": "residual.force_uncertainty_N",
}
UNITS = {
    "m": 1.0, "kN": KILO, "tf": 9806.65, "deg": DEGREE, "rad": 1.0, "t": 1e3, "kg/m^3": 1.0, "": 1.0
}  # fmt: skip


def in_summary(book: Any) -> Found:
    found: Found = {}
    for number in (0, 1):
        for row in table(book["Summary"], "Quantity", number):
            if row["Quantity"] in OF_THE_LINE:
                found[OF_THE_LINE[row["Quantity"]]] = row["Value in SI"]
    found["fairlead.horizontal_force_N"] = found["horizontal_force_N"]
    return found


def in_tables(book: Any) -> Found:
    """Find what the sheets Components and Line say of segments, point loads and the shape."""
    found: Found = {}
    sheet = book["Components"]
    for index, row in enumerate(table(sheet, "Segment", 1)):
        path = f"segments[{index}]"
        found[f"{path}.length_m"] = row["Length L (m)"]
        found[f"{path}.max_tension_N"] = row["Largest tension T (kN)"] * KILO
        found[f"{path}.utilisation"] = row["Utilisation"]
        found[f"{path}.max_tension_tf"] = row["Largest tension T (tf)"]
    if any(cell.value == "Point load" for cell in sheet["A"]):
        for index, row in enumerate(table(sheet, "Point load")):
            path = f"point_loads[{index}]"
            found[f"{path}.position_m"] = row["Position from the anchor (m)"]
            found[f"{path}.x_m"] = row["Distance from the anchor x (m)"]
            found[f"{path}.z_m"] = row["Height above the seabed z (m)"]
            found[f"{path}.seabed_reaction_N"] = row["Seabed reaction R (kN)"] * KILO
    for index, row in enumerate(table(book["Line"], "Arc length s (m)")):
        found[f"profile.s_m[{index}]"] = row["Arc length s (m)"]
        found[f"profile.x_m[{index}]"] = row["Distance from the anchor x (m)"]
        found[f"profile.z_m[{index}]"] = row["Height above the seabed z (m)"]
        found[f"profile.tension_N[{index}]"] = row["Tension T (kN)"] * KILO
    return found


@pytest.mark.parametrize("name", EVERY)
def test_every_number_of_the_solution_s_document(name: str) -> None:
    book = workbook(name)
    document = known_note(name).solution.to_dict(profile=True)
    document.pop("found", None)
    assert_holds(in_summary(book) | in_tables(book), document)


@pytest.mark.parametrize("name", EVERY)
def test_the_summary_is_the_same_in_both_units(name: str) -> None:
    book = workbook(name)
    shown = [row for number in (0, 1) for row in table(book["Summary"], "Quantity", number)]
    assert len(shown) > 15
    si: float | None = None
    for row in shown:
        si = row["Value in SI"] if row["Value in SI"] is not None else si
        assert si is not None
        assert same(row["Value"] * UNITS[row["Unit"]], si), row


FIELD = {"N": KILO, "m": 1.0, "rad": DEGREE}


@pytest.mark.parametrize("name", [name for name in EVERY if known_note(name).checks.results])
def test_every_number_of_the_checks_document(name: str) -> None:
    report = known_note(name).checks
    rows = table(workbook(name)["Checks"], "Load case")
    document = report.to_dict()
    assert len(rows) == len(document["checks"])
    for row, check in zip(rows, document["checks"], strict=True):
        unit = FIELD[check["unit"]]
        assert (row["Load case"], row["Check"]) == (check["load_case"], check["name"])
        assert same(row["Demand"] * unit, check["demand"])
        assert same(row["Capacity"] * unit, check["capacity"])
        if check["utilisation"] is None:
            assert row["Utilisation"] is None
        else:
            assert same(row["Utilisation"], check["utilisation"])
        assert row["Verdict"].startswith("passes" if check["passes"] else "FAILS")
    marked = [index for index, row in enumerate(rows) if row["Verdict"].endswith(" *")]
    assert marked == [document["governing"]]


def test_every_number_of_the_load_cases() -> None:
    document = known_note("states").checks.to_dict()["load_cases"]
    rows = table(workbook("states")["Load cases"], "Load case")
    headings = {
        "Fairlead height (m)": ("fairlead_height_m", 1.0),
        "Horizontal force H (kN)": ("horizontal_force_N", KILO),
        "Span S (m)": ("span_m", 1.0),
        "Fairlead tension T (kN)": ("fairlead_tension_N", KILO),
        "Anchor horizontal force H (kN)": ("anchor_horizontal_force_N", KILO),
        "Anchor vertical force V (kN)": ("anchor_vertical_force_N", KILO),
        "Inclination at the anchor θ (deg)": ("anchor_angle_rad", DEGREE),
        "Grounded length (m)": ("grounded_length_m", 1.0),
    }
    assert [row["Load case"] for row in rows] == [state["name"] for state in document]
    for row, state in zip(rows, document, strict=True):
        for heading, (key, unit) in headings.items():
            assert same(row[heading] * unit, state[key]), heading


@pytest.mark.parametrize("name", [name for name in EVERY if known_note(name).curve is not None])
def test_every_number_of_the_curve(name: str) -> None:
    curve = known_note(name).curve
    assert curve is not None
    document = curve.to_dict()
    rows = table(workbook(name)["Curve"], "Span S (m)")
    for heading, key, unit in (
        ("Span S (m)", "span_m", 1.0),
        ("Offset (m)", "offset_m", 1.0),
        ("Horizontal force H (kN)", "horizontal_force_N", KILO),
        ("Fairlead tension T (kN)", "fairlead_tension_N", KILO),
        ("Anchor tension TA (kN)", "anchor_tension_N", KILO),
        ("Inclination at the anchor θ₀ (deg)", "anchor_angle_rad", DEGREE),
        ("Grounded length (m)", "grounded_length_m", 1.0),
        ("Stiffness k (kN/m)", "stiffness_N_per_m", KILO),
    ):
        assert len(rows) == len(document[key])
        for row, value in zip(rows, document[key], strict=True):
            there = row[heading]
            assert there is value is None or same(there * unit, value), heading
    marks = table(workbook(name)["Curve"], "What happens as the force grows")
    assert same(marks[0]["Span S (m)"], document["reference"]["span_m"])
    for row, mark in zip(marks[1:], document["marks"], strict=True):
        assert same(row["Span S (m)"], mark["span_m"])
        assert same(row["Fairlead tension T (kN)"] * KILO, mark["fairlead_tension_N"])


@cache
def design_note() -> Note:
    """Search the space of a case that comes with catopt, and make the note of its answer."""
    from tempfile import TemporaryDirectory

    from catopt.casefile import read_case, write_case
    from catopt.design.search import design_case
    from catopt.render.plain import document_bytes
    from catopt.report.files import write_files

    result = design_case(read_case(CASES / "design-buoy-9.5m" / "case.toml"))
    with TemporaryDirectory() as folder:
        case, document = write_case(result.case).encode(), document_bytes(result.to_dict())
        write_files(Path(folder), {"case.toml": case, "design.json": document})
        note = read_note(Path(folder))
    assert note.chosen is not None
    written = design_document(result)
    del written["messages"]  # put in their places when the document is read
    assert list(numbers(note.chosen.document)) == list(numbers(written))
    return note


def test_every_objective_of_the_design_s_document() -> None:
    note = design_note()
    assert note.chosen is not None
    document = note.chosen.document
    book = opened(note)
    rows = table(book["Front"], "Design")
    keys = {"Mass in air (t)": ("mass_kg", 1e3), "Largest span S (m)": ("offset_m", 1.0),
            "Excursion (m)": ("excursion_m", 1.0)}  # fmt: skip
    assert len(rows) == len(document["front"]) > 10
    for number, (row, point) in enumerate(zip(rows, document["front"], strict=True), start=1):
        assert row["Design"] == number
        for heading, (key, unit) in keys.items():
            assert same(row[heading] * unit, point[key])
        assert same(row["Sinker (mass in air) (t)"] * 1e3, point["sinker"]["mass_kg"])
    steps = [*document["neighbours"], document["present"]]
    rows = table(book["Neighbours"], "Change")
    assert len(rows) == len(steps)
    for row, step in zip(rows, steps, strict=True):
        assert row["Verdict"].startswith("passes" if step["feasible"] else "FAILS")
        for heading, (key, unit) in keys.items():
            assert row[heading] is step[key] is None or same(row[heading] * unit, step[key])
        assert row["Utilisation"] is step["utilisation"] is None or same(
            row["Utilisation"], step["utilisation"]
        )


def test_components_are_those_of_the_line() -> None:
    note = known_note("leg")
    (wire, chain) = table(workbook("leg")["Components"], "Segment")
    first, second = note.solution.line.segments
    assert same(wire["Submerged weight per length w (N/m)"], first.submerged_weight)
    assert same(chain["Minimum breaking load MBL (kN)"] * KILO, second.MBL or 0.0)
    assert same(wire["Axial stiffness EA (MN)"] * 1e6, first.EA)
    assert (wire["Name"], chain["Name"]) == ("wire", "")


def test_figures_of_the_catalogue_have_their_source() -> None:
    rows = table(workbook("states")["Catalogue"], "Component")
    assert {row["Component"] for row in rows} == {"chain studless R3 76 mm"}
    (MBL,) = [row for row in rows if row["Quantity"] == "Minimum breaking load"]
    segment = known_note("states").solution.line.segments[0]
    assert same(MBL["Value"] * KILO, segment.MBL or 0.0)
    assert MBL["Confidence"] in {"A", "B", "C", "R"}
    assert MBL["Source"]


def test_inputs_are_numbers_in_si() -> None:
    rows = {row["Key"]: row for row in table(workbook("leg")["Inputs"], "Key")}
    assert rows["site.water_depth"] == {
        "Key": "site.water_depth", "As given": "56 m", "SI": 56.0, "SI unit": "m"
    }  # fmt: skip
    assert rows["line.segments[0].submerged_weight"]["SI"] == pytest.approx(30.4 * 9.80665)
    assert rows["site.seabed_friction"]["As given"] == 0.6
    assert "title" not in rows


@pytest.mark.parametrize("name", EVERY)
def test_every_number_of_the_verification(name: str) -> None:
    verification = known_note(name).verification
    assert verification is not None
    document = verification.to_dict()["static"]
    sheet = workbook(name)["Verification"]
    rows = table(sheet, "Quantity")
    assert len(rows) == len(document["quantities"])
    for row, each in zip(rows, document["quantities"], strict=True):
        unit = UNITS[row["Unit"]]
        assert same(row["Closed form"] * unit, each["closed_form"])
        assert same(row["Truss model, extrapolated"] * unit, each["extrapolated"])
        for mesh, value in zip(document["meshes"], each["fem"], strict=True):
            assert same(row[f"Truss of {mesh['elements']} bars"] * unit, value)
        gap = abs(each["difference"]) / each["scale"]
        assert same(row["Difference over its scale"], gap)
        order = row["Observed order"]
        assert order is each["order"] is None or same(order, each["order"])
        assert row["Verdict"] == ("agrees" if each["agrees"] else "DIFFERS")
    places = [cell.row for row in sheet.iter_rows() for cell in row if cell.value == "Bars"]
    for number, mesh in enumerate(document["meshes"], start=places[0] + 1):
        assert sheet.cell(number, 1).value == mesh["elements"]
        assert same(sheet.cell(number, 3).value, mesh["residual"])


# ------------------------------------------------------------------ the look


NOTES = [*EVERY, "design"]


def note_named(name: str) -> Note:
    return design_note() if name == "design" else known_note(name)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NOTES)
def test_every_sheet_is_laid_out_for_a_reader(name: str, language: Language) -> None:
    note = note_named(name)
    book = opened(note, language)
    if language == "en":
        assert book.sheetnames[0] == "Summary"
        assert [each for each in CERTAIN if each not in book.sheetnames] == []
        assert ("Curve" in book.sheetnames) == (note.curve is not None)
        assert ("Checks" in book.sheetnames) == bool(note.checks.results)
        assert ("Front" in book.sheetnames) == (note.chosen is not None)
    for sheet in book:
        assert sheet.freeze_panes == "A2"
        assert sheet.page_setup.paperSize == 9
        assert sheet.page_setup.fitToWidth in (None, 1)
        assert sheet.sheet_properties.pageSetUpPr.fitToPage
        assert sheet.print_area
        set_widths = {
            column
            for each in sheet.column_dimensions.values()
            for column in range(each.min, each.max + 1)
        }
        used = {cell.column for row in sheet.iter_rows() for cell in row if cell.value is not None}
        assert used <= set_widths


@pytest.mark.parametrize("name", NOTES)
def test_no_cell_is_an_error_or_a_stray_formula(name: str) -> None:
    data = workbook_of(note_named(name))
    values = openpyxl.load_workbook(BytesIO(data), data_only=True)
    formulas = openpyxl.load_workbook(BytesIO(data))
    for sheet in values:
        for row in sheet.iter_rows():
            for cell in row:
                assert cell.data_type != "e", (sheet.title, cell.coordinate)
                assert not re.match(r"#[A-Z]", str(cell.value)), (sheet.title, cell.coordinate)
                shown = formulas[sheet.title][cell.coordinate]
                if shown.data_type == "f":
                    assert re.fullmatch(r"=C\d+/D\d+", shown.value)
                    assert sheet.title == "Checks"


@pytest.mark.parametrize("name", NOTES)
def test_charts_are_native_and_lie_within_the_print_area(name: str) -> None:
    note = note_named(name)
    wanted = 2 + (note.curve is not None) + (note.chosen is not None)
    with zipfile.ZipFile(BytesIO(workbook_of(note))) as package:
        charts = [each for each in package.namelist() if "charts/chart" in each]
        assert len(charts) == wanted
        for chart in charts:
            assert b"<c:scatterChart>" in package.read(chart)
    book = openpyxl.load_workbook(BytesIO(workbook_of(note)))
    seen = 0
    sheet: Any
    for sheet in book:
        area = sheet.print_area.rpartition("!")[2].replace("$", "")
        _, _, right, bottom = range_boundaries(area)
        for chart in sheet._charts:
            seen += 1
            assert chart.anchor.to.col < right
            assert chart.anchor.to.row < bottom
    assert seen == wanted


def test_numbers_have_the_digits_of_their_quantity() -> None:
    sheet = openpyxl.load_workbook(BytesIO(workbook_of(known_note("leg"))))["Line"]
    assert [cell.number_format for cell in sheet[2][:4]] == ["0.000"] * 4
    assert QUANTITIES["tension"].digits == 3


def test_the_same_note_gives_the_same_bytes() -> None:
    note = known_note("leg")
    assert workbook_of(note) == workbook_of(note)


def test_texts_of_the_user_stay_texts(tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    source = (CASES / "buoy-9.5m" / "case.toml").read_text("utf-8")
    path.write_text(source.replace("Marker buoy, 9.5 m", "=1+1"), "utf-8")
    cell = openpyxl.load_workbook(BytesIO(workbook_of(read_note(path))))["Summary"]["A1"]
    assert (cell.value, cell.data_type) == ("=1+1", "s")


def test_a_front_written_by_hand(tmp_path: Path) -> None:
    """A document without what newer ones have beside the objectives is shown, too."""
    note = read_note(design_directory(tmp_path), 3)
    rows = table(opened(note)["Front"], "Design")
    assert [row["Mass in air (t)"] for row in rows] == [4.5, 4.615, 4.73]


# ------------------------------------------------------------------ in LibreOffice


SOFFICE = shutil.which("soffice") or shutil.which("libreoffice")

ALWAYS_RECALCULATE = """<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry">
<item oor:path="/org.openoffice.Office.Calc/Formula/Load"><prop oor:name="OOXMLRecalcMode"
oor:op="fuse"><value>0</value></prop></item>
</oor:items>
"""

FIFTEEN_DIGITS = 1e-14
"""Relative: LibreOffice writes 15 significant digits."""


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
    names = ("leg", "states", "design")
    for name in names:
        (tmp_path / f"{name}.xlsx").write_bytes(workbook_of(note_named(name)))
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


# ------------------------------------------------------------------ in Vietnamese


THE_SAME = {"SI", ""}
"""Headings that are the same in both languages."""


@pytest.mark.parametrize("name", NOTES)
def test_every_heading_and_every_tab_is_translated(name: str) -> None:
    note = note_named(name)
    english, said = opened(note, "en"), opened(note, "vi")
    assert not set(english.sheetnames) & set(said.sheetnames)
    of_the_case = {note.case.title, *(segment.name for segment in note.case.line.segments)}
    for ours, theirs in zip(english, said, strict=True):
        for row, other in zip(ours.iter_rows(), theirs.iter_rows(), strict=True):
            for cell, there in zip(row, other, strict=True):
                if isinstance(cell.value, str) and cell.font.b and cell.value not in of_the_case:
                    assert there.value not in {cell.value} - THE_SAME, cell.coordinate
