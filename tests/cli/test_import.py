"""``catopt import``, decks in the place of a case, and lines that meet in joints."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt import read_case

from .cases import write_files
from .conftest import Run, document_of, names, read_document


@pytest.fixture(autouse=True)
def _files(inside: Path) -> None:
    write_files(inside)


def test_it_writes_a_case_file(run: Run) -> None:
    ran = run("import", "oc3.txt", "--out", "new.toml")
    assert (ran.status, ran.out) == (0, "new.toml\n")
    assert read_case("new.toml") == read_case("oc3.txt")


def test_a_command_takes_a_deck(run: Run) -> None:
    assert len(read_document(run("system", "oc3.txt", "--json").out)["lines"]) == 3


def test_the_printed_figures_of_mappp(run: Run) -> None:
    given = ("--gravity", "9.81", "--density", "1025 kg/m^3", "--depth", "350 m")
    assert run("import", "bridle.map", *given, "--out", "case.toml").status == 0
    held = ("--held", "5 m, 0, 0, 0, 0, 0")
    document = document_of(run, "system", "case.toml", *held)
    assert document["schema"] == "catopt.network/1"
    rest, ahead = document["states"]
    assert rest["lines"][1]["to_tension_N"] == pytest.approx(711942.60, abs=5e-3)
    assert rest["stiffness"][0][0] == pytest.approx(1.99e4, abs=50.0)
    assert rest["stiffness"][5][5] == pytest.approx(1.41e8, abs=5e5)
    assert ahead["lines"][0]["horizontal_force_N"] == pytest.approx(597513.33, abs=5e-3)
    assert ahead["displacement"] == [5.0, 0.0, 0.0, 0.0, 0.0, 0.0]


def test_a_deck_with_joints_takes_the_place_of_a_file(run: Run) -> None:
    ran = run("system", "bridle.txt", "--out", "out", "--json")
    assert ran.status == 0
    assert read_document(ran.out)["states"][0]["points"][1]["kind"] == "joint"
    assert "network.json" in names(Path("out"))
