"""Lines of every kind, by name; N and m."""

from __future__ import annotations

import math

from catopt.model import Case, Line, Load, PointLoad, Segment, Site

EA = 5e8


def moored(
    segments: list[tuple[float, float, float]],
    height: float,
    load: Load,
    *,
    clumps: list[tuple[float, float]] | None = None,
    friction: float = 0.0,
    anchor_height: float = 0.0,
) -> Case:
    """Build a case of segments (length, weight, EA) and clump weights (place, weight)."""
    line = Line([Segment(*segment) for segment in segments], [PointLoad(*c) for c in clumps or ()])
    return Case(Site(max(height, 1.0), friction), line, load, height, anchor_height=anchor_height)


def force(H: float) -> Load:
    return Load(horizontal_force=H)


CASES: dict[str, Case] = {
    "hanging": moored([(20.0, 93.2, math.inf)], 9.5, force(3363.7)),
    "hanging, span given": moored([(20.0, 93.2, EA)], 9.5, Load(span=17.43)),
    "on the bed": moored([(400.0, 1000.0, EA)], 50.0, force(2e5)),
    "on the bed, span given": moored([(400.0, 1000.0, EA)], 50.0, Load(span=385.0)),
    "fairlead tension given": moored([(200.0, 1000.0, EA)], 50.0, Load(fairlead_tension=2e5)),
    "friction": moored([(400.0, 1000.0, EA)], 50.0, force(3e5), friction=0.5),
    "friction uses up the tension": moored([(400.0, 1000.0, EA)], 50.0, force(5e4), friction=1.0),
    "wire and chain": moored([(750.0, 298.0, 3.8e8), (332.0, 1470.0, 8e8)], 71.4, force(1.2e6)),
    "clump weight on the bed": moored(
        [(400.0, 1000.0, EA)], 50.0, force(1e5), clumps=[(100.0, 5e4)], friction=0.4
    ),
    "clump weight partly lifted": moored(
        [(300.0, 1000.0, EA)], 50.0, force(2e5), clumps=[(150.0, 1e5)], friction=0.5
    ),
    "clump weights off the bed": moored(
        [(150.0, 1000.0, EA), (150.0, 300.0, math.inf)],
        50.0,
        force(1.5e5),
        clumps=[(180.0, 5e4), (240.0, 2e4)],
    ),
    "raised anchor, on the bed between": moored(
        [(400.0, 1000.0, EA)], 50.0, force(3e4), anchor_height=20.0
    ),
    "raised anchor, below it": moored([(100.0, 1000.0, EA)], 50.0, force(3e4), anchor_height=50.0),
    "buoy on a hanging part": moored(
        [(150.0, 1000.0, EA)], 50.0, force(2e5), clumps=[(110.0, -2e4)]
    ),
    "buoyant segment": moored(
        [(100.0, 1000.0, EA), (50.0, -300.0, EA), (80.0, 500.0, EA)], 50.0, force(1e5)
    ),
    "nearly slack": moored([(100.0, 1000.0, EA)], 50.0, force(1e4)),
    "taut": moored([(200.0, 300.0, 5e7)], 100.0, Load(span=174.0)),
    "taut and inextensible": moored([(200.0, 1000.0, math.inf)], 100.0, Load(span=173.2)),
}

TOUCHES_TWICE: dict[str, Case] = {
    "touches twice": moored([(300.0, 1000.0, EA)], 50.0, force(2e4), clumps=[(150.0, -5e4)]),
    "touches twice, span given": moored(
        [(300.0, 1000.0, EA)], 50.0, Load(span=270.0), clumps=[(150.0, -5e4)]
    ),
    "touches twice, fairlead tension given": moored(
        [(300.0, 1000.0, EA)], 50.0, Load(fairlead_tension=8e4), clumps=[(150.0, -5e4)]
    ),
    "touches twice, friction, inextensible": moored(
        [(300.0, 1000.0, math.inf)], 50.0, force(4e4), clumps=[(150.0, -5e4)], friction=0.3
    ),
}
"""A buoy lifts each off the bed between two touchdowns."""

CASES |= TOUCHES_TWICE
