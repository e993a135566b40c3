"""Restoring curves, watch circles, one line damaged, water levels and the rule of practice."""

from __future__ import annotations

import math

import pytest

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
from catopt.mooring.case import at_levels, one_line_out, sharing_rule
from catopt.mooring.restoring import offset_curve, restoring_curve, watch_circle
from catopt.words import Message
from tests.mooring.layouts import CHAIN, fso, spread


def test_the_two_restoring_curves_are_each_others_inverse_along_a_line_of_symmetry() -> None:
    system = fso()
    forces = [-4e6, -1e6, 0.0, 1e6, 5e6]
    free = offset_curve(system, direction=0.0, forces=forces)
    held = restoring_curve(system, direction=0.0, offsets=free.offset)
    assert not free.is_held
    assert held.is_held
    # 1e-9 of the largest force: a residual of 1e-12 and the rounding of spans of 1 km
    assert held.force == pytest.approx(forces, abs=5e-3)
    assert held.force_across == pytest.approx([0.0] * 5, abs=5e-3)
    assert list(free.offset) == sorted(free.offset)
    for one, other in zip(free.responses, held.responses, strict=True):
        assert one.largest_tension == pytest.approx(other.largest_tension, rel=1e-9)


def test_off_the_lines_of_symmetry_a_force_moves_the_body_across_too() -> None:
    system = fso()
    free = offset_curve(system, direction=0.5, forces=[3e6])
    assert abs(free.across[0]) > 0.1
    solution = solve_system(system.under((3e6 * math.cos(0.5), 3e6 * math.sin(0.5))))
    assert math.hypot(free.offset[0], free.across[0]) == pytest.approx(
        math.hypot(*solution.offset), rel=1e-12
    )
    held = restoring_curve(system, direction=0.5, offsets=[free.offset[0]])
    assert abs(held.force_across[0]) > 1e4


def test_force_held_at_an_offset_against_single_lines() -> None:
    held = restoring_curve(spread(2), direction=0.0, offsets=[12.0])
    ahead = solve(CHAIN, height=50.0, span=548.0).horizontal_force
    behind = solve(CHAIN, height=50.0, span=572.0).horizontal_force
    assert held.force[0] == pytest.approx(behind - ahead, rel=1e-10)
    assert held.responses[0].most_loaded == 1


def test_an_offset_out_of_reach() -> None:
    line = Line([Segment(570.0, 1000.0)])
    with pytest.raises(NoEquilibriumError, match="line 1 is too short") as caught:
        restoring_curve(spread(2, line=line), direction=math.pi, offsets=[0.0, 20.0])
    assert caught.value.missing == pytest.approx(math.hypot(580.0, 50.0) - 570.0, rel=1e-9)


def test_the_watch_circle_repeats_with_the_layout() -> None:
    """Three clusters 120 degrees apart: what one side shows, the others show."""
    circle = watch_circle(fso(), force=4.281e6, directions=36)
    offsets = [each.offset for each in circle.responses]
    assert offsets[:12] == pytest.approx(offsets[12:24], rel=1e-10)
    assert offsets[:12] == pytest.approx(offsets[24:], rel=1e-10)
    away = solve_system(fso((-4.281e6, 0.0)))
    assert circle.responses[18].x == pytest.approx(away.position.x, rel=1e-10)
    assert offsets[circle.farthest] == pytest.approx(max(offsets), rel=1e-9)
    hardest = circle.directions[circle.hardest]
    again = solve_system(fso((4.281e6 * math.cos(hardest), 4.281e6 * math.sin(hardest))))
    assert max(line.tension for line in again.lines) == pytest.approx(
        max(each.largest_tension for each in circle.responses), rel=1e-10
    )


def test_one_line_out_is_the_system_built_without_it() -> None:
    force = (-4.281e6, 1e6)
    system = fso(force)
    zero = solve_system(system).neutral
    answers = one_line_out(system)
    assert [each.missing for each in answers] == list(range(9))
    for each in answers:
        legs = tuple(leg for index, leg in enumerate(system.legs) if index != each.missing)
        alone = solve_system(System(legs, force))
        assert each.response is not None
        tensions = [line.tension for line in alone.lines]
        assert each.response.largest_tension == pytest.approx(max(tensions), rel=1e-10)
        most_loaded = [i for i in range(9) if i != each.missing][tensions.index(max(tensions))]
        assert each.response.most_loaded == most_loaded
        assert each.response.offset == pytest.approx(
            math.hypot(alone.position.x - zero.x, alone.position.y - zero.y), rel=1e-10
        )
    intact = max(line.tension for line in solve_system(system).lines)
    windward = answers[1].response
    assert windward is not None
    assert windward.largest_tension > intact


def test_the_only_line_out() -> None:
    (answer,) = one_line_out(System((Leg(CHAIN, 0.0, 560.0, 50.0),), (1e5, 0.0)))
    assert answer.response is None
    assert answer.refusal == "no line is left"


def test_a_line_without_which_there_is_no_equilibrium() -> None:
    """Two lines on arms hold a moment; one alone swings round and holds hardly any."""
    legs = [Leg(CHAIN, k * math.pi, 570.0, 50.0, fairlead_radius=10.0) for k in (0, 1)]
    answers = one_line_out(System(tuple(legs), moment=1e6))
    assert all(each.response is None for each in answers)
    assert all("cannot carry the moment" in each.refusal for each in answers)


def test_water_levels() -> None:
    system = fso((-4.281e6, 0.0))
    low, mean, high = at_levels(system, [-2.0, 0.0, 2.0])
    # Higher water takes the slack out: the body moves less.
    assert low.response.offset > mean.response.offset > high.response.offset
    solution = solve_system(system)
    assert mean.response.offset == pytest.approx(math.hypot(*solution.offset), rel=1e-12)
    for row, wanted in zip(mean.stiffness, solution.stiffness, strict=True):
        assert row == pytest.approx(wanted, rel=1e-12, abs=1e-6)
    raised = solve_system(
        System.around(
            system.legs[0].line,
            azimuths=[leg.azimuth for leg in system.legs],
            anchor_radius=1056.0,
            fairlead_height=73.4,
            force=system.force,
        )
    )
    assert high.response.x == pytest.approx(raised.position.x, rel=1e-12)


def test_a_level_below_the_bed() -> None:
    with pytest.raises(InputError, match=r"levels\[1\]"):
        at_levels(fso(), [0.0, -80.0])


@pytest.mark.parametrize("lines", [6, 8, 10])
def test_the_rule_of_practice_on_the_system_it_is_made_for(lines: int) -> None:
    system = spread(lines, (1e6, 0.0)).under((-1e6, 0.0))
    rule = sharing_rule(system)
    assert rule.line == 0
    assert rule.horizontal_force is not None
    assert rule.horizontal_force == pytest.approx(1e6 / (lines / 4.0), rel=1e-12)
    most = solve_system(system).lines[0].horizontal_force
    # Catenaries stiffen and have pretension: the rule says too little.
    assert most > rule.horizontal_force


@pytest.mark.parametrize(
    ("system", "why"),
    [
        (fso((-1e6, 0.0)), "even number of lines"),
        (spread(2, (1e6, 0.0)), "4 or more"),
        (spread(6, (1e6, 1e6)), "along one of the lines"),
        (spread(6), "a horizontal force"),
        (fso((-1e6, 0.0), azimuths=(0.0, 0.1, 3.0, 3.1)), "spaced evenly"),
        (
            System((*spread(4).legs[:3], Leg(CHAIN, 1.5 * math.pi, 570.0, 50.0)), (1e6, 0.0)),
            "equal lines",
        ),
    ],
)
def test_where_the_rule_does_not_apply(system: System, why: str) -> None:
    rule = sharing_rule(system)
    assert rule.horizontal_force is None
    assert why in rule.why_not
    assert isinstance(rule.why_not, Message)


def test_refused_directions_and_forces() -> None:
    with pytest.raises(InputError, match="force"):
        watch_circle(fso(), force=0.0)
    with pytest.raises(InputError, match="directions"):
        watch_circle(fso(), force=1e6, directions=2)
    with pytest.raises(InputError, match=r"offsets\[1\]"):
        restoring_curve(fso(), direction=0.0, offsets=[1.0, math.nan])


@pytest.mark.parametrize("first", [0, 2])
def test_a_line_that_comes_to_touch_the_bed_twice_carries_on(first: int) -> None:
    """The line with a buoy does when that which held the body is gone."""
    chain = Line([Segment(200.0, 1000.0, EA=5e8)])
    buoyed = Line([Segment(200.0, 1000.0, EA=5e8)], [PointLoad(100.0, -60e3)])
    legs = [
        Leg(chain, math.pi, 190.0, 30.0),
        Leg(chain, math.pi / 2, 190.0, 30.0),
        Leg(chain, -math.pi / 2, 190.0, 30.0),
        Leg(buoyed, 0.0, 196.0, 30.0),
    ]
    turned = legs[first:] + legs[:first]
    answers = one_line_out(System(tuple(turned), force=(150e3, 0.0)))
    (without,) = (each.response for each in answers if turned[each.missing] is legs[0])
    assert without is not None
    left = solve_system(System(tuple(legs[1:]), force=(150e3, 0.0)))
    assert left.lines[2].solution.regime == "grounded-in-parts"
    assert without.x == pytest.approx(left.position.x, rel=1e-8)


def test_of_lines_that_carry_the_same_the_first_is_the_most_loaded() -> None:
    # A body without load on six lines alike: whichever rounding makes the largest.
    assert solve_system(spread(6, force=(0.0, 0.0))).most_loaded == 0
