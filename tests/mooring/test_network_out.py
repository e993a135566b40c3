"""Lines between points with one out: the joints are in balance again, and what fails is named."""

from __future__ import annotations

import math
from collections.abc import Sequence

import pytest

from catopt.errors import NotConvergedError
from catopt.model.network import Network
from catopt.mooring import network_out
from catopt.mooring.network_out import each_line_out
from catopt.mooring.network_rest import LinesAtRest
from tests.campaign.cuts import bridle


def left_over(rest: LinesAtRest) -> float:
    """Sum what is left at a joint of the pulls of its lines, weight, force and the bed, N."""
    worst = 0.0
    for k, point in enumerate(rest.network.points):
        if point.kind != "joint":
            continue
        pulls: list[Sequence[float]] = [point.hung, (0.0, 0.0, rest.joints.reactions[k])]
        for run, ends in zip(rest.runs, rest.joints.ends, strict=True):
            pulls += [ends.first] if run.first == k else []
            pulls += [ends.second] if run.second == k else []
        worst = max(worst, math.hypot(*(math.fsum(each) for each in zip(*pulls, strict=True))))
    return worst


@pytest.mark.parametrize("seed", range(6))
def test_the_joints_are_in_balance_without_a_line(seed: int) -> None:
    network = bridle(seed)
    gone = each_line_out(network)
    assert [each.missing for each in gone] == list(range(len(network.lines)))
    assert any(each.rest is not None for each in gone)
    for each in gone:
        assert set(each.left).isdisjoint({*each.loose, each.missing})
        if each.rest is not None:
            assert each.largest_tension is not None
            assert left_over(each.rest) <= 1e-6 * each.largest_tension
            assert len(each.rest.runs) == len(each.left)


def test_what_does_not_converge_says_without_which_line(monkeypatch: pytest.MonkeyPatch) -> None:
    def stops(_: Network) -> None:
        raise NotConvergedError("stopped short")

    monkeypatch.setattr(network_out, "at_rest", stops)
    gone = each_line_out(bridle(0))
    assert all(each.stopped_short and each.rest is None for each in gone if not each.loose)
    assert "Without line 1 no equilibrium was found" in gone[0].why_lost
    assert "stopped short" in gone[0].why_lost
