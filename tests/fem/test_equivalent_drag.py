"""Linear drag in the place of |r| r, beside what can be integrated by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.fem.morison import equivalent_drag

ROUGH = {1: 1e-3, 2: 6e-3, 3: 6e-3}
"""By axes: 96 parts leave some 2e-4 of the kink of |r|; across the largest, 12 nodes of Gauss."""


@pytest.mark.parametrize("axes", [1, 2, 3])
def test_without_a_mean_it_has_the_variance_of_the_drag(axes: int) -> None:
    """E|r|^4 = n (n + 2) s^4 in n axes, of which each linear one has D^2 s^2."""
    s = 0.7
    covariance = np.zeros((1, 3, 3))
    covariance[0, range(axes), range(axes)] = s**2
    (found,) = equivalent_drag(np.zeros((1, 3)), covariance)
    assert np.diag(found)[:axes] == pytest.approx(math.sqrt(axes + 2.0) * s, rel=ROUGH[axes])
    assert np.allclose(found, np.diag(np.diag(found)), atol=1e-9)


def test_in_a_stream_along_one_axis() -> None:
    """By the moments of |r| r of a normal r with a mean."""
    m, s = 0.4, 0.5
    over, bell = m / s / math.sqrt(2.0), math.exp(-0.5 * (m / s) ** 2)
    mean = (m * m + s * s) * math.erf(over) + m * s * math.sqrt(2.0 / math.pi) * bell
    variance = m**4 + 6.0 * m**2 * s**2 + 3.0 * s**4 - mean**2
    covariance = np.zeros((1, 3, 3))
    covariance[0, 2, 2] = s**2
    (found,) = equivalent_drag(np.array([[0.0, 0.0, m]]), covariance)
    assert found[2, 2] == pytest.approx(math.sqrt(variance) / s, rel=ROUGH[1])


def test_in_a_stream_alone_it_is_the_tangent() -> None:
    r = np.array([[0.3, -0.4, 1.2]])
    (found,) = equivalent_drag(r, np.zeros((1, 3, 3)))
    size = float(np.linalg.norm(r))
    assert found == pytest.approx(size * np.eye(3) + np.outer(r, r) / size, abs=1e-12)


def test_it_turns_with_the_velocity() -> None:
    rng = np.random.default_rng(4)
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    covariance = np.diag([0.9, 0.2, 0.05])[np.newaxis]
    mean = np.array([[0.2, 0.1, -0.3]])
    (straight,) = equivalent_drag(mean, covariance)
    (turned,) = equivalent_drag(mean @ turn.T, turn @ covariance @ turn.T)
    assert turned == pytest.approx(turn @ straight @ turn.T, abs=1e-9)


def test_by_drawn_velocities() -> None:
    """A million draws in a stream, two axes of different size: the variance within 1 %."""
    rng = np.random.default_rng(8)
    mean, spread = np.array([0.3, 0.2, 0.0]), np.array([0.8, 0.3, 0.0])
    r = mean + spread * rng.normal(size=(1_000_000, 3))
    drag = np.linalg.norm(r, axis=1)[:, np.newaxis] * r
    (found,) = equivalent_drag(mean[np.newaxis], np.diag(spread**2)[np.newaxis])
    linear = (r - mean) @ found.T
    assert linear.var(axis=0).sum() == pytest.approx(drag.var(axis=0).sum(), rel=0.01)
