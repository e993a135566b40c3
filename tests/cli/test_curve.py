"""``catopt curve``: its document, its range, and which points it shows."""

from __future__ import annotations

from itertools import pairwise

import pytest

from catopt.errors import InputError, Problem

from .conftest import BUOY, SOUGHT, Run, document_of


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


def test_both_ends_are_shown_of_many_points(run: Run) -> None:
    shown = points(run("curve", BUOY, "--points", "1000").out, "20 of 1000")
    forces = [line.split()[1] for line in shown]
    assert (len(forces), forces[0], forces[-1]) == (20, "0.034", "3.532")
