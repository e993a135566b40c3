"""The benchmarks run: each once, at sizes whose figures mean nothing."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.__main__ import BY_NAME, SIZES, all_of, comparisons
from benchmarks.house import Counts, counted, counts_of, solvers, tree_here

ROOT = Path(__file__).parents[1]
NO_PAGE = {"__init__", "__main__", "common", "guard_tasks", "mutants"}
"""Those that measure nothing by themselves, and the one that is told what to break."""


def test_every_benchmark_is_listed() -> None:
    found = {path.stem for path in (ROOT / "benchmarks").glob("*.py")} - NO_PAGE
    assert found == {*SIZES, *BY_NAME}


def test_a_table_with_a_peer_is_gathered_and_another_is_not() -> None:
    peer = ["| task | catopt | ratio |", "|---|---|---|", "| a | 1 us | 30 |"]
    own = ["| bars | time |", "|---|---|", "| 20 | 1 ms |"]
    assert comparisons([*peer, "", "Text.", *own]) == [*peer, ""]


@pytest.mark.slow
@pytest.mark.parametrize("name", all_of(smoke=True))
def test_it_runs_and_says_of_what_commit(name: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", f"benchmarks.{name}", "--smoke"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert f"`python -m benchmarks.{name} --smoke`, commit " in done.stdout


FILE = '''"""A file of two functions."""

import ast
from os import (
    path,
)


def shown(value):
    return _once(value) + _twice(value) + _twice(value)


def _once(
    value,
):
    return value


def _twice(value):
    return ast, path


async def _never(value): return value
'''
"""23 lines, of which 9 are blank."""


def test_the_house_counts_what_is_there() -> None:
    """Imports are 1 + 3 lines; signatures 1 + 3 + 1 and one line that holds all of its function."""
    assert counts_of(FILE) == Counts(
        lines=23, statements=8, files=1, functions=4, imports=4, signatures=6, blanks=9, alone=1
    )


def test_the_house_adds_files_by_part() -> None:
    tree = {
        "catopt/a/one.py": FILE, "catopt/a/b/two.py": FILE, "catopt/top.py": "x = 1\n",
        "catopt/a/words.toml": "not Python",
    }  # fmt: skip
    found = counted(tree)
    assert {part: each.lines for part, each in found.items()} == {"(top)": 1, "a": 46}
    assert found["a"].files == 2


ASKING = """
def shown(case, of):
    if isinstance(case, Case | Network) and of.system is None:
        return case.network if not case.system else None
    if of.system:
        return isinstance(case, Case)
    assert case.system is not None
    return case.system == of.system and not case.several_lines
"""


def test_the_house_counts_places_that_ask_which_kind_a_mooring_is() -> None:
    """A type, `is None`, `not`, `if`, `is not None`, `several_lines`; `==` of two asks nothing."""
    assert (counts_of(ASKING).forks, counts_of(ASKING).asking) == (6, 1)
    assert (counts_of(FILE).forks, counts_of(FILE).asking) == (0, 0)


ASKED, SOLVED = 43, 10
"""Places that ask which kind a mooring is, solvers of what is one concept: to go down, never up."""


def test_a_mooring_becomes_one_thing() -> None:
    tree = tree_here()
    assert sum(each.forks for each in counted(tree).values()) <= ASKED
    assert sum(map(len, solvers(tree).values())) <= SOLVED
