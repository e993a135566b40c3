"""Values with units that are given as options."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.units import Dimension


def in_si(given: Mapping[str, tuple[str | None, Dimension]]) -> dict[str, float]:
    """Read options, by their names, in SI: each a bare number or one with a unit, or left out.

    Raises InputError with every one that is wrong.
    """
    from catopt.errors import InputError, Problem
    from catopt.numerals import bare_number
    from catopt.units import to_si

    values: dict[str, float] = {}
    problems: list[Problem] = []
    for option, (text, dimension) in given.items():
        if text is None:
            continue
        try:
            values[option] = to_si(bare_number(text), dimension, option)
        except InputError as error:
            problems += error.problems
    if problems:
        raise InputError(problems, "options")
    return values


@contextmanager
def by_option(names: Mapping[str, str] | None = None) -> Iterator[None]:
    """Tell what is wrong with a setting by its option: by its own name where none is given."""
    from catopt.errors import InputError

    try:
        yield
    except InputError as error:
        known = names or {each.key: f"--{each.key}" for each in error.problems}
        problems = [replace(each, key=known[each.key]) for each in error.problems]
        raise InputError(problems, "options") from error
