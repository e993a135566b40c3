"""Buoys by name: real and generic ones that come with catopt, and a user's own file."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import MISSING, fields
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, Final, TypeVar

from catopt.catalogue.names import nearest
from catopt.catalogue.table import Table
from catopt.documents import read_text
from catopt.errors import InputError, Problem
from catopt.loads.buoy_shape import BuoyShape, BuoySlice
from catopt.model.validity import Findings
from catopt.words import Message

Made = TypeVar("Made")

SCHEMA = "catopt.buoys/1"
"""What a file of buoys has under its key ``schema``."""


@cache
def buoys() -> tuple[BuoyShape, ...]:
    """Return the buoys that come with catopt: generic ones of its own geometry, and real ones."""
    data = files("catopt.loads").joinpath("data")
    return tuple(
        shape
        for name in ("buoys.toml", "real_buoys.toml")
        for shape in parse_buoys(data.joinpath(name).read_text("utf-8"), f"catopt's {name}")
    )


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
    hint = Message("refused.there_are", names=", ".join(known))
    if near:
        hint = Message("refused.did_you_mean", near=near)
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
        findings.add("buoy", f'"{name}"', Message("refused_sizing.this_name_used_twice"))
    findings.raise_if_any()
    return found


_SLICES: Final = ("hull", "structure", "pylons", "topmarks")
_WORDS: Final = ("name", "origin", "chain_source")


def _read(table: Table, origin: str, findings: Findings) -> BuoyShape | None:
    """Make a buoy; None where something is wrong with it."""
    before = len(findings.problems)
    table.only(*(each.name for each in fields(BuoyShape)))
    for key in _WORDS:
        table.text(key, required=key == "name")
    table.flag("generic")
    short = () if table.has("hull") else ("hull_diameter", "hull_depth")
    for key in ("mass", *short):
        if not table.has(key):
            table.problem(key, Message("refused.number"))
    slices = {key: _slices(table, key, findings) for key in _SLICES if table.has(key)}
    if len(findings.problems) > before:
        return None
    values: dict[str, Any] = {"origin": origin, **table.values, **slices}
    return _made(table, BuoyShape, values, findings)


def _slices(table: Table, key: str, findings: Findings) -> tuple[BuoySlice, ...]:
    """Read an array of slices, from the lowest upwards."""
    made = []
    for each in table.tables(key):
        before = len(findings.problems)
        each.only(*(field.name for field in fields(BuoySlice)))
        for field in fields(BuoySlice):
            if field.default is MISSING and not each.has(field.name):
                each.problem(field.name, Message("refused.number"))
        if len(findings.problems) == before:
            made.append(_made(each, BuoySlice, each.values, findings))
    return tuple(slice_ for slice_ in made if slice_ is not None)


def _made(
    table: Table, maker: Callable[..., Made], values: dict[str, Any], findings: Findings
) -> Made | None:
    try:
        return maker(**values)
    except InputError as error:
        for problem in error.problems:
            findings.add(table.at(problem.key), problem.found, problem.allowed)
        return None
