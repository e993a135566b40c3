"""``catopt import``, decks in the place of a case, and lines that meet in joints."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt import read_case

from .cases import write_files
from .conftest import Run


@pytest.fixture(autouse=True)
def _files(inside: Path) -> None:
    write_files(inside)


def test_it_writes_a_case_file(run: Run) -> None:
    ran = run("import", "oc3.txt", "--out", "new.toml")
    assert (ran.status, ran.out) == (0, "new.toml\n")
    assert read_case("new.toml") == read_case("oc3.txt")
