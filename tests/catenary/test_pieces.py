"""Lines cut into pieces: reversed, cut at a place, measured; every array by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.catenary.find import _shortest
from catopt.catenary.pieces import (
    Pieces,
    above,
    below,
    has_buoyancy,
    reversed_pieces,
    tension_past_clump,
    total_length,
    total_weight,
)
from catopt.model import Line, PointLoad, Segment

THREE = Pieces(
    np.array([10.0, 20.0, 30.0]),
    np.array([100.0, 200.0, 300.0]),
    np.array([1e-9, 2e-9, 3e-9]),
    # Loads at the four joints, from the anchor up; then their coefficients of friction.
    np.array([0.0, 5.0, 7.0, 9.0, -1.0, 0.1, 0.2, 0.3]),
)
"""Three pieces with a load at each joint but the anchor."""


def arrays(pieces: Pieces) -> list[list[float]]:
    return [np.asarray(each).tolist() for each in pieces]


def test_a_line_from_its_other_end() -> None:
    assert arrays(reversed_pieces(THREE)) == [
        [30.0, 20.0, 10.0],
        [300.0, 200.0, 100.0],
        [3e-9, 2e-9, 1e-9],
        [9.0, 7.0, 5.0, 0.0, 0.3, 0.2, 0.1, -1.0],
    ]
    assert arrays(reversed_pieces(reversed_pieces(THREE))) == arrays(THREE)


def test_a_line_above_and_below_a_place() -> None:
    """4 m up the second piece: 16 m of it above, without a load at the cut, and 4 m below."""
    assert arrays(above(THREE, 1, 4.0)) == [
        [16.0, 30.0],
        [200.0, 300.0],
        [2e-9, 3e-9],
        [0.0, 7.0, 9.0, 0.1, 0.2, 0.3],
    ]
    assert arrays(below(THREE, 1, 4.0)) == [
        [10.0, 4.0],
        [100.0, 200.0],
        [1e-9, 2e-9],
        [0.0, 5.0, 0.0, -1.0, 0.1, 0.2],
    ]
    assert THREE.length.tolist() == [10.0, 20.0, 30.0]


def test_length_weight_and_buoyancy() -> None:
    """1,000 + 4,000 + 9,000 N of line and 12 N of clump weights; what hangs at its end is not."""
    assert total_length(THREE) == 60.0
    assert total_weight(THREE) == pytest.approx(14_012.0)
    assert not has_buoyancy(THREE)
    assert has_buoyancy(THREE._replace(weight=np.array([100.0, -1.0, 300.0])))
    buoyed = THREE.load.copy()
    buoyed[2] = -7.0
    assert has_buoyancy(THREE._replace(load=buoyed))


def test_friction_of_a_clump_weight_on_the_bed() -> None:
    """Its own coefficient of 0.2 times a reaction of 50 N, or the bed's of 0.6; never below 0."""
    assert tension_past_clump(100.0, THREE, 2, 0.6, 50.0) == pytest.approx(90.0)
    assert tension_past_clump(100.0, THREE, 0, 0.6, 50.0) == pytest.approx(70.0)
    assert tension_past_clump(100.0, THREE, 2, -0.6, 50.0) == pytest.approx(110.0)
    assert tension_past_clump(20.0, THREE, 0, 0.6, 50.0) == 0.0


@pytest.mark.parametrize(
    ("EA", "rise", "shortest"),
    [(math.inf, 60.0, 30.0), (math.inf, 35.0, 12.0), (1e9, 60.0, 12.0)],
)
def test_the_shortest_segment_that_is_worth_trying(EA: float, rise: float, shortest: float) -> None:
    """It reaches up with the other 30 m if nothing stretches, and holds its upper load at 12 m."""
    line = Line(
        [Segment(30.0, 100.0, EA=EA), Segment(40.0, 100.0, EA=EA)],
        point_loads=[PointLoad(20.0, 500.0), PointLoad(33.0, 500.0), PointLoad(42.0, 500.0)],
    )
    assert _shortest(line, 1, rise) == shortest
