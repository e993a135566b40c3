"""The front by its definition: for every pair of rows, whether one beats the other; its knee."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymoo.util.nds.non_dominated_sorting import NonDominatedSorting

from catopt.design.front import Floats, empty_front, knee, merge, non_dominated

GRID = st.integers(0, 6) | st.just(float("nan"))
"""Few values, so that rows are often equal in some objectives or in all."""


def by_definition(objectives: Floats) -> list[int]:
    """Every row that no other beats, of equal ones the first, none with nan."""
    kept = []
    for k, row in enumerate(objectives):
        as_small = (objectives <= row).all(axis=1)
        is_beaten = (as_small & (objectives < row).any(axis=1)).any()
        is_repeated = (objectives[:k] == row).all(axis=1).any()
        if not (np.isnan(row).any() or is_beaten or is_repeated):
            kept.append(k)
    return kept


@pytest.mark.parametrize("count", [2, 3])
@given(data=st.data())
@settings(max_examples=150, deadline=None)
def test_front_is_what_nothing_beats(count: int, data: st.DataObject) -> None:
    rows = data.draw(st.lists(st.lists(GRID, min_size=count, max_size=count), max_size=30))
    objectives = np.array(rows, dtype=np.float64).reshape(-1, count)
    assert sorted(non_dominated(objectives).tolist()) == by_definition(objectives)


@pytest.mark.parametrize("count", [2, 3])
def test_front_does_not_depend_on_the_order(count: int) -> None:
    generator = np.random.default_rng(3)
    objectives = generator.integers(0, 40, (500, count)).astype(np.float64)
    front = objectives[non_dominated(objectives)]
    for _ in range(10):
        shuffled = generator.permutation(objectives)
        np.testing.assert_array_equal(shuffled[non_dominated(shuffled)], front)


@pytest.mark.parametrize("count", [2, 3])
def test_front_of_many_agrees_with_pymoo(count: int) -> None:
    """On a sphere's octant, slightly thickened, where a large part belongs to the front."""
    generator = np.random.default_rng(4)
    direction = np.abs(generator.standard_normal((3000, count)))
    direction /= np.linalg.norm(direction, axis=1)[:, np.newaxis]
    objectives = 1.0 - direction * (1.0 - 0.01 * generator.random((3000, 1)))
    theirs = NonDominatedSorting().do(objectives, only_non_dominated_front=True)
    assert sorted(non_dominated(objectives).tolist()) == sorted(theirs.tolist())


def test_front_rises_in_the_first_objective() -> None:
    objectives = np.array([[3.0, 1.0], [1.0, 3.0], [2.0, 2.0], [2.0, 3.0]])
    assert non_dominated(objectives).tolist() == [1, 2, 0]


def test_no_row_and_no_finite_row() -> None:
    assert non_dominated(np.empty((0, 2))).tolist() == []
    assert non_dominated(np.empty((0, 3))).tolist() == []
    assert non_dominated(np.array([[1.0, np.nan], [np.nan, 1.0], [0.0, np.inf]])).tolist() == []


@pytest.mark.parametrize("count", [2, 3])
@pytest.mark.parametrize("batch", [1, 7, 200])
def test_front_of_a_stream_is_that_of_the_whole(count: int, batch: int) -> None:
    generator = np.random.default_rng(5)
    objectives = generator.integers(0, 30, (200, count)).astype(np.float64)
    genes = np.arange(200)[:, np.newaxis]
    front = empty_front(1, count)
    for first in range(0, 200, batch):
        front = merge(front, genes[first : first + batch], objectives[first : first + batch])
    best = non_dominated(objectives)
    # The same designs too: of equal ones the earliest stays.
    np.testing.assert_array_equal(front.genes, genes[best])
    np.testing.assert_array_equal(front.objectives, objectives[best])


# ------------------------------------------------------------------ its knee


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
