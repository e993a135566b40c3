"""Cases with spaces of whole moorings: equal chains about a body, under a force from many sides."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from catopt.model import Case, Checks, Design, Line, Segment, SegmentChoice, Site, System

SIX = tuple(math.radians(60.0 * number) for number in range(6))
LINE = Line([Segment(620.0, 1500.0, EA=8e8, mass=180.0, MBL=6e6)])
DEPTH, HEIGHT = 70.0, 68.0


def mooring_case(
    *,
    force: tuple[float, float] = (1.5e6, 0.0),
    azimuths: tuple[float, ...] = SIX,
    fairlead_radius: float = 0.0,
    yaw_free: bool | None = None,
    friction: float = 0.3,
    checks: Checks | None = None,
    **changes: Any,
) -> Case:
    """Case of 72 designs; changes go to its `Design`."""
    design: dict[str, Any] = {
        "segments": (
            SegmentChoice(
                lengths=(600.0, 630.0, 660.0),
                components=("chain studless R3", "chain studless R4"),
                diameters=(0.076, 0.1, 0.12),
            ),
        ),
        "lines": (4, 6),
        "anchor_radii": (600.0, 620.0),
        "headings": 12,
        "line_out": True,
    }
    system = System.around(
        LINE,
        azimuths=azimuths,
        anchor_radius=600.0,
        fairlead_height=HEIGHT,
        force=force,
        fairlead_radius=fairlead_radius,
        seabed_friction=friction,
        yaw_free=yaw_free,
    )
    default = Checks(safety_factor=1.67, safety_factor_line_out=1.25, max_anchor_uplift_angle=0.0)
    return Case(
        Site(DEPTH, seabed_friction=friction),
        LINE,
        None,
        HEIGHT,
        checks=checks or default,
        system=system,
        design=Design(**design | changes),
    )


def random_case(seed: int, designs: int) -> Case:
    """Draw a space of about so many designs: depth apart, everything varies."""
    draw = np.random.default_rng(seed)
    around = int(draw.integers(3, 8))
    lines = tuple(sorted({around, around + int(draw.integers(1, 3))}))
    sizes = np.sort(draw.choice(np.arange(0.06, 0.14, 0.002), 6, replace=False))
    radii = np.sort(draw.uniform(500.0, 640.0, 6))
    many = max(2, round(designs / (2 * len(sizes) * len(lines) * len(radii))))
    lengths = np.sort(draw.uniform(radii[0] - 20.0, radii[-1] + 60.0, many))
    arm = float(draw.choice([0.0, 6.0]))
    direction = draw.uniform(0.0, 2.0 * math.pi)
    size = float(draw.uniform(0.3e6, 2.5e6))
    first = float(draw.uniform(0.0, 1.0))
    return mooring_case(
        force=(size * math.cos(direction), size * math.sin(direction)),
        azimuths=(first,),
        fairlead_radius=arm,
        yaw_free=False,
        friction=float(draw.choice([0.0, 0.5])),
        segments=(
            SegmentChoice(
                tuple(lengths.tolist()),
                ("chain studless R3", "chain studless R4"),
                tuple(sizes.tolist()),
            ),
        ),
        lines=lines,
        anchor_radii=tuple(radii.tolist()),
        headings=int(draw.choice([1, 4, 8, 12])),
        line_out=bool(draw.integers(2)) or around > 5,
    )
