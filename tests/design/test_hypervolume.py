"""Hypervolume by boxes counted by hand, and beside pymoo's."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from pymoo.indicators.hv import HV

from catopt.design.front import hypervolume, reference_point


def volume(rows: list[list[float]], reference: list[float]) -> float:
    return hypervolume(np.array(rows, dtype=np.float64), np.array(reference, dtype=np.float64))


def test_areas_by_hand() -> None:
    """Three steps up to (4, 4): 3 x 1 + 2 x 1 + 1 x 1 = 6 squares; whole numbers are exact."""
    assert volume([[1, 3], [2, 2], [3, 1]], [4, 4]) == 6.0
    assert volume([[1, 1]], [4, 3]) == 6.0


def test_volumes_by_hand() -> None:
    """Whole numbers, exact: a box of 2 x 3 x 4; two of 4 that share 2; three of 3 that share 1."""
    assert volume([[0, 0, 0]], [2, 3, 4]) == 24.0
    assert volume([[0, 0, 1], [0, 1, 0]], [2, 2, 2]) == 4.0 + 4.0 - 2.0
    assert volume([[0, 2, 2], [2, 0, 2], [2, 2, 0]], [3, 3, 3]) == 3.0 + 3.0 + 3.0 - 2.0


def test_what_adds_nothing() -> None:
    """Beaten, repeated and far rows, rows on the edge of the reference and rows without answer."""
    rows = [[1.0, 3.0], [2.0, 2.0], [3.0, 1.0]]
    more = [[3.0, 3.0], [2.0, 2.0], [0.0, 9.0], [4.0, 0.0], [np.nan, 0.0]]
    assert volume(rows + more, [4, 4]) == 6.0
    assert volume([[5, 5]], [4, 4]) == 0.0
    assert hypervolume(np.empty((0, 2)), np.ones(2)) == 0.0
    assert hypervolume(np.empty((0, 3)), np.ones(3)) == 0.0


@pytest.mark.parametrize("count", [2, 3])
def test_agrees_with_pymoo(count: int) -> None:
    """Sums of some hundred products, in another order: 1e-12 is some hundred roundings."""
    generator = np.random.default_rng(6)
    for rows in (1, 2, 10, 80):
        objectives = generator.random((rows, count))
        reference = np.full(count, 0.9)
        theirs = HV(ref_point=reference)(objectives)
        assert hypervolume(objectives, reference) == pytest.approx(theirs, rel=1e-12)


@pytest.mark.parametrize("count", [2, 3])
def test_grows_with_every_design_and_ignores_their_order(count: int) -> None:
    """Rows in another order add the same terms, or the same slices: to rounding of their sum."""
    generator = np.random.default_rng(7)
    objectives = generator.random((60, count))
    reference = np.ones(count)
    volumes = [hypervolume(objectives[:rows], reference) for rows in range(61)]
    # A beaten design adds nothing but may move the rounding.
    assert all(after >= before - 1e-14 for before, after in pairwise(volumes))
    assert volumes[-1] > volumes[1] > volumes[0] == 0.0
    shuffled = generator.permutation(objectives)
    assert hypervolume(shuffled, reference) == pytest.approx(volumes[-1], rel=1e-14)


def test_reference_point_is_a_tenth_of_the_range_beyond_the_worst() -> None:
    """Exact but for one rounding of 0.1 x 2."""
    front = np.array([[1.0, 30.0], [3.0, 10.0]])
    np.testing.assert_allclose(reference_point(front), [3.2, 32.0], rtol=1e-15)


def test_reference_point_of_one_design_is_a_tenth_of_its_value_beyond_it() -> None:
    """Beyond it is upwards, also where an objective is negative."""
    np.testing.assert_allclose(reference_point(np.array([[2.0, -10.0]])), [2.2, -9.0], rtol=1e-15)
