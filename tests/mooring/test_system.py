"""The place of rest of a moored body: balance, symmetry, stiffness and refusals."""

from __future__ import annotations

import math

import pytest
from scipy.optimize import brentq

from catopt import (
    InputError,
    Line,
    NoEquilibriumError,
    PointLoad,
    Segment,
    System,
    solve,
    solve_system,
)
from catopt.model import Leg
from tests.mooring.layouts import CHAIN, FSO_LEG, fso, spread, total, unbalanced

BALANCE = 1e-10
"""Of the forces involved; the solver stops at 1e-12, and sums of nine lines round."""

PRESET = (-4281e3, 0.0)
"""Static force on the turret in S4, N."""


@pytest.mark.parametrize("force", [(0.0, 0.0), PRESET, (2e6, 3e6), (10.0, -1.0), (0.0, 9.8e6)])
def test_forces_balance(force: tuple[float, float]) -> None:
    solution = solve_system(fso(force))
    x, y, _ = unbalanced(solution)
    assert math.hypot(x, y) <= BALANCE * (total(solution) + math.hypot(*force))
    assert solution.residual.force <= BALANCE * (total(solution) + math.hypot(*force))
    for line in solution.lines:
        assert math.hypot(
            line.fairlead[0] - line.leg.anchor[0], line.fairlead[1] - line.leg.anchor[1]
        ) == pytest.approx(line.solution.span, rel=1e-14)  # double precision


def test_the_turret_goes_where_the_source_run_with_a_real_bed_says() -> None:
    """published.toml, [fso_rang_dong.finding]: about 22 m, not the printed 6.071 m."""
    solution = solve_system(fso(PRESET))
    assert solution.offset[0] == pytest.approx(-22.0, abs=0.5)  # "about 22 m": two digits
    assert solution.offset[1] == pytest.approx(0.0, abs=1e-9)  # symmetric about x


@pytest.mark.parametrize("turned", [0.3, 1.0, 2.5, -3.0])
def test_rotating_layout_and_force_rotates_the_answer(turned: float) -> None:
    force = (-3e6, 1.2e6)
    before, after = solve_system(fso(force)), solve_system(fso(force, turned=turned))
    x, y = before.offset
    cosine, sine = math.cos(turned), math.sin(turned)
    size = math.hypot(x, y)
    # 1e-10: double precision on lengths of 1 km beside offsets of some 10 m
    assert after.offset[0] == pytest.approx(cosine * x - sine * y, abs=1e-10 * size)
    assert after.offset[1] == pytest.approx(sine * x + cosine * y, abs=1e-10 * size)
    for line, turned_line in zip(before.lines, after.lines, strict=True):
        assert turned_line.tension == pytest.approx(line.tension, rel=1e-10)


def test_equal_lines_share_by_symmetry() -> None:
    along = solve_system(spread(6, (2e3, 0.0)))
    tensions = [line.tension for line in along.lines]
    assert along.offset[1] == pytest.approx(0.0, abs=1e-10)
    assert tensions[1] == pytest.approx(tensions[5], rel=1e-10)
    assert tensions[2] == pytest.approx(tensions[4], rel=1e-10)
    assert tensions[0] < tensions[1] < tensions[2] < tensions[3]
    none = solve_system(spread(6))
    assert [line.tension for line in none.lines] == pytest.approx([none.lines[0].tension] * 6)
    assert none.offset == (0.0, 0.0)
    assert math.hypot(none.position.x, none.position.y) <= 1e-9  # m, the origin by symmetry


def test_two_opposed_lines_against_two_single_lines() -> None:
    """The body's place from `solve(span=)` of each line alone and a scalar root."""
    force = 4e5
    system = spread(2, (force, 0.0))

    def left(offset: float) -> float:
        ahead = solve(CHAIN, height=50.0, span=560.0 - offset).horizontal_force
        behind = solve(CHAIN, height=50.0, span=560.0 + offset).horizontal_force
        return force + ahead - behind

    offset = brentq(left, 0.0, 38.0, xtol=1e-12, rtol=1e-15)
    solution = solve_system(system)
    assert solution.offset[0] == pytest.approx(offset, abs=1e-8)  # 1e-8 m: rounding of H over k
    behind = solve(CHAIN, height=50.0, span=560.0 + offset)
    assert solution.lines[1].tension == pytest.approx(behind.fairlead.tension, rel=1e-9)
    assert solution.lines[1].solution.grounded_length == pytest.approx(
        behind.grounded_length, rel=1e-8
    )


def test_a_single_line_turns_into_the_force_like_a_hawser() -> None:
    system = System((Leg(CHAIN, 0.4, 560.0, 50.0),), force=(-3e5, 2e5))
    solution = solve_system(system)
    alone = solve(CHAIN, height=50.0, horizontal_force=math.hypot(3e5, 2e5))
    assert solution.lines[0].solution.span == pytest.approx(alone.span, rel=1e-10)
    assert math.remainder(
        solution.lines[0].direction - math.atan2(-2e5, 3e5), 2.0 * math.pi
    ) == pytest.approx(0.0, abs=1e-10)


def test_a_larger_force_moves_the_body_farther_along_it() -> None:
    angle = 0.7
    along = []
    for force in (0.0, 1e3, 1e5, 5e5, 1e6, 2e6, 4e6, 8e6):
        x, y = solve_system(fso((force * math.cos(angle), force * math.sin(angle)))).offset
        along.append(x * math.cos(angle) + y * math.sin(angle))
    assert along == sorted(along)
    assert along[0] == pytest.approx(0.0, abs=1e-9)


def test_work_of_the_force_is_positive_between_any_two_places() -> None:
    """The potential of the lines is convex: (F1 - F2).(p1 - p2) > 0."""
    forces = [(1e6, 0.0), (0.0, 2e6), (-3e6, 1e6), (4e6, 4e6), (-1e5, -2e5)]
    places = [solve_system(fso(force)).offset for force in forces]
    for i in range(len(forces)):
        for j in range(i):
            work = sum(
                (forces[i][k] - forces[j][k]) * (places[i][k] - places[j][k]) for k in (0, 1)
            )
            assert work > 0.0


@pytest.mark.parametrize("force", [(0.0, 0.0), (-2e6, 1e6)])
def test_stiffness_against_differences_of_the_equilibrium(force: tuple[float, float]) -> None:
    """A small force df moves the body by K^-1 df."""
    middle = solve_system(fso(force))
    (xx, xy), (yx, yy) = middle.stiffness
    assert xy == pytest.approx(yx, rel=1e-12)
    step = 2e-4 * max(math.hypot(*force), 1e6)
    for dx, dy in ((step, 0.0), (0.0, step)):
        ahead = solve_system(fso((force[0] + dx, force[1] + dy))).offset
        behind = solve_system(fso((force[0] - dx, force[1] - dy))).offset
        move = [0.5 * (ahead[k] - behind[k]) for k in (0, 1)]
        # 1e-4: the second-order error of the difference over offsets of some centimetres
        assert xx * move[0] + xy * move[1] == pytest.approx(dx, abs=1e-4 * step)
        assert yx * move[0] + yy * move[1] == pytest.approx(dy, abs=1e-4 * step)


def test_stiffness_in_yaw_against_differences_of_the_equilibrium() -> None:
    force, moment = (-2e6, 5e5), 1e7
    middle = solve_system(fso(force, fairlead_radius=10.0, moment=moment))
    rows = middle.full_stiffness
    for i in range(3):
        for j in range(i):
            assert rows[i][j] == rows[j][i]
    change = (2e3, -1e3, 1e5)

    def place(sign: float) -> tuple[float, float, float]:
        found = solve_system(
            fso(
                (force[0] + sign * change[0], force[1] + sign * change[1]),
                fairlead_radius=10.0,
                moment=moment + sign * change[2],
            )
        ).position
        return found.x, found.y, found.yaw

    ahead, behind = place(1.0), place(-1.0)
    move = [0.5 * (a - b) for a, b in zip(ahead, behind, strict=True)]
    for row, wanted in zip(rows, change, strict=True):
        assert math.fsum(k * m for k, m in zip(row, move, strict=True)) == pytest.approx(
            wanted, rel=1e-4
        )  # second order, as above


def test_moments_balance_on_a_body_that_turns() -> None:
    solution = solve_system(fso((-3e6, 1e6), fairlead_radius=12.0, moment=2e7))
    x, y, moment = unbalanced(solution)
    assert math.hypot(x, y) <= BALANCE * total(solution)
    assert abs(moment) <= BALANCE * total(solution) * 12.0
    assert solution.position.yaw > 0.0
    assert solution.residual.moment <= BALANCE * total(solution) * 12.0


def test_a_moment_alone_turns_a_symmetric_body_on_the_spot() -> None:
    solution = solve_system(
        System.around(
            CHAIN,
            azimuths=[0.5 * math.pi * k for k in range(4)],
            anchor_radius=570.0,
            fairlead_height=50.0,
            fairlead_radius=10.0,
            moment=1e5,
        )
    )
    assert math.hypot(*solution.offset) <= 1e-8  # m
    tensions = [line.tension for line in solution.lines]
    assert tensions == pytest.approx([tensions[0]] * 4, rel=1e-10)
    # each line pulls off its radius by as much as it takes: 4 H r sin(angle) = M
    line = solution.lines[0]
    lever = 10.0 * math.sin(solution.position.yaw - line.direction)
    assert 4.0 * line.horizontal_force * lever == pytest.approx(1e5, rel=1e-9)


def test_a_body_does_not_balance_on_a_ridge() -> None:
    """Fairleads on the far side hold a body at yaw 0 only as a pencil stands on its tip."""
    legs = [
        Leg(CHAIN, azimuth, 560.0, 50.0, fairlead_radius=5.0, fairlead_azimuth=azimuth + math.pi)
        for azimuth in (0.0, math.pi)
    ]
    solution = solve_system(System(tuple(legs)))
    assert abs(math.remainder(solution.position.yaw, 2.0 * math.pi)) > 3.0
    assert solution.full_stiffness[2][2] > 0.0


def test_a_body_held_in_yaw_does_not_turn() -> None:
    free = fso((-3e6, 1e6), fairlead_radius=12.0)
    held = System(free.legs, free.force, yaw_free=False)
    assert solve_system(held).position.yaw == 0.0
    assert solve_system(free).position.yaw != 0.0


def test_lines_of_their_own() -> None:
    """A heavier line on one side draws the body there; every line keeps its own composition."""
    heavy = Line([Segment(600.0, 3000.0, EA=8e8)])
    legs = [
        Leg.between(heavy, anchor=(560.0, 0.0), fairlead=(3.0, 0.0), fairlead_height=50.0),
        Leg.between(CHAIN, anchor=(-560.0, 0.0), fairlead=(-3.0, 0.0), fairlead_height=48.0),
    ]
    solution = solve_system(System(tuple(legs), yaw_free=False))
    assert solution.position.x > 0.0
    assert solution.lines[0].solution.line == heavy
    assert solution.lines[0].horizontal_force == pytest.approx(
        solution.lines[1].horizontal_force, rel=1e-10
    )
    assert legs[1].azimuth == pytest.approx(math.pi)
    assert legs[1].fairlead == pytest.approx((-3.0, 0.0))


@pytest.mark.parametrize("friction", [0.0, 0.7])
def test_clump_weights_and_friction(friction: float) -> None:
    line = Line([Segment(600.0, 1000.0, EA=8e8)], [PointLoad(450.0, 2e5)])
    solution = solve_system(spread(4, (5e5, 1e5), line=line, friction=friction))
    x, y, _ = unbalanced(solution)
    assert math.hypot(x, y) <= BALANCE * total(solution)
    for state in solution.lines:
        alone = solve(line, height=50.0, span=state.solution.span, seabed_friction=friction)
        assert state.tension == pytest.approx(alone.fairlead.tension, rel=1e-8)
        assert state.solution.anchor.tension == pytest.approx(alone.anchor.tension, rel=1e-8)


def test_lines_that_do_not_stretch() -> None:
    """Under a great force the body hangs on the reach of two lines, wherever it slides there."""
    line = Line([Segment(566.0, 1000.0)])
    solution = solve_system(spread(3, (3e7, 1e6), line=line))
    x, y, _ = unbalanced(solution)
    assert math.hypot(x, y) <= 1e-9 * total(solution)  # a taut line: span to 1e-13, H to 1e-9
    reach = math.sqrt(566.0**2 - 50.0**2)
    assert max(state.solution.span for state in solution.lines) < reach


def test_slack_lines_leave_the_body_where_it_is_and_say_so() -> None:
    line = Line([Segment(700.0, 1000.0, EA=8e8)])
    solution = solve_system(spread(3, line=line))
    assert (solution.position.x, solution.position.y) == (0.0, 0.0)
    assert "do not hold the body" in solution.warnings[0]
    assert any("slack" in warning for warning in solution.warnings)


def test_lines_too_short_to_meet() -> None:
    line = Line([Segment(500.0, 1000.0)])
    with pytest.raises(NoEquilibriumError, match=r"within reach of every line: line \d") as e:
        solve_system(spread(2, line=line))
    assert e.value.quantity == "length"
    # Two opposed reaches of sqrt(500^2 - 50^2) leave this much of 2 * 560 m between them; the
    # search stays a thousandth of a reach, 0.5 m, inside the other one.
    assert e.value.missing == pytest.approx(1120.0 - 2.0 * math.sqrt(500**2 - 50**2), abs=0.51)


def test_a_line_shorter_than_its_height() -> None:
    with pytest.raises(NoEquilibriumError, match="line 1 is 40 m long"):
        solve_system(spread(3, line=Line([Segment(40.0, 1000.0)])))


def test_a_line_that_touches_twice_pulls_as_it_does_alone() -> None:
    line = Line([Segment(620.0, 1000.0, EA=8e8)], [PointLoad(300.0, -6e4)])
    legs = [Leg(CHAIN, 0.0, 560.0, 50.0), Leg(line, math.pi, 590.0, 50.0)]
    held = solve_system(System(tuple(legs)))
    other, lifted = held.lines
    assert lifted.solution.regime == "grounded-in-parts"
    alone = solve(line, height=50.0, span=lifted.solution.span)
    assert alone.horizontal_force == pytest.approx(other.solution.horizontal_force, rel=1e-9)


def test_a_load_on_yaw_that_nothing_feels() -> None:
    with pytest.raises(InputError, match="moment"):
        fso(PRESET, moment=1e6)


def test_every_problem_of_the_input_at_once() -> None:
    with pytest.raises(InputError) as caught:
        Leg(FSO_LEG, math.inf, -1.0, math.nan, fairlead_radius=-2.0)
    assert [problem.key for problem in caught.value.problems] == [
        "azimuth",
        "anchor_radius",
        "fairlead_height",
        "fairlead_radius",
        "fairlead_azimuth",
    ]
    with pytest.raises(InputError) as caught:
        System((), (1.0, math.nan), math.inf, -1.0, yaw_free=True)
    assert len(caught.value.problems) == 5


def test_touchdown_lies_between_anchor_and_fairlead() -> None:
    solution = solve_system(fso(PRESET))
    for line in solution.lines:
        place = line.touchdown
        assert place is not None
        to_anchor = math.dist(place, line.leg.anchor)
        to_fairlead = math.dist(place, line.fairlead)
        assert to_anchor + to_fairlead == pytest.approx(line.solution.span, rel=1e-12)
        # Stretched by T/EA < 0.5 %, what lies on the bed is as long as its horizontal way.
        assert to_anchor == pytest.approx(line.solution.grounded_length, rel=5e-3)


@pytest.mark.parametrize("side", [-1e-9, 0.0, 1e-9])
def test_a_line_against_x_has_one_direction_whichever_side_rounding_leaves_it_on(
    side: float,
) -> None:
    """A newton across, in units of 1e-9, moves the body by some 1e-14 m."""
    solution = solve_system(spread(4, (5e5, side)))
    assert solution.lines[2].direction == pytest.approx(math.pi, abs=1e-11)
