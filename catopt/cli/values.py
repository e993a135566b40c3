"""Values with units that are given as options."""

from __future__ import annotations

from collections.abc import Mapping
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
