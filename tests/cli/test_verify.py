"""``catopt verify``: what it prints and writes, what it refuses, and how it ends."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import jsonschema
import openpyxl
import pytest

from catopt import schemas
from catopt.catenary.case import solve_case
from catopt.catenary.solution import Solution
from catopt.errors import NotConvergedError
from catopt.model import Case

from .conftest import BUOY, CASES, Ran, Run, without_digest
from .test_cold_start import loaded

DESIGN = CASES / "design-buoy-9.5m" / "case.toml"

TWICE = """
title = "A buoy between two touchdowns"
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "300 m"
submerged_weight = "1000 N/m"
EA = "500 MN"
[[line.point_loads]]
position = "150 m"
submerged_weight = "-50 kN"
[load]
horizontal_force = "20 kN"
"""


@pytest.fixture
def twice(tmp_path: Path) -> Path:
    path = tmp_path / "twice.toml"
    path.write_text(TWICE, encoding="utf-8")
    return path


@pytest.fixture
def off(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the closed form be wrong: its line weighs one part in a hundred more."""

    def wrong(case: Case) -> Solution:
        from dataclasses import replace

        heavier = [replace(s, submerged_weight=1.01 * s.submerged_weight)
                   for s in case.line.segments]  # fmt: skip
        return solve_case(replace(case, line=replace_segments(case, heavier)))

    monkeypatch.setattr("catopt.verify.case.solve_case", wrong)


def replace_segments(case: Case, segments: list[Any]) -> Any:
    from catopt.model import Line

    return Line(segments, case.line.point_loads)


def document(ran: Ran) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(ran.out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.verify/1")).validate(found)
    return found


def fits(text: str) -> bool:
    return max(map(len, text.splitlines())) <= 80 and "…" not in text


# ------------------------------------------------------------------ what it prints


def test_a_line(run: Run) -> None:
    ran = run("verify", BUOY)
    assert (ran.status, ran.err) == (0, "")
    assert "The two models agree." in ran.out
    assert "Fairlead tension (kN)" in ran.out
    assert fits(ran.out)


def test_every_load_case(run: Run) -> None:
    ran = run("verify", DESIGN)
    assert ran.status == 0
    assert [f"Load case {name}" in ran.out for name in ("storm, high water", "everyday")] == [
        True, True,
    ]  # fmt: skip
    assert "The two models agree in all 3 load cases." in ran.out
    assert fits(ran.out)
    ran = run("verify", DESIGN, "--load-case", "everyday", "--json")
    assert [part["load_case"] for part in document(ran)["load_cases"]] == ["everyday"]


def test_a_line_that_touches_twice(run: Run, twice: Path) -> None:
    ran = run("verify", twice, "--strict")
    assert (ran.status, ran.err) == (0, "")
    assert "The two models agree." in " ".join(ran.out.split())
    assert fits(ran.out)


def test_json_is_the_document_of_python(run: Run) -> None:
    import catopt

    ran = run("verify", BUOY, "--json")
    assert (ran.status, ran.err) == (0, "")
    assert document(ran) == catopt.verify_case(catopt.read_case(BUOY)).to_dict()


# ------------------------------------------------------------------ how it ends


@pytest.mark.usefixtures("off")
def test_models_that_differ_are_an_answer_and_with_strict_3(run: Run) -> None:
    ran = run("verify", BUOY)
    assert (ran.status, ran.err) == (0, "")
    assert "The two models DIFFER: span by" in " ".join(ran.out.split())
    assert fits(ran.out)
    ran = run("verify", BUOY, "--strict", "--json")
    assert ran.status == 3
    assert document(ran)["verdict"] == "differs"
    assert ran.err.startswith("catopt: The two models DIFFER: ")
    assert run("verify", DESIGN, "--strict").status == 3


def test_not_converged_is_4_and_no_answer(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object, **__: object) -> object:
        raise NotConvergedError("the truss did not come to rest")

    monkeypatch.setattr("catopt.verify.line.solve_line", never)
    ran = run("verify", BUOY, "--json")
    assert (ran.status, ran.out) == (4, "")
    assert "did not come to rest" in ran.err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["no-such-file.toml"], "there is no such file"),
        ([BUOY, "--elements", "2"], "--elements: found 2; must be 4 or more"),
        ([BUOY, "--tolerance", "0"], "--tolerance: found 0.0; must be above 0"),
        ([BUOY, "--load-case", "storm"], "the case has no [[load_cases]]"),
        ([BUOY, "--all"], "a directory that catopt design --out wrote is wanted"),
        ([BUOY, "--all", "--design", "3"], "--design: found 3; does not go with --all"),
    ],
)
def test_wrong_input_is_2(run: Run, arguments: list[object], said: str) -> None:
    ran = run("verify", *arguments)
    assert (ran.status, ran.out) == (2, "")
    assert said in ran.err


# ------------------------------------------------------------------ fronts


@pytest.fixture(scope="module")
def front(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Search a small front once, and keep its directory."""
    from catopt.__main__ import main

    directory = tmp_path_factory.mktemp("front")
    case = DESIGN.read_text("utf-8")
    (directory / "small.toml").write_text(case, encoding="utf-8")
    options = ["--method", "nsga2", "--evaluations", "400", "--seed", "3", "--out"]
    assert main(["design", str(directory / "small.toml"), *options, str(directory)]) == 0
    return directory


@pytest.mark.slow
def test_every_design_of_a_front(run: Run, front: Path) -> None:
    designs = json.loads((front / "design.json").read_text("utf-8"))["front"]
    ran = run("verify", front, "--all", "--strict", "--elements", 40)
    assert ran.status == 0
    assert f"The two models agree on all {len(designs)} designs." in ran.out
    assert fits(ran.out)
    found = document(run("verify", front, "--all", "--json", "--elements", 20))["designs"]
    assert [each["design"] for each in found] == list(range(1, len(designs) + 1))
    for each, design in zip(found, designs, strict=True):
        (part,) = each["load_cases"]
        assert design["governing"].endswith(f"({part['load_case']})")


def test_one_design_in_all_its_load_cases(run: Run, front: Path) -> None:
    parts = document(run("verify", front, "--design", 1, "--json"))["load_cases"]
    assert len(parts) == 3


@pytest.mark.slow
def test_a_design_that_does_not_converge_is_4_and_the_others_are_shown(
    run: Run, front: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from catopt.verify.case import verify_case

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


# ------------------------------------------------------------------ files


def test_out_writes_tables_figures_and_the_document(run: Run, tmp_path: Path) -> None:
    ran = run("verify", BUOY, "--json", "--out", tmp_path / "out")
    assert ran.status == 0
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "verify.json", "verify.xlsx", "verdicts.csv", "quantities.csv", "meshes.csv",
        "shapes.csv", "comparison.png", "comparison.svg", "case.toml",
    }  # fmt: skip
    assert without_digest(tmp_path / "out" / "verify.json") == document(ran)
    book = openpyxl.load_workbook(tmp_path / "out" / "verify.xlsx")
    assert book.sheetnames == ["Verdicts", "Quantities", "Meshes", "Shapes"]
    with (tmp_path / "out" / "quantities.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert {row["Agrees"] for row in rows} == {"yes"}


@pytest.mark.slow
def test_out_of_a_front(run: Run, front: Path, tmp_path: Path) -> None:
    assert run("verify", front, "--all", "--out", tmp_path / "out").status == 0
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "verify.json", "verify.xlsx", "designs.csv", "verdicts.csv", "quantities.csv",
        "meshes.csv", "case.toml", "design.json",
    }  # fmt: skip


# ------------------------------------------------------------------ cold start


@pytest.mark.slow
def test_the_truss_model_is_loaded_by_verify_alone() -> None:
    """With the compiler, which may have its machine code on disk."""
    assert "numba" in loaded("verify", str(BUOY), "--json")
    assert "numba" not in loaded("check", str(DESIGN))
