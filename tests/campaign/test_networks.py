"""The campaign over networks, in small; and that it sees what is planted."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import pytest

from catopt.errors import NoEquilibriumError
from catopt.mooring.fixed_body import at_rest
from tests.campaign.network_check import faults_of_answer, faults_of_refusal, judge
from tests.campaign.networks import drawn, drawn_afloat


@pytest.mark.parametrize("seed", [0, 3, 10, 13, 18, 19])
def test_each_answer_balances(seed: int) -> None:
    assert judge(seed) == ("answered", [])


@pytest.mark.slow
def test_many() -> None:
    assert {seed: faults for seed in range(0, 60, 2) if (faults := judge(seed)[1])} == {}


@pytest.mark.parametrize("seed", [3, 13, 18])
def test_each_answer_with_floats_at_the_surface_balances(seed: int) -> None:
    assert judge(seed, drawn_afloat) == ("answered", [])


@pytest.mark.slow
def test_many_with_floats_at_the_surface() -> None:
    seeds = range(0, 300, 3)
    assert {seed: faults for seed in seeds if (faults := judge(seed, drawn_afloat)[1])} == {}


def test_a_joint_that_is_off_its_place_is_seen() -> None:
    found = at_rest(drawn(18))
    assert faults_of_answer(found) == []
    number = next(k for k, p in enumerate(found.network.points) if p.kind == "joint")
    x, y, z = found.joints.places[number]
    places = (*found.joints.places[:number], (x + 1e-4, y, z), *found.joints.places[number + 1 :])
    moved = replace(found, joints=found.joints._replace(places=places))
    assert "N left at" in faults_of_answer(moved)[0]


def test_a_refusal_without_a_cause_is_seen() -> None:
    smooth = drawn(18)
    rough = replace(smooth, site=replace(smooth.site, seabed_friction=0.6))
    error = NoEquilibriumError("a joint lies on the bed", "force", 1.0)
    assert "nothing of the kind" in faults_of_refusal(rough, error)[0]
    assert faults_of_refusal(replace(smooth, site=replace(smooth.site, seabed_friction=0.0)), error)


def test_lines_without_an_anchor_have_no_friction_while_it_is_sought() -> None:
    """Before, the forces on this grid had no energy: 200 steps of which the last did not move."""
    assert judge(12) == ("refused", [])


def test_what_friction_holds_to_the_last_digit_is_refused_for_that() -> None:
    """On a rough bed a line gives way by H^2 / (2 EA mu w): 4e-4 N are less than digits of places.

    Before, it was "not converged" with 2e-8 of the largest tension left over.
    """
    assert judge(264) == ("refused", [])


def test_friction_on_a_joint_of_two_lines_is_no_residual() -> None:
    """0.6 of the 2026 N with which the bed carries it."""
    found = at_rest(drawn(89))
    assert found.joints.residual < 1e-3
    assert max(found.joints.reactions) > 1e3


def test_a_body_that_lies_anywhere_without_load_rests_under_it() -> None:
    """Its place under the load is one; how far that is from none is told as not determined."""
    assert judge(96) == ("answered", [])
    assert all(map(math.isnan, itertools.chain(*(e.offset for e in at_rest(drawn(96)).bodies))))


@pytest.mark.parametrize("seed", [677, 717, 727, 1027])
def test_clumps_that_rest_on_the_bed_between_joints_come_to_rest(seed: int) -> None:
    """Before, not within 200 steps: such a line was as stiff as one that hangs clear."""
    assert judge(seed)[1] == []


def test_a_step_goes_down_where_friction_makes_stiffness_lopsided() -> None:
    """Three floats on rough ground: before, 200 steps of which all but the first did not move."""
    assert judge(1313) == ("answered", [])


def test_what_rubs_between_hanging_parts_of_a_row_is_refused() -> None:
    """A load that touches the rough bed between two floats: before, 1580 N were left over there."""
    assert judge(4709) == ("refused", [])
    with pytest.raises(NoEquilibriumError, match="lies on the bed between hanging parts"):
        at_rest(drawn(4709))
