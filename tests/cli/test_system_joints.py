"""``catopt system`` and ``catopt import`` with lines that meet in joints."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

from catopt import schemas
from catopt.__main__ import main
from tests.decks.own import BRIDLE, MAP_BRIDLE

GIVEN = ["--gravity", "9.81", "--density", "1025 kg/m^3", "--depth", "350 m"]


@pytest.fixture
def bridle(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    place = tmp_path / "bridle.map"
    place.write_text(MAP_BRIDLE)
    case = tmp_path / "case.toml"
    assert main(["import", str(place), *GIVEN, "--out", str(case)]) == 0
    capsys.readouterr()
    return case


def test_the_printed_figures_of_mappp(bridle: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["system", str(bridle), "--held", "5 m, 0, 0, 0, 0, 0", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.network/1")).validate(document)
    rest, ahead = document["states"]
    assert rest["lines"][1]["to_tension_N"] == pytest.approx(711942.60, abs=5e-3)
    assert rest["stiffness"][0][0] == pytest.approx(1.99e4, abs=50.0)
    assert rest["stiffness"][5][5] == pytest.approx(1.41e8, abs=5e5)
    assert ahead["lines"][0]["horizontal_force_N"] == pytest.approx(597513.33, abs=5e-3)
    assert ahead["displacement"] == [5.0, 0.0, 0.0, 0.0, 0.0, 0.0]


@pytest.mark.parametrize(("lang", "word"), [("en", "3 free joints"), ("vi", "3 nút tự do")])
def test_it_is_printed(
    bridle: Path, capsys: pytest.CaptureFixture[str], lang: str, word: str
) -> None:
    assert main(["system", str(bridle), "--stiffness", "--lang", lang]) == 0
    out = capsys.readouterr().out
    assert word in out
    assert "711.943" in out
    assert "19.864" in out
    assert main(["system", str(bridle), "--lang", lang]) == 0
    assert "19.864" not in capsys.readouterr().out


def test_a_deck_takes_the_place_of_a_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place = tmp_path / "deck.txt"
    place.write_text(BRIDLE)
    assert main(["system", str(place), "--out", str(tmp_path / "out"), "--json"]) == 0
    told = capsys.readouterr()
    assert json.loads(told.out)["states"][0]["points"][1]["kind"] == "joint"
    assert "note: lines meet in free points" in told.err
    assert (tmp_path / "out" / "network.json").is_file()


@pytest.mark.parametrize("command", ["solve", "curve", "check", "verify", "design", "report"])
def test_other_commands_refuse_it(
    bridle: Path, capsys: pytest.CaptureFixture[str], command: str
) -> None:
    assert main([command, str(bridle)]) == 2
    assert "catopt system and catopt import alone" in capsys.readouterr().err


def test_options_that_are_not_evaluated_are_refused(
    bridle: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = ["--line-out", "--watch-circle", "--curve", "0 deg", "--level", "1 m"]
    assert main(["system", str(bridle), *options]) == 2
    told = capsys.readouterr().err
    for option in options[:3] + options[4:5]:
        assert f"{option}: does not go with lines that meet in joints" in told
