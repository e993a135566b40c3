"""``catopt verify --dynamic``: what it finds and proves, and how it ends."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from catopt.casefile.design_directory import read_case_or_design
from catopt.cli import answering as command

from .conftest import OWN, Run, changed, document_of, names, read_document, rows, words

MOVING, CODED, DESIGN = (OWN / f"{name}.toml" for name in ("moving", "coded", "design-in-motion"))


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
    assert ran.status == command.INTERRUPTED == 130
    assert "stopped in load case load, run 1 of 1, after " in ran.err
    found = read_document(ran.out)["dynamic"]
    assert not found["is_complete"]
    assert 0.0 < found["load_cases"][0]["runs"][0]["reached_s"] < 24.0
    assert "dynamic_series.csv" in names(tmp_path)


def test_a_design_has_the_drag_of_its_components(run: Run, tmp_path: Path) -> None:
    assert run("design", DESIGN, "--out", tmp_path).status == 0
    (segment,) = read_case_or_design(tmp_path, 1).line.segments
    # The catalogue's 2.4 on the nominal diameter, not the line's own 76 mm.
    assert (segment.drag_normal, segment.drag_diameter) == (2.4, segment.nominal_diameter)
    ran = run("verify", tmp_path, "--design", "1", "--dynamic")
    assert ran.status == 0
    assert "Load case storm: line in motion" in ran.out


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


def test_a_front_in_motion_names_what_fails_there_alone(run: Run, tmp_path: Path) -> None:
    """With a factor of 12 both pass at rest; in motion 12 times the tension breaks the first."""
    path = changed(DESIGN, tmp_path, ("safety_factor = 2.0", "safety_factor = 12.0"))
    out, moved = tmp_path / "front", tmp_path / "moved"
    assert run("design", path, "--out", out).status == 0
    used = [
        12.0 * max(
            part["max_tension_N"] for part in in_motion(run, out, "--design", k)["load_cases"]
        ) / read_case_or_design(out, k).line.segments[0].MBL
        for k in (1, 2)
    ]  # fmt: skip
    assert used[0] > 1.0 > used[1]
    ran = run("verify", out, "--all", "--dynamic", "--out", moved)
    assert ran.status == 0
    shown = words(ran.out)
    assert "but in motion fail or have no answer that can be relied on: 1." in shown
    assert "Recommended: design 2, the knee of those that pass in motion" in shown
    assert "NOT PROVEN" not in shown
    found = read_document((moved / "verify.json").read_text("utf-8"))["dynamic"]
    assert (found["recommended_by_search"], found["recommended"]) == (1, 2)
    assert [each["passes"] for each in found["designs"]] == [False, True]
    checks = [each["checks"]["checks"][0]["utilisation"] for each in found["designs"]]
    assert checks == pytest.approx(used, rel=1e-12)
    once = run("verify", out, "--all", "--dynamic", "--once").out
    assert "NOT PROVEN: it was run once" in once
    assert "front_in_motion.csv" in names(moved)
