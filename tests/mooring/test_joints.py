"""Lines that meet in joints: by hand, by differences of their own loads, and what is refused."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt import InputError, Line, NoEquilibriumError, PointLoad, Segment, solve
from catopt.model import Site
from catopt.model.network import LineBetween, Network, Point
from catopt.mooring.fixed_body import hold
from catopt.mooring.network_rest import NetworkAtRest
from catopt.mooring.rest import TOLERANCE
from catopt.reproduce.items import published
from catopt.reproduce.reference_moorings import network_of


def rope(length: float, weight: float = 1e-3, EA: float = 1e9) -> Line:
    return Line([Segment(length, weight, EA=EA)])


def tripod(joint_weight: float, depth: float = 20.0, height: float = 10.0) -> Network:
    """Hang a joint from three ropes of 5 m whose other ends lie 4 m off, 120 deg apart."""
    ends = [Point(f"{k}", "anchor", 4.0 * math.cos(k * math.tau / 3.0),
                  4.0 * math.sin(k * math.tau / 3.0), height) for k in range(3)]  # fmt: skip
    points = [*ends, Point("joint", "joint", submerged_weight=joint_weight)]
    lines = [LineBetween(rope(5.0), f"{k}", "joint") for k in range(3)]
    return Network(Site(depth), tuple(points), tuple(lines))


@pytest.mark.parametrize(("weight", "height"), [(-6e3, 13.0), (6e3, 7.0)])
def test_three_ropes_carry_a_third_each(weight: float, height: float) -> None:
    # 3-4-5: the joint is 3 m above or below the ends; each rope carries 2 kN of it upright, that is
    # 2 kN x 5/3 = 3333.3 N. The ropes' own 5 mN are not seen; they stretch by 5 m x
    # 3333 N / 1 GN = 17 um, which moves the joint by 5/3 of that.
    found = hold(tripod(weight))
    assert found.place_of("joint") == pytest.approx((0.0, 0.0, height), abs=3e-5)
    for line in found.lines:
        assert line.fairlead.tension == pytest.approx(10e3 / 3.0, abs=0.05)
    assert found.joints.residual < 1e-9 * 10e3 / 3.0


def test_a_tether_stands_plumb() -> None:
    # Two ropes hold a buoy of 10 kN plumb over their anchor, 5 kN each: stretched by T l/EA =
    # 5 kN x 10 m / 1 MN = 0.05 m; their own 0.01 N is nothing beside that.
    points = [
        Point("anchor", "anchor", 3.0, 4.0, 0.0),
        Point("buoy", "joint", submerged_weight=-1e4),
    ]
    lines = [LineBetween(rope(10.0, EA=1e6), "anchor", "buoy") for _ in range(2)]
    found = hold(Network(Site(30.0), tuple(points), tuple(lines)))
    assert found.place_of("buoy") == pytest.approx((3.0, 4.0, 10.05), abs=1e-6)


def test_a_joint_in_a_line_is_a_line() -> None:
    # One chain of 100 and 60 m with a clump weight of 20 kN where they meet, and the same as two
    # lines that meet in a joint of that weight: the first is solved as one line.
    chain, wire = Segment(100.0, 1500.0, EA=4e8), Segment(60.0, 300.0, EA=2e8)
    whole = Line([chain, wire], [PointLoad(100.0, 20e3)])
    alone = solve(whole, height=60.0, span=140.0, seabed_friction=0.3)
    points = [
        Point("anchor", "anchor", 140.0, 0.0, 0.0),
        Point("clump", "joint", submerged_weight=20e3),
        Point("fairlead", "fairlead", 0.0, 0.0, 60.0),
    ]
    # Given from the fairlead down, the wire is the same.
    lines = [
        LineBetween(Line([chain]), "clump", "anchor"),
        LineBetween(Line([wire]), "fairlead", "clump"),
    ]
    found = hold(Network(Site(60.0, 0.3), tuple(points), tuple(lines)))
    assert found.body.load[0] == pytest.approx(alone.horizontal_force, rel=1e-9)
    assert -found.body.load[2] == pytest.approx(alone.fairlead.vertical_force, rel=1e-9)
    assert found.lines[0].anchor.tension == pytest.approx(alone.anchor.tension, rel=1e-9)
    (state,) = alone.point_loads
    assert found.place_of("clump") == pytest.approx((140.0 - state.x, 0.0, state.z), abs=1e-7)


def two_joints(friction: float = 0.0) -> Network:
    """Tie two bridles together by a line that lies on the bed between its joints."""
    points = [
        Point("west", "anchor", -180.0, 5.0, 0.0),
        Point("east", "anchor", 190.0, -10.0, 10.0),
        Point("j1", "joint", submerged_weight=2e4),
        Point("j2", "joint", submerged_weight=-1e4),
        Point("f1", "fairlead", -8.0, 6.0, 70.0),
        Point("f2", "fairlead", -8.0, -6.0, 70.0),
        Point("f3", "fairlead", 9.0, 0.0, 72.0),
    ]
    lines = [
        LineBetween(rope(120.0, 800.0, 4e8), "west", "j1"),
        LineBetween(rope(130.0, 700.0, 5e8), "east", "j2"),
        LineBetween(rope(62.0, 300.0, 2e8), "j1", "f1"),
        LineBetween(rope(64.0, 300.0, 2e8), "f2", "j1"),
        LineBetween(rope(66.0, 300.0, 2e8), "j2", "f3"),
        LineBetween(rope(190.0, 200.0, 3e8), "j1", "j2"),
    ]
    return Network(Site(75.0, friction), tuple(points), tuple(lines))


def slope(network: Network, at: tuple[float, ...], j: int, step: float) -> list[float]:
    plus, minus = (
        hold(network, tuple(v + sign * step * (k == j) for k, v in enumerate(at))).body.load
        for sign in (1.0, -1.0)
    )
    return [-(a - b) / (2.0 * step) for a, b in zip(plus, minus, strict=True)]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["bridle", "two joints"])
def test_stiffness_is_minus_the_derivative_of_the_load(name: str) -> None:
    network = network_of(published("bridle")) if name == "bridle" else two_joints()
    at = (1.0, -0.5, 0.3, 0.0, 0.0, 0.0)
    found = hold(network, at)
    regimes = [line.regime for line in found.lines]
    assert name == "bridle" or "grounded-between" in regimes
    stiffness = found.body.stiffness
    scale = [max(map(abs, row)) for row in stiffness]
    # What may be left over at a joint, N, is missing in the load; a fairlead is some 30 m away.
    left = TOLERANCE * max(forces(found))
    for j, step in enumerate((1e-3,) * 3 + (1e-5,) * 3):
        by_difference = slope(network, at, j, step)
        for i in range(6):
            own, lost = stiffness[i][j], left / step * (1.0 if i < 3 else 30.0)
            assert own == pytest.approx(by_difference[i], abs=2e-6 * scale[i] + lost), (i, j)


def forces(found: NetworkAtRest) -> list[float]:
    return [line.fairlead.tension for line in found.lines]


def test_order_and_names_do_not_matter() -> None:
    network = two_joints()
    turned = replace(network, points=network.points[::-1], lines=network.lines[::-1])
    assert forces(hold(turned))[::-1] == pytest.approx(forces(hold(network)), rel=1e-8)


def test_a_clump_on_a_bed_without_friction_is_carried_by_it() -> None:
    # Ropes of 5 m from ends 3 m up reach the bed 4 m off: the clump lies where they are straight,
    # or nearer, and pulls with nothing; all of its 6 kN less the ropes' share rest on the bed.
    network = tripod(6e3, height=2.0)
    ends = [replace(point, x=1.05 * (point.x or 0.0), y=1.05 * (point.y or 0.0)) if point.kind
            == "anchor" else point for point in network.points]  # fmt: skip
    found = hold(replace(network, points=tuple(ends), lines=tuple(
        replace(line, line=rope(4.6, 1.0, 1e6)) for line in network.lines)))  # fmt: skip
    # Chord hypot(4.2, 2) = 4.6519 m of a rope of 4.6 m: T = 1e6 x 0.0519/4.6 = 11.28 kN, which
    # lifts 3 x 11.28 x 2/4.6519 = 14.5 kN > 6 kN: the clump hangs; with a weight of 60 kN it lies.
    assert found.place_of("joint")[2] > 0.0
    heavy = [*ends[:3], replace(ends[3], submerged_weight=60e3)]
    lies = hold(replace(found.network, points=tuple(heavy)))
    assert lies.place_of("joint") == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)
    chord = math.hypot(4.2, 2.0)
    lift = 3.0 * 1e6 * (chord / 4.6 - 1.0) * 2.0 / chord
    assert lies.joints.reactions[3] == pytest.approx(60e3 - lift, abs=20.0)  # 3 ropes of 4.6 N
    with pytest.raises(NoEquilibriumError, match="joint joint comes to rest on the bed"):
        hold(replace(lies.network, site=Site(20.0, 0.5)))


def test_what_has_no_answer_is_refused() -> None:
    with pytest.raises(NoEquilibriumError, match="neither of its ends is an anchor"):
        hold(two_joints(friction=0.4))
    slack = two_joints()
    with pytest.raises(InputError, match="hangs slack"):
        hold(replace(slack, lines=(*slack.lines[:-1], LineBetween(rope(400.0, 50.0), "j1", "j2"))))


def test_every_fault_of_a_network_is_told_at_once() -> None:
    network = two_joints()
    faults = [
        LineBetween(Line([Segment(5.0, 1.0)]), "west", "j1"),
        LineBetween(rope(5.0, 0.0), "j1", "f1"),
    ]
    with pytest.raises(InputError) as caught:
        replace(network, lines=(*network.lines, *faults))
    assert [problem.key for problem in caught.value.problems] == [
        "lines[6].segments[0].EA",
        "lines[7].segments",
    ]
    with pytest.raises(InputError) as caught:
        Network(
            Site(10.0),
            (Point("a", "joint"), Point("a", "joint"), Point("b", "anchor", 0.0, 0.0, 0.0)),
            (LineBetween(rope(5.0), "a", "c"), LineBetween(rope(5.0), "b", "b")),
        )
    assert [str(p.key) for p in caught.value.problems] == [
        "points[1].name",
        "lines[0].end",
        "lines[1].end",
    ]
    with pytest.raises(InputError) as caught:
        replace(network, points=(*network.points, Point("idle", "joint")))
    assert [p.key for p in caught.value.problems] == ["points[7]"]
    assert Point("a", "anchor", 0.0, 0.0).height == 0.0
    with pytest.raises(InputError, match="height"):
        Point("a", "fairlead", 0.0, 0.0)
    with pytest.raises(InputError, match="only a joint"):
        Point("a", "anchor", 0.0, 0.0, 0.0, submerged_weight=5.0)
    with pytest.raises(InputError, match="leave it out"):
        Point("a", "joint", 0.0)
