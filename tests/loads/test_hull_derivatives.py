"""Linear derivatives of a hull, written out by hand, and where a current acts on one."""

from __future__ import annotations

import math

import pytest

from catopt.loads.hull_derivatives import hull_derivatives
from catopt.loads.tanker_20m import tanker
from catopt.loads.weathervane import Turning, lever_of

UNIT = math.pi * 0.05**2


def test_derivatives_by_hand() -> None:
    """L 100, B 20, T 5 m, Cb 0.8: T/L 0.05, B/T 4, B/L 0.2, as the MSS toolbox lists the terms."""
    found = hull_derivatives(100.0, 20.0, 5.0, 0.8)
    assert found.Yv == pytest.approx(-UNIT * (1.0 + 1.28))
    assert found.Nv == pytest.approx(-UNIT * (0.5 + 0.12))
    assert found.Yr == pytest.approx(-UNIT * (-0.5 + 0.44 - 0.32))
    assert found.Nr == pytest.approx(-UNIT * (0.25 + 0.156 - 0.112))
    assert found.Yv_dot == pytest.approx(-UNIT * (1.0 + 0.512 - 0.204))
    assert found.Nr_dot == pytest.approx(-UNIT * (1.0 / 12.0 + 0.0544 - 0.066))


@pytest.mark.parametrize(("draught", "block", "lever"), [(6.07, 0.72, 0.226), (12.6, 0.80, 0.357)])
def test_the_lever_of_a_tanker_of_50000_dwt(draught: float, block: float, lever: float) -> None:
    """By hand: (0.5 + 2.4 T/L)/(1 + 0.4 Cb B/T), L 203.7 and B 32.2 m.

    In ballast 0.5715/2.5278, loaded 0.6485/1.8178; the recalled series-60 has 0.344 for both.
    """
    assert hull_derivatives(203.7, 32.2, draught, block).lever == pytest.approx(lever, abs=6e-4)


def test_the_lever_falls_evenly_to_none_on_the_beam() -> None:
    """UFC's form, a + b theta with theta 180 deg from ahead and 90 deg abeam."""
    ship = tanker()
    of = Turning("Clarke-lever").yaw_of(ship)
    assert of == lever_of(ship)
    assert of is not None
    hull = (ship.length_waterline, ship.breadth, ship.draught, ship.block)
    assert of.at_the_bow == pytest.approx(hull_derivatives(*hull).lever)
    assert of.intercept + 90.0 * of.slope == pytest.approx(0.0, abs=1e-12)
