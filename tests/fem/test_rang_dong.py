"""FSO Rang Dong's printed statics, as run by the source; and the same mooring on a real bed.

Figures: S4, tables of static results for lines 1 and 2, turret offset, largest tensions.
"""

from __future__ import annotations

import time

import numpy as np
import pytest

import catopt
from catopt.fem import solve_system
from tests.fem.rang_dong import FORCE, TURRET_HEIGHT, as_run, legs

LINE_1 = [1828, 1818, 1809, 1799, 1790, 1779, 1766, 1754, 1742, 1730] + [1519] * 10
LINE_2 = [1918, 1908, 1898, 1889, 1879, 1868, 1856, 1843, 1831, 1819] + [1596] * 10
"""kN, elements from the turret to the anchor."""


@pytest.mark.parametrize(("number", "printed"), [(0, LINE_1), (1, LINE_2)])
def test_every_printed_tension(number: int, printed: list[int]) -> None:
    """To 0.02 %, or to half of the last printed digit where that is more."""
    tension = as_run().lines[number].tension[::-1] / 1e3
    assert np.abs(tension - printed).max() < max(0.5, 0.0002 * 1918)
    assert np.abs(tension / printed - 1.0).max() < 0.0004  # half a kN of 1519 kN is 0.03 %


def test_printed_turret_offset_and_largest_tensions() -> None:
    """6.071 m to its last digit; 1918 and 1596 kN."""
    solution = as_run()
    assert solution.position[0] == pytest.approx(-6.071, abs=0.0005)
    assert solution.position[1] == pytest.approx(0.0, abs=1e-9)
    tension = np.array([line.tension for line in solution.lines]) / 1e3
    assert tension.max() == pytest.approx(1918, abs=0.5)
    assert tension[:, 0].max() == pytest.approx(1596, abs=0.5)
    assert solution.residual < 1e-10


def test_the_held_bed_pulls_on_the_line() -> None:
    """The node at the second joint is held down with what the hanging part lifts."""
    line = as_run().lines[1]
    assert line.bed_reaction[10] < -300e3
    assert line.bed_reaction[11:].max() == 0.0


def test_a_bed_that_only_pushes_lets_the_turret_go_22_m() -> None:
    """The finding beside the printed 6.071 m. Closed form of each leg: forces within 0.01 %."""
    solution = solve_system(legs(), height=TURRET_HEIGHT, force=FORCE, elements=[50, 200, 100, 60])
    assert solution.position[0] == pytest.approx(-21.7, abs=0.1)
    x, y, _ = solution.position
    total = np.zeros(2)
    for leg, truss in zip(legs(), solution.lines, strict=True):
        way = np.array(leg.anchor[:2]) - [x, y]
        span = float(np.hypot(*way))
        closed = catopt.solve(leg.line, height=TURRET_HEIGHT, span=span)
        total += closed.horizontal_force * way / span
        assert truss.fairlead.tension == pytest.approx(closed.fairlead.tension, rel=1e-4)
        assert truss.anchor.tension == pytest.approx(closed.anchor.tension, rel=1e-4)
    assert total == pytest.approx([-FORCE[0], 0.0], abs=1e-4 * abs(FORCE[0]))


def test_180_bars_from_straight_take_well_below_a_second() -> None:
    as_run()
    start = time.process_time()
    as_run()
    assert time.process_time() - start < 0.2
