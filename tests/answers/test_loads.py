"""An answer of loads: each force with its axis, formula, numbers and source, and their sum."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catopt.answers.blocks import Text, Warnings
from catopt.answers.loads import loads_answer
from catopt.loads import compare_tanker

from .tables import tables_of


def test_the_last_row_is_the_force_that_the_mooring_holds() -> None:
    of = compare_tanker().loads
    frame = tables_of(loads_answer(of))["loads"]
    forces = frame["Force F (kN)"][:-1]
    by_axis = [forces[frame["Axis"][:-1] == axis].sum() for axis in ("surge", "sway")]
    # Relative: a few roundings of double precision.
    assert frame["Force F (kN)"].iloc[-1] == pytest.approx(
        (by_axis[0] ** 2 + by_axis[1] ** 2) ** 0.5, rel=1e-14
    )


def test_every_number_is_listed_and_explained() -> None:
    of = compare_tanker().loads
    answer = loads_answer(of)
    numbers = tables_of(answer)["numbers"]
    assert len(numbers) == sum(len(each.numbers) for each in of.components)
    how = next(each for each in answer.blocks if isinstance(each, Text) and each.caption)
    for each in of.components:
        assert f"{each.name}: {each.formula}\n  {each.numbers_text}\n" in how.said


def test_what_is_recalled_is_a_warning() -> None:
    of = compare_tanker().loads
    first = of.components[0]
    recalled = replace(first, source=replace(first.source, confidence="R"))
    answer = loads_answer(replace(of, components=(recalled, *of.components[1:])))
    said = [text for each in answer.blocks if isinstance(each, Warnings) for text in each.said]
    assert f"recalled figures (R), read in no document: {first.name}" in said
