"""The same answers where the packages that they do not need cannot be imported."""

from __future__ import annotations

import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest

from .conftest import CASES, Run

slow = partial(pytest.param, marks=pytest.mark.slow)

HEAVY = {"matplotlib", "numba", "pandas", "pymoo", "pyswarms", "scipy"}

BLOCKED = """
import sys

class Missing:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {names!r}:
            raise ImportError("no " + name)

sys.meta_path.insert(0, Missing())
from catopt.__main__ import main

sys.exit(main(sys.argv[1:]))
"""


def without(names: set[str], *arguments: object) -> str:
    """Run a command where some packages cannot be imported; return its standard output."""
    program = [sys.executable, "-c", BLOCKED.format(names=names)]
    command = [*program, "--debug", *map(str, arguments)]
    ran = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


@pytest.mark.parametrize(
    ("command", "case", "missing"),
    [
        ("solve", "ship-200m-sinker/case.toml", HEAVY | {"numpy"}),
        ("curve", "buoy-9.5m/case.toml", HEAVY),
        ("design", "design-buoy-9.5m/case.toml", HEAVY),
        slow("check", "tanker-20m-find-length/case.toml", HEAVY | {"numpy"}),
        slow("system", "fso-rang-dong/case.toml", HEAVY | {"numpy"}),
        slow("size buoy", "size-buoy/sizing.toml", HEAVY),
        slow("size tanker", "size-tanker/sizing.toml", HEAVY),
    ],
)
def test_the_document_is_the_same_to_the_byte(
    run: Run, command: str, case: str, missing: set[str]
) -> None:
    arguments = [*command.split(), CASES / case, "--json"]
    assert without(missing, *arguments) == run(*arguments).out


@pytest.mark.parametrize("case", ["buoy-9.5m/case.toml", slow("size-buoy/sizing.toml")])
def test_the_page_of_a_note_is_the_same_to_the_byte(run: Run, tmp_path: Path, case: str) -> None:
    arguments = ["report", CASES / case, "--no-verify", "--out"]
    without(HEAVY, *arguments, tmp_path / "without.html")
    assert run(*arguments, tmp_path / "with.html").status == 0
    assert (tmp_path / "without.html").read_bytes() == (tmp_path / "with.html").read_bytes()


def test_what_is_blocked_is_missing() -> None:
    """A command that needs one of them fails there."""
    with pytest.raises(AssertionError, match="no pyswarms"):
        without(HEAVY, "solve", CASES / "buoy-9.5m/case.toml", "--method", "pso", "--json")
