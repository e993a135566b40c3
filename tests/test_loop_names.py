"""Loops name the thing that they go over: no `of` or `each` in the parts that were read for it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import catopt

PACKAGE = Path(catopt.__file__).parent
READ = (
    "waves", "words", "schemas", "hydro", "web", "page_api", "report", "cli", "casefile",
    "decks", "reproduce",
)  # fmt: skip
"""Parts without such names; a part joins when its loops are named."""


def named(target: ast.expr) -> Iterator[str]:
    return (node.id for node in ast.walk(target) if isinstance(node, ast.Name))


@pytest.mark.parametrize("part", READ)
def test_a_loop_names_the_thing(part: str) -> None:
    found = [
        f"{path.name}:{node.target.lineno}"
        for path in sorted(PACKAGE.joinpath(part).rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.For | ast.comprehension)
        and not {"of", "each"}.isdisjoint(named(node.target))
    ]
    assert found == []
