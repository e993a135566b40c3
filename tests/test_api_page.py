"""docs/api.md has every public name, and docs/api-parts.md those of the parts."""

from __future__ import annotations

from pathlib import Path

import pytest

import catopt
from tests.api_page import PAGES, names, up_to_date


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_tables_are_up_to_date(page: Path) -> None:
    text = page.read_text("utf-8")
    assert text == up_to_date(text), "write it anew: python -m tests.api_page"


def test_every_public_name_is_described_once() -> None:
    described = [name for module, name in names(PAGES[0].read_text("utf-8")) if module == "catopt"]
    assert sorted(described) == sorted(set(catopt.__all__) - {"__version__"})


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_no_name_is_described_twice(page: Path) -> None:
    everything = list(names(page.read_text("utf-8")))
    assert len(set(everything)) == len(everything)
