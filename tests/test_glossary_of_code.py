"""docs/names.md names every public class, and nothing that there is not."""

from __future__ import annotations

import inspect
import re
from importlib import import_module

import catopt
from tests.api_page import DOCS, PAGES, names

PAGE = (DOCS / "names.md").read_text("utf-8")
PUBLIC, INSIDE = PAGE.split("\n## Inside\n")
ROW = re.compile(r"^\| (?!---|term|idea)(.*) \|$", re.MULTILINE)


def named(cell: str) -> list[str]:
    return re.findall(r"`([\w.]+)`", cell)


def public_classes() -> set[str]:
    """Classes of the interface that are terms; errors are no terms of the field."""
    found = {name: getattr(catopt, name) for name in catopt.__all__}
    found |= {
        name: getattr(import_module(module), name)
        for page in PAGES
        for module, name in names(page.read_text("utf-8"))
    }
    classes = {name: each for name, each in found.items() if inspect.isclass(each)}
    return {name for name, each in classes.items() if not issubclass(each, Exception)}


def test_every_public_class_is_named_once() -> None:
    told = [name for row in ROW.findall(PUBLIC) for name in named(row.split(" | ")[1])]
    assert sorted(told) == sorted(public_classes())


def test_what_is_inside_is_where_the_page_says() -> None:
    rows = [row.split(" | ") for row in ROW.findall(INSIDE)]
    assert len(rows) > 10
    for _, cell, places in rows:
        for name, place in zip(named(cell), named(places), strict=True):
            assert inspect.isclass(getattr(import_module(place), name)), f"{place}.{name}"
