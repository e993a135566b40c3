"""``catopt fatigue``: what it prints, writes and refuses, and how it ends."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import jsonschema
import pytest

from catopt import schemas
from catopt.verify import fatigue as running

from .conftest import BUOY, CASES, Run, without_digest

EXAMPLE = CASES / "fatigue-chain-20m" / "case.toml"


def test_a_line_that_was_run_once(run: Run) -> None:
    ran = run("fatigue", EXAMPLE, "--once")
    assert (ran.status, ran.err) == (0, "")
    assert "The line does not last 20 years" in ran.out
    assert "NOT PROVEN" in ran.out
    assert "rainflow (ASTM E1049)" in ran.out
    assert "FAILS" in ran.out
    assert max(map(len, ran.out.splitlines())) <= 80


def test_the_document_the_files_and_strict(run: Run, tmp_path: Path) -> None:
    ran = run("fatigue", EXAMPLE, "--once", "--strict", "--json", "--out", tmp_path / "out")
    assert ran.status == 3
    document = json.loads(ran.out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.fatigue/1")).validate(document)
    assert without_digest(tmp_path / "out" / "fatigue.json") == document
    with (tmp_path / "out" / "fatigue_damage.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    states = document["segments"][0]["sea_states"]
    assert [float(row["Damage in a year (-)"]) for row in rows] == pytest.approx(
        [state["damage_per_year"] for state in states], rel=1e-15
    )
    assert (tmp_path / "out" / "fatigue.xlsx").stat().st_size > 0


def test_a_case_without_fatigue_says_so(run: Run) -> None:
    ran = run("fatigue", BUOY)
    assert ran.status == 2
    assert "fatigue: [fatigue] is missing" in ran.err


@pytest.mark.slow
def test_a_damage_that_hangs_on_the_step_is_status_4(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By a limit that nothing keeps: the runs themselves have converged."""
    monkeypatch.setattr(running, "LIMIT", -1.0)
    ran = run("fatigue", EXAMPLE)
    assert ran.status == 4
    assert "NOT PROVEN; the runs in time: NOT CONVERGED" in ran.out
    assert "NOT CONVERGED" in ran.err


def test_without_rainflow_the_way_out_is_named(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    ran = run("fatigue", EXAMPLE)
    assert ran.status == 2
    assert "pip install 'catopt[fatigue]'" in ran.err
