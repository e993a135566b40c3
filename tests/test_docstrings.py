"""The examples of docstrings are run, and print what stands below them."""

from __future__ import annotations

import doctest
import importlib
import inspect
from pathlib import Path

import pytest

import catopt

PACKAGE = Path(__file__).parents[1] / "catopt"
MODULES = sorted(
    ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts)
    for path in PACKAGE.rglob("*.py")
    if ">>> " in path.read_text("utf-8")
)
FLAGS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS


@pytest.mark.slow
@pytest.mark.parametrize("name", MODULES)
def test_examples_print_what_they_say(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """From the project's root, where the cases are that they read."""
    monkeypatch.chdir(PACKAGE.parent)
    found = doctest.testmod(importlib.import_module(name), optionflags=FLAGS)
    assert found.attempted > 0
    assert found.failed == 0


@pytest.mark.parametrize("name", [each for each in catopt.__all__ if each[0].islower()])
def test_every_public_function_has_an_example_and_its_errors(name: str) -> None:
    said = inspect.getdoc(getattr(catopt, name)) or ""
    assert [
        each for each in ("Raises", "Examples") if f"\n{each}\n{'-' * len(each)}\n" not in said
    ] == []
