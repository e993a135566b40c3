"""S4's rule for sharing a force, beside its own sum written out and against catenaries."""

from __future__ import annotations

import math

import pytest

import catopt
from catopt.errors import InputError
from catopt.mooring.case import load_sharing_factor


def test_the_sums_of_six_eight_and_ten_lines() -> None:
    """With cos 60 = 1/2, cos 45 = 1/sqrt 2; cos 36 and cos 72 = (sqrt 5 +- 1)/4."""
    root = math.sqrt(5.0)
    six = 1.0 + 2.0 * 0.5**2
    eight = 1.0 + 2.0 * 0.5
    ten = 1.0 + 2.0 * ((root + 1.0) / 4.0) ** 2 + 2.0 * ((root - 1.0) / 4.0) ** 2
    # A sum of at most five terms of order 1 in double precision.
    assert load_sharing_factor(6) == pytest.approx(six, rel=1e-15)
    assert load_sharing_factor(8) == pytest.approx(eight, rel=1e-15)
    assert load_sharing_factor(10) == pytest.approx(ten, rel=1e-15)


@pytest.mark.parametrize("lines", [4, 6, 8, 10, 12, 14, 36, 100])
def test_the_factor_is_a_quarter_of_the_number_of_lines(lines: int) -> None:
    assert load_sharing_factor(lines) == pytest.approx(lines / 4.0, rel=1e-15)


@pytest.mark.parametrize("lines", [-6, 0, 1, 2, 3, 5, 7, 9])
def test_other_numbers_of_lines_are_refused(lines: int) -> None:
    with pytest.raises(InputError, match=f"lines: found {lines}; the rule needs an even number"):
        load_sharing_factor(lines)


def _carried(
    line: catopt.Line, height: float, pretension: float, lines: int, offset: float
) -> float:
    """Force that a ring of lines carries, over the horizontal force of the most loaded one.

    The body is moved by `offset` against the direction of the first line.
    """
    radius = catopt.solve(line, height=height, horizontal_force=pretension).span
    along, forces = [], []
    for k in range(lines):
        azimuth = 2.0 * math.pi * k / lines
        x, y = radius * math.cos(azimuth) + offset, radius * math.sin(azimuth)
        span = math.hypot(x, y)
        force = catopt.solve(line, height=height, span=span).horizontal_force
        along.append(force * x / span)
        forces.append(force)
    return math.fsum(along) / max(forces)


def test_catenaries_can_lie_on_either_side_of_the_rule() -> None:
    """As the finding of the study says: it depends on line, pretension and offset."""
    tanker = catopt.Line([catopt.Segment(55.0, 2100.0)])
    ship = catopt.Line([catopt.Segment(600.0, 1000.0)])
    assert _carried(tanker, 20.0, 100e3, 6, 0.78) < 0.5 * load_sharing_factor(6)
    assert _carried(ship, 200.0, 10e3, 8, 25.0) > 1.02 * load_sharing_factor(8)
