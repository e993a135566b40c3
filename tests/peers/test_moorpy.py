"""Beside MoorPy 1.3: its own test inputs, lines that it solves rightly, one that it does not."""

from __future__ import annotations

import math
import warnings
from typing import Any

import numpy as np
import pytest

from catopt.catenary.solve import solve
from catopt.model import Line, Segment
from tests.campaign.oracle import misfit

moorpy = pytest.importorskip("moorpy", reason="optional extra: peers")

# Inputs of MoorPy's tests/test_catenary.py: span, height, length, EA, weight, CB (friction, or
# minus the height of end A above the bed).
OWN_TESTS = [
    (400.0, 200.0, 500.0, 7.51e12, 800.0, 5.0),
    (400.0, 200.0, 500.0, 7.51e12, 800.0, 0.0),
    (400.0, 200.0, 500.0, 7.51e12, 800.0, 0.1),
    (400.0, 200.0, 500.0, 7.51e12, 200.0, -372.7),
    (89.9, 59.2, 130.0, 7.51e8, 881.05, -372.7),
    (37.96888656874307, 20.49078283711694, 100.0, 7.51e8, -881.0549577007893, -1245.2679469540894),
]

NEAR_TAUT = (231.8516245613182, 248.3746210557402, 339.7721054751881, 7e10, 34.91060469991227, 0.0)


def _moorpy(span: float, height: float, length: float, EA: float, w: float, CB: float) -> Any:
    from moorpy.Catenary import catenary

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return catenary(span, height, length, EA, w, CB=CB, Tol=1e-9)


def _ours(span: float, height: float, length: float, EA: float, w: float, CB: float) -> Any:
    raised = max(0.0, -CB)
    return solve(
        Line([Segment(length, w, EA)]),
        height=height + raised,
        span=span,
        seabed_friction=max(CB, 0.0),
        anchor_height=raised,
    )


@pytest.mark.parametrize("case", OWN_TESTS)
def test_inputs_of_its_own_tests(case: tuple[float, ...]) -> None:
    """Its tolerance is 1e-9 m of the end position: on these lines below 1e-6 of the forces."""
    H_A, V_A, H_B, V_B, info = _moorpy(*case)
    ours = _ours(*case)
    size = ours.fairlead.tension
    assert ours.anchor.horizontal_force == pytest.approx(H_A, abs=1e-6 * size)
    assert ours.anchor.vertical_force == pytest.approx(V_A, abs=1e-6 * size)
    assert ours.horizontal_force == pytest.approx(-H_B, rel=1e-6)
    assert ours.fairlead.vertical_force == pytest.approx(-V_B, rel=1e-6)
    assert ours.grounded_length == pytest.approx(info["LBot"], abs=1e-5 * ours.line.length)


@pytest.mark.slow
def test_the_near_taut_entry_of_its_tests_is_wrong() -> None:
    """231.85 m by 248.37 m, 339.77 m of line, strain 1.9e-7: its tests expect 9,214 N.

    That is EA times the strain, a spring without weight. The line's own sag asks for 396 kN, and
    quadrature of the line's equations with these forces ends at its fairlead.
    """
    span, height, length, EA, _, _ = NEAR_TAUT
    ours = _ours(*NEAR_TAUT)
    assert misfit(ours) < 1e-12
    strain = math.hypot(span, height) / length - 1.0
    spring = EA * strain * span / math.hypot(span, height)
    theirs = -_moorpy(*NEAR_TAUT)[2]
    assert theirs == pytest.approx(spring, rel=1e-3)
    assert ours.horizontal_force > 40.0 * theirs


def test_random_uniform_lines() -> None:
    """300 lines, slack to moderately taut, friction on half: forces to its tolerance."""
    rng = np.random.default_rng(3)
    for _ in range(300):
        length, w = float(rng.uniform(50, 1500)), float(rng.uniform(20, 5000))
        height = length * float(rng.uniform(0.1, 0.8))
        taut = math.sqrt(length**2 - height**2)
        span = (length - height) + (taut - length + height) * float(rng.uniform(0.3, 0.97))
        case = (span, height, length, w * length * 10 ** float(rng.uniform(2, 4)), w)
        CB = float(rng.choice([0.0, rng.uniform(0.1, 1.0)]))
        theirs = _moorpy(*case, CB)
        ours = _ours(*case, CB)
        assert ours.horizontal_force == pytest.approx(-theirs[2], rel=1e-5)
        assert ours.fairlead.vertical_force == pytest.approx(-theirs[3], rel=1e-6)
