"""``catopt fatigue``: its files, and how it ends."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from catopt.verify import fatigue as running

from .conftest import NAMED, Run, refused, rows

EXAMPLE = NAMED["FATIGUE"]


def test_the_damage_of_each_sea_state_and_strict(run: Run, tmp_path: Path) -> None:
    ran = run("fatigue", EXAMPLE, "--once", "--strict", "--json", "--out", tmp_path)
    assert ran.status == 3
    states = json.loads(ran.out)["segments"][0]["sea_states"]
    table = rows(tmp_path / "fatigue_damage.csv")
    assert [float(row["Damage in a year (-)"]) for row in table] == pytest.approx(
        [state["damage_per_year"] for state in states], rel=1e-15
    )


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
    ran = refused(run, "fatigue", EXAMPLE)
    assert "pip install 'catopt[fatigue]'" in ran.err
