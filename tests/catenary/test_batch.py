"""The compiled loop against the plain functions, and its manners with bad members."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np
import pytest

from catopt.catenary.batch import solve_many
from catopt.catenary.solve import solve
from catopt.errors import InputError
from catopt.model import Line, PointLoad, Segment
from tests.catenary.random_lines import random_setting

LEG = Line(
    [
        Segment(750.0, 298.1, EA=382.09e6),
        Segment(194.0, 1345.5, EA=721.98e6),
        Segment(138.0, 1524.0, EA=801.2e6),
    ],
    [PointLoad(900.0, 5e4)],
)


@pytest.mark.parametrize("known", ["horizontal_force", "span", "fairlead_tension"])
def test_batch_equals_scalar(known: str) -> None:
    """Same formulas: equal to the last digits, which compilers may round differently."""
    values = {
        "horizontal_force": np.geomspace(1e4, 1e7, 40),
        "span": np.linspace(1012.0, 1085.0, 40),
        "fairlead_tension": np.geomspace(3e5, 1e7, 40),
    }[known]
    at: Any = partial(solve_many, LEG, height=71.4, seabed_friction=0.5)
    many = at(**{known: values})
    assert many.converged.all()
    for index, value in enumerate(values):
        one = partial(solve, LEG, height=71.4, seabed_friction=0.5)(**{known: float(value)})
        assert many.tension[index] == pytest.approx(one.fairlead.tension, rel=1e-10)
        assert many.span[index] == pytest.approx(one.span, rel=1e-12)
        assert many.anchor_tension[index] == pytest.approx(one.anchor.tension, rel=1e-9, abs=1e-3)
        assert many.regime(index) == one.regime


def test_everything_may_vary() -> None:
    """Depth, friction, lengths, weights, stiffness, point loads: each member its own line."""
    n = 12
    rng = np.random.default_rng(5)
    height = rng.uniform(40.0, 90.0, n)
    mu = rng.uniform(0.0, 1.0, n)
    lengths = np.array([s.length for s in LEG.segments]) * rng.uniform(0.8, 1.2, (n, 3))
    weights = np.array([s.submerged_weight for s in LEG.segments]) * rng.uniform(0.8, 1.2, (n, 3))
    EA = np.array([s.EA for s in LEG.segments]) * rng.uniform(0.8, 1.2, (n, 3))
    EA[0] = math.inf
    position = rng.uniform(10.0, 700.0, (n, 1))
    clump = rng.uniform(1e3, 1e5, (n, 1))
    many = solve_many(
        LEG,
        height=height,
        horizontal_force=8e5,
        seabed_friction=mu,
        lengths=lengths,
        submerged_weights=weights,
        EA=EA,
        positions=position,
        point_weights=clump,
    )
    for i in range(n):
        segments = [Segment(*row) for row in zip(lengths[i], weights[i], EA[i], strict=True)]
        line = Line(segments, [PointLoad(position[i, 0], clump[i, 0])])
        one = solve(line, height=height[i], horizontal_force=8e5, seabed_friction=mu[i])
        assert many.span[i] == pytest.approx(one.span, rel=1e-12)


def test_a_bad_member_is_marked_and_spoils_nothing() -> None:
    spans = np.array([1050.0, -1.0, math.nan, 1e9, 1060.0])
    stiff = Line([Segment(1082.0, 298.1)])
    many = solve_many(stiff, height=71.4, span=spans)
    assert many.converged.tolist() == [True, False, False, False, True]
    assert many.reason(0) is None
    assert "invalid input" in str(many.reason(1))
    assert "invalid input" in str(many.reason(2))
    assert "too short" in str(many.reason(3))
    assert np.isnan(many.horizontal_force[1:4]).all()
    alone = solve_many(stiff, height=71.4, span=1060.0)
    assert many.horizontal_force[4] == alone.horizontal_force[0]


def test_threads_change_nothing() -> None:
    spans = np.linspace(1020.0, 1085.0, 501)
    one = solve_many(LEG, height=71.4, span=spans)
    two = solve_many(LEG, height=71.4, span=spans, workers=2)
    np.testing.assert_array_equal(one.horizontal_force, two.horizontal_force)


def test_shapes_that_do_not_fit_are_refused() -> None:
    with pytest.raises(InputError, match="exactly one"):
        solve_many(LEG, height=71.4)
    with pytest.raises(InputError, match=r"shape \(3,\)"):
        solve_many(LEG, height=71.4, span=1050.0, lengths=[1.0, 2.0])
    with pytest.raises(InputError, match="one entry per line"):
        solve_many(LEG, height=[71.4, 70.0], span=[1050.0, 1051.0, 1052.0])


@pytest.mark.parametrize("seed", range(30))
def test_flexibility_is_the_derivative_of_the_reach(seed: int) -> None:
    """Central differences of order 2, step 1e-4: relative error near 1e-8 where smooth."""
    s = random_setting(seed, raised=False)
    H = s.horizontal_force
    at = partial(solve_many, s.line, height=s.height, seabed_friction=s.seabed_friction)
    middle = at(horizontal_force=H)
    step = 1e-4
    less, more = (at(horizontal_force=H * f) for f in (1 - step, 1 + step))
    (x_H, x_V), (z_H, z_V) = middle.flexibility[0]
    by_formula = x_H - x_V * z_H / z_V
    by_difference = (more.span[0] - less.span[0]) / (2 * step * H)
    # Rounding of the spans limits the difference: eps L / (2 step H) in m/N.
    noise = 1e-14 * s.line.length / (2 * step * H)
    assert by_formula == pytest.approx(by_difference, rel=2e-4, abs=10 * noise)


def test_stiffness_is_the_inverse_of_the_flexibility() -> None:
    many = solve_many(LEG, height=71.4, span=[1040.0, 1070.0])
    identity = many.stiffness @ many.flexibility
    np.testing.assert_allclose(identity, np.broadcast_to(np.eye(2), (2, 2, 2)), atol=1e-12)


@pytest.mark.parametrize(
    "wrong",
    [
        {"positions": [[900.0], [1082.0]]},
        {"positions": [[900.0], [1e4]]},
        {"positions": [[900.0], [-1.0]]},
        {"lengths": [[750.0, 194.0, 138.0], [750.0, -194.0, 1138.0]]},
        {"submerged_weights": [[298.1, 1345.5, 1524.0], [298.1, math.nan, 1524.0]]},
        {"EA": [[382e6, 721e6, 801e6], [382e6, -721e6, 801e6]]},
        {"point_weights": [[5e4], [math.inf]]},
    ],
    ids=lambda wrong: next(iter(wrong)),
)
def test_a_line_that_cannot_be_is_marked_and_never_mended(wrong: dict[str, Any]) -> None:
    """The second of two lines is none: beyond its end, of negative length, not a number."""
    at: Any = partial(solve_many, LEG, height=71.4, horizontal_force=8e5)
    many = at(**wrong)
    assert many.converged.tolist() == [True, False]
    assert "invalid input" in str(many.reason(1))


def test_point_loads_out_of_order_are_marked() -> None:
    line = Line([Segment(1082.0, 298.1)], [PointLoad(100.0, 1e3), PointLoad(200.0, 1e3)])
    many = solve_many(
        line, height=71.4, horizontal_force=8e5, positions=[[100.0, 200.0], [200.0, 100.0]]
    )
    assert many.converged.tolist() == [True, False]
