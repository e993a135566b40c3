"""``catopt system``: what it prints and writes, what it refuses, and how it ends."""

from __future__ import annotations

import csv
import json
import math
import re
from pathlib import Path
from typing import Any

import jsonschema
import openpyxl
import pytest

import catopt
from catopt.schemas import schema

from .conftest import BUOY, CASES, Run

FSO = CASES / "fso-rang-dong" / "case.toml"
EVERYTHING = (
    "--line-out", "--watch-circle", "--curve", "180 deg", "--curve", "1.0", "--level", "-2 m",
    "--level", "2", "--stiffness", "--held", "5 m, 0, -1 m, 0, 2 deg, 0",
)  # fmt: skip

SPREAD = """
title = "Buoy on four lines"
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "600 m"
submerged_weight = "1000 N/m"
EA = "800 MN"
[system]
anchor_radius = "570 m"
azimuths = ["0 deg", "90 deg", "180 deg", "270 deg"]
fairlead_radius = "10 m"
force = ["200 kN", "0 kN"]
"""

TWO_HEADINGS = """
title = "Barge on two lines"
[site]
water_depth = "20 m"
[line]
[[line.segments]]
length = "80 m"
submerged_weight = "1000 N/m"
EA = "800 MN"
[system]
anchor_radius = "100 m"
azimuths = ["30 deg", "330 deg"]
fairlead_radius = "40 m"
force = ["100 kN", "0 kN"]
"""
"""By symmetry the body heads along x: bow to the anchors, or beyond them with its bow back."""


def document_of(run: Run, *arguments: object) -> dict[str, Any]:
    ran = run(*arguments, "--json")
    assert ran.status == 0, ran.err
    document: dict[str, Any] = json.loads(ran.out)
    jsonschema.validate(document, schema("catopt.system/1"))
    return document


def written(folder: Path, text: str) -> Path:
    path = folder / "case.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_document_keeps_its_schema_and_says_what_python_says(run: Run) -> None:
    document = document_of(run, "system", FSO)
    system = catopt.read_case(FSO).system
    assert system is not None
    solution = catopt.solve_system(system)
    assert document["offset_m"] == list(solution.offset)
    assert [line["fairlead_tension_N"] for line in document["lines"]] == [
        line.tension for line in solution.lines
    ]
    assert document["stiffness_N_per_m"] == [list(row) for row in solution.stiffness]
    # published.toml, [fso_rang_dong.finding]: about 22 m with a bed that only pushes
    assert document["offset_m"][0] == pytest.approx(-22.0, abs=0.5)
    assert document["sharing_rule"]["applies"] is False
    for extra in ("one_line_out", "watch_circle", "restoring_curves", "water_levels"):
        assert extra not in document


def test_what_is_asked_for_is_there(run: Run) -> None:
    document = document_of(run, "system", FSO, *EVERYTHING)
    assert [each["missing_line"] for each in document["one_line_out"]] == list(range(1, 10))
    assert document["watch_circle"]["force_N"] == 4.281e6
    assert [each["direction_rad"] for each in document["restoring_curves"]] == [
        pytest.approx(3.141592653589793),
        1.0,
    ]
    assert [each["level_m"] for each in document["water_levels"]] == [-2.0, 2.0]
    at_rest, held = document["held_body"]
    assert at_rest["displacement"][0] == document["position"]["x_m"]
    assert at_rest["load"][:2] == [pytest.approx(4.281e6), pytest.approx(0.0, abs=1e-3)]
    assert at_rest["stiffness"][0][0] == pytest.approx(document["stiffness_N_per_m"][0][0])
    assert held["displacement"] == [5.0, 0.0, -1.0, 0.0, pytest.approx(math.radians(2.0)), 0.0]


def test_a_body_that_turns_and_the_rule_of_practice(run: Run, tmp_path: Path) -> None:
    document = document_of(run, "system", written(tmp_path, SPREAD))
    assert document["yaw_is_free"] is True
    assert len(document["stiffness_with_yaw"]) == 3
    assert document["sharing_rule"] == {
        "applies": True,
        "line": 3,
        "horizontal_force_N": pytest.approx(200e3),  # N / 4 = 1: the one line carries all
        "why_not": "",
    }
    shown = run("system", tmp_path / "case.toml").out
    assert "by the rule of practice" in shown
    assert "free in x, y and yaw" in shown


def test_what_a_reader_sees(run: Run) -> None:
    shown = run("system", FSO, *EVERYTHING).out
    for words in (
        "FSO Rang Dong, nine-line turret",
        "9 lines, the body free in x and y",
        "Offset along x                 -21.738 m",
        "One line out",
        "A force of 4281.000 kN in every direction",
        "Held at offsets towards 180.00 deg",
        "Water levels",
        "Held at surge 5.000 m, sway 0.000 m, heave -1.000 m",
        "does not apply",
        "Residual of the balance",
    ):
        assert words in shown
    assert max(len(line) for line in shown.splitlines()) <= 80
    assert "…" not in shown.partition("Water levels")[0]


def test_the_files(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "out"
    ran = run("system", FSO, *EVERYTHING, "--out", out)
    assert ran.status == 0, ran.err
    assert sorted(path.name for path in out.iterdir()) == [
        "body.csv", "case.toml", "held_1_forces.csv", "held_1_load.csv", "held_1_moments.csv",
        "held_2_forces.csv", "held_2_load.csv", "held_2_moments.csv", "line_out.csv",
        "lines.csv", "plan.png", "plan.svg",
        "restoring.png", "restoring.svg", "restoring_1.csv", "restoring_2.csv", "system.json",
        "system.xlsx",
        "watch_circle.csv", "watch_circle.png", "watch_circle.svg", "water_levels.csv",
    ]  # fmt: skip
    document = json.loads((out / "system.json").read_text("utf-8"))
    with (out / "lines.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [float(row["Fairlead tension T (kN)"]) for row in rows] == pytest.approx(
        [line["fairlead_tension_N"] / 1e3 for line in document["lines"]], rel=1e-12
    )
    book = openpyxl.load_workbook(out / "system.xlsx")
    assert book.sheetnames == [
        "Body", "Lines", "One line out", "Watch circle", "Restoring 1", "Restoring 2",
        "Water levels", "Lines on a held body 1", "Lines on a held body 2",
    ]  # fmt: skip


def test_only_what_was_asked_for_is_written(run: Run, tmp_path: Path) -> None:
    run("system", FSO, "--out", tmp_path)
    assert {path.stem for path in tmp_path.iterdir()} == {"body", "case", "lines", "plan", "system"}


def test_no_watch_circle_without_a_force(run: Run, tmp_path: Path) -> None:
    path = written(tmp_path, SPREAD.replace('force = ["200 kN", "0 kN"]', ""))
    ran = run("system", path, "--watch-circle")
    assert ran.status == 0
    assert "no watch circle" in ran.err


def test_a_case_without_a_system(run: Run) -> None:
    ran = run("system", BUOY)
    assert ran.status == 2
    assert "a table [system]" in ran.err


@pytest.mark.parametrize("command", ["solve", "curve"])
def test_a_system_is_not_solved_as_one_line(run: Run, command: str) -> None:
    ran = run(command, FSO)
    assert ran.status == 2
    assert "catopt system solves it" in ran.err


def test_wrong_options(run: Run) -> None:
    ran = run("system", FSO, "--curve", "12 kg")
    assert ran.status == 2
    assert "--curve" in ran.err


def test_lines_that_do_not_meet(run: Run, tmp_path: Path) -> None:
    text = SPREAD.replace('EA = "800 MN"', "").replace("600 m", "500 m")
    ran = run("system", written(tmp_path, text))
    assert ran.status == 3
    assert "no place that every line reaches" in ran.err


def test_a_second_heading_is_named_in_every_face(run: Run, tmp_path: Path) -> None:
    case = written(tmp_path, TWO_HEADINGS)
    told = re.compile(
        r"the body would also rest at a yaw of -?180\.00 deg, its origin at \(\d+\.\d{3}, 0\.000\) "
        "m: which of them it takes depends on how it came there"
    )
    document = document_of(run, "system", case)
    assert document["position"]["yaw_rad"] == pytest.approx(0.0, abs=1e-9)
    assert sum(told.fullmatch(warning) is not None for warning in document["warnings"]) == 1
    assert told.search(" ".join(run("system", case).out.split()))
    assert run("report", case, "--no-verify", "--out", tmp_path / "note").status == 0
    (page,) = (tmp_path / "note").glob("*.html")
    assert told.search(page.read_text(encoding="utf-8"))
    (path,) = (tmp_path / "note").glob("*.xlsx")
    book = openpyxl.load_workbook(path)
    cells = [
        str(cell) for sheet in book for row in sheet.iter_rows(values_only=True) for cell in row
    ]
    assert any(told.search(cell) for cell in cells)


def test_a_moment_that_is_carried_is_not_refused(run: Run, tmp_path: Path) -> None:
    """One line on an arm of 20 m under 100 kN holds 400 kN m: it could hold 2,000."""
    text = SPREAD.replace(
        'azimuths = ["0 deg", "90 deg", "180 deg", "270 deg"]', 'azimuths = ["16 deg"]'
    )
    text = text.replace('"10 m"', '"20 m"').replace('"200 kN"', '"100 kN"')
    document = document_of(run, "system", written(tmp_path, text + 'moment = "400 kN*m"\n'))
    assert document["lines"][0]["horizontal_force_N"] == pytest.approx(1e5, rel=1e-9)
    assert -math.pi < document["position"]["yaw_rad"] <= math.pi


def test_a_moment_that_is_not_carried(run: Run, tmp_path: Path) -> None:
    ran = run("system", written(tmp_path, SPREAD + 'moment = "900 MN*m"\n'))
    assert ran.status == 3
    assert "cannot carry the moment" in ran.err


def test_what_does_not_go_with_a_system(run: Run, tmp_path: Path) -> None:
    text = SPREAD.replace('fairlead_radius = "10 m"', 'moment = "5 kN*m"\nyaw_free = true')
    ran = run("system", written(tmp_path, text + '[load]\nspan = "500 m"\n'))
    assert ran.status == 2
    assert "system.yaw_free" in ran.err
    assert "leave out load or system" in ran.err


def test_a_wrong_displacement_is_refused(run: Run) -> None:
    ran = run("system", FSO, "--held", "5 m, 0, 0")
    assert ran.status == 2
    assert "must be six values with commas between them: surge, sway, heave" in ran.err
    ran = run("system", FSO, "--held", "5 kN, 0, 0, 2 deg, 3 m, 0")
    assert "--held, surge: found" in ran.err
    assert "--held, pitch: found" in ran.err
