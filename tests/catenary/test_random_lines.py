"""Lines of every kind against quadrature of their differential equations (quadrature.py)."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.errors import NoEquilibriumError, TouchesTwiceError
from catopt.model import Line
from tests.catenary.quadrature import misfit
from tests.catenary.random_lines import random_setting

LENGTH_TOLERANCE = 1e-9
"""Of the length: what is asked of the end position."""

FORCE_TOLERANCE = 1e-12
"""Of the largest force: double precision over a few dozen additions."""


def _solved(seed: int, *, buoyant: bool) -> Solution | None:
    s = random_setting(seed, buoyant=buoyant)
    try:
        return solve(
            s.line,
            height=s.height,
            horizontal_force=s.horizontal_force,
            seabed_friction=s.seabed_friction,
            anchor_height=s.anchor_height,
        )
    except TouchesTwiceError:
        assert buoyant, "only a buoyant part can lift a line off the bed twice"
        return None


@pytest.mark.parametrize("block", range(20))
@pytest.mark.parametrize("buoyant", [False, True])
def test_equilibrium_by_quadrature(block: int, buoyant: bool) -> None:
    solved = 0
    for seed in range(100 * block, 100 * block + 100):
        solution = _solved(seed, buoyant=buoyant)
        if solution is None:
            continue
        solved += 1
        found = misfit(solution)
        assert max(found.x, found.z, found.below_bed) < LENGTH_TOLERANCE, seed
        assert max(found.vertical, found.horizontal) < FORCE_TOLERANCE, seed
        for load, state in zip(solution.line.point_loads, solution.point_loads, strict=True):
            rounding = FORCE_TOLERANCE * solution.fairlead.tension
            most = max(load.submerged_weight, 0.0) + rounding
            assert -rounding <= state.seabed_reaction <= most, seed
    # A line without buoyant parts always has an equilibrium here; with them most still have.
    assert solved == 100 if not buoyant else solved > 60


@pytest.mark.parametrize("seed", range(60))
def test_existence_is_decided_at_the_length_itself(seed: int) -> None:
    """Inextensible: a hair longer than the distance hangs, a hair shorter says what is missing."""
    s = random_setting(seed, raised=True)
    line = Line([replace(part, EA=math.inf) for part in s.line.segments], s.line.point_loads)
    rise = abs(s.height - s.anchor_height)
    span = float(np.sqrt(line.length**2 - rise**2))
    at = partial(solve, line, height=s.height, anchor_height=s.anchor_height)
    reached = at(span=span * (1 - 1e-7))
    assert reached.horizontal_force > 0.0
    with pytest.raises(NoEquilibriumError) as caught:
        at(span=span * (1 + 1e-7))
    assert 0.0 < caught.value.missing < 1e-6 * line.length
