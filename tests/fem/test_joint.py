"""A joint of three lines by the truss model, which knows nothing of the closed form."""

from __future__ import annotations

import numpy as np
import pytest

from catopt.fem.bed import Bed
from catopt.fem.mesh import mesh_line
from catopt.fem.problem import Water, build, straight
from catopt.fem.resting import Body
from catopt.fem.settle import Controls, settle
from catopt.model.network import Network
from catopt.mooring.held import NetworkAtRest, hold
from catopt.reproduce.published import published
from catopt.reproduce.reference_moorings import SURGE, network_of


def truss(rest: NetworkAtRest, joint: str, bars: int) -> tuple[np.ndarray, list[float]]:
    """Bring one joint to rest as the body in which its lines meet, free in all directions.

    Returns its place and the tension of the bar at the far end of each line.
    """
    network: Network = rest.network
    number = network.numbers[joint]
    lines = [each for each in network.lines if joint in (each.start, each.end)]
    far = [
        rest.joints.places[network.numbers[each.end if each.start == joint else each.start]]
        for each in lines
    ]
    meshes = [mesh_line(each.line, bars) for each in lines]
    start = np.mean(far, axis=0)
    weight = network.points[number].submerged_weight
    body = Body(np.ones(3), np.array([0.0, 0.0, -weight]), start)
    problem = build(meshes, body, Bed(), network.site.seabed_friction, Water(), False)
    state = straight(problem, np.array(far), np.tile(start, (len(far), 1)))
    found = settle(problem, state, Controls())
    bounds = problem.bars.start
    return found.state.x[bounds[1]], [float(found.state.tension[k]) for k in bounds[:-1]]


@pytest.mark.parametrize("away", [(0.0,) * 6, SURGE], ids=["in place", "5 m ahead"])
def test_the_bridle_of_mappp(away: tuple[float, ...]) -> None:
    """Bars with half their load at either end: the error falls to a quarter as they are halved.

    Every line is of one segment, so that it may be counted from either end.
    """
    rest = hold(network_of(published("bridle")), away)
    for joint in ("joint 1", "joint 2"):
        exact = np.array(rest.place_of(joint))
        coarse, fine = (truss(rest, joint, bars)[0] for bars in (40, 80))
        off = [float(np.linalg.norm(each - exact)) for each in (coarse, fine)]
        assert off[1] < 1e-4 * 450.0
        assert 3.0 < off[0] / off[1] < 5.0
        assert (4.0 * fine - coarse) / 3.0 == pytest.approx(exact, abs=2e-6 * 450.0)
