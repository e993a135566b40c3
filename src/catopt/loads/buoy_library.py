"""Buoys by name: catopt's generic ones, and a user's own file of the same form."""

from __future__ import annotations

import os
import tomllib
from dataclasses import MISSING, fields
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from catopt.catalogue.names import nearest
from catopt.errors import InputError, Problem
from catopt.loads.buoy_shape import BuoyShape

__all__ = ["SCHEMA", "buoy", "buoys", "parse_buoys", "read_buoys"]

SCHEMA = "catopt.buoys/1"
"""What a file of buoys has under its key ``schema``."""


@cache
def buoys() -> tuple[BuoyShape, ...]:
    """Return the buoys that come with catopt, generic ones of its own geometry; read once."""
    text = files("catopt.loads").joinpath("data").joinpath("buoys.toml").read_text("utf-8")
    return parse_buoys(text, "catopt's buoys.toml")


def buoy(name: str, among: tuple[BuoyShape, ...] | None = None) -> BuoyShape:
    """Look a buoy up.

    Parameters
    ----------
    name : str
        Such as ``"pillar 1.8 m"``.
    among : tuple of BuoyShape, optional
        Instead of catopt's own.

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

    Parameters
    ----------
    path : path
        The file.

    Raises
    ------
    InputError
        With every problem of the file.
    """
    source = os.fspath(path)
    try:
        text = Path(path).read_text("utf-8-sig")
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "save it as UTF-8"
        problem = Problem("file of buoys", "", f"it cannot be read: {reason}")
        raise InputError([problem], source) from None
    return parse_buoys(text, source)


def parse_buoys(text: str, source: str = "") -> tuple[BuoyShape, ...]:
    """Read the text of a file of buoys.

    Parameters
    ----------
    text : str
        TOML.
    source : str
        Name of the file, for messages.

    Raises
    ------
    InputError
        With every problem of the text.
    """
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError([Problem("file", "", str(error))], source) from None
    problems = [
        Problem(key, "an unknown key", "allowed here: schema, origin, buoy")
        for key in document
        if key not in {"schema", "origin", "buoy"}
    ]
    if document.get("schema") != SCHEMA:
        problems.append(Problem("schema", repr(document.get("schema")), f'"{SCHEMA}" is wanted'))
    tables = document.get("buoy")
    if not isinstance(tables, list) or not all(isinstance(each, dict) for each in tables):
        problems.append(Problem("buoy", "", "missing; one or more [[buoy]] are wanted"))
        tables = []
    origin = document.get("origin", "the user's own")
    read = [_read(table, f"buoy[{i}]", origin, problems) for i, table in enumerate(tables)]
    found = tuple(shape for shape in read if shape is not None)
    names = [shape.name for shape in found]
    problems += [
        Problem("buoy", f'"{name}"', "this name is used twice")
        for name in sorted({name for name in names if names.count(name) > 1})
    ]
    if problems:
        raise InputError(problems, source)
    return found


def _read(
    table: dict[str, Any], path: str, origin: Any, problems: list[Problem]
) -> BuoyShape | None:
    allowed = {each.name: each for each in fields(BuoyShape)}
    before = len(problems)
    for key in table:
        if key not in allowed:
            near = nearest(key, tuple(allowed))
            hint = f"did you mean {near}?" if near else f"allowed here: {', '.join(allowed)}"
            problems.append(Problem(f"{path}.{key}", "an unknown key", hint))
    missing = [k for k, f in allowed.items() if f.default is MISSING and k not in table]
    problems.extend(Problem(f"{path}.{key}", "", "missing") for key in missing)
    given = {"origin": origin, **table}
    problems.extend(
        Problem(f"{path}.{key}", repr(given[key]), "a text is wanted")
        for key in ("name", "origin")
        if key in given and not (isinstance(given[key], str) and given[key])
    )
    if len(problems) > before:
        return None
    try:
        return BuoyShape(**given)
    except InputError as error:
        problems.extend(Problem(f"{path}.{p.key}", p.found, p.allowed) for p in error.problems)
        return None
