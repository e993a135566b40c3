"""Many loads in one compiled call."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt import InputError, Line, PointLoad, Segment, System, solve_system
from catopt.model import Leg
from catopt.mooring.batch import Batch, solve_system_many
from tests.mooring.layouts import CHAIN, fso


@pytest.mark.slow
def test_500_random_loads_of_the_fso_all_converge() -> None:
    """Up to 9,824 kN, the largest force that S4 prints, from every side."""
    random = np.random.default_rng(20)
    size, side = random.uniform(0.0, 9.824e6, 500), random.uniform(0.0, 2.0 * math.pi, 500)
    force = np.column_stack([size * np.cos(side), size * np.sin(side)])
    answers = solve_system_many(fso(), force=force)
    assert answers.converged.all()
    assert answers.steps.max() <= 12
    to_anchor = np.array([leg.anchor for leg in fso().legs]) - answers.position[:, None, :2]
    span = np.linalg.norm(to_anchor, axis=2)
    np.testing.assert_allclose(answers.span, span, rtol=1e-14)  # double precision
    pull = (answers.horizontal_force / span)[:, :, None] * to_anchor
    left = np.linalg.norm(pull.sum(axis=1) + force, axis=1)
    assert (left <= 1e-10 * (answers.horizontal_force.sum(axis=1) + size)).all()


def test_the_compiled_loop_says_what_the_plain_one_says() -> None:
    system = fso(fairlead_radius=10.0)
    force = [(0.0, 0.0), (-4.281e6, 0.0), (1e6, 2e6)]
    moment = [0.0, 1e7, -5e6]
    answers = solve_system_many(system, force=force, moment=moment)
    for index in range(3):
        one = solve_system(system.under(force[index], moment[index]))
        place = one.position
        # 1e-9: both stop at a residual of 1e-12 of the forces
        np.testing.assert_allclose(
            answers.position[index], [place.x, place.y, place.yaw], rtol=1e-9, atol=1e-9
        )
        np.testing.assert_allclose(
            answers.tension[index], [line.tension for line in one.lines], rtol=1e-9
        )
        np.testing.assert_allclose(
            answers.anchor_tension[index],
            [line.solution.anchor.tension for line in one.lines],
            rtol=1e-9,
        )
        np.testing.assert_allclose(
            answers.grounded_length[index],
            [line.solution.grounded_length for line in one.lines],
            rtol=1e-8,
        )
        np.testing.assert_allclose(
            answers.stiffness[index], one.full_stiffness, rtol=1e-7, atol=1e-3
        )
        np.testing.assert_allclose(answers.offset[index], one.offset, rtol=1e-9, atol=1e-9)
        assert answers.reason(index) is None


def test_a_load_without_an_answer_leaves_the_others_alone() -> None:
    system = fso(fairlead_radius=10.0)
    answers = solve_system_many(system, force=[(1e6, 0.0)] * 3, moment=[0.0, 1e10, 1e6])
    assert answers.converged.tolist() == [True, False, True]
    assert answers.reason(1) == "turns over: the lines cannot carry the moment"
    assert np.isnan(answers.tension[1]).all()
    np.testing.assert_array_equal(
        answers.tension[2],
        solve_system_many(system, force=[(1e6, 0.0)], moment=1e6).tension[0],
    )


def test_a_load_that_makes_a_line_touch_twice_is_answered() -> None:
    buoyed = Line([Segment(620.0, 1000.0, EA=8e8)], [PointLoad(300.0, -6e4)])
    taut = Leg(Line([Segment(570.0, 1000.0, EA=8e8)]), 0.0, 575.0, 50.0)
    system = System((taut, Leg(buoyed, math.pi, 625.0, 50.0)))
    answers = solve_system_many(system, force=[(0.0, 0.0), (-3e7, 0.0)])
    alone = solve_system(system.under((-3e7, 0.0)))
    assert [each.solution.regime for each in alone.lines] == ["suspended", "grounded-in-parts"]
    wanted = [each.solution.fairlead.tension for each in alone.lines]
    np.testing.assert_allclose(answers.tension[1], wanted, rtol=1e-8)


def test_no_loads() -> None:
    assert solve_system_many(fso(), force=np.empty((0, 2))).tension.shape == (0, 9)


@pytest.mark.parametrize(
    ("force", "moment", "word"),
    [
        ([1.0, 2.0], 0.0, r"shape \(n, 2\)"),
        ([(1.0, 2.0)] * 3, [0.0, 0.0], r"shape \(3,\)"),
        ([(1.0, math.nan)], 0.0, "not finite"),
        ([(1.0, 0.0)], 5.0, "does not yaw"),
    ],
)
def test_refused(force: list[object], moment: object, word: str) -> None:
    system = System.around(CHAIN, azimuths=[0.0, 2.0, 4.0], anchor_radius=560.0, fairlead_height=50)
    with pytest.raises(InputError, match=word):
        solve_system_many(system, force=force, moment=moment)  # type: ignore[arg-type]


def test_a_load_leaves_no_trace_in_the_next() -> None:
    batch = Batch(fso())
    first = batch.under([[-1e6, 0.0]])
    batch.under([[3e6, 2e6]])
    assert batch.under([[-1e6, 0.0]]).position.tolist() == first.position.tolist()
