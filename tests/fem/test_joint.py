"""Joints by the truss model, which knows nothing of the closed form."""

from __future__ import annotations

import numpy as np
import pytest

from catopt.fem.mesh import mesh_line
from catopt.fem.network import LineEnd, MeetingPoint, solve_network
from catopt.model import Line, Segment
from catopt.mooring.fixed_body import hold
from catopt.mooring.network_rest import NetworkAtRest
from catopt.reproduce.items import published
from catopt.reproduce.reference_moorings import SURGE, network_of


def truss(rest: NetworkAtRest, bars: int) -> np.ndarray:
    """Bring all joints to rest at once, as nodes that their lines share; their places."""
    points = rest.network.points
    joints = [k for k, point in enumerate(points) if point.kind == "joint"]
    ends = [
        LineEnd((0.0, 0.0, 0.0), joints.index(k)) if k in joints else LineEnd(place)
        for k, place in enumerate(rest.joints.places)
    ]
    found = solve_network(
        [mesh_line(run.line, bars) for run in rest.runs],
        [(ends[run.first], ends[run.second]) for run in rest.runs],
        [MeetingPoint(points[k].hung) for k in joints],
        seabed_friction=rest.network.site.seabed_friction,
    )
    assert found.residual < 1e-10
    return np.array(found.places)


@pytest.mark.parametrize("away", [(0.0,) * 6, SURGE], ids=["in place", "5 m ahead"])
def test_the_bridle_of_mappp(away: tuple[float, ...]) -> None:
    """Bars with half their load at either end: the error falls to a quarter as they are halved."""
    rest = hold(network_of(published("bridle")), away)
    exact = np.array([rest.place_of(f"joint {k}") for k in (1, 2, 3)])
    coarse, fine = (truss(rest, bars) for bars in (40, 80))
    for k in range(3):
        off = [float(np.linalg.norm(each[k] - exact[k])) for each in (coarse, fine)]
        assert off[1] < 1e-4 * 450.0
        assert 3.0 < off[0] / off[1] < 5.0
        assert (4.0 * fine - coarse)[k] / 3.0 == pytest.approx(exact[k], abs=2e-6 * 450.0)


ROPE = Line([Segment(100.0, 10.0, EA=1e6)])
FREE = (LineEnd((0.0, 0.0, 0.0), 0), LineEnd((0.0, 0.0, 0.0), 1))


def test_the_bed_carries_a_joint_and_what_lies_beside_it() -> None:
    """Pulled straight on a smooth bed by T = EA (110 - 100)/100 from all sides: T is 100 kN.

    The bed has the clump of 5 kN and half of the four bars that end there; the hand calculation has
    no other force along z.
    """
    corners = [(110.0, 0.0, 0.0), (0.0, 110.0, 0.0), (-110.0, 0.0, 0.0), (0.0, -110.0, 0.0)]
    found = solve_network(
        [mesh_line(ROPE, 10)] * 4,
        [
            (LineEnd(at), FREE[0]) if k % 2 else (FREE[0], LineEnd(at))
            for k, at in enumerate(corners)
        ],
        [MeetingPoint((0.0, 0.0, -5e3))],
    )
    assert found.places[0] == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)
    assert found.reactions[0] == pytest.approx(5e3 + 4 * 0.5 * 10.0 * 10.0, rel=1e-9)
    for line in found.lines:
        assert line.tension == pytest.approx(1e5, rel=1e-9)


def test_a_line_between_two_joints_carries_what_pulls_them_apart() -> None:
    """Floats of 20 kN on upright tethers, 30 kN apart: force by force, without any solver.

    The tethers keep 20 kN less their weight upwards; the hawser, nearly level, has 30 kN along x
    less what leaning tethers take, so that along x both joints balance.
    """
    tether, hawser = Line([Segment(50.0, 1.0, EA=1e8)]), Line([Segment(40.0, 1.0, EA=1e8)])
    anchors = [(0.0, 0.0, 0.0), (40.0, 0.0, 0.0)]
    found = solve_network(
        [mesh_line(tether, 20), mesh_line(tether, 20), mesh_line(hawser, 20)],
        [(LineEnd(anchors[0]), FREE[0]), (LineEnd(anchors[1]), FREE[1]), FREE],
        [MeetingPoint((-3e4, 0.0, 2e4)), MeetingPoint((3e4, 0.0, 2e4))],
    )
    west, east, between = found.lines
    assert found.places[1][0] - found.places[0][0] == pytest.approx(
        40.0 * (1 + 3e4 / 1e8), rel=1e-5
    )
    for line, force in ((west, 3e4), (east, 3e4)):
        left = force - between.horizontal_force - line.horizontal_force
        assert abs(left) < 1e-4 * force
        assert line.fairlead.vertical_force == pytest.approx(2e4 - 0.5 * 40.0, rel=1e-6)
