"""``catopt verify --dynamic``: what it prints and writes, what it refuses, and how it ends."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import jsonschema
import openpyxl
import pytest

from catopt import schemas
from catopt.casefile.design_directory import read_case_or_design
from catopt.cli import answering as command
from catopt.verify.dynamic import verify_dynamic

from .conftest import BUOY, CHAIN_IN_MOTION, Run, without_digest


@pytest.fixture
def moving(tmp_path: Path) -> Path:
    path = tmp_path / "moving.toml"
    path.write_text(CHAIN_IN_MOTION, encoding="utf-8")
    return path


def document(text: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(text)
    jsonschema.Draft202012Validator(schemas.schema("catopt.verify/1")).validate(found)
    return found


def test_a_line_in_motion(run: Run, moving: Path) -> None:
    ran = run("verify", moving, "--dynamic")
    assert (ran.status, ran.err) == (0, "")
    assert "The two models agree." in ran.out
    assert "times the quasi-static" in ran.out
    assert "No part of the line goes slack." in ran.out
    assert max(map(len, ran.out.splitlines())) <= 80
    assert "Line in motion" not in run("verify", moving).out


def test_the_document_and_the_files(run: Run, moving: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    found = document(run("verify", moving, "--dynamic", "--json", "--out", out).out)
    (part,) = found["dynamic"]["load_cases"]
    assert found["dynamic"]["is_complete"]
    assert without_digest(out / "verify.json") == found
    with (out / "dynamic_series.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    (ran,) = part["runs"]
    since = ran["since_s"]
    tensions = [
        float(row["Fairlead tension T (N)"])
        for row in rows
        if float(row["Time (s)"]) > since - 1e-6  # the sample at the ramp's end counts
    ]
    # The largest is of every step; between samples the led end's acceleration is carried on.
    assert max(tensions) == pytest.approx(ran["max_fairlead_tension_N"], rel=1e-5)
    sheets = openpyxl.load_workbook(out / "dynamic.xlsx", read_only=True).sheetnames
    assert {"Series", "Statistics", "Envelope", "Runs", "Summary"} <= set(sheets)
    assert (out / "dynamic.png").stat().st_size > 0
    assert (out / "dynamic.svg").stat().st_size > 0


CODED = (
    CHAIN_IN_MOTION.replace('mass = "130 kg/m"', 'mass = "130 kg/m"\nMBL = "3000 kN"')
    + '[checks]\ncodes = ["API-RP-2SK"]\n'
)


def test_codes_judge_the_tensions_by_their_factors_for_motion(run: Run, tmp_path: Path) -> None:
    """By 1.67, in every face."""
    path, out = tmp_path / "coded.toml", tmp_path / "out"
    path.write_text(CODED, encoding="utf-8")
    found = document(run("verify", path, "--dynamic", "--json", "--out", out).out)["dynamic"]
    (made,) = found["checks"]["checks"]
    largest = found["load_cases"][0]["max_tension_N"]
    assert made["demand"] == largest
    assert made["utilisation"] == pytest.approx(1.67 * largest / 3000e3, rel=1e-12)
    assert found["checks"]["passes"] is True
    assert (made["state"], made["code"]) == ("intact", "API-RP-2SK")
    with (out / "dynamic_checks.csv").open(newline="", encoding="utf-8") as file:
        (row,) = csv.DictReader(file)
    assert float(row["Demand (unit of the row)"]) == pytest.approx(largest / 1e3, rel=1e-9)
    assert row["Code"] == "API-RP-2SK"
    printed = run("verify", path, "--dynamic", "--lang", "vi").out
    assert "Kiểm tra lực căng khi chuyển động" in printed
    assert "Checks of" not in printed


def test_a_case_without_codes_says_so(run: Run, moving: Path) -> None:
    ran = run("verify", moving, "--dynamic", "--json")
    checks = document(ran.out)["dynamic"]["checks"]
    assert (checks["passes"], checks["checks"]) == (None, [])
    assert checks["warnings"] == [
        "no code is named in [checks] codes: no code judges the tensions in motion"
    ]


def test_more_that_the_storm_is_likely_to_bring_is_said(run: Run, tmp_path: Path) -> None:
    """A random sea of 60 s, judged by its own largest tension; 3 h bring more."""
    sea = '[waves]\nspectrum = "jonswap"\nheight = "2 m"\nperiod = "8 s"\ndirection = "180 deg"\n'
    path = tmp_path / "sea.toml"
    still = '[motion]\nperiod = "8 s"\nsurge = "0.5 m"\n'
    assert still in CODED
    path.write_text(CODED.replace(still, sea).replace('"24 s"', '"2 min"'), encoding="utf-8")
    found = document(run("verify", path, "--dynamic", "--once", "--json").out)["dynamic"]
    fairlead = found["load_cases"][0]["quantities"][0]
    said = [each for each in found["checks"]["warnings"] if "the most probable one" in each]
    assert fairlead["most_probable_max"] > fairlead["max"]
    (told,) = said
    assert told.startswith("load case load: the largest tension at the fairlead of the runs")
    assert f"{fairlead['most_probable_max'] / 1e3:.3f} kN" in told


def test_a_case_at_rest_says_what_it_lacks(run: Run) -> None:
    ran = run("verify", BUOY, "--dynamic")
    assert ran.status == 2
    assert "dynamics: missing; write [dynamics] with a duration" in ran.err
    assert "line.segments[0].drag_normal: missing" in ran.err


@pytest.fixture
def stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    """Press Ctrl-C in the middle of the run."""

    def tell(done: int, total: int) -> None:
        if done > total / 14:  # half of the run; its proof takes up to six times as much
            raise KeyboardInterrupt

    def stops(*args: Any, **options: Any) -> Any:
        return verify_dynamic(*args, **options | {"progress": tell})

    monkeypatch.setattr("catopt.verify.dynamic.verify_dynamic", stops)


@pytest.mark.usefixtures("stopped")
def test_ctrl_c_keeps_what_was_computed_and_says_so(run: Run, moving: Path, tmp_path: Path) -> None:
    ran = run("verify", moving, "--dynamic", "--json", "--out", tmp_path / "out")
    assert ran.status == command.INTERRUPTED == 130
    assert "stopped in load case load, run 1 of 1, after " in ran.err
    found = document(ran.out)["dynamic"]
    assert not found["is_complete"]
    assert 0.0 < found["load_cases"][0]["runs"][0]["reached_s"] < 24.0
    assert (tmp_path / "out" / "dynamic_series.csv").exists()


DESIGN = """
[[load_cases]]
name = "storm"
horizontal_force = "300 kN"
[checks]
safety_factor = 2.0
[design]
[[design.segments]]
component = "chain studless R3"
diameters = ["76 mm", "84 mm"]
lengths = ["120 m", "130 m"]
"""


def test_a_design_has_the_drag_of_its_components(run: Run, tmp_path: Path) -> None:
    path, out = tmp_path / "design.toml", tmp_path / "front"
    path.write_text(
        CHAIN_IN_MOTION.replace('[load]\nhorizontal_force = "300 kN"', "") + DESIGN, "utf-8"
    )
    assert run("design", path, "--out", out).status == 0
    line = read_case_or_design(out, 1).line
    # The catalogue's 2.4 on the nominal diameter, not the line's own 76 mm.
    assert line.segments[0].drag_normal == 2.4
    assert line.segments[0].drag_diameter == line.segments[0].nominal_diameter
    ran = run("verify", out, "--design", "1", "--dynamic")
    assert ran.status == 0
    assert "Load case storm: line in motion" in ran.out


SNAPPING = (
    CHAIN_IN_MOTION.replace('surge = "0.5 m"', 'heave = "3 m"').replace("300 kN", "20 kN")
    + 'ramp = "8 s"\n'
)  # fmt: skip


@pytest.mark.slow
def test_a_maximum_that_hangs_on_the_bars_ends_with_4(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "snapping.toml"
    path.write_text(SNAPPING, encoding="utf-8")
    ran = run("verify", path, "--dynamic", "--json")
    assert ran.status == command.STOPPED == 4
    assert "catopt: load case load: NOT CONVERGED: run again " in ran.err
    found = document(ran.out)["dynamic"]
    assert found["verdict"] == "not converged"
    (part,) = found["load_cases"]
    assert max(each["change"] for each in part["changes"]) > 0.05


def test_the_proof_stands_beside_the_maxima(run: Run, moving: Path) -> None:
    found = document(run("verify", moving, "--dynamic", "--json").out)["dynamic"]
    (part,) = found["load_cases"]
    assert (found["verdict"], part["proof"]) == ("converged", "step")
    (again,) = part["runs"][0]["again"]
    assert again["time_step_s"] == part["runs"][0]["time_step_s"] / 2
    (ran,) = part["runs"]
    lost = ran["energy"]["numerical_J"] / ran["energy"]["put_in_J"]
    assert abs(lost) == pytest.approx(part["numerical_part"])
    assert "Run again at half the step" in run("verify", moving, "--dynamic").out
    twice = document(run("verify", moving, "--dynamic", "--twice-the-bars", "--json").out)
    assert [a["elements"] for a in twice["dynamic"]["load_cases"][0]["runs"][0]["again"]] == [
        20,
        40,
    ]


def test_once_says_so_in_every_form(run: Run, moving: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    ran = run("verify", moving, "--dynamic", "--once", "--json", "--out", out)
    assert ran.status == 0
    assert document(ran.out)["dynamic"]["verdict"] == "not proven"
    with (out / "dynamic_summary.csv").open(newline="", encoding="utf-8") as file:
        (row,) = csv.DictReader(file)
    assert (row["Verdict"], row["Proof"]) == ("not proven", "run once")
    book = openpyxl.load_workbook(out / "dynamic.xlsx")
    assert "not proven" in [cell.value for row in book["Summary"].iter_rows() for cell in row]
    assert "NOT PROVEN: it was run once" in run("verify", moving, "--dynamic", "--once").out
    shown = run("verify", moving, "--dynamic", "--once", "--lang", "vi").out
    assert "CHƯA KIỂM CHỨNG: chỉ chạy một lần" in shown
    # The note of the directory is of the run that was asked for there.
    assert run("report", out, "--out", tmp_path / "note").status == 0
    (page,) = (tmp_path / "note").glob("*.html")
    assert "NOT PROVEN: it was run once" in page.read_text(encoding="utf-8")


def test_once_without_motion_is_refused(run: Run, moving: Path) -> None:
    ran = run("verify", moving, "--once")
    assert ran.status == 2
    assert "--once: goes with --dynamic, which is missing" in ran.err


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (["--workers", "2"], "--workers: goes with --dynamic, which is missing"),
        (["--dynamic", "--workers", "0"], "--workers: found 0; 1 or more processes"),
    ],
)
def test_workers_that_make_no_sense_are_refused(
    run: Run, moving: Path, given: list[str], said: str
) -> None:
    ran = run("verify", moving, *given)
    assert ran.status == 2
    assert said in ran.err


@pytest.mark.slow
def test_extremes_are_in_every_form_with_their_duration_and_interval(
    run: Run, tmp_path: Path
) -> None:
    path = tmp_path / "sea.toml"
    sea = '[waves]\nspectrum = "jonswap"\nheight = "2 m"\nperiod = "6 s"\ncomponents = 30\n'
    text = CHAIN_IN_MOTION.replace(
        '"24 s"\nelements = 20', '"5 min"\nelements = 8\ntime_step = "0.1 s"'
    )
    path.write_text(f'{text}duration_of_interest = "90 min"\n{sea}', encoding="utf-8")
    out = tmp_path / "out"
    ran = run("verify", path, "--dynamic", "--once", "--json", "--out", out)
    tension, *_, offset = document(ran.out)["dynamic"]["load_cases"][0]["quantities"]
    tail = tension["tail"]
    assert (tail["duration_s"], tail["confidence"]) == (5400.0, 0.9)
    assert tail["low"] < tension["most_probable_max"] == tail["most_probable_max"] < tail["high"]
    assert offset["tail"] is None  # led as prescribed
    with (out / "dynamic_statistics.csv").open(newline="", encoding="utf-8") as file:
        row, *_ = csv.DictReader(file)
    assert float(row["Interval from (unit of the row)"]) == tail["low"]
    assert float(row["Interval to (unit of the row)"]) == tail["high"]
    assert float(row["Duration of interest (s)"]) == 5400.0
    assert float(row["Threshold of the tail (unit of the row)"]) == tail["threshold"]
    shown = " ".join(run("verify", path, "--dynamic", "--once").out.split())
    told = (tension["most_probable_max"], tail["low"], tail["high"], tail["expected_max"])
    most, low, high, mean = (f"{value / 1e3:.3f}" for value in told)
    assert (
        f"In 90 min the most probable maximum of the fairlead tension is {most} kN (90% interval "
        f"{low} to {high} kN); the expected one is {mean} kN."
    ) in shown
    vietnamese = " ".join(run("verify", path, "--dynamic", "--once", "--lang", "vi").out.split())
    assert "Trong 90 min, cực đại khả dĩ nhất của lực căng tại điểm treo là" in vietnamese
    assert f"(khoảng tin cậy 90% từ {low} đến {high} kN)" in vietnamese


def test_a_front_in_motion_names_what_fails_there_alone(run: Run, tmp_path: Path) -> None:
    """With a factor of 12 both pass at rest; in motion 12 times the tension breaks the first."""
    path, out = tmp_path / "design.toml", tmp_path / "front"
    text = CHAIN_IN_MOTION.replace('[load]\nhorizontal_force = "300 kN"', "") + DESIGN
    path.write_text(text.replace("safety_factor = 2.0", "safety_factor = 12.0"), "utf-8")
    assert run("design", path, "--out", out).status == 0
    alone = [
        document(run("verify", out, "--design", str(k), "--dynamic", "--json").out)["dynamic"]
        for k in (1, 2)
    ]
    used = [
        12.0 * max(part["max_tension_N"] for part in each["load_cases"])
        / read_case_or_design(out, k).line.segments[0].MBL
        for k, each in enumerate(alone, start=1)
    ]  # fmt: skip
    assert used[0] > 1.0 > used[1]
    ran = run("verify", out, "--all", "--dynamic", "--out", tmp_path / "moved")
    assert ran.status == 0
    assert "but in motion fail or have no answer that can be relied on: 1." in " ".join(
        ran.out.split()
    )
    assert "Recommended: design 2, the knee of those that pass in motion" in " ".join(
        ran.out.split()
    )
    found = document((tmp_path / "moved" / "verify.json").read_text("utf-8"))["dynamic"]
    assert (found["recommended_by_search"], found["recommended"]) == (1, 2)
    assert [each["passes"] for each in found["designs"]] == [False, True]
    checks = [each["checks"]["checks"][0]["utilisation"] for each in found["designs"]]
    assert checks == pytest.approx(used, rel=1e-12)
    assert "NOT PROVEN" not in ran.out
    once = run("verify", out, "--all", "--dynamic", "--once").out
    assert "NOT PROVEN: it was run once" in once
    assert "front_in_motion.csv" in {each.name for each in (tmp_path / "moved").iterdir()}


def test_a_front_in_motion_needs_a_limit_of_the_tension(run: Run, tmp_path: Path) -> None:
    path, out = tmp_path / "design.toml", tmp_path / "front"
    text = CHAIN_IN_MOTION.replace('[load]\nhorizontal_force = "300 kN"', "") + DESIGN
    path.write_text(text.replace("safety_factor = 2.0", 'max_span = "200 m"'), "utf-8")
    assert run("design", path, "--out", out).status == 0
    ran = run("verify", out, "--all", "--dynamic")
    assert ran.status == 2
    assert "codes or a safety_factor are wanted" in " ".join(ran.err.split())
