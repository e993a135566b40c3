"""Commands of a case with a current at rest: what takes it, and what refuses it."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt import read_case, solve_case

from .conftest import OWN, Run, document_of, refused, validate
from .test_one_screen import is_a_screen

CASE = OWN / "in-current.toml"


def test_the_document_says_what_the_current_does(run: Run) -> None:
    document = document_of(run, "solve", CASE, "--profile")
    validate(document)
    assert document["method"] == "shooting"
    own, profile = document["current"], document["profile"]
    # The ends hold the drag; across x the bed's friction and the fairlead share it.
    assert own["fairlead_force_N"][0] == pytest.approx(60e3)
    assert own["drag_N"][1] > 0.0 > own["fairlead_force_N"][1]
    assert max(map(abs, profile["y_m"])) > 1.0
    assert profile["y_m"][-1] == pytest.approx(0.0, abs=1e-6)


def test_people_see_the_current(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    for line, shown in (("solve", "Drag of the current along x"), ("check", "in the current")):
        card = "\n".join(is_a_screen(run, monkeypatch, line, str(CASE)))
        assert shown in card
        assert not {"verify", "curve", "report"} & {*card.split()}
    assert "power law, 1.5 m/s at the surface, towards 30 deg from x" in " ".join(
        run("solve", CASE, "--full").out.split()
    )
    assert "Lực cản của dòng chảy" in run("solve", CASE, "--lang", "vi", "--full").out


def test_checks_are_of_the_line_in_the_current(run: Run, tmp_path: Path) -> None:
    checked = document_of(run, "check", CASE)
    tension = solve_case(read_case(CASE)).fairlead.tension
    assert max(each["demand"] for each in checked["checks"]) == pytest.approx(tension)
    assert run("solve", CASE, "--out", tmp_path / "out").status == 0
    assert {"line.svg", "profile.csv"} <= {each.name for each in (tmp_path / "out").iterdir()}


@pytest.mark.parametrize(
    "command",
    [
        ("solve", "--method", "pso"),
        ("curve",),
        ("verify",),
        ("report",),
        ("export", "--to", "moordyn"),
    ],
)
def test_what_takes_still_water_refuses_it(
    run: Run, tmp_path: Path, command: tuple[str, ...]
) -> None:
    name, *options = command
    out = ("--out", tmp_path / "out.html") if name == "report" else ()
    said = refused(run, name, CASE, *options, *out)
    assert "at rest a current is for catopt solve and check" in said.err


def test_what_it_does_not_go_with_is_told(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "case.toml"
    text = CASE.read_text("utf-8")
    text = text.replace(
        "[load]", '[find]\nquantity = "length"\nsegment = 1\nanchor_angle = "0 deg"\n\n[load]'
    )
    place.write_text(text, encoding="utf-8")
    assert "a current at rest cannot be combined with [find]" in refused(run, "solve", place).err
