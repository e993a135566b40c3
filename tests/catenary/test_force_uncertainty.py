"""What the rounding of the input leaves open of the forces."""

from __future__ import annotations

import math

import pytest

from catopt import solve, solve_many
from catopt.model import Line, Segment


def test_a_nearly_taut_line_says_that_its_last_digits_decide() -> None:
    """By hand: a shallow catenary has H = w L sqrt(L / (24 (L - S))), so dH/dL = H / (2 (L - S)).

    The bound takes half a unit in the last place of length, span and heights, all in the worst
    sense, and sixteen of them for the solver's own residual.
    """
    w, length, spare = 100.0, 1000.0, 1e-9
    line = Line([Segment(length, w)])
    taut = solve(line, height=500.0, anchor_height=500.0, span=length - 1.0)
    assert taut.residual.force_uncertainty < 1e-9 * taut.fairlead.tension
    hard = solve(line, height=500.0, anchor_height=500.0, span=length - spare)
    H = w * length * math.sqrt(length / (24.0 * spare))
    one_digit = 2.0**-53 * length * H / (2.0 * spare)
    assert hard.horizontal_force == pytest.approx(H, rel=1e-3)
    assert one_digit < hard.residual.force_uncertainty < 30.0 * one_digit
    assert any("last digits" in warning for warning in hard.warnings)
    assert not any("last digits" in warning for warning in taut.warnings)
    many = solve_many(line, height=500.0, anchor_height=500.0, span=length - spare)
    assert many.force_uncertainty[0] == pytest.approx(hard.residual.force_uncertainty, rel=0.01)


def test_the_bound_holds_when_the_input_moves_by_its_rounding() -> None:
    line = Line([Segment(1000.0, 100.0)])
    at = {"height": 500.0, "anchor_height": 500.0}
    span = 1000.0 - 1e-8
    here = solve(line, span=span, **at)
    moved = solve(line, span=math.nextafter(span, 0.0), **at)
    change = abs(moved.horizontal_force - here.horizontal_force)
    # One whole unit in the last place of the span is two halves of it.
    assert 0.0 < change < 2.0 * here.residual.force_uncertainty
