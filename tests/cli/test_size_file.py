"""``catopt size`` from a file: the same answers as from options, and what it says of mistakes.

Beside every ``broken_sizing/NAME.toml`` stands ``NAME.txt``, the message word for word; the name
begins with the command.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest

from catopt import read_case

from .conftest import Ran, Run
from .test_size import BUOY, OWN, SHIP, Terminal

ROOT = Path(__file__).parents[2]
BROKEN = Path(__file__).parent / "broken_sizing"
NAMES = sorted(path.stem for path in BROKEN.glob("*.toml"))
PAGE = (ROOT / "docs" / "sizing.md").read_text(encoding="utf-8")

BUOY_FILE = """
[site]
water_depth = "12 m"
low_water = 10
[environment]
wind = "25 m/s"
current = "1.5 m/s"
hs = "1.5 m"
period = 6.0
[buoy]
name = "pillar 2.4 m"
[sinker]
soil = "clean fine to medium sand"
"""
OWN_FILE = """
[site]
water_depth = "9.5 m"
[buoy]
horizontal_force = "0.343 tf"
reserve_buoyancy = "12 kN"
"""
SHIP_FILE = """
[site]
water_depth = "22 m"
low_water = "20 m"
[environment]
wind = "20 m/s"
current = "1.2 m/s"
hmax = "3.5 m"
period = "8 s"
[ship]
length = "234 m"
breadth = "31.3 m"
draught = "12.4 m"
moulded_depth = "16 m"
"""

WITHOUT_SOIL = BUOY[: BUOY.index("--soil")]


@pytest.fixture
def written(tmp_path: Path) -> Path:
    """Where a test puts its file."""
    return tmp_path / "sizing.toml"


@pytest.mark.parametrize(
    ("text", "arguments"),
    [
        (BUOY_FILE, BUOY),
        (OWN_FILE, OWN),
        (SHIP_FILE, SHIP),
    ],
    ids=["buoy", "own", "ship"],
)
def test_a_file_gives_what_the_same_options_give(
    run: Run, written: Path, text: str, arguments: tuple[str, ...]
) -> None:
    written.write_text(text, "utf-8")
    by_options = run(*arguments, "--json")
    by_file = run(*arguments[:2], written, "--json")
    assert (by_file.status, by_file.err) == (by_options.status, by_options.err) == (0, "")
    assert by_file.out == by_options.out


def without_inputs(ran: Ran) -> dict[str, Any]:
    """Read the document but for where each input is from: a default may be typed, too."""
    found: dict[str, Any] = json.loads(ran.out)
    del found["inputs"]
    return found


def test_an_option_goes_before_the_file(run: Run, written: Path) -> None:
    written.write_text(BUOY_FILE, "utf-8")
    typed = run("size", "buoy", written, "--hs", "1 m", "--friction", "0.5", "--json")
    same = run(*WITHOUT_SOIL, "--friction", "0.5", "--hs", "1 m", "--json")
    assert typed.status == 0
    assert typed.out == same.out
    # Even one that is its own default.
    written.write_text(BUOY_FILE + 'material = "steel"\n', "utf-8")
    typed = run("size", "buoy", written, "--sinker", "concrete", "--json")
    assert without_inputs(typed) == without_inputs(run(*BUOY, "--json"))


def test_what_holds_the_line_is_what_was_typed(run: Run, written: Path) -> None:
    written.write_text(SHIP_FILE + '[sinker]\nsoil = "hard clay"\n', "utf-8")
    typed = run("size", "tanker", written, "--anchor", "Stevpris Mk5", "--json")
    assert without_inputs(typed) == without_inputs(run(*SHIP, "--json"))
    written.write_text(SHIP_FILE + '[anchor]\nsoil = "sand"\n', "utf-8")
    typed = run("size", "tanker", written, "--anchor", "sinker", "--json")
    assert typed.status == 0
    assert typed.out == run(*SHIP, "--anchor", "sinker", "--json").out


def test_what_is_wrong_with_an_option_keeps_its_name(run: Run, written: Path) -> None:
    written.write_text(BUOY_FILE.replace("1.5 m/s", "15 m/s"), "utf-8")
    ran = run("size", "buoy", written, "--wind", "200 m/s", "--hmax", "1 m")
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.startswith(f"catopt: {written}: 3 errors\n")
    assert "--wind: found 200 m/s" in ran.err
    assert 'environment.current: found "15 m/s"' in ran.err
    assert "--hmax: found 1 m; below the significant height of 1.5 m" in ran.err


def test_a_key_at_fault_hides_no_option_at_fault(run: Run, written: Path) -> None:
    written.write_text(BUOY_FILE.replace("wind =", "wint ="), "utf-8")
    ran = run("size", "buoy", written, "--wind", "25 kg")
    assert "environment.wint: found an unknown key; did you mean wind?" in ran.err
    assert '--wind: found "25 kg", a mass' in ran.err


def test_only_what_the_file_leaves_out_is_asked(
    run: Run, written: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written.write_text(BUOY_FILE.replace('water_depth = "12 m"', ""), "utf-8")
    terminal = Terminal("12 m")
    monkeypatch.setattr(sys, "stdin", terminal)
    ran = run("size", "buoy", written, "--json")
    assert (ran.status, terminal.answers) == (0, [])
    assert "Wind at 10 m" not in ran.err
    monkeypatch.undo()
    assert json.loads(ran.out) == json.loads(run(*BUOY, "--json").out)


def test_a_file_at_fault_is_told_before_anything_is_asked(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stdin", Terminal())
    ran = run("size", "buoy", BROKEN / "buoy-misspelt.toml")
    assert (ran.status, ran.out) == (2, "")
    assert "5 errors" in ran.err
    assert "Water depth" not in ran.err


@pytest.mark.parametrize("name", NAMES)
def test_the_message_is_exactly_this(run: Run, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(BROKEN)
    ran = run("size", name.partition("-")[0], f"{name}.toml")
    assert (ran.status, ran.out) == (2, "")
    assert ran.err == (BROKEN / f"{name}.txt").read_text(encoding="utf-8")


def test_every_broken_file_has_its_message() -> None:
    assert sorted(path.stem for path in BROKEN.glob("*.txt")) == NAMES
    assert len(NAMES) >= 20


def test_what_is_no_file_is_told(run: Run, tmp_path: Path) -> None:
    for command in ("buoy", "tanker"):
        ran = run("size", command, tmp_path / "gone.toml")
        assert (ran.status, ran.out) == (2, "")
        assert "there is no such file" in ran.err
    assert "it is a folder" in run("size", "buoy", tmp_path).err


def test_a_file_of_buoys_counts_from_the_folder_of_the_file(run: Run, tmp_path: Path) -> None:
    library = (ROOT / "catopt/loads/data/buoys.toml").read_text("utf-8")
    (tmp_path / "mine.toml").write_text(library.replace('"pillar ', '"my pillar '), "utf-8")
    written = tmp_path / "sizing.toml"
    text = BUOY_FILE.replace('"pillar 2.4 m"', '"my pillar 2.4 m"\nfile = "mine.toml"')
    written.write_text(text, "utf-8")
    by_file = run("size", "buoy", written, "--json")
    options = ["my pillar 2.4 m" if each == "pillar 2.4 m" else each for each in BUOY]
    by_options = run(*options, "--buoys", tmp_path / "mine.toml", "--json")
    assert by_file.status == 0
    assert by_file.out == by_options.out
    (tmp_path / "mine.toml").unlink()
    gone = run("size", "buoy", written)
    assert gone.status == 2
    assert "mine.toml" in gone.err


def test_title_and_source_go_to_the_case(run: Run, written: Path, tmp_path: Path) -> None:
    written.write_text('title = "Fairway"\nsource = "Survey"\n' + BUOY_FILE, "utf-8")
    place = tmp_path / "case.toml"
    assert run("size", "buoy", written, "--save", place).status == 0
    case = read_case(place)
    assert (case.title, case.source) == ("Fairway", "Survey")


def test_the_examples_come_to_what_is_worked_by_hand(run: Run) -> None:
    buoy = json.loads(run("size", "buoy", ROOT / "cases/size-buoy/sizing.toml", "--json").out)
    # To the digits that docs/sizing.md prints: 38 mm, 54.5 m, 20 t.
    assert buoy["chain"]["nominal_diameter_m"] == pytest.approx(0.038, abs=1e-12)
    assert buoy["chain"]["length_m"] == 54.5
    assert buoy["sinker"]["mass_kg"] == 20e3
    assert buoy["title"] == "Pillar buoy in 12 m"
    ship = json.loads(run("size", "tanker", ROOT / "cases/size-tanker/sizing.toml", "--json").out)
    # 73 mm and 178.75 m, which is 6.5 shots, as docs/sizing.md prints.
    assert ship["chain"]["nominal_diameter_m"] == pytest.approx(0.073, abs=1e-12)
    assert ship["chain"]["length_m"] == 178.75
    # 288.0 kN in docs/loads.md, to its last digit; in ballast 293 kN, which governs.
    forces = {each["load_case"]: each["horizontal_force_N"] for each in ship["loads"]}
    assert forces["loaded, high water"] == pytest.approx(288.0e3, abs=0.05e3)
    assert forces["ballast, high water"] == pytest.approx(293e3, abs=0.5e3)


def test_loads_of_a_file_are_those_of_the_same_options(run: Run, written: Path) -> None:
    written.write_text(BUOY_FILE, "utf-8")
    weather = BUOY[2 : BUOY.index("--soil")]
    for options in (("--chain", "38 mm"), ("--wind", "0 m/s")):
        by_file = run("loads", "buoy", written, *options, "--json")
        assert by_file.status == 0
        found = json.loads(by_file.out)
        found["assumptions"].remove("Given, but no part of these loads: sinker.soil.")
        assert found == json.loads(run("loads", "buoy", *weather, *options, "--json").out)


def test_loads_of_a_tanker_s_file_are_those_worked_by_hand(run: Run) -> None:
    place = ROOT / "cases/size-tanker/sizing.toml"
    found = json.loads(run("loads", "ship", place, "--json").out)
    # 288.0 kN in docs/loads.md, to its last digit; 293 kN in ballast, which is laid out.
    forces = {each["condition"]: each["horizontal_force_N"] for each in found["headings"]}
    assert forces["loaded"] == pytest.approx(288.0e3, abs=0.05e3)
    assert found["horizontal_force_N"] == forces["ballast"] == pytest.approx(293e3, abs=0.5e3)
    assert any("deckhouse" in words for words in found["assumptions"])
    typed = json.loads(run("loads", "ship", place, "--frontal-area", "600 m^2", "--json").out)
    assert typed["horizontal_force_N"] > found["horizontal_force_N"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("buoy", "buoy-missing"), ("2 errors", "site.water_depth: missing", "buoy.name: missing")),
        (("buoy", "buoy-many"), ("7 errors", "environment.wind: found 200", "buoy.name: found")),
        (("ship", "tanker-missing"), ("4 errors", "did you mean breadth?", "ship.draught")),
        (
            ("ship", "tanker-aground"),
            ("1 error", "ship.moulded_depth", "deck would be under water"),
        ),
    ],
)
def test_loads_tell_the_mistakes_of_a_file(
    run: Run, arguments: tuple[str, str], words: tuple[str, ...]
) -> None:
    command, name = arguments
    ran = run("loads", command, BROKEN / f"{name}.toml")
    assert (ran.status, ran.out) == (2, "")
    for each in words:
        assert each in ran.err
