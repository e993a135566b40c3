"""Lines without weight: straight where they are stretched, of no known force where slack."""

from __future__ import annotations

import math

import pytest

from catopt import InputError, Line, Segment, solve, solve_many
from catopt.errors import NoEquilibriumError

TAUT = Line([Segment(79.0, 0.0, EA=1e8)])


def test_a_taut_line_without_weight_pulls_by_its_stretch() -> None:
    """79 m of 100 MN over a chord of hypot(80, 10) m: T = EA (chord - L) / L."""
    chord = math.hypot(80.0, 10.0)
    tension = 1e8 * (chord - 79.0) / 79.0
    by_span = solve(TAUT, height=80.0, span=10.0)
    assert by_span.fairlead.tension == pytest.approx(tension, rel=1e-12)
    assert by_span.horizontal_force == pytest.approx(tension * 10.0 / chord, rel=1e-12)
    by_tension = solve(TAUT, height=80.0, fairlead_tension=tension)
    assert by_tension.span == pytest.approx(10.0, rel=1e-10)
    upright = solve(TAUT, height=80.0, span=0.0)
    assert upright.fairlead.tension == pytest.approx(1e8 / 79.0, rel=1e-10)
    assert solve(TAUT, height=0.0, span=79.5).fairlead.tension == pytest.approx(
        1e8 * 0.5 / 79.0, rel=1e-12
    )


def test_two_segments_without_weight_stretch_one_after_the_other() -> None:
    two = Line([Segment(40.0, 0.0, EA=1e8), Segment(39.0, 0.0, EA=1e7)])
    softness = 40.0 / 1e8 + 39.0 / 1e7
    found = solve(two, height=80.0, span=10.0)
    wanted = (math.hypot(80.0, 10.0) - 79.0) / softness
    assert found.fairlead.tension == pytest.approx(wanted, rel=1e-12)


def test_a_tension_straightens_a_line_without_weight() -> None:
    found = solve(TAUT, height=40.0, fairlead_tension=1e6)
    assert found.span == pytest.approx(math.sqrt((79.0 * 1.01) ** 2 - 40.0**2), rel=1e-12)
    rigid = solve(Line([Segment(79.0, 0.0)]), height=40.0, fairlead_tension=1e6)
    assert rigid.span == pytest.approx(math.sqrt(79.0**2 - 40.0**2), rel=1e-12)
    with pytest.raises(NoEquilibriumError, match=r"265823 N too small.*takes 1\.26582e\+06 N"):
        solve(TAUT, height=80.0, fairlead_tension=1e6)


@pytest.mark.parametrize(("height", "span"), [(40.0, 10.0), (79.0, 0.0)])
def test_a_slack_line_without_weight_needs_its_force(height: float, span: float) -> None:
    with pytest.raises(InputError, match="only where it is stretched"):
        solve(TAUT, height=height, span=span)
    rigid = Line([Segment(79.0, 0.0)])
    with pytest.raises(NoEquilibriumError, match=r"1\.62258 m too short"):
        solve(rigid, height=80.0, span=10.0)


def test_many_lines_without_weight_are_solved_as_one_is() -> None:
    """Where the chord is longer than the line, and under any tension; a slack one has no shape."""
    line = Line([Segment(79.0, 0.0, EA=1e8)])
    found = solve_many(line, height=10.0, span=[80.0, 78.0])
    stretched = 1e8 * (math.hypot(80.0, 10.0) - 79.0) / 79.0
    assert found.converged.tolist() == [True, False]
    assert found.tension[0] == pytest.approx(stretched, rel=1e-9)
    pulled = solve_many(line, height=10.0, fairlead_tension=[stretched])
    assert pulled.span[0] == pytest.approx(80.0, rel=1e-9)
