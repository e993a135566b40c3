"""The knee on fronts whose knee is plain to see."""

from __future__ import annotations

import numpy as np
import pytest

from catopt.design.front import knee


def test_knee_lies_furthest_below_the_chord() -> None:
    """Shares of (20, 10): (0.2, 0.1), sum 0.3; of (10, 50): (0.1, 0.5); of (60, 5): (0.6, 0.05)."""
    front = np.array([[0.0, 100.0], [10.0, 50.0], [20.0, 10.0], [60.0, 5.0], [100.0, 0.0]])
    found = knee(front)
    assert found.index == 2
    # 0.2 and 0.1 to rounding.
    assert found.shares == pytest.approx((0.2, 0.1), rel=1e-15)
    assert found.depth == pytest.approx(0.7, rel=1e-15)


def test_knee_does_not_depend_on_units() -> None:
    front = np.array([[0.0, 100.0], [10.0, 50.0], [20.0, 10.0], [60.0, 5.0], [100.0, 0.0]])
    assert knee(front * [1000.0, 0.01] + [7.0, -3.0]).index == 2


def test_knee_of_three_objectives() -> None:
    """Each corner is best in one and worst in two; the design between them has 0.3 of each."""
    corners = [[0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0]]
    assert knee(np.array([*corners, [0.3, 0.3, 0.3]])).index == 3


def test_front_without_knee_gives_its_first_end() -> None:
    """All on the chord or above it: no compromise is worth its price."""
    bulging = np.array([[0.0, 1.0], [0.7, 0.7], [1.0, 0.0]])
    assert knee(bulging).index == 0
    assert knee(bulging).depth == 0.0
    straight = np.stack((np.linspace(0.0, 1.0, 11), 1.0 - np.linspace(0.0, 1.0, 11)), axis=1)
    assert knee(straight[::-1]).index == 10


def test_fronts_of_one_and_of_two_designs() -> None:
    assert knee(np.array([[5.0, 7.0]])).index == 0
    assert knee(np.array([[5.0, 7.0], [6.0, 1.0]])).index == 0
    assert knee(np.array([[6.0, 1.0], [5.0, 7.0]])).index == 1


def test_an_objective_that_is_the_same_for_all_does_not_count() -> None:
    front = np.array([[0.0, 4.0, 1.0], [0.2, 4.0, 0.1], [1.0, 4.0, 0.0]])
    assert knee(front).index == 1


def test_no_design_has_no_knee() -> None:
    with pytest.raises(ValueError, match="empty front"):
        knee(np.empty((0, 2)))
