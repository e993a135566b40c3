"""Joints on the bed, joints in one line, slack bridles: kinks that Newton's method has to pass."""

from __future__ import annotations

import time
from collections.abc import Sequence
from pathlib import Path

import pytest

from catopt import InputError, solve
from catopt.casefile import read_mooring
from catopt.catenary.pieces import LineProblem
from catopt.model import Line, PointLoad, Segment
from catopt.model.network import Network
from catopt.mooring.chains import rows_of
from catopt.mooring.fixed_body import hold
from catopt.mooring.joints import Ends, Vector, ends_of, fixed_net, hung, run_of
from catopt.mooring.net import room_for
from tests.campaign.cuts import bridle_fault, fault

HARD = Path(__file__).parents[1] / "hard_cases"


def network(name: str) -> Network:
    read = read_mooring(HARD / f"{name}.toml")
    assert isinstance(read, Network)
    return read


@pytest.mark.parametrize("name", ["cut_MIN_0", "cut_MIN_1", "cut_MIN_4"])
def test_a_chain_cut_into_three_is_the_chain(name: str) -> None:
    cut_up = network(name)
    anchor, fairlead = cut_up.points[:2]
    line = Line([line.line.segments[0] for line in cut_up.lines])
    alone = solve(line, height=fairlead.place[2], span=anchor.place[0] - fairlead.place[0])
    start = time.process_time()
    found = hold(cut_up)
    assert time.process_time() - start < 1.0
    assert found.body.load[0] == pytest.approx(alone.horizontal_force, rel=1e-6)
    assert -found.body.load[2] == pytest.approx(alone.fairlead.vertical_force, rel=1e-6)
    if name == "cut_MIN_1":
        assert found.body.load[0] == pytest.approx(54_759.91, abs=0.005)


@pytest.mark.parametrize("name", ["cut_MIN_6", "wild_TO_67", "wild_NC_48"])
def test_what_hangs_slack_is_refused_at_once(name: str) -> None:
    start = time.process_time()
    with pytest.raises(InputError, match="hangs slack"):
        hold(network(name))
    assert time.process_time() - start < 1.0


def test_rows_go_from_the_anchor_and_keep_the_order_of_their_lines() -> None:
    (row,) = rows_of(network("cut_MIN_0"))
    assert (row.start, row.end, row.joints) == ("anchor", "fairlead", ("joint 1", "joint 2"))
    assert row.lines == ((0, False), (1, False), (2, False))


def between(line: Line, a: Vector, b: Vector) -> Ends:
    """Hang a line between two points, the bed without friction."""
    runs = [run_of("", 0, 1, line)]
    net = fixed_net(runs, [a, b], [0.0])
    return ends_of(0, net, hung(net, room_for(net), runs))


def test_a_taut_line_on_the_bed_is_as_stiff_as_it_stretches() -> None:
    """100 m with EA 1 MN, both ends on the bed: EA / L = 10 kN/m along it, H / S across."""
    line = Line([Segment(100.0, 500.0, EA=1e6)])
    ends = between(line, (0.0, 0.0, 0.0), (100.5, 0.0, 0.0))
    assert isinstance(ends.problem, LineProblem)
    assert ends.state.H == pytest.approx(1e6 * 0.5 / 100.0, rel=1e-9)
    assert ends.stiffness[3][3] == pytest.approx(1e4, rel=1e-9)
    assert ends.stiffness[4][4] == pytest.approx(5e3 / 100.5, rel=1e-9)


@pytest.mark.parametrize("other", [0.0, 3.0])
@pytest.mark.parametrize("height", [10.0, 22.0, 24.9, 25.1, 25.2, 27.0])
def test_a_slack_line_is_as_stiff_upwards_as_what_it_lifts(height: float, other: float) -> None:
    """By differences: of rope, of rope and chain, while a clump is lifted (1 / sum of L / EA).

    So it is where the other end hangs off the bed, too.
    """
    line = Line(
        [Segment(100.0, 500.0, EA=1e7), Segment(20.0, 100.0, EA=1e6)], [PointLoad(95.0, 5e3)]
    )
    step = 1e-6
    low, at, high = (
        between(line, (0.0, 0.0, other), (40.0, 0.0, height + d)) for d in (-step, 0.0, step)
    )
    assert at.state.H == 0.0
    slope = -(high.second[2] - low.second[2]) / (2.0 * step)
    assert at.stiffness[5][5] == pytest.approx(slope, rel=1e-4)


def test_a_clump_that_rests_on_the_bed_by_itself_carries_its_part() -> None:
    """No length lies, yet raising an end leaves the pull at the other; by differences."""
    line = Line([Segment(11.8, 180.0, EA=1.6e7)], [PointLoad(7.5, 540.0)])
    at = (0.0, 0.0, 1.345, 10.824, -4.31, 0.31)

    def ends(at: Sequence[float]) -> Ends:
        return between(line, (at[0], at[1], at[2]), (at[3], at[4], at[5]))

    found, step = ends(at), 1e-5
    assert found.state.grounded == 0.0
    carried = found.second[2] + found.first[2] + 11.8 * 180.0 + 540.0
    assert 1.0 < carried < 539.0  # of the clump
    stiffest = max(map(max, found.stiffness))
    for j in range(6):
        there, back = ([x + sense * step * (i == j) for i, x in enumerate(at)] for sense in (1, -1))
        after, before = ends(there), ends(back)
        change = zip((*after.first, *after.second), (*before.first, *before.second), strict=True)
        by_differences = [(b - a) / (2.0 * step) for a, b in change]
        own = [row[j] for row in found.stiffness]
        assert own == pytest.approx(by_differences, abs=1e-6 * stiffest)


@pytest.mark.parametrize("seed", range(12))
def test_a_line_cut_at_joints_is_the_line(seed: int) -> None:
    assert fault(seed) == ""


@pytest.mark.slow
def test_cuts_and_bridles() -> None:
    """600 cuts and 300 bridles went through it when it was written."""
    assert [(seed, said) for seed in range(1000, 1060) if (said := fault(seed))] == []
    assert [(seed, said) for seed in range(1000, 1030) if (said := bridle_fault(seed))] == []
