"""Random mooring lines as they are built, from a seed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from catopt.model import Line, PointLoad, Segment


@dataclass(frozen=True)
class Moored:
    """A line and how it is moored, without its load.

    Attributes
    ----------
    line : Line
        The line.
    setting : dict
        height, seabed_friction and anchor_height, as both solvers take them.
    horizontal_force : float
        N.
    """

    line: Line
    setting: dict[str, Any]
    horizontal_force: float


def moored_line(seed: int) -> Moored:
    """Draw a line: 1 to 3 segments, 0 to 2 clump weights, from slack on the bed to taut.

    Depth 20 to 600 m, 1.1 to 4 times as much line, weights of segments up to 10 apart, a third
    of the lines inextensible, half of them on a rough bed, a tenth with a
    raised anchor and no friction.
    """
    rng = np.random.default_rng(seed)
    height = 20.0 * 30.0 ** rng.random()
    length = height * 1.1 * (4.0 / 1.1) ** rng.random()
    parts = rng.uniform(0.3, 1.0, int(rng.integers(1, 4)))
    parts *= length / parts.sum()
    weights = 3000.0 * 10.0 ** -rng.random(len(parts))
    total = float(parts @ weights)
    EA = math.inf if rng.random() < 1 / 3 else total * 10.0 ** rng.uniform(1.5, 4.0)
    segments = [Segment(float(a), float(w), EA) for a, w in zip(parts, weights, strict=True)]
    loads = [
        PointLoad(float(rng.uniform(0.1, 0.9)) * length, total * 10.0 ** rng.uniform(-2.0, -0.5))
        for _ in range(int(rng.integers(0, 3)))
    ]
    is_raised = rng.random() < 0.1
    friction = 0.0 if is_raised else float(rng.choice([0.0, rng.uniform(0.2, 1.0)]))
    return Moored(
        line=Line(segments, loads),
        setting={
            "height": height,
            "seabed_friction": friction,
            "anchor_height": 0.2 * height if is_raised else 0.0,
        },
        horizontal_force=total * height / length * 10.0 ** rng.uniform(-0.5, 1.0),
    )
