"""What a command loads before it answers: counted in modules, for times wander."""

from __future__ import annotations

import re
import subprocess
import sys

import pytest

from .conftest import typed

HEAVY = {
    "jinja2", "matplotlib", "numba", "numpy", "pandas", "pint", "pymoo", "pyswarms", "scipy",
    "xlsxwriter",
}  # fmt: skip


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
