"""Random mooring lines of every kind, from a seed."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from catopt.model import Line, PointLoad, Segment


@dataclass(frozen=True)
class RandomLine:
    """A line and where it is moored."""

    line: Line
    height: float
    anchor_height: float
    seabed_friction: float
    horizontal_force: float


def random_setting(seed: int, *, buoyant: bool = False, raised: bool | None = None) -> RandomLine:
    """Draw a line: 1 to 5 segments, 0 to 3 point loads, weights of neighbours 1 to 1000 apart."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(1, 6))
    scale = 10.0 ** rng.uniform(0.5, 3.2)
    weight = 10.0 ** rng.uniform(0.0, 3.5)
    segments = [
        Segment(
            length=scale * 10.0 ** rng.uniform(-1.5, 0.0),
            submerged_weight=weight * 10.0 ** rng.uniform(-3.0, 0.0) * _sign(rng, buoyant),
            EA=math.inf if rng.random() < 0.4 else weight * scale * 10.0 ** rng.uniform(0.5, 5.0),
        )
        for _ in range(count)
    ]
    length = math.fsum(segment.length for segment in segments)
    total = sum(abs(s.submerged_weight) * s.length for s in segments)
    loads = [
        PointLoad(
            position=float(rng.uniform(0.02, 0.98)) * length,
            submerged_weight=total * 10.0 ** rng.uniform(-2.5, 0.3) * _sign(rng, buoyant),
        )
        for _ in range(int(rng.integers(0, 4)) if rng.random() < 0.6 else 0)
    ]
    is_raised = rng.random() < 0.3 if raised is None else raised
    steepness = rng.choice([rng.uniform(0.05, 0.9), 0.999, 0.01])
    height = float(length * steepness)
    anchor_height = float(rng.uniform(0.0, 0.4)) * length if is_raised else 0.0
    if is_raised and rng.random() < 0.3:
        height, anchor_height = anchor_height, min(height, 0.9 * length)
    return RandomLine(
        line=Line(segments, loads),
        height=height,
        anchor_height=anchor_height,
        seabed_friction=float(rng.choice([0.0, rng.uniform(0.1, 1.2)])),
        horizontal_force=float(total * 10.0 ** rng.uniform(-4.0, 3.0)),
    )


def moderate_setting(seed: int) -> RandomLine:
    """Draw a line as they are built: L/h 1.05 to 5, 1 to 4 segments, 0 to 2 clump weights.

    Weights of segments 1 to 30 apart, half of the lines elastic, half of them on a rough bed.
    """
    rng = np.random.default_rng(seed)
    height = 10.0 ** rng.uniform(0.7, 2.7)
    length = height * (1.0 + 0.05 * 80.0 ** rng.random())
    parts = rng.uniform(0.1, 1.0, int(rng.integers(1, 5)))
    parts *= length / parts.sum()
    weights = 1000.0 * 30.0 ** -rng.random(len(parts))
    total = float(parts @ weights)
    EA = total * 10.0 ** rng.uniform(1.5, 4.0) if rng.random() < 0.5 else math.inf
    segments = [
        Segment(float(part), float(weight), EA) for part, weight in zip(parts, weights, strict=True)
    ]
    loads = [
        PointLoad(float(rng.uniform(0.05, 0.95)) * length, total * 10.0 ** rng.uniform(-1.5, 0.0))
        for _ in range(int(rng.integers(0, 3)))
    ]
    return RandomLine(
        line=Line(segments, loads),
        height=height,
        anchor_height=0.0,
        seabed_friction=float(rng.choice([0.0, rng.uniform(0.1, 1.2)])),
        horizontal_force=total * height / length * 10.0 ** rng.uniform(-1.0, 1.5),
    )


def _sign(rng: np.random.Generator, buoyant: bool) -> float:
    return -1.0 if buoyant and rng.random() < 0.3 else 1.0
