"""``catopt size``: its document, its case for other commands, and what it asks."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest

from .conftest import Run, document_of, fits, refused, typed, words

BUOY, OWN, SHIP = (typed(name) for name in ("SIZE_BUOY", "SIZE_OWN", "SIZE_SHIP"))
AROUND = [*SHIP, "--buoy", "mooring buoy 5.0 m", "--lines", "6"]
SINKER = [*SHIP, "--anchor", "sinker", "--clump-weight", "20 t"]


@pytest.mark.parametrize(
    "arguments",
    [BUOY, *(pytest.param(each, marks=pytest.mark.slow) for each in (OWN, SHIP, AROUND, SINKER))],
    ids=["buoy", "own", "ship", "around", "sinker"],
)
def test_the_document_and_the_view(run: Run, arguments: list[str]) -> None:
    found = document_of(run, *arguments)
    roles = [each["role"] for each in found["candidates"]]
    assert roles.count("recommended") == 1
    assert all(check["passes"] for check in found["checks"])
    shown = run(*arguments).out
    assert fits(shown)
    length = found["chain"]["length_m"]
    assert f"{length:g} m = {length / 27.5:.2f} shots" in words(shown)
    assert found["loads"] or arguments == OWN
    for each in found["loads"]:
        parts = [component for part in each["parts"] for component in part["components"]]
        assert len(parts) == 5 or arguments != BUOY
        assert all(
            one["formula"] and one["numbers"] and one["source"]["confidence"] for one in parts
        )


def test_a_saved_case_gives_the_same_answer_to_every_command(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "buoy.toml"
    ran = run(*BUOY, "--save", str(place), "--json")
    assert ran.status == 0
    assert str(place) in ran.err
    sized = json.loads(ran.out)
    assert [load["load_case"] for load in sized["loads"]] == [
        "storm, high water",
        "storm, low water",
    ]
    design, check, solved = (
        json.loads(run(name, place, "--json").out) for name in ("design", "check", "solve")
    )
    best = design["front"][sized["design"]["recommended"] - 1]
    assert best["mass_kg"] == min(each["mass_kg"] for each in design["front"])
    for key in ("length_m", "nominal_diameter_m"):
        assert best["segments"][0][key] == sized["chain"][key]
    assert best["sinker"]["mass_kg"] == sized["sinker"]["mass_kg"]
    assert check["passes"]
    assert check["checks"] == sized["checks"] == best["checks"]
    assert solved["fairlead"]["tension_N"] == sized["load_cases"][0]["tension_N"]


@pytest.mark.slow
def test_a_saved_pattern_goes_to_catopt_system(run: Run, tmp_path: Path) -> None:
    assert run(*AROUND, "--out", str(tmp_path)).status == 0
    sized = json.loads((tmp_path / "size.json").read_text("utf-8"))
    system = document_of(run, "system", tmp_path / "system.toml")
    largest = max(line["horizontal_force_N"] for line in system["lines"])
    states = sized["pattern"]["states"]
    # Both are solved to a residual far below this.
    assert largest == pytest.approx(max(s["line_force_N"] for s in states), rel=1e-9)
    assert document_of(run, "check", tmp_path / "case.toml")["passes"]


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


def chain_of(run: Run, *arguments: object) -> Any:
    return json.loads(run(*arguments, "--json").out)["chain"]


def test_what_is_missing_is_asked_on_a_terminal(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    left = answering(
        monkeypatch,
        *("pillar 2.4 m", "twelve", "12 m", "10 m", "", "1.5 m/s", "1.5 m"),
        "clean fine to medium sand",
    )
    ran = run("size", "buoy", "--period", "6 s", "--json")
    assert (ran.status, left) == (0, [])
    assert "twelve" in ran.err  # it was told, and asked for again
    asked, told = json.loads(ran.out), document_of(run, *BUOY)
    assert asked["chain"] == told["chain"]
    assert asked["load_cases"] == told["load_cases"]


def test_a_buoy_of_one_s_own_and_a_ship_are_asked_for(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    left = answering(monkeypatch, "own", "0.343 tf", "12 kN", "9.5 m", "", "", "")
    asked = chain_of(run, "size", "buoy")
    assert left == []
    assert asked == chain_of(run, *OWN)
    ship = ("", "234 m", "31.3 m", "12.4 m")  # no deadweight, but what is estimated from it
    left = answering(monkeypatch, *ship, "22 m", "20 m", "20 m/s", "1.2 m/s")
    rest = ("--moulded-depth", "16 m", "--hmax", "3.5 m", "--period", "8 s")
    asked = chain_of(run, "size", "tanker", *rest)
    assert left == []
    assert asked == chain_of(run, *SHIP)


def test_nothing_is_asked_when_enough_was_given(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch)
    assert run(*OWN).status == 0


def test_an_end_of_the_answers_is_told(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch, "pillar 2.4 m")
    ran = refused(run, "size", "buoy")
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
