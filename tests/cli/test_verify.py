"""``catopt verify``: what it prints and writes, what it refuses, and how it ends."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from catopt.catenary.case import solve_case
from catopt.catenary.solution import Solution
from catopt.errors import NotConvergedError
from catopt.model import Case, Line
from catopt.verify.case import verify_case
from tests.verify.test_floater import CASE as AFLOAT
from tests.verify.test_floater import FOUR

from .conftest import (
    BUOY,
    DESIGN,
    OWN,
    Run,
    changed,
    document_of,
    fits,
    names,
    read_document,
    rows,
    validate,
    words,
)


@pytest.fixture
def off(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the closed form be wrong: its line weighs one part in a hundred more."""

    def wrong(case: Case) -> Solution:
        heavier = [
            replace(each, submerged_weight=1.01 * each.submerged_weight)
            for each in case.line.segments
        ]
        return solve_case(replace(case, line=Line(heavier, case.line.point_loads)))

    monkeypatch.setattr("catopt.verify.case.solve_case", wrong)


@pytest.mark.usefixtures("off")
def test_models_that_differ_are_an_answer_and_with_strict_3(run: Run) -> None:
    ran = run("verify", BUOY)
    assert (ran.status, ran.err) == (0, "")
    assert "The two models DIFFER: span by" in words(ran.out)
    assert fits(ran.out)
    ran = run("verify", BUOY, "--strict", "--json")
    assert ran.status == 3
    assert read_document(ran.out)["verdict"] == "differs"
    assert ran.err.startswith("catopt: The two models DIFFER: ")
    assert run("verify", DESIGN, "--strict").status == 3


def test_not_converged_is_4_and_no_answer(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object, **__: object) -> object:
        raise NotConvergedError("the truss did not reach equilibrium")

    monkeypatch.setattr("catopt.verify.line.solve_line", never)
    ran = run("verify", BUOY, "--json")
    assert (ran.status, ran.out) == (4, "")
    assert "did not reach equilibrium" in ran.err


@pytest.mark.slow
def test_a_design_that_does_not_converge_is_4_and_the_others_are_shown(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen = []

    def first_fails(case: Case, **settings: Any) -> object:
        seen.append(case)
        if len(seen) == 1:
            raise NotConvergedError("stopped short")
        return verify_case(case, **settings)

    monkeypatch.setattr("catopt.verify.case.verify_case", first_fails)
    assert run("design", DESIGN, "--out", tmp_path).status == 0
    ran = run("verify", tmp_path, "--all")
    assert ran.status == 4
    assert "Design 1: stopped short" in ran.out
    assert "NO ANSWER" in ran.out
    assert "did not converge" in ran.err
    assert fits(ran.out)


# ------------------------------------------------------------------ in motion

MOVING = OWN / "moving.toml"


def in_motion(run: Run, case: Path, *further: object) -> dict[str, Any]:
    """Return what a document says of the motion."""
    found: dict[str, Any] = document_of(run, "verify", case, "--dynamic", *further)["dynamic"]
    return found


def test_the_series_has_the_largest_tension(run: Run, tmp_path: Path) -> None:
    found = in_motion(run, MOVING, "--out", tmp_path)
    assert found["is_complete"]
    (ran,) = found["load_cases"][0]["runs"]
    tensions = [
        float(row["Fairlead tension T (N)"])
        for row in rows(tmp_path / "dynamic_series.csv")
        if float(row["Time (s)"]) > ran["since_s"] - 1e-6  # the sample at the ramp's end counts
    ]
    # The largest is of every step; between samples the led end's acceleration is carried on.
    assert max(tensions) == pytest.approx(ran["max_fairlead_tension_N"], rel=1e-5)


@pytest.mark.usefixtures("stopped")
def test_ctrl_c_keeps_what_was_computed_and_says_so(run: Run, tmp_path: Path) -> None:
    ran = run("verify", MOVING, "--dynamic", "--json", "--out", tmp_path)
    assert ran.status == 130
    assert "stopped in load case load, run 1 of 1, after " in ran.err
    found = read_document(ran.out)["dynamic"]
    assert not found["is_complete"]
    assert 0.0 < found["load_cases"][0]["runs"][0]["reached_s"] < 24.0
    assert "dynamic_series.csv" in names(tmp_path)


@pytest.mark.slow
def test_extremes_are_in_every_form_with_their_duration_and_interval(
    run: Run, tmp_path: Path
) -> None:
    sea = '[waves]\nspectrum = "jonswap"\nheight = "2 m"\nperiod = "6 s"\ncomponents = 30\n'
    short = '"24 s"\nelements = 20\n'
    long = '"5 min"\nelements = 8\ntime_step = "0.1 s"\nduration_of_interest = "90 min"\n'
    path = changed(MOVING, tmp_path, (short, long + sea))
    out = tmp_path / "out"
    (part,) = in_motion(run, path, "--once", "--out", out)["load_cases"]
    tension, *_, offset = part["quantities"]
    tail = tension["tail"]
    assert (tail["duration_s"], tail["confidence"]) == (5400.0, 0.9)
    assert tail["low"] < tension["most_probable_max"] == tail["most_probable_max"] < tail["high"]
    assert offset["tail"] is None  # led as prescribed
    row, *_ = rows(out / "dynamic_statistics.csv")
    assert float(row["Interval from (unit of the row)"]) == tail["low"]
    assert float(row["Interval to (unit of the row)"]) == tail["high"]
    assert float(row["Duration of interest (s)"]) == 5400.0
    assert float(row["Threshold of the tail (unit of the row)"]) == tail["threshold"]
    told = (tension["most_probable_max"], tail["low"], tail["high"], tail["expected_max"])
    most, low, high, mean = (f"{value / 1e3:.3f}" for value in told)
    assert (
        f"In 90 min the most probable maximum of the fairlead tension is {most} kN (90% interval "
        f"{low} to {high} kN); the expected one is {mean} kN."
    ) in words(run("verify", path, "--dynamic", "--once").out)
    vietnamese = words(run("verify", path, "--dynamic", "--once", "--lang", "vi").out)
    assert "Trong 90 min, cực đại khả dĩ nhất của lực căng tại điểm treo là" in vietnamese
    assert f"(khoảng tin cậy 90% từ {low} đến {high} kN)" in vietnamese


@pytest.mark.slow
def test_a_cluster_gives_the_same_front(run: Run, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    assert run("design", OWN / "design-in-motion.toml", "--out", tmp_path / "front").status == 0
    how = ("verify", tmp_path / "front", "--all", "--dynamic", "--out")
    assert run(*how, tmp_path / "here", "--workers", "2").status == 0
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None
    ) as cluster:
        ran = run(*how, tmp_path / "there", "--scheduler", cluster.scheduler_address)
    assert ran.status == 0
    for name in ("front_in_motion.csv", "verify.json"):
        assert (tmp_path / "there" / name).read_bytes() == (tmp_path / "here" / name).read_bytes()
    refused = run("verify", tmp_path / "front", "--all", "--scheduler", "tcp://127.0.0.1:9")
    assert refused.status == 2
    assert "goes with --all --dynamic" in refused.err


MOORING = """
[site]
water_depth = "30 m"
[line]
fairlead_height = "28 m"
[[line.segments]]
component = "chain studless R3"
diameter = "76 mm"
length = "200 m"
[system]
anchor_radius = "195 m"
azimuths = ["0 deg", "90 deg", "180 deg", "270 deg"]
force = ["400 kN", "0 kN"]
[checks]
safety_factor = 2.0
[design]
lines = [4]
anchor_radii = ["195 m"]
headings = 4
[[design.segments]]
components = ["chain studless R3"]
diameters = ["76 mm", "95 mm"]
lengths = ["200 m"]
[motion]
period = "8 s"
surge = "0.5 m"
[dynamics]
duration = "40 s"
elements = 10
"""


@pytest.mark.slow
def test_a_front_of_whole_moorings_is_verified_at_rest_and_in_motion(
    run: Run, tmp_path: Path
) -> None:
    """Before, the table of designs looked for the tension of a single line: StopIteration."""
    (tmp_path / "case.toml").write_text(MOORING, "utf-8")
    front = tmp_path / "front"
    assert run("design", tmp_path / "case.toml", "--out", front).status == 0
    ran = run("verify", front, "--all", "--dynamic", "--once", "--json")
    assert ran.status == 0
    document = json.loads(ran.out)
    assert [each["verdict"] for each in document["designs"]] == ["agrees"] * 2
    tensions = [each["largest_tension_N"] for each in document["dynamic"]["designs"]]
    assert len(tensions) == 2
    text = run("verify", front, "--all")
    assert "agree on all 2 designs" in text.out


@pytest.mark.parametrize("lines", ["one", "four"])
def test_a_buoy_afloat_is_of_the_schema(run: Run, tmp_path: Path, lines: str) -> None:
    """Before, its pitch and the part of it under water had units that the schema did not allow."""
    text = AFLOAT if lines == "one" else FOUR.read_text("utf-8").replace('"300 s"', '"8 s"')
    place = tmp_path / "buoy.toml"
    place.write_text(text, encoding="utf-8")
    found = document_of(run, "verify", place, "--dynamic", "--once")
    validate(found)
    units = {each["quantity"]: each["unit"] for each in found["dynamic"]["body"]}
    assert units["floater_pitch"] == "rad"
    assert units["floater_wet"] == ""
