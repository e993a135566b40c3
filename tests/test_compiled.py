"""Compiling is told once, when it happens, and not when the machine code is read from disk."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

KERNEL = '''
def twice(x):
    """Not compiled anywhere before."""
    return 2.0 * x


def four_times(x):
    """The same, by another kernel."""
    return 4.0 * x
'''
RUN = """
from catopt.compiled import compiled, when_compiling
from kernel import four_times, twice

told = []
when_compiling(lambda: told.append("compiling"))
assert compiled(twice)(1.5) == 3.0
assert compiled(four_times)(1.5) == 6.0
print(len(told))
"""


def test_compiling_is_told_once_and_only_where_it_happens(tmp_path: Path) -> None:
    """Every process is new; the second finds what the first one kept."""
    (tmp_path / "kernel.py").write_text(KERNEL)
    (tmp_path / "run.py").write_text(RUN)
    told = [
        subprocess.run(
            [sys.executable, "run.py"], cwd=tmp_path, capture_output=True, text=True, check=True
        ).stdout.strip()
        for _ in range(2)
    ]
    assert told == ["1", "0"]
