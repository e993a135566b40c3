"""``catopt size`` from a file: the same answers as from options, and what it says of mistakes.

Beside every ``broken_sizing/NAME.toml`` stands ``NAME.txt``, the message word for word; the name
begins with the command.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from catopt import read_case

from .conftest import BROKEN, CASES, OWN, Run, changed, document_of, refused
from .test_size import BUOY, SHIP, answering
from .test_size import OWN as OWN_BUOY

NAMES = sorted(path.stem for path in BROKEN.glob("*.toml"))
BUOY_FILE, OWN_FILE, SHIP_FILE = (OWN / f"size-{name}.toml" for name in ("buoy", "own", "ship"))
WITHOUT_SOIL = BUOY[: BUOY.index("--soil")]


def longer(case: Path, folder: Path, further: str) -> Path:
    """Write a file of its own with further tables or keys at its end."""
    path = folder / "sizing.toml"
    path.write_text(case.read_text("utf-8") + further, "utf-8")
    return path


@pytest.mark.parametrize(
    ("file", "arguments"),
    [(BUOY_FILE, BUOY), (OWN_FILE, OWN_BUOY), (SHIP_FILE, SHIP)],
    ids=["buoy", "own", "ship"],
)
def test_a_file_gives_what_the_same_options_give(
    run: Run, file: Path, arguments: list[str]
) -> None:
    by_options = run(*arguments, "--json")
    by_file = run(*arguments[:2], file, "--json")
    assert (by_file.status, by_file.err) == (by_options.status, by_options.err) == (0, "")
    assert by_file.out == by_options.out


def without_inputs(run: Run, *arguments: object) -> dict[str, Any]:
    """Read the document but for where each input is from: a default may be typed, too."""
    found = document_of(run, *arguments)
    del found["inputs"]
    return found


def test_an_option_goes_before_the_file(run: Run, tmp_path: Path) -> None:
    further = ("--hs", "1 m", "--friction", "0.5", "--json")
    typed = run("size", "buoy", BUOY_FILE, *further)
    assert (typed.status, typed.out) == (0, run(*WITHOUT_SOIL, *further).out)
    # Even one that is its own default.
    steel = longer(BUOY_FILE, tmp_path, 'material = "steel"\n')
    concrete = without_inputs(run, "size", "buoy", steel, "--sinker", "concrete")
    assert concrete == without_inputs(run, *BUOY)


def test_what_holds_the_line_is_what_was_typed(run: Run, tmp_path: Path) -> None:
    clay = longer(SHIP_FILE, tmp_path, '[sinker]\nsoil = "hard clay"\n')
    anchored = without_inputs(run, "size", "tanker", clay, "--anchor", "Stevpris Mk5")
    assert anchored == without_inputs(run, *SHIP)
    sand = longer(SHIP_FILE, tmp_path, '[anchor]\nsoil = "sand"\n')
    typed = run("size", "tanker", sand, "--anchor", "sinker", "--json")
    assert (typed.status, typed.out) == (0, run(*SHIP, "--anchor", "sinker", "--json").out)


def test_what_is_wrong_with_an_option_keeps_its_name(run: Run, tmp_path: Path) -> None:
    file = changed(BUOY_FILE, tmp_path, ("1.5 m/s", "15 m/s"))
    ran = refused(run, "size", "buoy", file, "--wind", "200 m/s", "--hmax", "1 m")
    assert ran.err.startswith(f"catopt: {file}: 3 errors\n")
    assert "--wind: found 200 m/s" in ran.err
    assert 'environment.current: found "15 m/s"' in ran.err
    assert "--hmax: found 1 m; below the significant height of 1.5 m" in ran.err


def test_a_key_at_fault_hides_no_option_at_fault(run: Run, tmp_path: Path) -> None:
    file = changed(BUOY_FILE, tmp_path, ("wind =", "wint ="))
    ran = run("size", "buoy", file, "--wind", "25 kg")
    assert "environment.wint: found an unknown key; did you mean wind?" in ran.err
    assert '--wind: found "25 kg", a mass' in ran.err


def test_only_what_the_file_leaves_out_is_asked(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    left = answering(monkeypatch, "12 m")
    file = changed(BUOY_FILE, tmp_path, ('water_depth = "12 m"', ""))
    ran = run("size", "buoy", file, "--json")
    assert (ran.status, left) == (0, [])
    assert "Wind at 10 m" not in ran.err
    assert json.loads(ran.out) == document_of(run, *BUOY)


def test_a_file_at_fault_is_told_before_anything_is_asked(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    answering(monkeypatch)
    ran = refused(run, "size", "buoy", BROKEN / "buoy-misspelt.toml")
    assert "5 errors" in ran.err
    assert "Water depth" not in ran.err


@pytest.mark.parametrize("name", NAMES)
def test_the_message_is_exactly_this(run: Run, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(BROKEN)
    ran = refused(run, "size", name.partition("-")[0], f"{name}.toml")
    assert ran.err == (BROKEN / f"{name}.txt").read_text(encoding="utf-8")


def test_every_broken_file_has_its_message() -> None:
    assert sorted(path.stem for path in BROKEN.glob("*.txt")) == NAMES
    assert len(NAMES) >= 20


def test_a_file_of_buoys_counts_from_the_folder_of_the_file(run: Run, tmp_path: Path) -> None:
    library = (CASES.parent / "catopt/loads/data/buoys.toml").read_text("utf-8")
    mine = tmp_path / "mine.toml"
    mine.write_text(library.replace('"pillar ', '"my pillar '), "utf-8")
    named = ('"pillar 2.4 m"', '"my pillar 2.4 m"\nfile = "mine.toml"')
    file = changed(BUOY_FILE, tmp_path, named)
    options = ["my pillar 2.4 m" if each == "pillar 2.4 m" else each for each in BUOY]
    by_file = run("size", "buoy", file, "--json")
    assert by_file.status == 0
    assert by_file.out == run(*options, "--buoys", mine, "--json").out
    mine.unlink()
    gone = run("size", "buoy", file)
    assert gone.status == 2
    assert "mine.toml" in gone.err


def test_title_and_source_go_to_the_case(run: Run, tmp_path: Path) -> None:
    titled = ("[site]", 'title = "Fairway"\nsource = "Survey"\n[site]')
    place = tmp_path / "case.toml"
    file = changed(BUOY_FILE, tmp_path, titled)
    assert run("size", "buoy", file, "--save", place).status == 0
    case = read_case(place)
    assert (case.title, case.source) == ("Fairway", "Survey")


def test_loads_of_a_file_are_those_of_the_same_options(run: Run) -> None:
    weather = WITHOUT_SOIL[2:]
    for options in (("--chain", "38 mm"), ("--wind", "0 m/s")):
        found = document_of(run, "loads", "buoy", BUOY_FILE, *options)
        found["assumptions"].remove("Given, but no part of these loads: sinker.soil.")
        assert found == document_of(run, "loads", "buoy", *weather, *options)


def test_an_option_beside_a_tanker_s_file_changes_its_loads(run: Run) -> None:
    loads = ("loads", "ship", CASES / "size-tanker/sizing.toml")
    typed = document_of(run, *loads, "--frontal-area", "600 m^2")
    assert typed["horizontal_force_N"] > document_of(run, *loads)["horizontal_force_N"]
