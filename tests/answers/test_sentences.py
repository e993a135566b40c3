"""What answers say: how a force follows, what governs, and what motion adds."""

from __future__ import annotations

from dataclasses import replace

from catopt.answers.blocks import Text, Warnings
from catopt.answers.loads import loads_answer
from catopt.answers.size import motion_sentence, size_answer
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
    assert said == "Allowance for motion 1.5 on the steady forces, in every check (given)."
    assert say(said, "vi").startswith("Hệ số động 1.5 ")
    assert say(said, "vi").endswith("(cho trước).")
    none = motion_sentence(replace(of, dynamic_factor=1.0))
    assert none == "No allowance for motion on the steady forces (given)."
