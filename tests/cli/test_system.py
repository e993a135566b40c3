"""``catopt system``: its document, and in which headings a body rests."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import catopt

from .conftest import FSO, OWN, Run, document_of, sheets, words


def test_the_document_says_what_python_says(run: Run) -> None:
    document = document_of(run, "system", FSO)
    system = catopt.read_case(FSO).system
    assert system is not None
    solution = catopt.solve_system(system)
    assert document["offset_m"] == list(solution.offset)
    tensions = [line["fairlead_tension_N"] for line in document["lines"]]
    assert tensions == [line.tension for line in solution.lines]
    assert document["stiffness_N_per_m"] == [list(row) for row in solution.stiffness]
    for extra in ("one_line_out", "watch_circle", "restoring_curves", "water_levels"):
        assert extra not in document


def test_a_second_heading_is_named_in_every_face(run: Run, tmp_path: Path) -> None:
    """By symmetry the body heads along x: bow to the anchors, or beyond them with its bow back."""
    case = OWN / "two-headings.toml"
    told = re.compile(
        r"the body would also rest at a yaw of -?180\.00 deg, its origin at \(\d+\.\d{3}, 0\.000\) "
        "m: which of them it takes depends on how it came there"
    )
    document = document_of(run, "system", case)
    assert document["position"]["yaw_rad"] == pytest.approx(0.0, abs=1e-9)
    assert sum(told.fullmatch(warning) is not None for warning in document["warnings"]) == 1
    assert told.search(words(run("system", case).out))
    assert run("report", case, "--no-verify", "--out", tmp_path / "note").status == 0
    (page,) = (tmp_path / "note").glob("*.html")
    assert told.search(page.read_text(encoding="utf-8"))
    (path,) = (tmp_path / "note").glob("*.xlsx")
    cells = [str(cell) for sheet in sheets(path).values() for row in sheet for cell in row]
    assert any(told.search(cell) for cell in cells)
