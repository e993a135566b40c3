"""``catopt size``: what it prints, writes and asks, and what it says of wrong input."""

from __future__ import annotations

import csv
import json
import sys
from pathlib import Path
from typing import Any

import jsonschema
import openpyxl
import pytest

from catopt import schemas

from .conftest import Run
from .test_cold_start import HEAVY, loaded

BUOY = (
    *("size", "buoy", "pillar 2.4 m", "--depth", "12 m", "--low-water", "10 m"),
    *("--wind", "25 m/s", "--current", "1.5 m/s", "--hs", "1.5 m", "--period", "6 s"),
    *("--soil", "clean fine to medium sand"),
)
OWN = ("size", "buoy", "--depth", "9.5 m", "--force", "0.343 tf", "--reserve-buoyancy", "12 kN")
SHIP = (
    *("size", "tanker", "--length", "234 m", "--breadth", "31.3 m", "--draught", "12.4 m"),
    *("--moulded-depth", "16 m", "--depth", "22 m", "--low-water", "20 m"),
    *("--wind", "20 m/s", "--current", "1.2 m/s", "--hmax", "3.5 m", "--period", "8 s"),
)
AROUND = (*SHIP, "--buoy", "mooring buoy 5.0 m", "--lines", "6")
SINKER = (*SHIP, "--anchor", "sinker", "--clump-weight", "20 t")


def document(run: Run, *arguments: str) -> dict[str, Any]:
    ran = run(*arguments, "--json")
    assert (ran.status, ran.err) == (0, "")
    found: dict[str, Any] = json.loads(ran.out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.size/1")).validate(found)
    return found


@pytest.mark.parametrize(
    "arguments",
    [BUOY, *(pytest.param(each, marks=pytest.mark.slow) for each in (OWN, SHIP, AROUND, SINKER))],
    ids=["buoy", "own", "ship", "around", "sinker"],
)
def test_the_document_is_that_of_its_schema_and_the_view_fits(
    run: Run, arguments: tuple[str, ...]
) -> None:
    found = document(run, *arguments)
    roles = [each["role"] for each in found["candidates"]]
    assert roles.count("recommended") == 1
    assert all(check["passes"] for check in found["checks"])
    shown = run(*arguments).out
    assert max(map(len, shown.splitlines())) <= 80
    assert "\x1b" not in shown  # piped: no colours
    length = found["chain"]["length_m"]
    assert f"{length:g} m = {length / 27.5:.2f} shots" in " ".join(shown.split())


def test_every_load_has_formula_numbers_and_source(run: Run) -> None:
    found = document(run, *BUOY)
    assert [each["load_case"] for each in found["loads"]] == [
        "storm, high water",
        "storm, low water",
    ]
    for each in found["loads"]:
        parts = [component for part in each["parts"] for component in part["components"]]
        assert len(parts) == 5
        assert all(
            one["formula"] and one["numbers"] and one["source"]["confidence"] for one in parts
        )


def test_what_is_not_given_is_told(run: Run) -> None:
    found = document(run, "size", "buoy", "pillar 3.0 m", "--depth", "15 m")
    told = found["defaults"]
    for words in ("wind 25 m/s", "current 1 m/s", "Hs 2 m", "no tide", "code IALA-CALMAR"):
        assert words in told
    assert "wave period 5.1 s" in told  # 3.6 sqrt(2), to the printed digit
    assert not any(each.startswith("wind") for each in document(run, *OWN)["defaults"])


def test_a_saved_case_gives_the_same_answer_to_every_command(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "buoy.toml"
    ran = run(*BUOY, "--save", str(place), "--json")
    assert ran.status == 0
    assert str(place) in ran.err
    sized = json.loads(ran.out)
    design = json.loads(run("design", str(place), "--json").out)
    best = design["front"][sized["design"]["recommended"] - 1]
    assert best["mass_kg"] == min(each["mass_kg"] for each in design["front"])
    assert best["segments"][0]["length_m"] == sized["chain"]["length_m"]
    assert best["segments"][0]["nominal_diameter_m"] == sized["chain"]["nominal_diameter_m"]
    assert best["sinker"]["mass_kg"] == sized["sinker"]["mass_kg"]
    check = json.loads(run("check", str(place), "--json").out)
    assert check["passes"]
    assert check["checks"] == sized["checks"] == best["checks"]
    solved = json.loads(run("solve", str(place), "--json").out)
    assert solved["fairlead"]["tension_N"] == sized["load_cases"][0]["tension_N"]


@pytest.mark.slow
def test_a_saved_pattern_goes_to_catopt_system(run: Run, tmp_path: Path) -> None:
    assert run(*AROUND, "--out", str(tmp_path)).status == 0
    sized = json.loads((tmp_path / "size.json").read_text("utf-8"))
    ran = run("system", str(tmp_path / "system.toml"), "--json")
    assert ran.status == 0
    largest = max(line["horizontal_force_N"] for line in json.loads(ran.out)["lines"])
    states = sized["pattern"]["states"]
    # Both are solved to a residual far below this.
    assert largest == pytest.approx(max(s["line_force_N"] for s in states), rel=1e-9)
    assert json.loads(run("check", str(tmp_path / "case.toml"), "--json").out)["passes"]


def test_a_case_that_is_there_is_kept(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "mine.toml"
    place.write_text("mine", "utf-8")
    ran = run(*BUOY, "--save", str(place))
    assert (ran.status, ran.out) == (2, "")
    assert "--save" in ran.err
    assert "is there already and is kept" in ran.err
    assert place.read_text("utf-8") == "mine"
    gone = run(*BUOY, "--save", str(tmp_path / "gone" / "case.toml"))
    assert gone.status == 2
    assert "there is no directory" in gone.err


def test_what_is_written(run: Run, tmp_path: Path) -> None:
    assert run(*BUOY, "--out", str(tmp_path)).status == 0
    tables = {"inputs", "sizing", "alternatives", "candidates", "checks", "forces"}
    tables |= {"numbers", "notes"}
    files = {"size.json", "size.xlsx", "case.toml", "line.png", "line.svg", "note.html"}
    assert {path.name for path in tmp_path.iterdir()} == files | {f"{t}.csv" for t in tables}
    rows = list(csv.DictReader((tmp_path / "forces.csv").read_text("utf-8").splitlines()))
    totals = [row for row in rows if row["Force"] == "horizontal force"]
    sized = json.loads((tmp_path / "size.json").read_text("utf-8"))
    assert [float(row["Force F (kN)"]) for row in totals] == [
        each["horizontal_force_N"] / 1e3 for each in sized["loads"]
    ]
    book = openpyxl.load_workbook(tmp_path / "size.xlsx")
    assert {name.lower() for name in book.sheetnames} >= tables - {"inputs", "alternatives"}
    book.close()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (
            ("size", "buoy"),
            (
                "2 errors",
                '--depth: missing; it is wanted, such as "12 m"',
                "BUOY: missing; the name",
            ),
        ),
        (
            ("size", "buoy", "piller 1.8 m", "--depth", "12 m", "--wind", "200 m/s"),
            ("2 errors", "did you mean pillar 1.8 m?", "--wind: found 200 m/s; above 100 m/s"),
        ),
        (
            (*BUOY, "--chain", "chain stud-link U9", "--soil", "soft mud", "--code", "IALA"),
            ("3 errors", "--chain", "--soil: found 'soft mud'", "--code"),
        ),
        ((*BUOY, "--depth", "9 m"), ("--depth: found 9 m; below low water, 10 m",)),
        ((*BUOY, "--low-water", "1 m"), ("BUOY: found", "1 m deep at low water")),
        ((*BUOY, "--force", "5 kN"), ("BUOY", "leave it out, or --force")),
        ((*BUOY, "--wind", "0", "--current", "0", "--hs", "0"), ("something has to push",)),
        ((*BUOY, "--diameter-min", "200 mm"), ("--chain", "no size of it is sold from 200")),
        (
            (*OWN[:-1], "0.3 kN"),
            ("--reserve-buoyancy: found 0.3 kN; below the pull of the lightest line",),
        ),
        (OWN[:-2], ("--reserve-buoyancy: missing",)),
        (
            (*SHIP, "--low-water", "12 m", "--wind", "200 m/s"),
            ("2 errors", "--draught: found 12.4 m; the water is 12 m deep at low water", "--wind"),
        ),
        (("size", "tanker", "--depth", "20 m"), ("3 errors", "--length", "--breadth", "--draught")),
        ((*SHIP, "--moulded-depth", "12 m"), ("--moulded-depth", "the deck would be under water")),
        ((*SHIP, "--dwt", "90000 t"), ("--dwt", "not below what a ship of these dimensions")),
        ((*SHIP, "--lines", "2"), ("--lines: found 2; 1, or 3 to 24",)),
        ((*SHIP, "--hawser", "40 m"), ("--hawser", "give --buoy with it")),
        ((*SHIP, "--anchor", "hook"), ("--anchor: found 'hook'",)),
        ((*SHIP, "--soil", "rock"), ("--soil: found 'rock'",)),
    ],
)
def test_what_is_wrong_is_told_by_the_option(
    run: Run, arguments: tuple[str, ...], words: tuple[str, ...]
) -> None:
    ran = run(*arguments)
    assert (ran.status, ran.out) == (2, "")
    for each in words:
        assert each in ran.err


def test_nothing_that_is_sold_is_status_3_with_advice(run: Run) -> None:
    ran = run(*BUOY, "--diameter-max", "16 mm")
    assert (ran.status, ran.out) == (3, "")
    for words in ("none of the", "fails by the least", "What may help"):
        assert words in ran.err


def test_a_buoy_that_cannot_carry_all_lines_is_status_3(run: Run) -> None:
    ran = run(*SHIP, "--buoy", "mooring buoy 2.5 m", "--lines", "8")
    assert (ran.status, ran.out) == (3, "")
    assert "buoy" in ran.err


class Terminal:
    """Standard input of somebody who answers."""

    def __init__(self, *answers: str) -> None:
        self.answers = list(answers)

    def isatty(self) -> bool:
        return True

    def readline(self) -> str:
        return self.answers.pop(0) + "\n" if self.answers else ""


def answering(monkeypatch: pytest.MonkeyPatch, *answers: str) -> list[str]:
    """Sit somebody at the terminal; what is left of the answers is returned."""
    terminal = Terminal(*answers)
    monkeypatch.setattr(sys, "stdin", terminal)
    return terminal.answers


def test_what_is_missing_is_asked_on_a_terminal(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    left = answering(
        monkeypatch,
        *("pillar 2.4 m", "twelve", "12 m", "10 m", "", "1.5 m/s", "1.5 m"),
        "clean fine to medium sand",
    )
    ran = run("size", "buoy", "--period", "6 s", "--json")
    assert (ran.status, left) == (0, [])
    assert "twelve" in ran.err  # it was told, and asked for again
    asked = json.loads(ran.out)
    monkeypatch.undo()
    told = document(run, *BUOY)
    assert asked["chain"] == told["chain"]
    assert asked["load_cases"] == told["load_cases"]


def test_a_buoy_of_one_s_own_and_a_ship_are_asked_for(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    left = answering(monkeypatch, "own", "0.343 tf", "12 kN", "9.5 m", "", "", "")
    ran = run("size", "buoy", "--json")
    assert (ran.status, left) == (0, [])
    assert json.loads(ran.out)["chain"] == json.loads(run(*OWN, "--json").out)["chain"]
    ship = ("", "234 m", "31.3 m", "12.4 m")  # no deadweight, but what is estimated from it
    left = answering(monkeypatch, *ship, "22 m", "20 m", "20 m/s", "1.2 m/s")
    rest = ("--moulded-depth", "16 m", "--hmax", "3.5 m", "--period", "8 s", "--json")
    ran = run("size", "tanker", *rest)
    assert (ran.status, left) == (0, [])
    assert json.loads(ran.out)["chain"] == json.loads(run(*SHIP, "--json").out)["chain"]


def test_nothing_is_asked_when_enough_was_given(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch)
    assert run(*OWN).status == 0


def test_an_end_of_the_answers_is_told(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch, "pillar 2.4 m")
    ran = run("size", "buoy")
    assert (ran.status, ran.out) == (2, "")
    assert "--depth: missing; nobody answered" in ran.err


def test_questions_in_vietnamese(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    left = answering(monkeypatch, "raft", "own", "8 kN", "25 kN", "12 m", "", "", "")
    ran = run("size", "buoy", "--lang", "vi")
    assert (ran.status, left) == (0, [])
    assert '"raft" không có trong danh sách' in ran.err
    assert "Độ sâu nước ở mực nước thấp [12 m]: " in ran.err
    left = answering(monkeypatch, "", "120 m", "18 m", "7 m", "22 m", "", "", "", "")
    ran = run("size", "tanker", "--lang", "vi")
    assert (ran.status, left) == (0, [])
    assert "Chiều dài toàn bộ của tàu: " in ran.err


@pytest.mark.parametrize("command", ["buoy", "tanker"])
def test_help_and_wrong_input_load_nothing_heavy(command: str) -> None:
    found = loaded("size", command, "--help")
    assert "catopt" in found
    assert found & (HEAVY | {"rich"}) == set()
