"""What answers say: verdicts, what governs, what is recalled, and how a figure follows."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt import catalogue
from catopt.answers.blocks import Table, Text, Warnings
from catopt.answers.catalogue import catalogue_answer
from catopt.answers.check import (
    check_answer,
    governing_sentence,
    load_case_words,
    verdict_sentence,
)
from catopt.answers.loads import loads_answer
from catopt.answers.size import size_answer, steady_sentence
from catopt.catalogue.document import Answer as Found
from catopt.checks.case import check_case
from catopt.loads import compare_tanker
from catopt.model import Checks, Load, LoadCase
from catopt.quantities import QUANTITIES
from catopt.render.values import cell
from catopt.render.workbook import workbook
from catopt.words import say

from .results import around, buoy_case, by_force
from .tables import tables_of


def test_the_verdict_of_checks_and_what_governs() -> None:
    """230 kN / 5 = 46 kN; 4.377 / 46 = 0.095."""
    passing = check_case(buoy_case())
    assert verdict_sentence(passing) == "The one check passes."
    assert governing_sentence(passing) == (
        "Governing: tension, segment 1 (chain) in load case load, utilisation 0.095 (case file)."
    )
    nothing = check_case(buoy_case(checks=Checks()))
    assert verdict_sentence(nothing) == "Nothing was checked."
    assert governing_sentence(nothing) == ""
    assert tables_of(check_answer(nothing))["checks"].empty
    assert workbook(check_answer(nothing)).startswith(b"PK")


def test_a_load_case_is_named_with_its_force() -> None:
    states = (LoadCase("storm", 3363.68), LoadCase("low", 1e3, -1.0, "reference"))
    report = check_case(buoy_case(load=None, load_cases=states))
    assert load_case_words(report, 1) == (
        "Load case low (reference): horizontal force 1.000 kN, fairlead height 8.5 m"
    )
    alone = check_case(buoy_case(load=Load(1e3)))
    assert load_case_words(alone, 0).startswith("Load case load: ")


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


def test_diameters_are_written_in_as_few_digits_as_they_have() -> None:
    family = catalogue.standard().family("chain studless")
    found = Found("show", (family,), catalogue.standard().sold("chain studless", grade="R4"))
    sizes = next(
        each
        for each in catalogue_answer(found).blocks
        if isinstance(each, Table) and each.name == "sizes"
    )
    written = [cell(sizes.columns[0], row) for row in range(3)]
    assert written == ["19", "20.5", "22"]
    assert QUANTITIES["nominal_diameter"].format(0.019) == "19.0"


def test_how_a_figure_follows_is_said_in_both_languages() -> None:
    family = catalogue.standard().family("chain studless")
    chain = catalogue.component("chain studless R4", 0.076)
    answer = catalogue_answer(Found("show", (family,), (chain,)), in_full=True)
    how = next(each for each in answer.blocks if isinstance(each, Text) and each.caption)
    formula = "0.0274 d^2 (44 - 0.08 d) kN"
    assert f"{formula}, d in mm;" in say(how.said, "en")
    assert f"{formula}, d tính bằng mm;" in say(how.said, "vi")


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


def test_what_a_sizing_does_not_judge_is_said() -> None:
    """A ship without a ballast draught is sized loaded."""
    of = around()
    assert any("with its ballast draught both" in each for each in of.assumptions)
