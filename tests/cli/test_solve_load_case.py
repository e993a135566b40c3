"""``catopt solve`` of a case with load cases: under which it is solved."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import catopt
from catopt.catenary.case import solve_case

from .conftest import BUOY, Run

BED_CHAIN = """
[site]
water_depth = 20
[[line.segments]]
length = 100
submerged_weight = 2100
"""

STATES = """
[[load_cases]]
name = "storm"
horizontal_force = "450 kN"
water_level = "1.5 m"
[[load_cases]]
name = "everyday"
horizontal_force = "100 kN"
kind = "reference"
"""


@pytest.fixture
def states(tmp_path: Path) -> Path:
    path = tmp_path / "states.toml"
    path.write_text(BED_CHAIN + STATES, encoding="utf-8")
    return path


def document(run: Run, *arguments: object) -> dict[str, Any]:
    ran = run("solve", *arguments, "--json")
    assert ran.status == 0, ran.err
    return json.loads(ran.out)  # type: ignore[no-any-return]


def test_without_load_the_first_load_case_is_solved_and_named(run: Run, states: Path) -> None:
    """The fairlead goes up with the water: 20 m and 1.5 m of tide."""
    found = document(run, states)
    assert (found["horizontal_force_N"], found["fairlead_height_m"]) == (450e3, 21.5)
    assert found["warnings"] == [
        'solved under the first load case, "storm"; there is also "everyday" (--load-case NAME)'
    ]
    shown = run("solve", states).out
    assert "450.000 kN" in shown
    assert "21.500 m" in shown


def test_a_load_case_is_chosen_by_its_name(run: Run, states: Path) -> None:
    found = document(run, states, "--load-case", "everyday")
    assert (found["horizontal_force_N"], found["fairlead_height_m"]) == (100e3, 20.0)
    assert found["warnings"] == []


def test_a_load_goes_before_the_load_cases(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "both.toml"
    path.write_text(BED_CHAIN + "[load]\nhorizontal_force = 3e5\n" + STATES, encoding="utf-8")
    found = document(run, path)
    assert (found["horizontal_force_N"], found["warnings"]) == (3e5, [])
    assert document(run, path, "--load-case", "storm")["horizontal_force_N"] == 450e3


def test_the_only_load_case_needs_no_word(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "one.toml"
    path.write_text(BED_CHAIN + STATES.partition('[[load_cases]]\nname = "every')[0], "utf-8")
    found = document(run, path)
    assert (found["horizontal_force_N"], found["warnings"]) == (450e3, [])


def test_the_swarm_takes_the_first_load_case_too(run: Run, states: Path) -> None:
    small = ("--method", "pso", "--particles", "10", "--iterations", "5")
    ran = run("solve", states, *small, "--json")
    assert ran.status in (0, 4)  # so small a swarm need not converge
    assert "load" not in ran.err


def test_the_curve_has_the_first_load_case_as_its_reference(run: Run, states: Path) -> None:
    ran = run("curve", states, "--json")
    found = json.loads(ran.out)
    assert found["reference"]["horizontal_force_N"] == 450e3
    assert found["fairlead_height_m"] == 21.5


@pytest.mark.parametrize(
    ("text", "name", "allowed"),
    [
        (BED_CHAIN + STATES, "strom", "one of storm, everyday is wanted"),
        ("", "storm", "the case has no [[load_cases]]"),
        (
            BED_CHAIN + STATES + '[find]\nquantity = "touchdown_force"\n',
            "storm",
            "the case seeks something, touchdown_force; leave out the option or [find]",
        ),
    ],
)
def test_what_cannot_be_chosen_is_refused(
    run: Run, tmp_path: Path, text: str, name: str, allowed: str
) -> None:
    path = tmp_path / "case.toml"
    path.write_text(text or BUOY.read_text("utf-8"), encoding="utf-8")
    ran = run("solve", path, "--load-case", name)
    assert ran.status == 2
    words = " ".join(ran.err.split())
    assert f'--load-case: found "{name}"; {allowed}' in words


def test_python_gives_the_same(states: Path) -> None:
    case = catopt.read_case(states)
    first = solve_case(case)
    assert first.span == solve_case(case.under(case.load_cases[0])).span
    assert len(first.warnings) == 1
