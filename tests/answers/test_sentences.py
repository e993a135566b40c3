"""What answers say: how a force follows, what governs, and what motion adds."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catopt import Case, Line, Load, Segment, Site, solve_case
from catopt.answers.blocks import Text, Verdict, Warnings
from catopt.answers.loads import loads_answer
from catopt.answers.size import motion_sentence, size_answer
from catopt.answers.solution import solution_answer
from catopt.loads import compare_tanker
from catopt.words import Message, say

from .results import by_force
from .tables import tables_of


def test_every_force_is_explained_and_what_is_recalled_is_a_warning() -> None:
    of = compare_tanker().loads
    how = next(each for each in loads_answer(of).blocks if isinstance(each, Text) and each.caption)
    for each in of.components:
        assert f"{each.name}: {each.formula}\n  {each.numbers_text}\n" in how.said
    first = of.components[0]
    recalled = replace(first, source=replace(first.source, confidence="R"))
    answer = loads_answer(replace(of, components=(recalled, *of.components[1:])))
    said = [text for each in answer.blocks if isinstance(each, Warnings) for text in each.said]
    assert f"recalled figures (R), read in no document: {first.name}" in said


def test_what_governs_is_said() -> None:
    of = by_force()
    notes = tables_of(size_answer(of))["notes"]
    governs = list(notes["Text"][notes["Kind"] == "governs"])
    assert len(governs) == len(of.limits) + 1
    assert of.point.governing is not None
    assert f"{of.point.governing.utilisation:.3f}" in governs[-1]
    assert say(governs[-1], "vi").startswith("Sát giới hạn nhất: ")


def test_what_stands_for_motion_is_said_with_where_it_is_from() -> None:
    of = replace(by_force(), dynamic_factor=1.5, motion=Message("sizing.factor_given"))
    said = motion_sentence(of)
    assert said == "Dynamic factor of 1.5 on the steady forces, in every check (given)."
    assert say(said, "vi").startswith("Hệ số động 1.5 ")
    assert say(said, "vi").endswith("(cho trước).")
    none = motion_sentence(replace(of, dynamic_factor=1.0))
    assert none == "No dynamic factor on the steady forces (given)."


@pytest.mark.parametrize(("MBL", "parts"), [(4e3, True), (5e3, False)])
def test_a_line_that_parts_is_said_above_its_numbers(MBL: float, parts: bool) -> None:
    chain = Segment(name="chain", length=20.0, submerged_weight=9.5 * 9.80665, MBL=MBL)
    case = Case(
        Site(water_depth=9.5),
        Line((chain,)),
        load=Load(horizontal_force=3363.68),
        fairlead_height=9.5,
    )
    answer = solution_answer(case, solve_case(case))  # S1's buoy: 0.446 tf at the fairlead
    first = [each for each in answer.card if isinstance(each, Verdict)]
    assert [each.passes for each in first] == ([False] if parts else [])
    for each in first:
        assert answer.card.index(each) == 1
        assert "segment 1 carries 4.37" in each.said
        assert say(each.said, "vi").startswith("Dây đứt: đoạn 1 chịu 4.37")
