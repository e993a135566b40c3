"""``catopt curve``: what it prints and writes, what it refuses, and how it ends."""

from __future__ import annotations

import json
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

import catopt
from catopt.errors import InputError

from .conftest import BUOY, CASES, Run, without_digest
from .test_json import document_of
from .test_out import names, png_size, rows

TANKER = CASES / "tanker-20m-find-length" / "case.toml"
FILES = {
    "case.toml",
    "curve.json",
    "curve.xlsx",
    "curve.csv",
    "curve_marks.csv",
    "curve.png",
    "curve.svg",
}


def words(text: str) -> str:
    return " ".join(text.split())


# ------------------------------------------------------------------ the document


@pytest.mark.parametrize("over", ["force", "span", "offset"])
def test_the_document(run: Run, over: str) -> None:
    document = document_of(run, "curve", TANKER, "--over", over, "--points", 30)
    assert (document["schema"], document["over"]) == ("catopt.curve/1", over)
    lists = [key for key, value in document.items() if isinstance(value, list) and key != "marks"]
    assert len(lists) == 9
    assert {len(document[key]) for key in lists} == {30}
    stepped = {"force": "horizontal_force_N", "span": "span_m", "offset": "offset_m"}[over]
    values = document[stepped]
    steps = [b - a for a, b in pairwise(values)]
    assert steps == pytest.approx([steps[0]] * 29, rel=1e-9)


def test_the_tanker_of_s3_and_its_marks(run: Run) -> None:
    """At the length that was found the touchdown is at the anchor under the 450 kN of the case."""
    document = document_of(run, "curve", TANKER)
    assert round(document["found"]["value"], 2) == 47.21
    assert round(document["reference"]["fairlead_tension_N"] / 1e3, 2) == 540.35
    assert [mark["kind"] for mark in document["marks"]] == [
        "clump_weight",
        "clump_weight",
        "regime",
        "limit",
    ]
    touchdown, limit = document["marks"][2:]
    assert touchdown["horizontal_force_N"] == pytest.approx(450e3, rel=1e-9)
    # 770 tf / 5 at the fairlead.
    assert limit["fairlead_tension_N"] == pytest.approx(770e3 / 5 * 9.80665, rel=1e-9)
    zero = document["reference"]["span_m"]
    offsets = [span - zero for span in document["span_m"]]
    assert document["offset_m"] == pytest.approx(offsets, abs=1e-12)


def test_it_prints_what_python_gives(run: Run) -> None:
    result = catopt.curve_case(catopt.read_case(BUOY), over="span", points=9)
    document = document_of(run, "curve", BUOY, "--over", "span", "--points", 9)
    assert document == result.to_dict()


def test_a_line_on_the_bed_has_no_stiffness_in_the_document(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "flat.toml"
    text = BUOY.read_text("utf-8").replace('fairlead_height = "9.5 m"', "fairlead_height = 0")
    path.write_text(text, encoding="utf-8")
    document = document_of(run, "curve", path, "--points", 2)
    assert document["stiffness_N_per_m"] == [None, None]
    assert " - " in words(run("curve", path).out)


# ------------------------------------------------------------------ the range


def test_values_are_read_with_their_units(run: Run) -> None:
    document = document_of(
        run, "curve", BUOY, "--over", "force", "--from", "0.1 tf", "--to", "2000", "--points", 3
    )
    expected = [980.665, (980.665 + 2000.0) / 2.0, 2000.0]
    assert document["horizontal_force_N"] == pytest.approx(expected, rel=1e-15)
    assert document["range"] == "as given"


def test_an_offset_may_be_negative(run: Run) -> None:
    offset = ("--over", "offset", "--from", "-200 cm", "--to", "0.005", "--points", 3)
    document = document_of(run, "curve", BUOY, *offset)
    assert document["offset_m"] == pytest.approx([-2.0, -0.9975, 0.005], abs=1e-12)
    assert document["reference"]["span_m"] == pytest.approx(17.43, abs=5e-3)  # S1's digits


@pytest.mark.parametrize(
    ("further", "said"),
    [
        (["--over", "time"], "'time' is not one of"),
        (["--from", "10 m"], '--from: found "10 m", a length; a force is wanted'),
        (["--over", "span", "--to", "10 kN"], '--to: found "10 kN", a force; a length is wanted'),
        (["--over", "span", "--to", "wide"], '--to: found "wide"; a length is wanted'),
        (["--to", "nan"], '--to: found "nan"; must be finite'),
        (["--from", "5 kN", "--to", "4 kN"], "--to: found 4 kN; must be above the start"),
        (["--from", "5 kN"], "--to: found 3531.86 N; must be above the start"),
        (["--from", "0"], "--from: found 0; must be above 0 N"),
        (["--over", "offset", "--from", "-18 m"], "--from: found -18 m; must be above -17.43 m"),
        (["--points", "1"], "--points: found 1; must be from 2 to 10000"),
        (["--points", "few"], "--points"),
    ],
    ids=" ".join,
)
def test_a_wrong_range_is_2(run: Run, further: list[str], said: str) -> None:
    ran = run("curve", BUOY, *further)
    assert (ran.status, ran.out) == (2, "")
    assert said in words(ran.err)
    assert "Traceback" not in ran.err


def test_everything_wrong_with_a_range_is_told_at_once(run: Run) -> None:
    ran = run("curve", BUOY, "--from", "1 m", "--to", "2 kg")
    assert [word in ran.err for word in ("--from", "--to", "2 errors")] == [True] * 3
    ran = run("curve", BUOY, "--from", "2 kN", "--to", "1 kN", "--points", "0")
    assert [word in ran.err for word in ("--to", "--points", "2 errors")] == [True] * 3


def test_a_range_beyond_the_line_is_3_and_says_by_how_much(run: Run) -> None:
    """20 m of chain reach sqrt(20^2 - 9.5^2) = 17.5997 m; 18 m would take 20.3531 m."""
    for further in ((), ("--json",)):
        ran = run("curve", BUOY, "--over", "span", "--from", "15 m", "--to", "18 m", *further)
        assert (ran.status, ran.out) == (3, "")
        assert f"{math.hypot(18.0, 9.5) - 20.0:.6g} m too short" in ran.err
        assert f"below a span of {math.sqrt(20.0**2 - 9.5**2):.6g} m" in ran.err


def test_another_function_s_input_error_is_passed_on(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only problems of the range take the names of the options."""
    from catopt.errors import Problem

    def refuse(*_: object, **__: object) -> None:
        raise InputError([Problem("site.water_depth", "0", "must be above 0 m")], "Site")

    monkeypatch.setattr("catopt.catenary.case_curve.solve_case", refuse)
    ran = run("curve", BUOY)
    assert (ran.status, "site.water_depth: found 0" in ran.err) == (2, True)


# ------------------------------------------------------------------ the terminal


def test_few_points_are_all_shown_and_no_marks_are_said(run: Run) -> None:
    shown = run("curve", BUOY, "--to", "1 kN", "--points", "4").out
    (table,) = [part for part in shown.split("\n\n") if part.startswith("Points")]
    lines = table.splitlines()
    rule = next(k for k, line in enumerate(lines) if set(line) == {"─"})
    assert len(lines) - rule - 1 == 4
    assert "No regime changes and no limit is reached in this range." in shown


def test_both_ends_are_shown_of_many_points(run: Run) -> None:
    shown = run("curve", BUOY, "--points", "1000").out
    (table,) = [part for part in shown.split("\n\n") if part.startswith("20 of 1000")]
    _, points = table.split("─\n")
    forces = [line.split()[1] for line in points.splitlines()]
    assert (len(forces), forces[0], forces[-1]) == (20, "0.034", "3.532")


# ------------------------------------------------------------------ the files


def test_it_writes_its_files(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "new" / "deep"
    ran = run("curve", TANKER, "--out", out, "--json")
    assert (ran.status, names(out)) == (0, FILES)
    assert ran.err == f"{len(FILES)} files written to {out}\n"
    document: dict[str, Any] = json.loads(ran.out)
    assert without_digest(out / "curve.json") == document
    points, marks = rows(out / "curve.csv"), rows(out / "curve_marks.csv")
    assert [float(row["Span S (m)"]) for row in points] == document["span_m"]
    assert [row["Regime"] for row in points] == document["regime"]
    assert [row["What happens"] for row in marks] == [m["event"] for m in document["marks"]]
    for row, force in zip(points, document["horizontal_force_N"], strict=True):
        assert float(row["Horizontal force H (kN)"]) == force / 1e3
    for row in points[0], marks[0]:
        text = {"Regime", "Kind", "What happens"}
        assert all(heading in text or heading.endswith(")") for heading in row)
    assert png_size(out / "curve.png")[0] == 1440  # the width of the page
    assert "</svg>" in (out / "curve.svg").read_text("utf-8")
