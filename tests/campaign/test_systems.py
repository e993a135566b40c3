"""A slice of the campaign over systems, and that its checks would see an error."""

from __future__ import annotations

import math
import random
from dataclasses import replace

import pytest

from catopt import NoEquilibriumError, System, solve_system
from catopt.model import Leg
from catopt.mooring.network_rest import Position
from tests.campaign.random_system import drawn_system
from tests.campaign.systems import Tally, faults_of_answer, faults_of_refusal, run
from tests.mooring.layouts import CHAIN, fso
from tests.mooring.test_headings import crossed, on_an_arm

LOADED = fso((-3e6, 1e6), fairlead_radius=12.0, moment=2e7)


@pytest.mark.slow
def test_a_slice() -> None:
    _is_clean(run(50, seed=2026))


@pytest.mark.slow
def test_a_larger_slice() -> None:
    """`python -m tests.campaign` runs thousands."""
    _is_clean(run(200, seed=2026))


def _is_clean(tally: Tally) -> None:
    assert tally.failures == ()
    assert tally.answered + tally.refused_rightly == tally.count
    assert tally.with_moment > 0.5 * tally.count
    assert tally.refused_rightly > 0
    assert tally.with_two > 0


@pytest.mark.parametrize("number", ["1 83", "1 1987", "2 691", "2 4014", "2027 118"])
def test_answers_that_the_campaign_mended(number: str) -> None:
    """A yaw without stiffness; lines without stretch; no force; a moment that bends."""
    system = drawn_system(random.Random(f"system {number}"))
    assert faults_of_answer(solve_system(system)) == []


def test_a_refusal_that_the_campaign_mended() -> None:
    """The largest moment is at a bend, between two yaws of the search."""
    system = drawn_system(random.Random("system 1 2352"))
    with pytest.raises(NoEquilibriumError) as caught:
        solve_system(system)
    assert faults_of_refusal(system, caught.value) == []


def test_a_right_answer_has_no_fault() -> None:
    assert faults_of_answer(solve_system(LOADED)) == []


# The forces balance to 1e-8 of some 1e7 N with a stiffness of 1e6 N/m: a micrometre is seen.
@pytest.mark.parametrize(
    ("dx", "dy", "dyaw"), [(1e-5, 0.0, 0.0), (0.0, -1e-5, 0.0), (0.0, 0.0, 1e-5)]
)
def test_a_body_out_of_place_is_seen(dx: float, dy: float, dyaw: float) -> None:
    solution = solve_system(LOADED)
    at = solution.position
    moved = replace(solution, position=Position(at.x + dx, at.y + dy, at.yaw + dyaw))
    assert any(" left" in fault for fault in faults_of_answer(moved))


def test_a_yaw_beyond_half_a_turn_is_seen() -> None:
    solution = solve_system(LOADED)
    at = solution.position
    turned = replace(solution, position=replace(at, yaw=at.yaw + 2.0 * math.pi))
    assert [fault[:3] for fault in faults_of_answer(turned)] == ["yaw"]


def test_a_body_on_a_ridge_is_seen() -> None:
    """Turned about its fairlead until the lever of the force is the same on the other side."""
    solution = solve_system(on_an_arm(4e5))
    assert faults_of_answer(solution) == []
    (line,), at = solution.lines, solution.position
    out = math.asin(4e5 / 2e6)
    yaw = at.yaw + math.pi - 2.0 * out
    arm = math.radians(16.0) + yaw
    x = line.fairlead[0] - 20.0 * math.cos(arm)
    y = line.fairlead[1] - 20.0 * math.sin(arm)
    ridge = replace(
        solution, position=Position(x, y, math.remainder(yaw, 2.0 * math.pi)), warnings=()
    )
    assert any("not stable" in fault for fault in faults_of_answer(ridge))
    assert not any(" left" in fault for fault in faults_of_answer(ridge))


def test_a_heading_that_is_not_named_is_seen() -> None:
    solution = solve_system(crossed((2e5, 5e4)))
    assert faults_of_answer(solution) == []
    silent = replace(solution, warnings=())
    assert any("is not named" in fault for fault in faults_of_answer(silent))


def test_a_heading_that_does_not_exist_is_seen() -> None:
    solution = solve_system(LOADED)
    told = (
        "the body also has equilibrium at a yaw of 90.00 deg, its origin at (0.000, 0.000) m: "
        "which one it takes depends on its history"
    )
    faults = faults_of_answer(replace(solution, warnings=(told,)))
    assert any("where a warning says" in fault for fault in faults)


def refused(moment: float, carried: float, missing: float) -> NoEquilibriumError:
    return NoEquilibriumError(
        f"the lines cannot carry the moment of {moment:.6g} N m on the body: they resist up to "
        f"{carried:.6g} N m in that sense, {missing:.4g} N m less",
        "moment",
        missing,
    )


def test_a_refusal_that_contradicts_itself_is_seen() -> None:
    (fault,) = faults_of_refusal(on_an_arm(4e5), refused(4e5, 5.513e5, -1.513e5))
    assert "contradicts itself" in fault


def test_a_refusal_of_what_exists_is_seen() -> None:
    (fault,) = faults_of_refusal(on_an_arm(4e5), refused(4e5, 3e5, 1e5))
    assert "rests at" in fault


def test_a_refusal_with_a_wrong_limit_is_seen() -> None:
    assert faults_of_refusal(on_an_arm(2.5e6), refused(2.5e6, 2e6, 0.5e6)) == []
    (fault,) = faults_of_refusal(on_an_arm(2.5e6), refused(2.5e6, 1.9e6, 0.6e6))
    assert "carries 2e+06 N m" in fault or "carries 1.99" in fault


def test_a_body_that_no_line_holds_is_not_looked_at_for_headings() -> None:
    system = System((Leg(CHAIN, 0.0, 560.0, 50.0, fairlead_radius=5.0),))
    assert faults_of_answer(solve_system(system)) == []
