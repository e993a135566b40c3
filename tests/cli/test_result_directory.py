"""Directories that ``--out`` wrote: each has its case; ``catopt report`` makes the note of it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from catopt.casefile import read_case

from .conftest import CASES, Run
from .notes import note_of

OF_REPORT = Path(__file__).parents[1] / "report" / "cases"
CHAIN, MOVING, STATES = (OF_REPORT / f"{name}.toml" for name in ("swarm", "harmonic", "states"))

pytestmark = pytest.mark.usefixtures("inside")


def report(run: Run, *arguments: object) -> dict[str, Any]:
    return note_of(run, *arguments, "--no-verify")[0]


@pytest.mark.parametrize("path", [*sorted(CASES.glob("*/case.toml")), CHAIN, STATES], ids=str)
def test_every_case_comes_back_the_same(run: Run, path: Path) -> None:
    command = "system" if "[system]" in path.read_text("utf-8") else "check"
    assert run(command, path, "--out", "out").status == 0
    assert read_case("out/case.toml") == read_case(path)


@pytest.mark.slow
def test_the_swarm_of_a_directory_is_in_its_note(run: Run) -> None:
    ran = run("solve", CHAIN, "--method", "pso", "--runs", 2, "--json", "--out", "out")
    told = json.loads(ran.out)["pso"]
    document = report(run, "out")
    assert "swarm" in document["sections"]
    keys = ("objective", "evaluations", "runs", "converged_runs", "closed_form_difference")
    assert document["swarm"] == {key: told[key] for key in keys}
    assert told["runs"] == 2
    assert report(run, "out", "--method", "closed-form")["swarm"] is None
    assert report(run, CHAIN)["swarm"] is None
    assert report(run, CHAIN, "--method", "pso")["swarm"]["runs"] == 3


@pytest.mark.slow
def test_the_motion_of_a_directory_is_in_its_note(run: Run) -> None:
    ran = run("verify", MOVING, "--dynamic", "--json", "--out", "out")
    (told,) = json.loads(ran.out)["dynamic"]["load_cases"]
    document = report(run, "out")
    assert "in_motion" in document["sections"]
    motion = document["motion"]
    for key in ("max_tension_N", "amplification", "slack_time_s"):
        assert motion[key] == told[key]
    assert motion["max_fairlead_tension_N"] == told["quantities"][0]["max"]
    assert motion["utilisation"] == told["max_tension_N"] / 1e6  # 3000 kN over 3
    assert report(run, "out", "--no-dynamic")["motion"] is None
    assert report(run, MOVING)["motion"] is None
    assert report(run, MOVING, "--dynamic")["motion"] == motion


@pytest.mark.usefixtures("stopped")
def test_ctrl_c_writes_no_note_and_says_so(run: Run) -> None:
    """An older note stays: one of half a run must not take its place."""
    assert run("report", MOVING).status == 0
    older = Path("harmonic.html").read_bytes()
    ran = run("report", MOVING, "--dynamic", "--json")
    assert (ran.status, ran.out) == (130, "")
    assert "stopped in load case load, run 1 of 1, after " in ran.err
    assert "no note was written" in ran.err
    assert "catopt verify CASE --dynamic --out DIR keeps" in ran.err
    assert Path("harmonic.html").read_bytes() == older
