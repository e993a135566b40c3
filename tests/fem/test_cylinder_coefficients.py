"""S4's terms of drag and added mass as recalled: points by hand, limits, and which way they go."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.fem.morison import added_mass, steady_drag, wake_amplification


@pytest.mark.parametrize(
    ("relative", "expected"),
    [(1e-6, 0.65), (1e-4, 0.65), (1e-3, 0.85), (10**-2.5, 0.95), (1e-2, 1.05), (0.3, 1.05)],
)
def test_steady_drag(relative: float, expected: float) -> None:
    """(29 + 4 log10 D)/20: 17/20 at 1e-3, 19/20 at 10^-2.5."""
    assert steady_drag(0.1 * relative, 0.1) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize(
    ("steady", "KC", "expected"),
    [
        (1.0, 11.0, 1.352),  # C_pi = 1.5 - 0.024 · 2 = 1.452, less 0.1
        (1.0, 7.0, 0.952),
        (1.0, 1.0, 0.452),
        (1.0, 0.25, 1.452),  # C_pi - 1 + 2 · 0.5
        (0.8, 1.5, 0.38),  # C_pi = 1.5 - 0.024 · 5
    ],
)
def test_wake_amplification(steady: float, KC: float, expected: float) -> None:
    assert wake_amplification(steady, KC) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize(
    ("steady", "KC", "expected"),
    [(0.65, 2.0, 1.0), (0.65, 8.0, 0.78), (0.65, 50.0, 0.6), (1.05, 50.0, 0.2), (1.05, 13.0, 0.56)],
)
def test_added_mass(steady: float, KC: float, expected: float) -> None:
    """1 - 0.044 (KC - 3) down to 0.6 - (C_DS - 0.65)."""
    assert added_mass(steady, KC) == pytest.approx(expected, abs=1e-12)


def test_the_parts_meet_at_their_limits() -> None:
    for limit in (1e-4, 1e-2):
        sides = [steady_drag(limit * (1.0 + s), 1.0) for s in (-1e-12, 1e-12)]
        assert sides[0] == pytest.approx(sides[1], abs=1e-11)
    for steady in (0.65, 0.9, 1.05):
        for limit in (0.75, 2.0):
            sides = [wake_amplification(steady, limit + s) for s in (-1e-12, 1e-12)]
            assert sides[0] == pytest.approx(sides[1], abs=1e-11)
        for limit in (3.0, 3.0 + (0.4 + steady - 0.65) / 0.044):
            sides = [added_mass(steady, limit + s) for s in (-1e-12, 1e-12)]
            assert sides[0] == pytest.approx(sides[1], abs=1e-11)


def test_which_way_they_go() -> None:
    """More drag with roughness; from KC 2 on more drag and less added mass with KC."""
    drags = [steady_drag(k, 1.0) for k in np.geomspace(1e-5, 0.1, 60)]
    assert drags == sorted(drags)
    for steady in (0.65, 1.05):
        psi = [wake_amplification(steady, KC) for KC in np.linspace(2.0, 11.99, 50)]
        assert psi == sorted(psi)
        masses = [added_mass(steady, KC) for KC in np.linspace(0.0, 60.0, 80)]
        assert masses == sorted(masses, reverse=True)
        assert min(wake_amplification(steady, KC) for KC in np.linspace(0.0, 11.9, 200)) > 0.0
        assert math.isfinite(added_mass(steady, 1e9))
