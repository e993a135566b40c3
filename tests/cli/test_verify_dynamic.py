"""``catopt verify --dynamic``: what it finds and proves, and how it ends."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from catopt.cli import answering as command

from .conftest import OWN, Run, changed, document_of, names, read_document, rows, words

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
    assert ran.status == command.INTERRUPTED == 130
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
