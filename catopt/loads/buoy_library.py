"""Buoys by name: catopt's generic ones, and a user's own file of the same form."""

from __future__ import annotations

import os
from dataclasses import MISSING, fields
from functools import cache
from importlib.resources import files
from pathlib import Path

from catopt.catalogue.names import nearest
from catopt.catalogue.table import Table
from catopt.documents import read_text
from catopt.errors import InputError, Problem
from catopt.loads.buoy_shape import BuoyShape
from catopt.model.validity import Findings

SCHEMA = "catopt.buoys/1"
"""What a file of buoys has under its key ``schema``."""


@cache
def buoys() -> tuple[BuoyShape, ...]:
    """Return the buoys that come with catopt, generic ones of its own geometry; read once."""
    text = files("catopt.loads").joinpath("data").joinpath("buoys.toml").read_text("utf-8")
    return parse_buoys(text, "catopt's buoys.toml")


def buoy(name: str, among: tuple[BuoyShape, ...] | None = None) -> BuoyShape:
    """Look a buoy up, such as ``"pillar 1.8 m"``, among some or catopt's own.

    Raises
    ------
    InputError
        When there is none of that name.
    """
    known = {each.name: each for each in (buoys() if among is None else among)}
    if name in known:
        return known[name]
    near = nearest(name, tuple(known))
    hint = f"did you mean {near}?" if near else "there are: " + ", ".join(known)
    raise InputError([Problem("buoy", f'"{name}"', hint)], "buoys")


def read_buoys(path: str | os.PathLike[str]) -> tuple[BuoyShape, ...]:
    """Read a file of buoys of one's own (TOML, of the form of catopt's buoys.toml).

    Raises
    ------
    InputError
        With every problem of the file.
    """
    source = os.fspath(path)
    return parse_buoys(read_text(Path(path), source, kind="file of buoys"), source)


def parse_buoys(text: str, source: str = "") -> tuple[BuoyShape, ...]:
    """Read the text of a file of buoys, whose source is named in messages of every problem."""
    file, findings = Table.of_file(text, source, SCHEMA, ("origin", "buoy"))
    origin = file.text("origin", required=False) or "the user's own"
    read = [_read(table, origin, findings) for table in file.tables("buoy")]
    found = tuple(shape for shape in read if shape is not None)
    names = [shape.name for shape in found]
    for name in sorted({name for name in names if names.count(name) > 1}):
        findings.add("buoy", f'"{name}"', "this name is used twice")
    findings.raise_if_any()
    return found


def _read(table: Table, origin: str, findings: Findings) -> BuoyShape | None:
    """Make a buoy; None where something is wrong with it."""
    allowed = {each.name: each for each in fields(BuoyShape)}
    before = len(findings.problems)
    table.only(*allowed)
    table.text("name")
    table.text("origin", required=False)
    for key, each in allowed.items():
        if each.default is MISSING and key not in {"name", "origin"} and not table.has(key):
            table.problem(key, "a number is wanted")
    if len(findings.problems) > before:
        return None
    try:
        return BuoyShape(**{"origin": origin, **table.values})
    except InputError as error:
        for problem in error.problems:
            findings.add(table.at(problem.key), problem.found, problem.allowed)
        return None
