"""Systems drawn at random: 1 to 24 lines, on the origin or on arms, with and without moments."""

from __future__ import annotations

import math
import random

from catopt import Line, PointLoad, Segment, System
from catopt.model import Leg

__all__ = ["drawn_system"]

COUNTS = (1, 1, 2, 2, 3, 3, 4, 4, 6, 8, 9, 12, 24)
EA = {"inextensible": (math.inf,), "chain": (8e8,), "taut": (3e7,), "mixed": (math.inf, 5e8)}


def drawn_system(draw: random.Random) -> System:
    """One system, slack to taut, whose lines all reach their fairleads at the origin."""
    kind, count = draw.choice(list(EA)), draw.choice(COUNTS)
    height = draw.uniform(10.0, 300.0)
    arm = draw.choice([0.0, 3.0, 8.0, 20.0, 40.0])
    radius = max(height * draw.uniform(1.0, 12.0), 2.5 * arm)
    is_alike, lay = draw.random() < 0.4, draw.choice(["outwards", "aside", "anywhere"])
    anchor_height = 5.0 if count < 5 and draw.random() < 0.02 else 0.0
    legs: list[Leg] = []
    for k in range(count):
        azimuth = 2.0 * math.pi * k / count + draw.uniform(-0.3, 0.3)
        anchor_radius = radius if is_alike else radius * draw.uniform(0.85, 1.2)
        line = legs[0].line if is_alike and legs else _line(kind, draw, anchor_radius, arm, height)
        aside = {"outwards": 0.0, "aside": 0.9, "anywhere": draw.uniform(-math.pi, math.pi)}[lay]
        legs.append(
            Leg(
                line,
                azimuth,
                anchor_radius,
                height,
                anchor_height=anchor_height,
                fairlead_radius=arm,
                fairlead_azimuth=azimuth + aside,
            )
        )
    weight = sum(s.length * s.submerged_weight for leg in legs for s in leg.line.segments)
    force = 0.0 if draw.random() < 0.1 else weight / count * 10.0 ** draw.uniform(-3.0, 1.0)
    side = draw.uniform(0.0, 2.0 * math.pi)
    moment = 0.0
    if arm > 0.0 and draw.random() < 0.85:
        most = arm * (force + 0.3 * weight)
        moment = most * draw.choice([-1.0, 1.0]) * 10.0 ** draw.uniform(-3.0, 0.0)
    return System(
        tuple(legs),
        (force * math.cos(side), force * math.sin(side)),
        moment,
        seabed_friction=draw.choice([0.0, 0.5, 1.0]),
    )


def _line(kind: str, draw: random.Random, radius: float, arm: float, height: float) -> Line:
    reach = math.hypot(radius + arm, height)
    is_taut = kind == "taut" and draw.random() < 0.5
    length = reach * (draw.uniform(0.97, 1.0) if is_taut else draw.uniform(1.003, 1.25))
    weight = draw.uniform(20.0, 200.0) if kind == "taut" else draw.uniform(50.0, 2000.0)
    stiffness = draw.choice(EA[kind])
    count = draw.choice([1, 2, 3])
    segments = [
        Segment(length / count, weight * (draw.uniform(0.2, 2.0) if k else 1.0), EA=stiffness)
        for k in range(count)
    ]
    clump = PointLoad(length * draw.uniform(0.1, 0.9), draw.uniform(0.0, 2e5))
    return Line(segments, [clump] if draw.random() < 0.3 else [])
