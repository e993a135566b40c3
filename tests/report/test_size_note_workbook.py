"""The note of a sizing as a workbook: its numbers are the document's, and it opens."""

from __future__ import annotations

import math
import re
import shutil
import subprocess
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from catopt.notes.size import Given, size_note
from catopt.render.texts import LANGUAGES, Language
from catopt.report.workbook.note_size import size_note_workbook

from .size_page_cases import EVERY, known_size_note
from .test_note_workbook import assert_holds, same, table

KILO, MILLI, DEGREE = 1e3, 1e-3, math.pi / 180.0

OF_EVERY = [
    "Summary", "Inputs", "Loads", "Load sums", "Candidates", "Line", "Checks", "Load cases",
    "What holds the line", "Swing radius", "What the answer rests on", "Curve", "Front",
    "Neighbours", "Components", "Catalogue", "Verification",
]  # fmt: skip


@cache
def workbook(name: str, language: Language = "en") -> Any:
    """Read the workbook of a sizing back, once."""
    data = size_note_workbook(known_size_note(name), language)
    return openpyxl.load_workbook(BytesIO(data), data_only=True)


def assert_same(found: float | None, value: float | None) -> None:
    """Assert that both are equal but for the workbook's digits, or both missing."""
    assert (found is None) == (value is None)
    assert found is None or value is None or same(found, value)


@pytest.fixture(params=EVERY)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


def test_the_sheets_are_there_in_order(name: str) -> None:
    sheets = workbook(name).sheetnames
    assert [each for each in sheets if each not in ("Numbers", "Several lines")] == OF_EVERY
    assert ("Several lines" in sheets) == (name == "six")
    assert ("Numbers" in sheets) == (name != "given")


def test_every_number_of_the_summary(name: str) -> None:
    document = known_size_note(name).sizing.to_dict()
    rows = table(workbook(name)["Summary"], "Quantity")
    found = {row["Quantity"].partition(" (")[0]: row["Value in SI"] for row in rows}
    chain = document["chain"]
    for label, value in {
        "Nominal diameter": chain["nominal_diameter_m"],
        "Length": chain["length_m"],
        "Line mass in air": chain["mass_kg"],
        "Swing radius at low water": document["swing_radius"]["total_m"],
        "Excursion": document["excursion_m"],
        "Largest tension": document["largest_tension_N"],
        "Reserve buoyancy": document["reserve_buoyancy_N"],
        "MBL over largest tension, new chain": document["break_factor"],
        "Proof load over largest tension, new chain": document["proof_factor"],
    }.items():
        assert_same(found.get(label), value)


def test_every_force_and_every_number_of_the_loads(name: str) -> None:
    document = known_size_note(name).sizing.to_dict()["loads"]
    book = workbook(name)
    found: dict[str, float | None] = {}
    wanted: dict[str, Any] = {"loads": []}
    rows = [row for row in table(book["Loads"], "Load case") if row["Formula"]]
    numbers = table(book["Numbers"], "Load case") if "Numbers" in book.sheetnames else []
    at, put = iter(rows), iter(numbers)
    for each in document:
        for part in each["parts"]:
            for component in part["components"]:
                row = next(at)
                place = f"loads[{len(wanted['loads'])}]"
                assert (row["Load case"], row["Force"]) == (each["load_case"], component["name"])
                assert row["Confidence"] == component["source"]["confidence"]
                found[f"{place}.force"] = row["Horizontal force H (kN)"] * KILO
                values = []
                for index, number in enumerate(component["numbers"]):
                    shown = next(put)
                    assert shown["Meaning"] == number["meaning"]
                    found[f"{place}.numbers[{index}]"] = shown["Value in SI"]
                    values.append(number["value"])
                wanted["loads"].append({"force": abs(component["force_N"]), "numbers": values})
    assert list(at) == []
    assert list(put) == []
    assert_holds(found, wanted)


def test_sums_are_formulas_of_what_stands_above_them(name: str) -> None:
    note = known_size_note(name)
    data = size_note_workbook(note)
    formulas: Any = openpyxl.load_workbook(BytesIO(data))["Loads"]
    values: Any = openpyxl.load_workbook(BytesIO(data), data_only=True)["Loads"]
    parts = [part for each in note.sizing.settled.posed.loads for part in each.parts]
    summed = [
        cell for (cell,) in formulas.iter_rows(min_col=4, max_col=4) if "=" in str(cell.value)
    ]
    assert len(summed) == len(parts)
    for cell, part in zip(summed, parts, strict=True):
        found = re.fullmatch(r"=SUM\(D(\d+):D(\d+)\)", str(cell.value))
        assert found is not None
        first, last = int(found[1]), int(found[2])
        assert last == cell.row - 1
        forces = [values.cell(row, 4).value for row in range(first, last + 1)]
        assert math.fsum(forces) * KILO == pytest.approx(part.horizontal_force, rel=1e-13)
        assert same(values.cell(cell.row, 4).value * KILO, part.horizontal_force)


def test_sums_of_load_cases(name: str) -> None:
    document = known_size_note(name).sizing.to_dict()
    rows = table(workbook(name)["Load sums"], "Load case")
    for row, each in zip(rows, document["loads"], strict=True):
        assert row["Load case"] == each["load_case"]
        assert same(row["Sum (kN)"] * KILO, each["horizontal_force_N"])
        assert row["Depth of still water (m)"] == each["depth_m"]


def test_every_number_of_the_candidates(name: str) -> None:
    document = known_size_note(name).sizing.to_dict()["candidates"]
    rows = table(workbook(name)["Candidates"], "Size")
    headings = {
        "Nominal diameter d (mm)": ("nominal_diameter_m", MILLI),
        "Length L (m)": ("length_m", 1.0),
        "Mass in air (t)": ("mass_kg", KILO),
        "Largest span S (m)": ("offset_m", 1.0),
        "Horizontal force H (kN)": ("horizontal_force_N", KILO),
        "Anchor, mass in air (t)": ("anchor_mass_kg", KILO),
    }
    for row, each in zip(rows, document, strict=True):
        assert (row["Size"], row["Chain"]) == (each["role"], each["component"])
        for heading, (key, unit) in headings.items():
            if each[key] is None:
                assert row[heading] is None
            else:
                assert same(row[heading] * unit, each[key]), heading


def test_every_number_of_what_holds_the_line(name: str) -> None:
    document = known_size_note(name).sizing.to_dict()
    size = document["sinker"] or document["drag_anchor"]
    rows = table(workbook(name)["What holds the line"], "What")
    found = {row["What"]: row["Value in SI"] for row in rows}
    for label, key in {
        "Mass in air that is needed": "needed_mass_kg",
        "Safety factor that is wanted": "wanted_factor",
        "Factor that is reached": "factor",
        "Its ultimate holding capacity": "holding_capacity_N",
        "Its weight in water": "submerged_weight_N",
        "Friction on the soil, tan δ": "friction",
        "Density of the sinker": "density_kg_per_m3",
    }.items():
        assert_same(found.get(label), size.get(key))


def test_every_number_of_the_swing_radius(name: str) -> None:
    document = known_size_note(name).sizing.to_dict()["swing_radius"]
    rows = table(workbook(name)["Swing radius"], "Part")
    lengths = {row["Part"]: row["Length (m)"] for row in rows}
    for part in document["parts"]:
        assert same(lengths[part["name"]], part["length_m"])
    assert same(lengths["Swing radius"], document["total_m"])


def test_every_number_of_the_pattern() -> None:
    document = known_size_note("six").sizing.to_dict()["pattern"]
    sheet = workbook("six")["Several lines"]
    headings = {
        "Force on the body (kN)": ("force_N", KILO),
        "Most loaded line by S4's rule (kN)": ("rule_force_N", KILO),
        "Most loaded line in equilibrium (kN)": ("line_force_N", KILO),
        "Tension (kN)": ("tension_N", KILO),
        "Force off that line (deg)": ("direction_rad", DEGREE),
        "Largest offset of the body (m)": ("offset_m", 1.0),
        "Largest pull of all lines downwards (kN)": ("pull_N", KILO),
    }
    for row, state in zip(table(sheet, "Load case"), document["states"], strict=True):
        for heading, (key, unit) in headings.items():
            assert same(row[heading] * unit, state[key]), heading
    listed = {cell.value: sheet.cell(cell.row, 2).value for cell in sheet["A"]}
    assert same(listed["Anchor radius (m)"], document["anchor_radius_m"])
    assert same(listed["Pretension, horizontal (kN)"] * KILO, document["pretension_N"])
    assert listed["Lines"] == 6


def test_every_number_of_the_checks(name: str) -> None:
    document = known_size_note(name).sizing.to_dict()["checks"]
    rows = table(workbook(name)["Checks"], "Load case")
    unit = {"N": KILO, "m": 1.0, "rad": DEGREE}
    for row, check in zip(rows, document, strict=True):
        assert same(row["Demand"] * unit[check["unit"]], check["demand"])
        assert same(row["Capacity"] * unit[check["unit"]], check["capacity"])


def test_every_number_of_the_load_cases(name: str) -> None:
    document = known_size_note(name).sizing.to_dict()["load_cases"]
    rows = table(workbook(name)["Load cases"], "Load case")
    for row, state in zip(rows, document, strict=True):
        assert row["Load case"] == state["name"]
        assert same(row["Horizontal force H (kN)"] * KILO, state["horizontal_force_N"])
        assert same(row["Span S (m)"], state["span_m"])
        assert same(row["Fairlead tension T (kN)"] * KILO, state["tension_N"])


def test_it_has_native_charts(name: str) -> None:
    book: Any = openpyxl.load_workbook(BytesIO(size_note_workbook(known_size_note(name))))
    drawn = {sheet.title for sheet in book if sheet._charts}
    assert {"Line", "Curve", "Front"} <= drawn


def test_the_same_note_gives_the_same_bytes() -> None:
    note = known_size_note("size-buoy")
    assert size_note_workbook(note) == size_note_workbook(note)


def test_options_are_inputs_where_there_is_no_file() -> None:
    given = Given(None, (("BUOY", "pillar 2.4 m"), ("--depth", "12 m")))
    note = size_note(known_size_note("size-buoy").sizing, given, verify=False)
    book = openpyxl.load_workbook(BytesIO(size_note_workbook(note)))
    rows = table(book["Inputs"], "Option")
    assert [(row["Option"], row["As given"]) for row in rows] == list(given.options)
    assert "Verification" not in book.sheetnames


def test_both_languages_have_the_same_numbers(name: str) -> None:
    books = [workbook(name, language) for language in LANGUAGES]
    assert len(books[0].sheetnames) == len(books[1].sheetnames)
    for english, vietnamese in zip(*books, strict=True):
        for one, other in zip(english.iter_rows(), vietnamese.iter_rows(), strict=True):
            for a, b in zip(one, other, strict=True):
                if isinstance(a.value, int | float):
                    assert a.value == b.value, (english.title, a.coordinate)
    assert books[1].sheetnames[2] == "Tải trọng"


LIBREOFFICE = shutil.which("soffice") or shutil.which("libreoffice")


@pytest.mark.slow
@pytest.mark.skipif(not LIBREOFFICE, reason="no LibreOffice on this machine")
@pytest.mark.parametrize("name", ["size-buoy", "six"])
def test_libreoffice_opens_it_and_computes_the_same(name: str, tmp_path: Path) -> None:
    """Converted to .xlsx by LibreOffice, which works its formulas out anew; to fifteen digits."""
    assert LIBREOFFICE is not None
    source = tmp_path / "note.xlsx"
    source.write_bytes(size_note_workbook(known_size_note(name), "vi"))
    out = tmp_path / "out"
    subprocess.run(
        [
            LIBREOFFICE, f"-env:UserInstallation=file://{tmp_path}/profile", "--headless",
            "--convert-to", "xlsx", "--outdir", str(out), str(source),
        ],
        check=True,
        timeout=180,
        capture_output=True,
    )  # fmt: skip
    made = openpyxl.load_workbook(out / "note.xlsx", data_only=True)
    ours = workbook(name, "vi")
    assert made.sheetnames == ours.sheetnames
    for sheet in ours:
        for cells in sheet.iter_rows():
            for cell in cells:
                if isinstance(cell.value, int | float):
                    other = made[sheet.title][cell.coordinate].value
                    assert other == pytest.approx(cell.value, rel=1e-14), cell.coordinate
