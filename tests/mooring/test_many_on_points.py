"""Many loads on bodies between points in one call, beside each load by itself."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from catopt import Line, Segment
from catopt.errors import NoEquilibriumError
from catopt.model import Site
from catopt.model.network import LineBetween, MooredBody, Network, Point
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.many import NetworkSolutions, solve_network_many
from tests.campaign.networks import drawn

from .test_bodies import barge

LOADS = np.array([[0.0, 0.0, 0.0], [100e3, 0.0, 0.0], [-60e3, 20e3, 5e4], [20e3, 0.0, 1e11]])


def alone(network: Network, load: np.ndarray) -> Network:
    (body,) = network.bodies
    x, y, moment = load.tolist()
    return replace(network, bodies=(replace(body, force=(x, y), moment=moment),))


def test_many_loads_are_each_by_itself() -> None:
    """The last is a moment that no lines can carry: it is told, and the others are answered."""
    network = barge()
    found = solve_network_many(network, force=LOADS[:, None])
    assert set(found.reasons) == {3}
    assert "turns over" in found.reasons[3]
    assert np.isnan(found.position[3]).all()
    assert np.isnan(found.first_force[3]).all()
    for number, load in enumerate(LOADS[:3]):
        rest = at_rest(alone(network, load))
        (body,) = rest.bodies
        place = (body.position.x, body.position.y, body.position.yaw)
        assert found.position[number, 0] == pytest.approx(place, rel=1e-9, abs=1e-9)
        assert found.offset[number, 0] == pytest.approx(body.offset, rel=1e-9, abs=1e-9)
        for k, ends in enumerate(rest.joints.ends):
            pull = math.hypot(*ends.second)
            assert found.first_force[number, k] == pytest.approx(ends.first, abs=1e-8 * pull)
            assert found.second_force[number, k] == pytest.approx(ends.second, abs=1e-8 * pull)
            assert found.grounded_length[number, k] == pytest.approx(ends.state.grounded, abs=1e-6)
        assert (
            found.residual[number]
            <= 1e-8 * np.linalg.norm(found.second_force[number], axis=1).max()
        )


def buoyed() -> Network:
    """Moor a body by a row of two lines with a buoy between them, and by a line of its own."""
    chain = Line([Segment(120.0, 300.0, EA=1e8)])
    points = (
        Point("west", "anchor", -200.0, 0.0, 0.0),
        Point("east", "anchor", 200.0, 0.0, 0.0),
        Point("buoy", "joint", submerged_weight=-2e3),
        Point("bow", "fairlead", -5.0, 0.0, 50.0, body="barge"),
        Point("stern", "fairlead", 5.0, 0.0, 50.0, body="barge"),
    )
    lines = (
        LineBetween(chain, "west", "buoy"),
        LineBetween(chain, "buoy", "bow"),
        LineBetween(Line([Segment(230.0, 300.0, EA=1e8)]), "east", "stern"),
    )
    return Network(Site(50.0), points, lines, bodies=(MooredBody("barge"),))


def test_joints_in_a_row_are_parted() -> None:
    """Each line has its own forces."""
    network = buoyed()
    found = solve_network_many(network, force=LOADS[:3, None])
    assert not found.reasons
    for number, load in enumerate(LOADS[:3]):
        for k, ends in enumerate(at_rest(alone(network, load)).joints.ends):
            assert found.second_force[number, k] == pytest.approx(ends.second, rel=1e-9)


def test_a_buoy_that_comes_up_is_afloat() -> None:
    """What draws the body back from its chain slackens the ropes that hold the buoy down."""
    rope = Line([Segment(148.0, 50.0, EA=1e8)])
    points = (
        Point("north", "anchor", -150.0, 40.0, 0.0),
        Point("south", "anchor", -150.0, -40.0, 0.0),
        Point("east", "anchor", 260.0, 0.0, 0.0),
        Point("buoy", "joint", submerged_weight=-8e3),
        Point("bow", "fairlead", 0.0, 0.0, 40.0, body="barge"),
    )
    lines = (
        LineBetween(rope, "north", "buoy"),
        LineBetween(rope, "south", "buoy"),
        LineBetween(Line([Segment(40.0, 50.0, EA=1e8)]), "buoy", "bow"),
        LineBetween(Line([Segment(262.0, 1500.0, EA=1e8)]), "east", "bow"),
    )
    network = Network(Site(40.0), points, lines, bodies=(MooredBody("barge"),))
    loads = np.array([[[0.0, 0.0, 0.0]], [[-1e5, 0.0, 0.0]]])
    found = solve_network_many(network, force=loads)
    assert not found.reasons
    # Of its 8 kN the ropes use a part under the second load: each end on it pulls it down by that.
    down = -sum(found.second_force[:, k, 2] for k in (0, 1)) - found.first_force[:, 2, 2]
    assert down[0] == pytest.approx(8e3)
    assert 0.0 < down[1] < 7.9e3


def of_own_load(network: Network) -> NetworkSolutions:
    own = [[(*body.force, body.moment) for body in network.bodies]]
    return solve_network_many(network, force=own)


@pytest.mark.parametrize("seed", [1, 21])
def test_random_networks_are_each_by_itself(seed: int) -> None:
    network = drawn(seed)
    found = of_own_load(network)
    assert not found.reasons
    moved = [body.offset for body in at_rest(network).bodies]
    assert found.offset[0] == pytest.approx(np.array(moved), rel=1e-7, abs=1e-7)


def test_a_line_that_friction_holds_at_both_ends_is_told() -> None:
    """Neither of its ends is an anchor: so it is refused by itself, too."""
    network = drawn(56)
    with pytest.raises(NoEquilibriumError, match="neither of its ends is an anchor") as refused:
        at_rest(network)
    assert of_own_load(network).reasons == {0: refused.value.message}
