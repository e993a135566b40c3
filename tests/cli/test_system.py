"""``catopt system``: its document, and in which headings a body rests."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

import catopt

from .conftest import FSO, OWN, Run, changed, document_of, sheets, typed, words

SPREAD = OWN / "four-lines.toml"


def test_the_document_says_what_python_says(run: Run) -> None:
    document = document_of(run, "system", FSO)
    system = catopt.read_case(FSO).system
    assert system is not None
    solution = catopt.solve_system(system)
    assert document["offset_m"] == list(solution.offset)
    tensions = [line["fairlead_tension_N"] for line in document["lines"]]
    assert tensions == [line.tension for line in solution.lines]
    assert document["stiffness_N_per_m"] == [list(row) for row in solution.stiffness]
    # published.toml, [fso_rang_dong.finding]: about 22 m with a bed that only pushes
    assert document["offset_m"][0] == pytest.approx(-22.0, abs=0.5)
    assert document["sharing_rule"]["applies"] is False
    for extra in ("one_line_out", "watch_circle", "restoring_curves", "water_levels"):
        assert extra not in document


def test_what_is_asked_for_is_there(run: Run) -> None:
    document = document_of(run, *typed("system FSO EVERYTHING"))
    assert [each["missing_line"] for each in document["one_line_out"]] == list(range(1, 10))
    assert document["watch_circle"]["force_N"] == 4.281e6
    directions = [each["direction_rad"] for each in document["restoring_curves"]]
    assert directions == [pytest.approx(math.pi), 1.0]
    assert [each["level_m"] for each in document["water_levels"]] == [-2.0, 2.0]
    at_rest, held = document["held_body"]
    assert at_rest["displacement"][0] == document["position"]["x_m"]
    assert at_rest["load"][:2] == [pytest.approx(4.281e6), pytest.approx(0.0, abs=1e-3)]
    assert at_rest["stiffness"][0][0] == pytest.approx(document["stiffness_N_per_m"][0][0])
    assert held["displacement"] == [5.0, 0.0, -1.0, 0.0, pytest.approx(math.radians(2.0)), 0.0]


def test_a_body_that_turns_and_the_rule_of_practice(run: Run) -> None:
    document = document_of(run, "system", SPREAD)
    assert document["yaw_is_free"] is True
    assert len(document["stiffness_with_yaw"]) == 3
    assert document["sharing_rule"] == {
        "applies": True,
        "line": 3,
        "horizontal_force_N": pytest.approx(200e3),  # N / 4 = 1: the one line carries all
        "why_not": "",
    }


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


def test_a_moment_that_is_carried_is_not_refused(run: Run, tmp_path: Path) -> None:
    """One line on an arm of 20 m under 100 kN holds 400 kN m: it could hold 2,000."""
    case = changed(
        SPREAD, tmp_path, ('"0 deg", "90 deg", "180 deg", "270 deg"', '"16 deg"'),
        ('"10 m"', '"20 m"'), ('force = ["200 kN"', 'moment = "400 kN*m"\nforce = ["100 kN"'),
    )  # fmt: skip
    document = document_of(run, "system", case)
    assert document["lines"][0]["horizontal_force_N"] == pytest.approx(1e5, rel=1e-9)
    assert -math.pi < document["position"]["yaw_rad"] <= math.pi
