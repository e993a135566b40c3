"""Random networks of every kind: 2 to 24 lines, joints, unequal and slack lines, floats, bodies."""

from __future__ import annotations

import itertools
import math
import random
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from catopt.constants import STANDARD_GRAVITY
from catopt.model import Line, PointLoad, Segment, Site
from catopt.model.network import LineBetween, MooredBody, Network, Point

KINDS = ("crowfoot", "bodies", "grid", "floats", "chain of joints")


def drawn(seed: int) -> Network:
    """Draw a network of any kind."""
    draw = random.Random(seed)
    made = _Drawing(draw)
    {
        "crowfoot": made.crowfoot,
        "bodies": made.bodies,
        "grid": made.grid,
        "floats": made.floats,
        "chain of joints": made.joints_in_a_row,
    }[KINDS[seed % len(KINDS)]]()
    return made.network(f"{KINDS[seed % len(KINDS)]} {seed}")


def drawn_afloat(seed: int) -> Network:
    """Draw a network of any kind in water so shallow that floats come up; some have a height.

    Most bodies float by their draught and freeboard, or are pulled under.
    """
    network, draw = drawn(seed), random.Random(f"afloat {seed}")
    depth = network.site.water_depth * draw.choice([0.25, 0.5, 0.75, 1.0])
    points = []
    for point in network.points:
        own: dict[str, Any] = {}
        if point.is_float and draw.random() < 0.7:
            own["mass"] = draw.uniform(0.0, 1.0) * -point.submerged_weight / STANDARD_GRAVITY
            if draw.random() < 0.5:
                own["float_height"] = depth * draw.uniform(1e-3, 0.3)
        points.append(replace(point, **own))
    site, sides = replace(network.site, water_depth=depth), random.Random(f"bodies {seed}")
    bodies = tuple(_afloat(body, network, depth, sides) for body in network.bodies)
    return replace(network, site=site, points=tuple(points), bodies=bodies)


def _afloat(body: MooredBody, network: Network, depth: float, draw: random.Random) -> MooredBody:
    """Give most bodies a waterplane, by a reserve of buoyancy beside the weight of their lines."""
    if draw.random() < 0.3:
        return body
    weight = sum(abs(line.line.submerged_weight) for line in network.lines)
    draught, freeboard = (depth * draw.uniform(0.005, 0.1) for _ in range(2))
    reserve = weight * 10.0 ** draw.uniform(-1.0, 1.5)
    area = reserve / (network.site.water_density * STANDARD_GRAVITY * freeboard)
    return replace(body, waterplane_area=area, draught=draught, freeboard=freeboard)


class _Drawing:
    """Points, lines and bodies as they are drawn, and about where each point will be."""

    def __init__(self, draw: random.Random) -> None:
        self.draw = draw
        self.depth = draw.choice([20.0, 60.0, 150.0, 400.0]) * draw.uniform(0.7, 1.4)
        self.friction = draw.choice([0.0, 0.0, 0.6])
        self.weight = draw.uniform(100.0, 2500.0)
        self.points: list[Point] = []
        self.about: dict[str, tuple[float, float, float]] = {}
        self.lines: list[LineBetween] = []
        self.loaded: list[MooredBody] = []

    def network(self, title: str) -> Network:
        return Network(
            Site(self.depth, self.friction),
            tuple(self.points),
            tuple(self.lines),
            title=title,
            bodies=tuple(self.loaded),
        )

    def anchor(self, x: float, y: float) -> str:
        height = self.draw.choice([0.0, 0.0, 0.0, 0.1 * self.depth])
        return self.add(Point(f"a{len(self.points)}", "anchor", x, y, height), (x, y, height))

    def fairlead(self, x: float, y: float, height: float, body: str = "") -> str:
        name = f"f{len(self.points)}"
        return self.add(Point(name, "fairlead", x, y, height, body=body), (x, y, height))

    def joint(self, x: float, y: float, z: float, weight: float, force: float = 0.0) -> str:
        side = self.draw.uniform(0.0, math.tau)
        pull = (force * math.cos(side), force * math.sin(side), 0.0)
        point = Point(f"j{len(self.points)}", "joint", submerged_weight=weight, force=pull)
        return self.add(point, (x, y, z))

    def add(self, point: Point, about: tuple[float, float, float]) -> str:
        self.points.append(point)
        self.about[point.name] = about
        return point.name

    def tie(self, start: str, end: str, slack: tuple[float, float] = (0.99, 1.15)) -> None:
        """Lay a line of one to three segments between two points, taut to slack."""
        draw = self.draw
        chord = math.dist(self.about[start], self.about[end])
        length = chord * draw.uniform(*slack)
        if draw.random() < 0.12:
            length = chord * draw.uniform(1.2, 1.9)
        parts = [draw.uniform(0.2, 1.0) for _ in range(draw.choice([1, 1, 1, 2, 3]))]
        segments = []
        for part in parts:
            weight = self.weight * 10.0 ** draw.uniform(-1.0, 0.3)
            stiffness = weight * 10.0 ** draw.uniform(4.0, 6.0)
            segments.append(Segment(length * part / sum(parts), weight, EA=stiffness))
        loads = []
        if draw.random() < 0.2:
            size = self.weight * chord * draw.uniform(-0.1, 0.4)
            loads.append(PointLoad(length * draw.uniform(0.15, 0.85), size))
        if draw.random() < 0.5:
            start, end = end, start
        self.lines.append(LineBetween(Line(segments, loads), start, end))

    def legs(self, ends: list[str]) -> None:
        """Tie points to anchors of their own, each outwards of it."""
        for name in ends:
            x, y, z = self.about[name]
            side = math.atan2(y, x) + self.draw.uniform(-0.4, 0.4)
            away = max(z, 0.2 * self.depth) * self.draw.uniform(1.5, 7.0)
            self.tie(self.anchor(x + away * math.cos(side), y + away * math.sin(side)), name)

    def ring(self, count: int, radius: float) -> list[tuple[float, float]]:
        turn = self.draw.uniform(0.0, math.tau)
        sides = [turn + math.tau * (k + self.draw.uniform(-0.2, 0.2)) / count for k in range(count)]
        return [(radius * math.cos(side), radius * math.sin(side)) for side in sides]

    def heavy(self, part: float) -> float:
        return self.weight * self.depth * part

    def crowfoot(self) -> None:
        """Split legs into two or three before a body that is held, or free."""
        draw = self.draw
        height = self.depth * draw.uniform(0.7, 1.0)
        body = draw.choice(["", "body"])
        radius = self.depth * draw.uniform(0.05, 0.3)
        for x, y in self.ring(draw.randint(2, 6), 3.0 * radius):
            weight = self.heavy(draw.choice([0.0, draw.uniform(-0.1, 0.5)]))
            joint = self.joint(x, y, 0.7 * height, weight)
            for across in draw.choice([(-0.4, 0.4), (-0.4, 0.0, 0.4)]):
                at = (0.3 * x - across * y, 0.3 * y + across * x)
                self.tie(joint, self.fairlead(*at, height, body), (0.98, 1.08))
            self.legs([joint])
        if body:
            self.load(body, self.heavy(draw.choice([0.0, 0.3, 2.0])))

    def load(self, name: str, force: float, x: float = 0.0, y: float = 0.0) -> None:
        side = self.draw.uniform(0.0, math.tau)
        along = (force * math.cos(side), force * math.sin(side))
        self.loaded.append(MooredBody(name, x, y, along))

    def bodies(self) -> None:
        """Moor one to three bodies on unequal legs, with lines between them."""
        draw, names = self.draw, []
        height = self.depth * draw.uniform(0.8, 1.0)
        count = draw.randint(1, 3)
        for k in range(count):
            x, y = 2.5 * self.depth * k, draw.uniform(-0.5, 0.5) * self.depth
            arm = self.depth * draw.uniform(0.05, 0.3)
            names.append(f"body {k}")
            for at in self.ring(draw.randint(3, 24 // count - 2), arm):
                fairlead = self.fairlead(x + at[0], y + at[1], height, names[k])
                away = self.depth * draw.uniform(2.0, 6.0) / arm
                self.tie(self.anchor(x + at[0] * away, y + at[1] * away), fairlead)
            self.load(names[k], self.heavy(draw.choice([0.0, 0.5, 3.0])), x, y)
        for one, other in itertools.pairwise(names):
            ends = [[p.name for p in self.points if p.body == name] for name in (one, other)]
            self.tie(draw.choice(ends[0]), draw.choice(ends[1]), (1.0, 1.2))

    def grid(self) -> None:
        """Tie a ring of floats to each other, each on a leg; a net pulls at them."""
        draw = self.draw
        count = draw.randint(3, 7)
        radius = self.depth * draw.uniform(0.5, 2.0)
        joints = [
            self.joint(
                *at,
                0.7 * self.depth,
                -self.heavy(draw.uniform(0.05, 0.6)),
                self.heavy(draw.choice([0.0, 0.3])),
            )
            for at in self.ring(count, radius)
        ]
        for one, other in zip(joints, joints[1:] + joints[:1], strict=True):
            self.tie(one, other, (0.97, 1.05))
        if draw.random() < 0.5:
            hub = self.joint(0.0, 0.0, 0.6 * self.depth, -self.heavy(0.1))
            for each in joints:
                self.tie(hub, each, (0.97, 1.1))
        self.legs(joints)

    def floats(self) -> None:
        """Hold floats below the surface on one to four lines each."""
        draw = self.draw
        for k in range(draw.randint(1, 5)):
            x, z = 4.0 * self.depth * k, self.depth * draw.uniform(0.3, 0.8)
            lift = -self.heavy(draw.uniform(1.5, 4.0))
            name = self.joint(x, 0.0, z, lift, self.heavy(draw.choice([0.0, 0.5])))
            for at in self.ring(draw.randint(1, 4), z * draw.uniform(0.3, 2.0)):
                self.tie(self.anchor(x + at[0], at[1]), name, (0.9, 1.02))
        if len(self.lines) == 1:
            self.tie(self.anchor(-self.depth, 0.0), self.points[0].name, (0.9, 1.02))

    def joints_in_a_row(self) -> None:
        """Lay many joints between an anchor and a fairlead, some held from the side."""
        draw = self.draw
        count, away = draw.randint(2, 8), self.depth * draw.uniform(2.0, 6.0)
        before = self.anchor(away, 0.0)
        for k in range(count):
            part = (k + 1) / (count + 1)
            place = (away * (1.0 - part), 0.0, self.depth * part * draw.uniform(0.4, 1.0))
            joint = self.joint(*place, self.heavy(draw.uniform(-0.3, 0.5)))
            self.tie(before, joint, (1.0, 1.1))
            if draw.random() < 0.4:
                side = draw.choice([-1.0, 1.0]) * draw.uniform(1.5, 4.0) * self.depth
                self.tie(self.anchor(place[0], side), joint, (1.0, 1.2))
            before = joint
        self.tie(before, self.fairlead(0.0, 0.0, self.depth), (1.0, 1.1))


def counted(
    count: int,
    first: int,
    tell: Callable[[str], object],
    judged: Callable[[int], tuple[str, str]],
) -> int:
    """Judge networks by their seeds; `judged` says what came of one, and what is wrong with it.

    Tells of each with something wrong, and how many came to what. Returns how many had.
    """
    counts: Counter[str] = Counter()
    failures = 0
    for seed in range(first, first + count):
        came, fault = judged(seed)
        counts[f"{KINDS[seed % len(KINDS)]}: {came}"] += 1
        failures += bool(fault)
        if fault:
            tell(f"network {seed}: {fault}")
    for name, value in sorted(counts.items()):
        tell(f"{name:>30}{value:>10,}")
    return failures
