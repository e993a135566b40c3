"""S4's turret by a search: its own mooring beside the front, and the front by another route."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

import catopt
from catopt.checks.system import check_system
from catopt.model import System
from catopt.mooring.case import one_line_out
from catopt.mooring.solution import solve_system
from catopt.mooring.zero_load import zero_load_position

CASE = Path("cases/design-turret-56m/case.toml")
FORCE = 4_281e3
"""N: S4, chapter 4."""


def _headings(system: System) -> Iterator[System]:
    for degrees in range(0, 360, 30):
        angle = math.radians(degrees)
        yield system.under((FORCE * math.cos(angle), FORCE * math.sin(angle)))


def _farthest(system: System) -> float:
    """Solve every heading with all lines and without each; m from the zero-load position."""
    rest = zero_load_position(system).neutral
    ways = []
    for loaded in _headings(system):
        for found in (solve_system(loaded), *(out.solution for out in one_line_out(loaded))):
            assert found is not None
            at = found.position
            ways.append(math.hypot(at.x - rest.x, at.y - rest.y))
    return max(ways)


@pytest.mark.slow
def test_the_front_of_the_turret_beside_the_mooring_that_is_there() -> None:
    case = catopt.read_case(CASE)
    result = catopt.design_case(case)
    assert result.is_exact
    own = result.present.point
    assert own is not None
    assert case.system is not None
    assert own.objectives["offset_m"] == pytest.approx(_farthest(case.system), rel=1e-7)
    by_hand = 9 * (750 * 34.9 + 194 * 157.7 + (80 + 58) * 178.7)
    assert own.objectives["mass_kg"] == pytest.approx(by_hand, abs=0.5)
    for point in (result.front[0], result.best):
        assert point.objectives["mass_kg"] < by_hand
        assert point.mooring is not None
        found = point.mooring.system
        assert point.objectives["offset_m"] == pytest.approx(_farthest(found), rel=1e-6)
        for loaded in _headings(found):
            line = found.legs[0].line
            assert check_system(replace(case, line=line, system=loaded, design=None)).passes
