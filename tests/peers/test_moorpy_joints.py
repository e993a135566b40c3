"""Lines that meet in free points, read by MoorPy 1.3 and by catopt: places, forces, stiffness."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import pytest

from catopt.casefile import read_mooring
from catopt.model.network import Network
from catopt.mooring.held import hold
from tests.decks.own import BRIDLE

moorpy = pytest.importorskip("moorpy", reason="optional extra: peers")


def theirs(place: Path, surge: float = 0.0) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        system = moorpy.System(file=str(place))
        for point in system.pointList:
            if point.type == -1:
                point.r[0] += surge
        system.initialize()
        system.solveEquilibrium(DOFtype="free", tol=1e-9)
    return system


def test_joints_and_forces(tmp_path: Path) -> None:
    place = tmp_path / "bridle.txt"
    place.write_text(BRIDLE)
    network = read_mooring(place)
    assert isinstance(network, Network)
    ours, system = hold(network), theirs(place)
    for point, own in zip(system.pointList, ours.joints.places, strict=True):
        assert (point.r[0], point.r[1], point.r[2] + 350.0) == pytest.approx(own, abs=1e-6 * 350.0)
    for line, own_line in zip(system.lineList, ours.lines, strict=True):
        tensions = sorted([own_line.anchor.tension, own_line.fairlead.tension])
        assert sorted([line.TA, line.TB]) == pytest.approx(tensions, rel=1e-6)


@pytest.mark.slow
def test_stiffness_by_differences_of_their_forces(tmp_path: Path) -> None:
    """Over half a metre either way the force bends by some 1e-3 of its slope."""
    place = tmp_path / "bridle.txt"
    place.write_text(BRIDLE)
    network = read_mooring(place)
    assert isinstance(network, Network)
    pulls = []
    for surge in (0.5, -0.5):
        coupled = [point for point in theirs(place, surge).pointList if point.type == -1]
        pulls.append(math.fsum(float(point.getForces()[0]) for point in coupled))
    own = [hold(network, (surge, 0.0, 0.0, 0.0, 0.0, 0.0)).body.load[0] for surge in (0.5, -0.5)]
    assert pulls == pytest.approx(own, rel=1e-6)
    slope = pulls[1] - pulls[0]
    assert hold(network).body.stiffness[0][0] == pytest.approx(slope, rel=2e-3)
