"""Which way a body heads: an equilibrium that exists is found, and a second one named."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from catopt import NoEquilibriumError, System, solve, solve_system
from catopt.model import Leg
from catopt.mooring.batch import solve_system_many
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.solution import SystemSolution
from tests.mooring.layouts import CHAIN, fso
from tests.mooring.test_bodies import as_points

FORCE, ARM = 1e5, 20.0
MOST = FORCE * ARM
"""A line on an arm has a place of rest exactly where the moment is below this, N m."""


def on_an_arm(moment: float, azimuth: float = math.radians(16.0), side: float = 0.0) -> System:
    """600 m of chain, 1 kN/m, on an arm of 20 m under 100 kN."""
    leg = Leg(CHAIN, azimuth, 560.0, 50.0, fairlead_radius=ARM)
    force = (FORCE * math.cos(side), FORCE * math.sin(side))
    return System((leg,), force, moment)


@pytest.mark.parametrize("share", [-0.9999, -0.95, -0.2, -0.05, 0.05, 0.2, 0.95, 0.9999])
@pytest.mark.parametrize("side", [0.0, 2.0, math.pi, -1.0])
def test_one_line_on_an_arm_holds_every_moment_below_force_times_arm(
    share: float, side: float
) -> None:
    """The line pulls against the force with as much; the lever M / F turns the arm out of it.

    M = F arm sin(angle between the force turned round and the arm), the arm on the far side.
    """
    solution = solve_system(on_an_arm(share * MOST, side=side))
    azimuth = side + math.pi + math.asin(share) - math.radians(16.0)
    # 1e-7 rad: 1e-9 of the moment, the solver's own limit, over the slope at 0.9999 of the most
    assert math.remainder(solution.position.yaw - azimuth, 2.0 * math.pi) == pytest.approx(
        0.0, abs=1e-7
    )
    line = solution.lines[0]
    alone = solve(CHAIN, height=50.0, horizontal_force=FORCE)
    assert line.solution.span == pytest.approx(alone.span, rel=1e-9)
    assert math.remainder(line.direction - side - math.pi, 2.0 * math.pi) == pytest.approx(
        0.0, abs=1e-9
    )
    assert not any("rest at" in warning for warning in solution.warnings)


@pytest.mark.parametrize("share", [-0.95, -0.2, 0.2, 0.95, 0.9999])
def test_a_body_on_points_goes_round_to_the_heading_that_holds_it(share: float) -> None:
    """By the same lever: the force along x comes from where the line is, which holds it behind."""
    (body,) = at_rest(as_points(on_an_arm(share * MOST), 60.0)).bodies
    azimuth = math.pi + math.asin(share) - math.radians(16.0)
    off = math.remainder(body.position.yaw - azimuth, 2.0 * math.pi)
    assert off == pytest.approx(0.0, abs=1e-7)


def test_many_loads_find_what_one_load_finds() -> None:
    shares = [-0.9, -0.2, 0.2, 0.9, 1.1]
    answers = solve_system_many(
        on_an_arm(0.0), force=[(FORCE, 0.0)] * 5, moment=[share * MOST for share in shares]
    )
    assert answers.converged.tolist() == [True, True, True, True, False]
    assert answers.reason(4) == "turns over: the lines cannot carry the moment"
    for index, share in enumerate(shares[:4]):
        one = solve_system(on_an_arm(share * MOST)).position
        np.testing.assert_allclose(
            answers.position[index], (one.x, one.y, one.yaw), rtol=1e-9, atol=1e-9
        )


@pytest.mark.parametrize("share", [1.0001, 1.5, -1.0001, -30.0])
def test_the_limit_is_that_at_the_loaded_position(share: float) -> None:
    with pytest.raises(NoEquilibriumError, match=r"resist up to 2e[+]06 N m in that sense") as e:
        solve_system(on_an_arm(share * MOST))
    # A difference of two moments, each right to 1e-8 of itself, is right to 1e-4 of 1e-4.
    assert e.value.missing == pytest.approx((abs(share) - 1.0) * MOST, rel=1e-4)


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_refusal_is_right_to_both_sides_of_its_limit(sense: float) -> None:
    force = (-4281e3, 5e5)
    with pytest.raises(NoEquilibriumError, match="cannot carry the moment") as caught:
        solve_system(fso(force, fairlead_radius=10.0, moment=sense * 1e9))
    assert caught.value.quantity == "moment"
    largest = 1e9 - caught.value.missing
    assert 0.0 < largest < 1e9
    solve_system(fso(force, fairlead_radius=10.0, moment=0.99999 * sense * largest))
    with pytest.raises(NoEquilibriumError) as caught:
        solve_system(fso(force, fairlead_radius=10.0, moment=1.00001 * sense * largest))
    assert caught.value.missing == pytest.approx(1e-5 * largest, rel=1e-2)


@pytest.mark.parametrize("azimuth", [float(degrees) for degrees in range(0, 360, 24)])
def test_yaw_comes_back_within_half_a_turn(azimuth: float) -> None:
    """Fairleads on the far side turn the body half round; the force adds to it."""
    system = on_an_arm(0.3 * MOST, math.radians(azimuth), side=0.4)
    assert -math.pi < solve_system(system).position.yaw <= math.pi
    many = solve_system_many(system, force=[system.force], moment=system.moment)
    assert -math.pi < many.position[0, 2] <= math.pi


def crossed(force: tuple[float, float] = (0.0, 0.0)) -> System:
    """Two fairleads 40 m apart, each with a line both ways: the body lies across, either way."""
    return System(
        tuple(
            Leg.between(CHAIN, anchor=anchor, fairlead=fairlead, fairlead_height=50.0)
            for fairlead in ((20.0, 0.0), (-20.0, 0.0))
            for anchor in ((570.0, 0.0), (-570.0, 0.0))
        ),
        force,
    )


def headings(solution: SystemSolution) -> list[float]:
    """Yaws of the answer and of its warnings, deg, sorted."""
    named = [warning for warning in solution.warnings if "also has equilibrium" in warning]
    yaws = [float(warning.split("yaw of ")[1].split(" deg")[0]) for warning in named]
    return sorted([math.degrees(solution.position.yaw), *yaws])


def test_a_second_heading_is_named() -> None:
    """By symmetry: half a turn maps the body on itself, and 90 deg lies between."""
    solution = solve_system(crossed())
    assert headings(solution) == pytest.approx([-90.0, 90.0], abs=5e-3)  # two printed decimals
    assert any("its origin at (0.000, 0.000) m" in warning for warning in solution.warnings)


def test_a_second_heading_is_named_under_load() -> None:
    solution = solve_system(replace(crossed((2e5, 5e4)), moment=1e5))
    one, other = headings(solution)
    # Half a turn maps the body on itself, under any load.
    assert one == pytest.approx(other - 180.0, abs=1e-2)  # two printed decimals


def test_a_single_heading_is_not_said_to_have_company() -> None:
    assert not any(
        "rest at" in w for w in solve_system(fso((1e6, 0.0), fairlead_radius=5.0)).warnings
    )
