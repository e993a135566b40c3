"""Lines that meet in free points, read by MoorPy 1.3 and by catopt: places, forces, stiffness."""

from __future__ import annotations

import io
import math
import random
import warnings
from collections.abc import Callable
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catopt.casefile import read_mooring
from catopt.catenary.solve import solve
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import CatoptError
from catopt.model import Line, Segment, Site
from catopt.model.network import LineBetween, MooredBody, Network, Point
from catopt.mooring.fixed_body import at_rest, hold
from catopt.mooring.joints import Vector
from catopt.mooring.network_rest import LinesAtRest
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


def for_both(seed: int) -> Network:
    """Draw legs with bridles, clumps and buoys: uniform lines, a smooth bed, the body held."""
    draw = random.Random(seed)
    depth = draw.uniform(30.0, 400.0)
    heavy = draw.uniform(100.0, 2500.0)
    points: list[Point] = []
    lines: list[LineBetween] = []
    count = draw.randint(2, 4)

    def tie(start: Vector, end: Vector, names: tuple[str, str]) -> None:
        length = math.dist(start, end) * draw.uniform(0.995, 1.06)
        weight = heavy * 10.0 ** draw.uniform(-0.7, 0.3)
        segment = Segment(length, weight, EA=weight * length * 10.0 ** draw.uniform(2.0, 3.5))
        lines.append(LineBetween(Line([segment]), *names))

    for k in range(count):
        side = math.tau * (k + draw.uniform(-0.2, 0.2)) / count
        x, y = math.cos(side), math.sin(side)
        far, near = depth * draw.uniform(2.0, 4.0), depth * draw.uniform(0.6, 1.2)
        height = 0.7 * depth * draw.uniform(0.6, 1.0)
        anchor, joint = (far * x, far * y, 0.0), (near * x, near * y, height)
        points += [
            Point(f"a{k}", "anchor", *anchor),
            Point(f"j{k}", "joint", submerged_weight=heavy * depth * draw.uniform(-0.1, 0.2)),
        ]
        tie(anchor, joint, (f"a{k}", f"j{k}"))
        for across in draw.choice([(0.0,), (-0.1, 0.1), (-0.1, 0.0, 0.1)]):
            place = (0.2 * depth * x - across * depth * y, 0.2 * depth * y + across * depth * x)
            name = f"f{k}{across}"
            points.append(Point(name, "fairlead", *place, depth))
            tie(joint, (*place, depth), (f"j{k}", name))
    return Network(Site(1.5 * depth), tuple(points), tuple(lines), title=f"legs {seed}")


def floats_for_both(seed: int) -> Network:
    """Draw a ring of floats at the surface, each on a leg, tied to each other and pulled at."""
    draw = random.Random(f"floats {seed}")
    depth = draw.uniform(10.0, 200.0)
    heavy, count = draw.uniform(20.0, 500.0), draw.randint(3, 6)
    points: list[Point] = []
    lines: list[LineBetween] = []
    ring = depth * draw.uniform(0.5, 1.5)

    def tie(one: str, other: str, chord: float, slack: float) -> None:
        weight = heavy * 10.0 ** draw.uniform(-0.7, 0.3)
        segment = Segment(chord * slack, weight, EA=weight * chord * 10.0 ** draw.uniform(2.0, 3.5))
        lines.append(LineBetween(Line([segment]), one, other))

    sides = [math.tau * (k + draw.uniform(-0.2, 0.2)) / count for k in range(count)]
    for k, side in enumerate(sides):
        x, y, far = math.cos(side), math.sin(side), ring + depth * draw.uniform(1.5, 3.0)
        lift = heavy * depth * draw.uniform(1.0, 6.0)
        pull = (*(heavy * depth * draw.uniform(-0.2, 0.2) for _ in range(2)), 0.0)
        mass = lift * draw.uniform(0.05, 0.5) / STANDARD_GRAVITY
        height = depth * draw.uniform(0.005, 0.1)
        points += [
            Point(f"a{k}", "anchor", far * x, far * y, 0.0),
            Point(f"f{k}", "joint", None, None, None, -lift, pull, mass, height),
        ]
        tie(f"a{k}", f"f{k}", math.hypot(far - ring, depth), draw.uniform(1.0, 1.1))
    for k, side in enumerate(sides):
        after = (k + 1) % count
        chord = 2.0 * ring * abs(math.sin(0.5 * (sides[after] - side)))
        tie(f"f{k}", f"f{after}", chord, draw.uniform(0.99, 1.03))
    return Network(Site(depth), tuple(points), tuple(lines), title=f"floats {seed}")


def line_type(name: str, segment: Segment) -> dict[str, Any]:
    """Write a segment as MoorPy has it."""
    return {
        "name": name,
        "d_vol": 1e-9,
        "m": segment.submerged_weight / STANDARD_GRAVITY,
        "w": segment.submerged_weight,
        "EA": segment.EA,
        "EAd": 0.0,
        "EAd_Lm": 0.0,
        "cost": 0.0,
        "material": "",
        "MBL": 0.0,
    }


def by_moorpy(network: Network, near: LinesAtRest, draw: random.Random) -> Any | None:
    """Solve by MoorPy from up to 0.2 % of the depth away; None where it is off by itself.

    It takes the weight of a line from mass and volume: a line of no volume weighs its mass.
    """
    depth, g = network.site.water_depth, STANDARD_GRAVITY
    with warnings.catch_warnings(), redirect_stdout(io.StringIO()):
        warnings.simplefilter("ignore")
        system = moorpy.System(depth=depth, rho=network.site.water_density, g=g)
        for point, place in zip(network.points, near.joints.places, strict=True):
            x, y, z = (at + draw.uniform(-0.002, 0.002) * depth for at in place)
            free = point.kind == "joint"
            at = (x, y, max(z, 0.0) - depth) if free else (*place[:2], place[2] - depth)
            height = point.float_height
            pull = [*point.hung[:2], point.hung[2]] if free and not height else [0.0, 0.0, 0.0]
            system.addPoint(0 if free else 1, list(at), fExt=pull)
            if height:  # what it displaces is spread evenly over its height
                own = system.pointList[-1]
                own.m, own.v = point.mass, point.lost_above / (network.site.water_density * g)
                own.fExt, own.zSpan = list(point.force), [0.0, height]
        for k, line in enumerate(network.lines):
            (segment,) = line.line.segments
            name = f"type {k}"
            system.lineTypes[name] = line_type(name, segment)
            ends = (network.numbers[end] + 1 for end in (line.start, line.end))
            system.addLine(segment.length, name, pointA=next(ends), pointB=next(ends))
        try:
            system.initialize()
            system.solveEquilibrium(DOFtype="free", tol=1e-7, maxIter=40)
        except Exception:  # it has several; none is an answer
            return None
    strongest = max(max(line.TA, line.TB) for line in system.lineList)
    for point in system.pointList:
        lies = point.r[2] <= -depth + 1e-9
        if point.type == 0 and (lies or max(map(abs, point.getForces())) > 1e-6 * strongest):
            return None  # joints on its bed of springs are another model
    wrong = (is_wrong(line, depth, strongest) for line in system.lineList)
    return None if any(wrong) else system


def is_wrong(line: Any, depth: float, strongest: float) -> bool:
    """Whether MoorPy's line misses, between its own ends, what a line of the same figures pulls."""
    a, b = sorted((line.rA, line.rB), key=lambda end: float(end[2]))
    alone = solve(
        Line([Segment(line.L, line.type["w"], EA=line.type["EA"])]),
        height=float(b[2]) + depth,
        anchor_height=max(float(a[2]) + depth, 0.0),
        span=float(math.hypot(*(b - a)[:2])),
    )
    off = sorted([line.TA, line.TB])[1] - alone.fairlead.tension
    return bool(abs(off) > 1e-6 * strongest)


def compared_with_moorpy(
    seeds: range, drawn: Callable[[int], Network] = for_both
) -> tuple[int, list[str]]:
    """How many networks both solve, and where they differ."""
    both, unlike = 0, []
    for seed in seeds:
        try:
            network = drawn(seed)
            ours = at_rest(network)
        except CatoptError:
            continue
        if any(each.horizontal_force == 0.0 for each in ours.lines):
            continue  # of slack lines it has another model
        system = by_moorpy(network, ours, random.Random(seed))
        if system is None:
            continue
        both += 1
        strongest = max(line.fairlead.tension for line in ours.lines)
        for line, own in zip(system.lineList, ours.lines, strict=True):
            pair = sorted([line.TA, line.TB]), sorted([own.anchor.tension, own.fairlead.tension])
            off = max(abs(a - b) for a, b in zip(*pair, strict=True)) / strongest
            if off > 1e-5:
                unlike.append(f"{network.title}, line {line.number}: {off:.1e}, {pair}")
    return both, unlike


def test_random_networks() -> None:
    """Its forces are left at 1e-6 of the largest; soft lines turn that into some 1e-5 of others."""
    both, unlike = compared_with_moorpy(range(12))
    assert unlike == []
    assert both >= 6


@pytest.mark.slow
def test_three_hundred_random_networks() -> None:
    both, unlike = compared_with_moorpy(range(1000, 1500))
    assert unlike == []
    assert both >= 300


def test_random_networks_with_floats_at_the_surface() -> None:
    both, unlike = compared_with_moorpy(range(8), floats_for_both)
    assert unlike == []
    assert both >= 4


@pytest.mark.slow
def test_three_hundred_random_networks_with_floats_at_the_surface() -> None:
    both, unlike = compared_with_moorpy(range(600), floats_for_both)
    assert unlike == []
    assert both >= 300


def raft_for_both(seed: int) -> Network:
    """Draw a raft that floats deeper as its legs pull; it does not turn."""
    draw = random.Random(f"raft {seed}")
    depth, heavy = draw.uniform(10.0, 200.0), draw.uniform(20.0, 500.0)
    count, arm = draw.randint(3, 6), depth * draw.uniform(0.05, 0.5)
    points: list[Point] = []
    lines: list[LineBetween] = []
    for k in range(count):
        side = math.tau * (k + draw.uniform(-0.2, 0.2)) / count
        x, y, away = math.cos(side), math.sin(side), depth * draw.uniform(1.5, 3.0)
        high = depth * draw.choice([0.0, 0.3, 1.2])  # on the bed, up the bank, above the water
        chord = math.hypot(away, depth - high)
        points += [
            Point(f"a{k}", "anchor", (arm + away) * x, (arm + away) * y, high),
            Point(f"f{k}", "fairlead", arm * x, arm * y, depth, body="raft"),
        ]
        weight = heavy * 10.0 ** draw.uniform(-0.7, 0.3)
        stiffness = weight * chord * 10.0 ** draw.uniform(2.0, 3.5)
        segment = Segment(chord * draw.uniform(1.0, 1.08), weight, EA=stiffness)
        lines.append(LineBetween(Line([segment]), f"a{k}", f"f{k}"))
    draught, freeboard = (depth * draw.uniform(0.01, 0.2) for _ in range(2))
    body = MooredBody(
        "raft",
        force=(heavy * depth * draw.uniform(-0.5, 0.5), heavy * depth * draw.uniform(-0.5, 0.5)),
        yaw_free=False,
        waterplane_area=heavy * 10.0 ** draw.uniform(-3.0, -1.0),
        draught=draught,
        freeboard=freeboard,
    )
    site = Site(depth)
    return Network(site, tuple(points), tuple(lines), title=f"raft {seed}", bodies=(body,))


def raft_by_moorpy(network: Network, near: LinesAtRest) -> Any | None:
    """Solve a raft by MoorPy, upright and without yaw; None where it is off by itself."""
    depth, g = network.site.water_depth, STANDARD_GRAVITY
    (body,), (rest,) = network.bodies, near.bodies
    area, draught, _ = body.afloat
    with warnings.catch_warnings(), redirect_stdout(io.StringIO()):
        warnings.simplefilter("ignore")
        system = moorpy.System(depth=depth, rho=network.site.water_density, g=g)
        # Of its own weight and what it displaces without lines nothing is left at height 0.
        place = [rest.position.x, rest.position.y, rest.rise, 0.0, 0.0, 0.0]
        volume = area * draught
        mass = network.site.water_density * volume
        force = np.array([*body.force, 0.0, 0.0, 0.0, 0.0])
        system.addBody(0, place, m=mass, v=volume, AWP=area, f6Ext=force, DOFs=[0, 1, 2])
        for point in network.points:
            x, y, z = point.place
            if point.kind == "fairlead":
                system.addPoint(1, [x, y, z - depth], body=1)
            else:
                system.addPoint(1, [x, y, z - depth])
        for k, line in enumerate(network.lines):
            (segment,) = line.line.segments
            system.lineTypes[f"type {k}"] = line_type(f"type {k}", segment)
            ends = (network.numbers[end] + 1 for end in (line.start, line.end))
            system.addLine(segment.length, f"type {k}", pointA=next(ends), pointB=next(ends))
        try:
            system.initialize()
            system.solveEquilibrium(DOFtype="free", tol=1e-7, maxIter=40)
        except Exception:  # as above
            return None
    strongest = max(max(line.TA, line.TB) for line in system.lineList)
    left = np.abs(system.bodyList[0].getForces()[:3]).max()
    is_off = left > 1e-5 * strongest
    is_off |= any(is_wrong(line, depth, strongest) for line in system.lineList)
    return None if is_off else system


def rafts_compared(seeds: range) -> tuple[int, list[str]]:
    """How many rafts both solve, and where they differ."""
    both, unlike = 0, []
    for seed in seeds:
        try:
            ours = at_rest(raft_for_both(seed))
        except CatoptError:
            continue
        (rest,) = ours.bodies
        if rest.floating.under or rest.rise > 0.9 * rest.body.afloat[1]:
            continue  # MoorPy's waterplane goes on for ever
        if any(each.horizontal_force == 0.0 for each in ours.lines):
            continue
        system = raft_by_moorpy(ours.network, ours)
        if system is None:
            continue
        both += 1
        strongest = max(max(each.fairlead.tension, each.anchor.tension) for each in ours.lines)
        for line, own in zip(system.lineList, ours.lines, strict=True):
            pair = sorted([line.TA, line.TB]), sorted([own.anchor.tension, own.fairlead.tension])
            off = max(abs(a - b) for a, b in zip(*pair, strict=True)) / strongest
            if off > 1e-5:
                unlike.append(f"{ours.network.title}, line {line.number}: {off:.1e}, {pair}")
        depth = ours.network.site.water_depth
        if abs(system.bodyList[0].r6[2] - rest.rise) > 1e-5 * depth:
            unlike.append(f"{ours.network.title}: {system.bodyList[0].r6[2]} m, {rest.rise} m")
    return both, unlike


def test_random_rafts() -> None:
    both, unlike = rafts_compared(range(10))
    assert unlike == []
    assert both >= 5


@pytest.mark.slow
def test_three_hundred_random_rafts() -> None:
    both, unlike = rafts_compared(range(500))
    assert unlike == []
    assert both >= 300
