"""Tables of a sizing: units of the field, one table of checks and of loads in every command."""

from __future__ import annotations

import math
from dataclasses import replace

import pandas as pd
import pytest

from catopt.answers.check import check_answer
from catopt.answers.loads import loads_answer
from catopt.answers.size import size_answer, steady_sentence
from catopt.words import say

from .results import around, by_force
from .tables import tables_of


def test_the_summary_is_in_the_units_of_its_rows() -> None:
    of = around()
    rows = tables_of(size_answer(of))["sizing"].set_index("What")
    value, unit = rows["Value (unit of the row)"], rows["Unit"]
    diameter = of.point.line.segments[0].nominal_diameter
    assert diameter is not None
    assert (unit["Chain"], value["Chain"]) == ("mm", pytest.approx(diameter * 1e3, rel=1e-15))
    # A shot of chain is 27.5 m.
    assert unit["Length in shots"] == "shots"
    assert value["Length in shots"] == value["Length"] / 27.5
    assert (unit["Lines, evenly spaced"], value["Lines, evenly spaced"]) == ("-", 4.0)
    assert unit["Tension at the fairlead"] == "kN"
    assert value["Tension at the fairlead"] == of.hardest[1].fairlead.tension / 1e3


def test_checks_of_a_sizing_are_those_of_the_command_check() -> None:
    of = around()
    alone = tables_of(check_answer(of.point.checks))["checks"]
    pd.testing.assert_frame_equal(tables_of(size_answer(of))["checks"], alone, check_exact=True)


def test_loads_of_a_sizing_are_those_of_the_command_loads() -> None:
    of = around()
    found = tables_of(size_answer(of))
    for each in of.settled.posed.loads:
        for part in each.parts:
            alone = tables_of(loads_answer(part))
            for name, same in (("forces", "loads"), ("numbers", "numbers")):
                frame = found[name]
                own = frame[(frame["Load case"] == each.load_case) & (frame["On"] == part.title)]
                own = own.drop(columns=["Load case", "On"]).reset_index(drop=True)
                pd.testing.assert_frame_equal(own, alone[same], check_exact=True, check_dtype=False)


def test_a_force_that_was_given_stands_alone() -> None:
    found = tables_of(size_answer(by_force()))
    # One rounding of the conversion.
    assert list(found["forces"]["Force F, given (kN)"]) == pytest.approx([3.3637] * 2, rel=1e-15)
    assert found["numbers"].empty
    assert "Symbol" in found["numbers"]
    assert "pattern" not in found


def test_candidates_are_in_the_units_of_the_field() -> None:
    of = around()
    frame = tables_of(size_answer(of))["candidates"]
    best = frame[frame["Which"] == "recommended"].iloc[0]
    mass, anchor = of.point.line.mass, of.point.anchor
    assert mass is not None
    assert anchor is not None
    assert anchor.mass is not None
    assert best["Mass in air (t)"] == pytest.approx(mass / 1e3, rel=1e-15)
    assert best["Anchor, mass in air (t)"] == pytest.approx(anchor.mass / 1e3, rel=1e-15)
    assert best["Largest span S (m)"] == of.point.objectives["offset_m"]


def test_the_pattern_has_its_angle_in_degrees() -> None:
    of = around()
    assert of.pattern is not None
    frame = tables_of(size_answer(of))["pattern"]
    for row, state in zip(frame.to_dict("records"), of.pattern.states, strict=True):
        # One rounding of the conversion either way.
        assert row["Force off that line (deg)"] == pytest.approx(
            math.degrees(state.direction), rel=1e-15
        )
        assert row["Pull of all lines (kN)"] == state.pull / 1e3


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
