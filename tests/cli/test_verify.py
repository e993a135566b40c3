"""``catopt verify``: what it prints and writes, what it refuses, and how it ends."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from catopt.__main__ import main
from catopt.catenary.case import solve_case
from catopt.catenary.solution import Solution
from catopt.errors import NotConvergedError
from catopt.model import Case, Line
from catopt.verify.case import verify_case

from .conftest import BUOY, DESIGN, Run, document_of, fits, read_document, words


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
        raise NotConvergedError("the truss did not come to rest")

    monkeypatch.setattr("catopt.verify.line.solve_line", never)
    ran = run("verify", BUOY, "--json")
    assert (ran.status, ran.out) == (4, "")
    assert "did not come to rest" in ran.err


@pytest.fixture(scope="module")
def front(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Search a small front once, and keep its directory."""
    directory = tmp_path_factory.mktemp("front")
    options = ["--method", "nsga2", "--evaluations", "400", "--seed", "3", "--out"]
    assert main(["design", str(DESIGN), *options, str(directory)]) == 0
    return directory


@pytest.mark.slow
def test_every_design_of_a_front(run: Run, front: Path) -> None:
    designs = json.loads((front / "design.json").read_text("utf-8"))["front"]
    ran = run("verify", front, "--all", "--strict", "--elements", 40)
    assert ran.status == 0
    assert f"The two models agree on all {len(designs)} designs." in ran.out
    assert fits(ran.out)
    found = document_of(run, "verify", front, "--all", "--elements", 20)["designs"]
    assert [each["design"] for each in found] == list(range(1, len(designs) + 1))
    for each, design in zip(found, designs, strict=True):
        (part,) = each["load_cases"]
        assert design["governing"].endswith(f"({part['load_case']})")


@pytest.mark.slow
def test_a_design_that_does_not_converge_is_4_and_the_others_are_shown(
    run: Run, front: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen = []

    def first_fails(case: Case, **settings: Any) -> object:
        seen.append(case)
        if len(seen) == 1:
            raise NotConvergedError("stopped short")
        return verify_case(case, **settings)

    monkeypatch.setattr("catopt.verify.case.verify_case", first_fails)
    ran = run("verify", front, "--all")
    assert ran.status == 4
    assert "Design 1: stopped short" in ran.out
    assert "NO ANSWER" in ran.out
    assert "did not converge" in ran.err
    assert fits(ran.out)
