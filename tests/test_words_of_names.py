"""Modules and shared names are terms: docs/glossary.md lists the words that are none."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
TABLE = (ROOT / "docs" / "glossary.md").read_text("utf-8").split("\n## Words that names")[1]
ROWS = re.findall(r"^\| (?!word|---)(.*?) \| .*? \|(.*)\|$", TABLE, re.MULTILINE)
STAYS = {name for _, names in ROWS for name in re.findall(r"`(\w+)`", names)}
WORDS = {word for words, _ in ROWS for word in words.split(", ") if word not in ("known", "alone")}
FILES = sorted((ROOT / "catopt").rglob("*.py"))


def parts(name: str) -> set[str]:
    """Words of a name, whether it is written with capitals or with underscores."""
    return set(re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower().split("_"))


def is_refused(name: str) -> bool:
    return name not in STAYS and (name == "known" or not WORDS.isdisjoint(parts(name)))


def shared_names(file: Path) -> Iterator[str]:
    """Yield functions and classes of a module that others may import."""
    for node in ast.parse(file.read_text("utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and node.name[0] != "_":
            yield node.name


@pytest.mark.parametrize(
    ("name", "refused"),
    [
        ("settle", True),
        ("turned_line", True),
        ("HeldBed", True),
        ("known", True),
        ("is_known", False),
    ],
)
def test_a_name_is_read_word_by_word(name: str, refused: int) -> None:
    assert is_refused(name) == refused


def test_every_module_is_named_by_a_term() -> None:
    assert [str(file) for file in FILES if is_refused(file.stem)] == []


def test_every_shared_name_is_a_term() -> None:
    found = {name: file for file in FILES for name in shared_names(file)}
    assert {name: str(file) for name, file in found.items() if is_refused(name)} == {}


def test_what_stays_is_there() -> None:
    names = {name for file in FILES for name in shared_names(file)}
    methods = {"not_judged"}  # a column of documents
    assert names | methods >= STAYS


CHANGES = {"append", "add", "clear", "extend", "insert", "pop", "update", "write", "write_text"}


def writes(function: ast.FunctionDef) -> bool:
    """Whether a function stores into something, or calls what changes it."""
    for node in ast.walk(function):
        if isinstance(node, ast.Attribute | ast.Subscript) and isinstance(node.ctx, ast.Store):
            return True
        called = node.func if isinstance(node, ast.Call) else None
        if isinstance(called, ast.Attribute) and called.attr in CHANGES:
            return True
    return False


def test_a_predicate_does_not_act() -> None:
    """What begins with is, has, are, can or may answers, and leaves all as it is."""
    found = [
        f"{file}: {node.name}"
        for file in FILES
        for node in ast.walk(ast.parse(file.read_text("utf-8")))
        if isinstance(node, ast.FunctionDef)
        and re.match("_*(is|has|are|can|may)_", node.name)
        and writes(node)
    ]
    assert found == []
