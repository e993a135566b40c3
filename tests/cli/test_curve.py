"""``catopt curve``: its document, its range, and which points it shows."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from catopt.errors import InputError, Problem

from .conftest import BUOY, SOUGHT, Run, changed, document_of, words


@pytest.mark.parametrize(
    ("over", "stepped"),
    [("force", "horizontal_force_N"), ("span", "span_m"), ("offset", "offset_m")],
)
def test_the_document(run: Run, over: str, stepped: str) -> None:
    document = document_of(run, "curve", SOUGHT, "--over", over, "--points", 30)
    assert document["over"] == over
    lists = [key for key, value in document.items() if isinstance(value, list) and key != "marks"]
    assert len(lists) == 9
    assert {len(document[key]) for key in lists} == {30}
    steps = [b - a for a, b in pairwise(document[stepped])]
    assert steps == pytest.approx([steps[0]] * 29, rel=1e-9)


def test_the_tanker_of_s3_and_its_marks(run: Run) -> None:
    """At the length that was found the touchdown is at the anchor under the 450 kN of the case."""
    document = document_of(run, "curve", SOUGHT)
    assert round(document["found"]["value"], 2) == 47.21
    assert round(document["reference"]["fairlead_tension_N"] / 1e3, 2) == 540.35
    touchdown, limit = document["marks"][2:]
    kinds = [mark["kind"] for mark in document["marks"]]
    assert kinds == ["clump_weight", "clump_weight", "regime", "limit"]
    assert touchdown["horizontal_force_N"] == pytest.approx(450e3, rel=1e-9)
    # 770 tf / 5 at the fairlead.
    assert limit["fairlead_tension_N"] == pytest.approx(770e3 / 5 * 9.80665, rel=1e-9)
    zero = document["reference"]["span_m"]
    offsets = [span - zero for span in document["span_m"]]
    assert document["offset_m"] == pytest.approx(offsets, abs=1e-12)


def test_a_line_on_the_bed_has_no_stiffness_in_the_document(run: Run, tmp_path: Path) -> None:
    path = changed(BUOY, tmp_path, ('fairlead_height = "9.5 m"', "fairlead_height = 0"))
    document = document_of(run, "curve", path, "--points", 2)
    assert document["stiffness_N_per_m"] == [None, None]
    assert " - " in words(run("curve", path).out)


def test_values_are_read_with_their_units(run: Run) -> None:
    span = ("--over", "force", "--from", "0.1 tf", "--to", "2000", "--points", 3)
    document = document_of(run, "curve", BUOY, *span)
    expected = [980.665, (980.665 + 2000.0) / 2.0, 2000.0]
    assert document["horizontal_force_N"] == pytest.approx(expected, rel=1e-15)
    assert document["range"] == "as given"


def test_an_offset_may_be_negative(run: Run) -> None:
    offset = ("--over", "offset", "--from", "-200 cm", "--to", "0.005", "--points", 3)
    document = document_of(run, "curve", BUOY, *offset)
    assert document["offset_m"] == pytest.approx([-2.0, -0.9975, 0.005], abs=1e-12)
    assert document["reference"]["span_m"] == pytest.approx(17.43, abs=5e-3)  # S1's digits


def test_another_function_s_input_error_is_passed_on(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only problems of the range take the names of the options."""

    def refuse(*_: object, **__: object) -> None:
        raise InputError([Problem("site.water_depth", "0", "must be above 0 m")], "Site")

    monkeypatch.setattr("catopt.catenary.case_curve.solve_case", refuse)
    ran = run("curve", BUOY)
    assert (ran.status, "site.water_depth: found 0" in ran.err) == (2, True)


def points(shown: str, heading: str) -> list[str]:
    """Read the rows of the one table with this heading."""
    (table,) = [part for part in shown.split("\n\n") if part.startswith(heading)]
    return table.partition("─\n")[2].splitlines()


def test_few_points_are_all_shown_and_no_marks_are_said(run: Run) -> None:
    shown = run("curve", BUOY, "--to", "1 kN", "--points", "4").out
    assert len(points(shown, "Points")) == 4
    assert "No regime changes and no limit is reached in this range." in shown


def test_both_ends_are_shown_of_many_points(run: Run) -> None:
    shown = points(run("curve", BUOY, "--points", "1000").out, "20 of 1000")
    forces = [line.split()[1] for line in shown]
    assert (len(forces), forces[0], forces[-1]) == (20, "0.034", "3.532")
