"""Systems that the tests of moored bodies share."""

from __future__ import annotations

import math
from collections.abc import Sequence

from catopt.model import Leg, Line, Segment, System
from catopt.mooring.solution import SystemSolution

G0 = 9.80665

FSO_AZIMUTHS = tuple(math.radians(a) for a in (-3, 0, 3, 117, 120, 123, 237, 240, 243))
FSO_LEG = Line(
    [
        Segment(750.0, 30.4 * G0, EA=382.09e6, MBL=6140e3, name="wire 95 mm"),
        Segment(194.0, 137.2 * G0, EA=721.98e6, MBL=6230e3, name="chain 89 mm"),
        Segment(80.0, 155.4 * G0, EA=801.2e6, MBL=6140e3, name="chain 95 mm"),
        Segment(58.0, 155.4 * G0, EA=801.2e6, MBL=6140e3, name="chain 95 mm"),
    ]
)
"""S4, chapter 4: the figures of reproduce/published.toml [fso_rang_dong], from the anchor."""


def fso(
    force: tuple[float, float] = (0.0, 0.0),
    *,
    azimuths: Sequence[float] = FSO_AZIMUTHS,
    fairlead_radius: float = 0.0,
    moment: float = 0.0,
    turned: float = 0.0,
) -> System:
    """FSO Rang Dong on a bed that only pushes; `turned` rad about the origin, load and all."""
    cosine, sine = math.cos(turned), math.sin(turned)
    return System.around(
        FSO_LEG,
        azimuths=[azimuth + turned for azimuth in azimuths],
        anchor_radius=1056.0,
        fairlead_height=71.4,
        fairlead_radius=fairlead_radius,
        force=(cosine * force[0] - sine * force[1], sine * force[0] + cosine * force[1]),
        moment=moment,
    )


CHAIN = Line([Segment(600.0, 1000.0, EA=8e8)])


def spread(
    lines: int,
    force: tuple[float, float] = (0.0, 0.0),
    *,
    line: Line = CHAIN,
    friction: float = 0.0,
) -> System:
    """Equal lines, evenly spaced from x."""
    return System.around(
        line,
        azimuths=[2.0 * math.pi * k / lines for k in range(lines)],
        anchor_radius=560.0,
        fairlead_height=50.0,
        seabed_friction=friction,
        force=force,
    )


def unbalanced(solution: SystemSolution) -> tuple[float, float, float]:
    """Force and moment left on the body, from the lines as they were laid out; N, N, N m."""
    x, y = solution.system.force
    moment = solution.system.moment
    for line in solution.lines:
        pull_x = line.horizontal_force * math.cos(line.direction)
        pull_y = line.horizontal_force * math.sin(line.direction)
        arm_x = line.fairlead[0] - solution.position.x
        arm_y = line.fairlead[1] - solution.position.y
        x += pull_x
        y += pull_y
        moment += arm_x * pull_y - arm_y * pull_x
    return x, y, moment


def total(solution: SystemSolution) -> float:
    return math.fsum(line.horizontal_force for line in solution.lines)


def unequal_legs(one: Line, other: Line) -> tuple[Leg, ...]:
    """Lay two lines in turn round a body, on fairleads of different heights."""
    return tuple(
        Leg.between(
            line,
            anchor=(400.0 * math.cos(at), 400.0 * math.sin(at)),
            fairlead=(9.0 * math.cos(at + 0.2), 9.0 * math.sin(at + 0.2)),
            fairlead_height=height,
        )
        for line, at, height in (
            (one, 0.1, 70.0),
            (other, 1.4, 74.0),
            (one, 3.3, 78.0),
            (other, 4.6, 70.0),
        )
    )
