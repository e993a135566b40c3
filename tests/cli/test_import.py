"""``catopt import``, and decks in the place of a case."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from catopt import read_case
from catopt.__main__ import main
from tests.decks.own import MAP, MOORDYN

OC3 = MAP.format(
    types="0.09 77.7066 384.243e6 0.001 0 0 0 0",
    anchor="853.87 0",
    fairlead="5.2 0 -70",
    length=902.2,
)


@pytest.fixture
def deck(tmp_path: Path) -> Path:
    place = tmp_path / "oc3.txt"
    place.write_text(MOORDYN)
    return place


def test_it_writes_a_case_file(deck: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = deck.parent / "case.toml"
    assert main(["import", str(deck), "--out", str(out)]) == 0
    assert read_case(out) == read_case(deck)
    told = capsys.readouterr()
    assert told.out == f"{out}\n"
    assert "note: line 5: main: w = 698.0945 N/m in water" in told.err


def test_a_command_takes_a_deck(deck: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["system", str(deck), "--json"]) == 0
    told = capsys.readouterr()
    assert len(json.loads(told.out)["lines"]) == 3
    assert "note: line 5: main: w = 698.0945 N/m" in told.err


def test_what_mappp_lacks_is_asked_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    place = tmp_path / "map.dat"
    place.write_text(OC3)
    assert main(["solve", str(place)]) == 2
    assert "--gravity 9.80665" in capsys.readouterr().err
    options = ["--gravity", "9.80665", "--density", "1025 kg/m^3", "--depth", "320 m"]
    assert main(["import", str(place), *options, "--lang", "vi", "--json"]) == 0
    told = capsys.readouterr()
    document = json.loads(told.out)
    assert document["schema"] == "catopt.import/1"
    assert 'span = "848.67 m"' in document["text"]
    assert "ma sát đáy: CB 0.001" in told.err


def test_wrong_options_are_told_at_once(deck: Path, capsys: pytest.CaptureFixture[str]) -> None:
    wrong = ["--gravity", "-1", "--depth", "5 kg", "--line", "0"]
    assert main(["import", str(deck), *wrong]) == 2
    told = capsys.readouterr().err
    assert all(option in told for option in ("--gravity", "--depth", "--line"))


def test_a_case_file_is_no_deck(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["import", "cases/buoy-9.5m/case.toml"]) == 2
    assert "LINE TYPES" in capsys.readouterr().err
