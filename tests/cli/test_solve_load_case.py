"""``catopt solve`` of a case with load cases: under which it is solved."""

from __future__ import annotations

from pathlib import Path

import catopt
from catopt.catenary.case import solve_case

from .conftest import OWN, Run, changed, document_of

STATES = OWN / "bed-chain.toml"
EVERYDAY = '[[load_cases]]\nname = "everyday"\nhorizontal_force = "100 kN"\nkind = "reference"\n'
LOAD = "[load]\nhorizontal_force = 3e5\n"


def test_without_load_the_first_load_case_is_solved_and_named(run: Run) -> None:
    """The fairlead goes up with the water: 20 m and 1.5 m of tide."""
    found = document_of(run, "solve", STATES)
    assert (found["horizontal_force_N"], found["fairlead_height_m"]) == (450e3, 21.5)
    assert found["warnings"] == [
        'solved under the first load case, "storm"; there is also "everyday" (--load-case NAME)'
    ]


def test_a_load_case_is_chosen_by_its_name(run: Run) -> None:
    found = document_of(run, "solve", STATES, "--load-case", "everyday")
    assert (found["horizontal_force_N"], found["fairlead_height_m"]) == (100e3, 20.0)
    assert found["warnings"] == []


def test_a_load_goes_before_the_load_cases(run: Run, tmp_path: Path) -> None:
    path = changed(STATES, tmp_path, (EVERYDAY, EVERYDAY + LOAD))
    found = document_of(run, "solve", path)
    assert (found["horizontal_force_N"], found["warnings"]) == (3e5, [])
    storm = document_of(run, "solve", path, "--load-case", "storm")
    assert storm["horizontal_force_N"] == 450e3


def test_the_only_load_case_needs_no_word(run: Run, tmp_path: Path) -> None:
    found = document_of(run, "solve", changed(STATES, tmp_path, (EVERYDAY, "")))
    assert (found["horizontal_force_N"], found["warnings"]) == (450e3, [])


def test_the_swarm_takes_the_first_load_case_too(run: Run) -> None:
    small = ("--method", "pso", "--particles", "10", "--iterations", "5")
    ran = run("solve", STATES, *small, "--json")
    assert ran.status in (0, 4)  # so small a swarm need not converge
    assert "load" not in ran.err


def test_the_curve_has_the_first_load_case_as_its_reference(run: Run) -> None:
    found = document_of(run, "curve", STATES)
    assert found["reference"]["horizontal_force_N"] == 450e3
    assert found["fairlead_height_m"] == 21.5


def test_python_gives_the_same() -> None:
    case = catopt.read_case(STATES)
    first = solve_case(case)
    assert first.span == solve_case(case.under(case.load_cases[0])).span
    assert len(first.warnings) == 1
