"""What a command loads, counted in modules, for times wander; and what it can do without."""

from __future__ import annotations

import re
import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest

from .conftest import CASES, Run, typed

slow = partial(pytest.param, marks=pytest.mark.slow)

NOT_NEEDED = {"matplotlib", "numba", "pandas", "pymoo", "pyswarms", "scipy"}
"""Packages without which most answers are the same."""
HEAVY = NOT_NEEDED | {"jinja2", "numpy", "pint", "xlsxwriter"}
LIGHT = HEAVY | {"pydantic", "rich"}


def loaded(*arguments: str) -> set[str]:
    """Top-level names of all modules that a command imports."""
    command = [sys.executable, "-X", "importtime", "-m", "catopt", *arguments]
    ran = subprocess.run(command, capture_output=True, text=True, check=True)
    lines = re.findall(r"^import time:.*\|\s*(\S+)$", ran.stderr, flags=re.MULTILINE)
    return {line.partition(".")[0] for line in lines}


@pytest.mark.parametrize(
    ("line", "absent"),
    [
        ("--help", LIGHT),
        ("--version", LIGHT),
        ("solve --help", HEAVY | {"rich"}),
        ("size buoy --help", HEAVY | {"rich"}),
        ("size tanker --help", HEAVY | {"rich"}),
        ("curve BUOY", HEAVY - {"numpy"}),
        ("catalog show polyester --diameter 0.2", HEAVY),
        ("catalog search --mbl '500 kN' --json", HEAVY | {"rich"}),
        ("solve BUOY --profile", HEAVY),
        ("solve BUOY --json", HEAVY | {"rich"}),
        ("check CASES/tanker-20m/case.toml", HEAVY),
        ("check DESIGN", HEAVY),
        ("verify BUOY", {"jinja2", "matplotlib", "pandas", "xlsxwriter"}),
        ("system FSO --line-out --watch-circle", HEAVY),
        ("system FSO --json", HEAVY | {"rich"}),
    ],
)
def test_nothing_heavy_is_loaded(line: str, absent: set[str]) -> None:
    found = loaded(*typed(line))
    assert "catopt" in found
    assert found & absent == set()


def test_the_guard_sees_what_is_loaded() -> None:
    assert {"numpy", "pyswarms", "rich"} <= loaded(*typed("solve BUOY --method pso"))
    assert "numba" in loaded(*typed("verify BUOY --json"))


# ------------------------------------------------------------------ what cannot be imported

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
        ("solve", "ship-200m-sinker/case.toml", NOT_NEEDED | {"numpy"}),
        ("curve", "buoy-9.5m/case.toml", NOT_NEEDED),
        ("design", "design-buoy-9.5m/case.toml", NOT_NEEDED),
        slow("check", "tanker-20m-find-length/case.toml", NOT_NEEDED | {"numpy"}),
        slow("system", "fso-rang-dong/case.toml", NOT_NEEDED | {"numpy"}),
        slow("size buoy", "size-buoy/sizing.toml", NOT_NEEDED),
        slow("size tanker", "size-tanker/sizing.toml", NOT_NEEDED),
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
    without(NOT_NEEDED, *arguments, tmp_path / "without.html")
    assert run(*arguments, tmp_path / "with.html").status == 0
    assert (tmp_path / "without.html").read_bytes() == (tmp_path / "with.html").read_bytes()


def test_what_is_blocked_is_missing() -> None:
    """A command that needs one of them fails there."""
    with pytest.raises(AssertionError, match="no pyswarms"):
        without(NOT_NEEDED, "solve", CASES / "buoy-9.5m/case.toml", "--method", "pso", "--json")
