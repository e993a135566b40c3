"""``--units``: tables, files, figures and notes are all in the units that are asked for."""

from __future__ import annotations

import re
from pathlib import Path

import openpyxl
import pytest

from .conftest import BUOY, CASES, Run

DESIGN = CASES / "design-buoy-9.5m" / "case.toml"
TANKER = CASES / "tanker-20m-sinker" / "case.toml"
BODY = CASES / "fso-rang-dong" / "case.toml"
SIZED: list[object] = [
    "size", "tanker", "--length", "234 m", "--breadth", "31.3 m", "--draught", "12.4 m",
    "--depth", "20 m",
]  # fmt: skip

COMMANDS: list[list[object]] = [
    ["solve", BUOY, "--profile"],
    ["solve", TANKER],
    ["check", TANKER],
    ["curve", BUOY],
    ["system", BODY],
    ["design", DESIGN],
    SIZED,
]


@pytest.mark.parametrize("units", ["tf", "si"])
@pytest.mark.parametrize("arguments", COMMANDS, ids=lambda arguments: " ".join(map(str, arguments)))
def test_no_kilonewton_is_left_on_a_terminal(run: Run, arguments: list[object], units: str) -> None:
    assert "kN" in run(*arguments).out
    assert "kN" not in run(*arguments, "--units", units).out


def test_a_value_is_the_same_force(run: Run) -> None:
    """S1's buoy: H is given as 0.343 tf, 0.343 x 9.80665 = 3.364 kN (theory: exact)."""
    for units, force in {"tf": "0.3430 tf", "kN": "3.364 kN", "si": "3364 N"}.items():
        shown = run("solve", BUOY, "--units", units).out
        assert re.search(rf"\nHorizontal force H +{re.escape(force)}\n", shown)


def test_the_setting_of_the_user_holds_and_an_option_goes_before_it(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CATOPT_UNITS", "tf")
    assert "0.3430 tf\n" in run("solve", BUOY).out
    assert "kN" not in run("solve", BUOY).out
    assert "tf" not in run("solve", BUOY, "--units", "kN").out
    monkeypatch.setenv("CATOPT_UNITS", "stone")
    ran = run("solve", BUOY)
    assert ran.status == 2
    assert "'stone' is not one of 'tf', 'kN', 'si'" in ran.err


def test_published_figures_stay_in_the_units_in_which_they_are_printed(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    ran = run("reproduce", "load_sharing", "--units", "tf")
    assert ran.status == 2
    assert "No such option" in ran.err
    usual = run("reproduce", "load_sharing").out
    monkeypatch.setenv("CATOPT_UNITS", "tf")
    assert run("reproduce", "load_sharing").out == usual


def test_one_run_leaves_no_units_to_the_next(run: Run) -> None:
    usual = run("solve", BUOY).out
    run("solve", BUOY, "--units", "tf")
    assert run("solve", BUOY).out == usual


def test_every_file_is_in_them_and_the_document_is_in_si(run: Run, tmp_path: Path) -> None:
    usual = run(*SIZED, "--json").out
    assert run(*SIZED, "--units", "tf", "--json", "--out", tmp_path).out == usual
    assert "Pull" in (tmp_path / "sizing.csv").read_text("utf-8")
    for path in tmp_path.glob("*.csv"):
        assert "kN" not in path.read_text("utf-8").replace("(44 - 0.08 d) kN", "")
    assert "F (tf)" in (tmp_path / "forces.csv").read_text("utf-8")
    book = openpyxl.load_workbook(tmp_path / "size.xlsx")
    words = [str(cell.value) for sheet in book for row in sheet.iter_rows() for cell in row]
    assert any("(tf)" in each for each in words)
    assert not any("kN" in each for each in words)
    page = (tmp_path / "note.html").read_text("utf-8").replace("(44 - 0.08 d) kN", "")
    assert " tf" in page
    assert "kN" not in page


def test_a_drawing_has_one_axis_of_tension_in_them(run: Run, tmp_path: Path) -> None:
    """Beside kN stands tf; who asks for one of them sees it alone."""
    run("solve", BUOY, "--units", "tf", "--out", tmp_path)
    drawn = (tmp_path / "tension.svg").read_text("utf-8")
    assert drawn.count("(tf) -->") == 1
    assert "kN" not in drawn
