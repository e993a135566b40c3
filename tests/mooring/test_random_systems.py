"""Systems of every kind, drawn at random: each comes to rest, and rests."""

from __future__ import annotations

import math
import random

import pytest

from catopt import Line, PointLoad, Segment, System, solve_system
from catopt.model import Leg
from tests.mooring.layouts import total, unbalanced

EA = {"inextensible": (math.inf,), "chain": (8e8,), "taut": (3e7,), "mixed": (math.inf, 5e8)}


def drawn(kind: str, draw: random.Random) -> System:
    """One to eight lines of one kind, in any place around the body, slack to taut."""
    height, count = draw.uniform(10.0, 300.0), draw.choice([1, 2, 3, 4, 6, 8])
    radius, fairlead_radius = height * draw.uniform(1.5, 15.0), draw.choice([0.0, 5.0, 20.0])
    legs = []
    for k in range(count):
        anchor_radius = max(radius * draw.uniform(0.8, 1.2), 2.0 * fairlead_radius)
        chord = math.hypot(anchor_radius - fairlead_radius, height)
        taut = kind == "taut"
        length = chord * (draw.uniform(0.97, 1.0) if taut else draw.uniform(1.005, 1.2))
        weight = draw.uniform(20.0, 200.0) if taut else draw.uniform(50.0, 2000.0)
        stiffness = draw.choice(EA[kind])
        segments = [
            Segment(0.6 * length, weight, EA=stiffness),
            Segment(0.4 * length, weight * draw.uniform(0.2, 2.0), EA=stiffness),
        ]
        clump = PointLoad(length * draw.uniform(0.1, 0.9), draw.uniform(0.0, 2e5))
        legs.append(
            Leg(
                Line(segments, [clump] if draw.random() < 0.3 else []),
                2.0 * math.pi * k / count + draw.uniform(-0.3, 0.3),
                anchor_radius,
                height,
                anchor_height=draw.choice([0.0, 0.0, 5.0]),
                fairlead_radius=fairlead_radius,
            )
        )
    force, side = 10.0 ** draw.uniform(3.0, 7.0), draw.uniform(0.0, 2.0 * math.pi)
    return System(
        tuple(legs),
        (force * math.cos(side), force * math.sin(side)),
        seabed_friction=draw.choice([0.0, 0.5]),
    )


@pytest.mark.parametrize("count", [4, pytest.param(25, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", EA)
def test_each_rests(kind: str, count: int) -> None:
    draw = random.Random(7)
    for index in range(count):
        system = drawn(kind, draw)
        solution = solve_system(system)
        x, y, moment = unbalanced(solution)
        forces = total(solution) + math.hypot(*system.force)
        # 1e-8: the solver's own limit is 1e-9 where rounding bars the way; a line that does not
        # stretch, close to its end, has its span to 1e-13 and its force to 1e-9 of themselves.
        assert math.hypot(x, y) <= 1e-8 * forces, index
        if system.turns:
            assert abs(moment) <= 1e-8 * forces * system.legs[0].fairlead_radius, index
            (xx, xy, xm), (_, yy, ym), (_, _, mm) = solution.full_stiffness
            plane = xx * yy - xy * xy
            if plane > 0.0:  # the body, turned a little, turns back: the Schur complement
                back = mm - (yy * xm * xm - 2.0 * xy * xm * ym + xx * ym * ym) / plane
                assert back >= -1e-9 * abs(mm), index
