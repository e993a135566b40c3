"""There and back over random lines of every kind: by the span and by the tension."""

from __future__ import annotations

from functools import partial
from typing import Any

import pytest

from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.errors import NoEquilibriumError, TouchesTwiceError
from catopt.model import Line, Segment
from tests.catenary.random_lines import random_setting

EPS = 2.0**-52
STEP = 1e-4


def _there(seed: int, *, buoyant: bool) -> tuple[Any, Solution, Solution] | None:
    """Return a solver for a random line, its answer, and the answer for a little more force."""
    s = random_setting(seed, buoyant=buoyant)
    at: Any = partial(
        solve,
        s.line,
        height=s.height,
        seabed_friction=s.seabed_friction,
        anchor_height=s.anchor_height,
    )
    try:
        force = s.horizontal_force
        return at, at(horizontal_force=force), at(horizontal_force=force * (1.0 + STEP))
    except TouchesTwiceError:
        return None


@pytest.mark.parametrize("buoyant", [False, True])
@pytest.mark.parametrize("block", range(10))
def test_force_to_span_to_force(block: int, buoyant: bool) -> None:
    """To 1e-10, or to what twenty roundings of span and height make of a nearly taut line."""
    for seed in range(100 * block, 100 * block + 100):
        found = _there(seed, buoyant=buoyant)
        if found is None:
            continue
        at, there, more = found
        back = at(span=there.span)
        length = there.line.length
        slope = abs(more.span - there.span) / STEP
        rounding = EPS * length * (1.0 + length / there.span)
        allowed = 1e-10 + 20.0 * rounding / max(slope, 1e-300)
        assert back.horizontal_force == pytest.approx(there.horizontal_force, rel=allowed), seed


@pytest.mark.parametrize("buoyant", [False, True])
@pytest.mark.parametrize("block", range(10))
def test_force_to_tension_to_force(block: int, buoyant: bool) -> None:
    """To 1e-10, or to twenty roundings of a tension that hardly knows the force.

    A line that hangs below its anchor or carries a buoy may have the same tension at a larger
    force; then that one is the answer (tension.given_tension).
    """
    for seed in range(100 * block, 100 * block + 100):
        found = _there(seed, buoyant=buoyant)
        if found is None:
            continue
        at, there, more = found
        tension = there.fairlead.tension
        back = at(fairlead_tension=tension)
        assert back.fairlead.tension == pytest.approx(tension, rel=1e-12), seed
        slope = abs(more.fairlead.tension - tension) / STEP
        allowed = 1e-10 + 20.0 * EPS * tension / max(slope, 1e-300)
        assert back.horizontal_force >= there.horizontal_force * (1.0 - allowed), seed
        is_plain = not buoyant and there.anchor_height == 0.0
        if is_plain:
            expected = pytest.approx(there.horizontal_force, rel=allowed)
            assert back.horizontal_force == expected, seed


def test_least_tension_from_both_sides() -> None:
    """Just above the weight of what must hang there is an answer; just below there is none."""
    line = Line([Segment(30.0, 100.0), Segment(25.0, 2100.0)])
    weight = 20.0 * 2100.0
    just_enough = solve(line, height=20.0, fairlead_tension=weight * (1.0 + 1e-6))
    assert 0.0 < just_enough.horizontal_force < 1e-5 * weight
    with pytest.raises(NoEquilibriumError) as caught:
        solve(line, height=20.0, fairlead_tension=weight * (1.0 - 1e-6))
    # The least tension is the limit of no force, computed at 1e-13 of the weight.
    assert caught.value.missing == pytest.approx(1e-6 * weight, rel=1e-5)


@pytest.mark.parametrize("force", [1.0, 1e4, 1e8])
def test_length_against_the_height_from_both_sides(force: float) -> None:
    """Inextensible: any force has an answer as soon as the line is longer than the height."""
    assert solve(Line([Segment(20.0, 100.0)]), height=20.0 - 1e-6, horizontal_force=force).span > 0
    with pytest.raises(NoEquilibriumError) as caught:
        solve(Line([Segment(20.0, 100.0)]), height=20.0 + 1e-6, horizontal_force=force)
    assert caught.value.missing == pytest.approx(1e-6, rel=1e-6)
