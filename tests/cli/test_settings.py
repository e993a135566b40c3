"""``--units``, ``--lang`` and what is set once for all by the environment."""

from __future__ import annotations

from pathlib import Path

import pytest

from .conftest import BUOY, Run, refused, sheets, typed


def test_the_language_may_be_set_once_for_all(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    english, vietnamese = run("solve", BUOY).out, run("solve", BUOY, "--lang", "vi").out
    monkeypatch.setenv("CATOPT_LANG", "vi")
    assert run("solve", BUOY).out == vietnamese != english
    assert run("solve", BUOY, "--lang", "en").out == english
    monkeypatch.setenv("CATOPT_LANG", "fr")
    refused = run("solve", BUOY)
    assert refused.status == 2
    assert "CATOPT_LANG" in refused.err


def test_the_units_of_the_user_hold_and_an_option_goes_before_them(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CATOPT_UNITS", "tf")
    assert "0.3430 tf\n" in run("solve", BUOY).out
    assert "kN" not in run("solve", BUOY).out
    assert "tf" not in run("solve", BUOY, "--units", "kN").out
    monkeypatch.setenv("CATOPT_UNITS", "stone")
    ran = refused(run, "solve", BUOY)
    assert "'stone' is not one of 'tf', 'kN', 'si'" in ran.err


def test_published_figures_stay_in_the_units_in_which_they_are_printed(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    usual = run("reproduce", "load_sharing").out
    monkeypatch.setenv("CATOPT_UNITS", "tf")
    assert run("reproduce", "load_sharing").out == usual


def test_one_run_leaves_no_units_to_the_next(run: Run) -> None:
    usual = run("solve", BUOY).out
    run("solve", BUOY, "--units", "tf")
    assert run("solve", BUOY).out == usual


def test_every_file_is_in_them_and_the_document_is_in_si(run: Run, tmp_path: Path) -> None:
    sized = typed(
        "size tanker --length '234 m' --breadth '31.3 m' --draught '12.4 m' --depth '20 m'"
    )
    usual = run(*sized, "--json").out
    assert run(*sized, "--units", "tf", "--json", "--out", tmp_path).out == usual
    assert "Pull" in (tmp_path / "sizing.csv").read_text("utf-8")
    for path in tmp_path.glob("*.csv"):
        assert "kN" not in path.read_text("utf-8").replace("(44 - 0.08 d) kN", "")
    assert "F (tf)" in (tmp_path / "forces.csv").read_text("utf-8")
    tables = sheets(tmp_path / "size.xlsx").values()
    said = [str(cell) for table in tables for row in table for cell in row]
    assert any("(tf)" in each for each in said)
    assert not any("kN" in each for each in said)
    page = (tmp_path / "note.html").read_text("utf-8").replace("(44 - 0.08 d) kN", "")
    assert " tf" in page
    assert "kN" not in page


def test_a_drawing_has_one_axis_of_tension_in_them(run: Run, tmp_path: Path) -> None:
    """Beside kN stands tf; who asks for one of them sees it alone."""
    run("solve", BUOY, "--units", "tf", "--out", tmp_path)
    drawn = (tmp_path / "tension.svg").read_text("utf-8")
    assert drawn.count("(tf) -->") == 1
    assert "kN" not in drawn
