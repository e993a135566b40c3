"""The benchmarks run: each once, at sizes whose figures mean nothing."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.__main__ import BY_NAME, SIZES, all_of, comparisons

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
