"""Starts and steps of the searches, in spaces small enough to write down."""

from __future__ import annotations

import numpy as np
import pytest

from catopt.checks.kinds import ROUNDING
from catopt.design.front import EvaluationArchive, crowding_distance
from catopt.design.steps import double_steps, improve, reached, scattered, single_steps

from .known_space import KnownSpace, grid, scrambled, tanker


def test_single_and_double_steps() -> None:
    assert single_steps(2).tolist() == [[1, 0], [0, 1], [-1, 0], [0, -1]]
    assert sorted(double_steps(2).tolist()) == [[-1, -1], [-1, 1], [1, -1], [1, 1]]
    assert double_steps(1).shape == (0, 1)
    # Of two genes out of five there are ten pairs, with four signs each.
    assert len(np.unique(double_steps(5), axis=0)) == 40


@pytest.mark.slow
def test_steps_stay_in_the_space_and_are_canonical() -> None:
    space = scrambled((3, 2), 2, 1.0)
    around = reached(space, np.array([[0, 0], [2, 1]]), single_steps(2))
    assert around.tolist() == [[1, 0], [0, 1], [1, 1], [2, 0]]
    without_clump = np.array([[0, 0, 0, 0, 0]])
    around = reached(tanker(), without_clump, single_steps(5))
    # The fifth gene, a place of no clump weight, leads back to the design itself.
    assert [0, 0, 0, 0, 0] in around.tolist()
    assert not around[around[:, 3] == 0, 4].any()


def test_scattered_designs_take_every_value_equally_often() -> None:
    space = scrambled((4, 5, 2), 2, 1.0)
    designs = scattered(space, 40, np.random.default_rng(1))
    for column, size in zip(designs.T, space.sizes, strict=True):
        assert np.bincount(column).tolist() == [40 // size] * size


def test_improving_ends_where_nothing_next_to_the_front_is_unknown() -> None:
    """A valley along a diagonal, entered at its foot: every step leads to the next design."""
    _, (x, y) = grid(np.arange(20.0), np.arange(20.0))
    table = np.stack((x + 30.0 * np.abs(x - y), -y + 30.0 * np.abs(x - y)), axis=1)
    space = KnownSpace("valley", (20, 20), -1, -1, table, np.full(400, -1.0))
    archive = EvaluationArchive(space, 400)
    archive.evaluate(np.array([[0, 0]]))
    improve(archive, 10)
    # The exact front is the valley's floor; single steps alone would stay at its foot.
    assert archive.front.genes.tolist() == [[k, k] for k in range(20)]
    steps = np.concatenate((single_steps(2), double_steps(2)))
    assert archive.is_known(reached(space, archive.front.genes, steps)).all()
    assert archive.evaluations < 200


def test_improving_goes_towards_feasibility_first() -> None:
    _, (x, y) = grid(np.arange(20.0), np.arange(20.0))
    exceedance = (10.0 - np.minimum(x, 10.0)) * 0.1 - ROUNDING
    space = KnownSpace("slope", (20, 20), -1, -1, np.stack((x, y), axis=1), exceedance)
    archive = EvaluationArchive(space, 400)
    archive.evaluate(np.array([[0, 5]]))
    improve(archive, 10)
    assert archive.front.genes.tolist() == [[10, 0]]


def test_crowding_distance_by_hand() -> None:
    """Round (2, 4) 3 of 10 and 6 of 8 lie between neighbours, round (3, 2) 8 of 10 and 4 of 8."""
    front = np.array([[0.0, 8.0], [2.0, 4.0], [3.0, 2.0], [10.0, 0.0]])
    distance = crowding_distance(front)
    # Sums of two quotients: a few roundings.
    np.testing.assert_allclose(distance, [np.inf, 0.3 + 0.75, 0.8 + 0.5, np.inf], rtol=1e-15)
    assert crowding_distance(np.array([[1.0, 2.0]])).tolist() == [np.inf]
    assert crowding_distance(np.empty((0, 2))).tolist() == []
