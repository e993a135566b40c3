"""A clump weight's own friction on the bed in closed form: tension at the anchor by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

import catopt
from catopt.catenary.solve import solve
from catopt.model import Case, Line, Load, PointLoad, Segment, Site

BED, OWN = 0.3, 0.9
W, PLACE, HEIGHT, WEIGHT = 50e3, 50.0, 20.0, 1000.0


def line(friction: float | None = OWN, EA: float = math.inf) -> Line:
    return Line(
        [Segment(200.0, WEIGHT, EA)], [PointLoad(PLACE, W, friction=friction, accept=["friction"])]
    )


def by_hand(force: float) -> float:
    """H less 0.3 w of what lies and 0.9 W; sqrt(h (h + 2 H/w)) hang (S2)."""
    lying = 200.0 - math.sqrt(HEIGHT * (HEIGHT + 2.0 * force / WEIGHT))
    return force - BED * WEIGHT * lying - OWN * W


@pytest.mark.parametrize("force", [1e5, 1.2e5])
def test_a_clump_weight_that_rests_wholly(force: float) -> None:
    solution = solve(line(), height=HEIGHT, horizontal_force=force, seabed_friction=BED)
    assert solution.anchor.tension == pytest.approx(by_hand(force), rel=1e-12)
    same = solve(line(BED), height=HEIGHT, horizontal_force=force, seabed_friction=BED)
    plain = solve(line(None), height=HEIGHT, horizontal_force=force, seabed_friction=BED)
    assert same.anchor.tension == plain.anchor.tension
    assert plain.anchor.tension == pytest.approx(by_hand(force) + (OWN - BED) * W, rel=1e-12)


def test_a_clump_weight_that_is_lifted_in_part() -> None:
    """Above it 150 m hang; the bed carries W less V(0), which the height gives by bisection."""
    H, length = 6e5, 150.0
    low, high = 0.0, W
    for _ in range(200):
        V = 0.5 * (low + high)
        rise = (math.hypot(H, V + WEIGHT * length) - math.hypot(H, V)) / WEIGHT
        low, high = (V, high) if rise < HEIGHT else (low, V)
    solution = solve(line(), height=HEIGHT, horizontal_force=H, seabed_friction=BED)
    expected = H - OWN * (W - V) - BED * WEIGHT * PLACE
    assert 0.0 < V < W
    assert solution.anchor.tension == pytest.approx(expected, rel=1e-10)


def test_friction_uses_up_the_tension_and_not_more() -> None:
    solution = solve(line(3.0), height=HEIGHT, horizontal_force=1e5, seabed_friction=BED)
    assert solution.anchor.tension == 0.0


def test_many_at_once() -> None:
    forces = np.array([1e5, 1.2e5])
    many = catopt.solve_many(line(), height=HEIGHT, horizontal_force=forces, seabed_friction=BED)
    expected = [by_hand(force) for force in forces]
    assert many.anchor_tension == pytest.approx(expected, rel=1e-12)


def test_a_raised_anchor() -> None:
    """From the bed up to an anchor 2 m above it a part hangs under what friction left of H.

    Up there V = -sqrt(2 w h H' + (w h)^2), of an arc of sqrt(h (h + 2 H'/w)), with
    H' = H - 0.9 W - 0.3 w (200 - both arcs).
    """
    H, raised = 1.4e5, 2.0
    upper = math.sqrt(HEIGHT * (HEIGHT + 2.0 * H / WEIGHT))
    left = H
    for _ in range(200):
        lower = math.sqrt(raised * (raised + 2.0 * left / WEIGHT))
        left = H - OWN * W - BED * WEIGHT * (200.0 - upper - lower)
    assert lower < PLACE
    solution = solve(
        line(), height=HEIGHT, horizontal_force=H, seabed_friction=BED, anchor_height=raised
    )
    assert solution.anchor.horizontal_force == pytest.approx(left, rel=1e-9)
    assert solution.anchor.vertical_force == pytest.approx(-WEIGHT * lower, rel=1e-9)


def test_the_truss_model_agrees() -> None:
    case = Case(Site(HEIGHT, BED), line(EA=1e9), Load(horizontal_force=1e5), HEIGHT)
    found = catopt.verify_case(case)
    assert found.verdict == "agrees"
    assert found.static.rough == ()
