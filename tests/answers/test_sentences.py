"""What answers say: how a force follows, what governs, and what motion adds."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt.answers.blocks import Text, Warnings
from catopt.answers.loads import loads_answer
from catopt.answers.size import size_answer, steady_sentence
from catopt.loads import compare_tanker
from catopt.words import say

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


def test_the_allowance_for_motion_is_said_first() -> None:
    """Tensions and a drag anchor's pull go with the factor, and so do their utilisations."""
    of = replace(by_force(), dynamic_factor=1.5)
    tension = of.hardest[1].fairlead.tension / 1e3
    checks = [each for each in of.point.checks.results if each.kind == "tension"]
    worst = max(each.demand / each.capacity for each in checks)
    said = say(steady_sentence(of), "en")
    assert f"the tension at the fairlead is {1.5 * tension:.4g} kN, not {tension:.4g} kN" in said
    assert "allowance for motion of 1.5 (given)" in said
    assert f"tension then stands at {1.5 * worst:.3f} of its limit" in said
    beyond = say(steady_sentence(replace(of, dynamic_factor=1.1 / worst)), "en")
    assert "tension then stands at 1.100 of its limit: MORE THAN ALLOWED" in beyond


def test_what_does_not_go_with_the_pull_is_looked_at_under_the_larger_one() -> None:
    """The line of the buoy under 1.5 H, as an inextensible catenary that has left the bed.

    With u = asinh(sqrt(L^2 - h^2)/(2 a)), a = H/w, and tanh m = h/L the pull at the anchor is
    V = H sinh(m - u); the sinker then needs V + SF H/mu. Stretch is a few parts in 100,000.
    """
    still = replace(by_force(), dynamic_factor=1.0)
    assert still.fails_in_motion == ()
    of = replace(by_force(), dynamic_factor=1.5)
    line, anchor, sinker = of.point.line, of.point.anchor, of.sinker
    assert anchor is not None
    assert sinker is not None
    pull, length, height = 1.5 * 3363.7, line.length, of.hardest[1].fairlead_height
    a = pull / line.segments[0].submerged_weight
    u = math.asinh(math.sqrt(length**2 - height**2) / (2.0 * a))
    lift = pull * math.sinh(math.atanh(height / length) - u)
    found = {each.kind: each for each in of.fails_in_motion}
    assert found["uplift_angle"].demand == pytest.approx(math.atan2(lift, pull), rel=1e-3)
    needed = lift + sinker.safety_factor * pull / sinker.friction
    assert found["sliding"].demand == pytest.approx(needed, rel=1e-3)
    said = say(steady_sentence(of), "en")
    assert f"sliding of the sinker then FAILS: {needed / 1e3:.4g} kN beside " in said
    vietnamese = say(steady_sentence(of), "vi")
    assert "khi đó trượt của rùa neo KHÔNG ĐẠT: " in vietnamese
