"""Lines out of tables are those of the closed form, and so is the ship on them."""

from __future__ import annotations

import math

import pytest

import catopt
from catopt.floater.line_tables import span_under, tables_of, tabulated
from catopt.model import Line, Segment, System
from catopt.mooring.zero_load import net_of

CHAIN = Segment(length=250.0, submerged_weight=1800.0, EA=8e8)
LINE = Line((CHAIN,))


def tables(way: float) -> object:
    system = System.around(LINE, azimuths=(math.pi,), anchor_radius=240.0, fairlead_height=22.0)
    return tables_of(net_of(system), way)


@pytest.mark.parametrize("height", [19.3, 22.0, 24.1])
@pytest.mark.parametrize("force", [2e3, 4e4, 3e5, 1.5e6])
def test_a_table_is_the_closed_form_within_two_thousandths(height: float, force: float) -> None:
    """Nodes are 5 % apart in force: a chord of H ~ (end - span)^-1/2 is 1e-3 off at most."""
    known = catopt.solve(LINE, height=height, horizontal_force=force)
    found = tabulated(0, known.span, height, tables(4.0))  # type: ignore[arg-type]
    assert found.held
    assert pytest.approx(force, rel=2e-3) == found.H
    assert found.fairlead == pytest.approx(known.fairlead.tension, rel=2e-3)
    assert found.anchor == pytest.approx(known.anchor.tension, rel=2e-3)


def test_the_span_under_a_force_is_that_of_the_closed_form() -> None:
    known = catopt.solve(LINE, height=22.0, horizontal_force=3e5)
    more = catopt.solve(LINE, height=22.0, horizontal_force=3.3e5)
    found = span_under(3.1e5, 22.0, tables(4.0))  # type: ignore[arg-type]
    assert known.span < found.length < more.span
    assert found.stiffness == pytest.approx(3e4 / (more.span - known.span), rel=0.1)


@pytest.mark.parametrize("height", [20.5, 23.3])
def test_between_two_heights_the_span_is_even(height: float) -> None:
    """Chords of 5 % in force and of 1.3 m in height miss the closed form by centimetres."""
    known = catopt.solve(LINE, height=height, horizontal_force=3e5)
    found = span_under(3e5, height, tables(4.0))  # type: ignore[arg-type]
    assert found.length == pytest.approx(known.span, abs=0.03)


def test_a_line_that_does_not_reach_says_so() -> None:
    assert not tabulated(0, 400.0, 22.0, tables(4.0)).held  # type: ignore[arg-type]
