"""What the guard times: one task after another by the catopt that this Python has.

Run by `benchmarks.guard` with the Python of each version: names of tasks come in by lines, and
processor seconds go out. Imports stand in the tasks, so that a version without one still does the
others.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

LINES = 20_000
G = 9.81

Run = Callable[[], object]


def kernel(line: str, height: float, friction: float = 0.0, **known: tuple[float, float]) -> Run:
    """Solve many lines, evenly spread between two values of what is known."""
    import numpy as np

    from catopt.catenary.batch import solve_many

    ((name, between),) = known.items()
    asked: dict[str, Any] = {name: np.linspace(*between, LINES)}
    return lambda: solve_many(lines()[line], height=height, seabed_friction=friction, **asked)


def lines() -> dict[str, Any]:
    """Lines of the kernel's tasks."""
    from catopt.model import Line, PointLoad, Segment

    def segments(*rows: tuple[float, float, float]) -> list[Segment]:
        return [Segment(length, weight, EA=EA) for length, weight, EA in rows]

    return {
        "single": Line(segments((600.0, 1e3, 8e8))),
        "four": Line(
            segments(
                (800.0, 1e3, 8e8), (200.0, 1.2e3, 9e8), (300.0, 800.0, 7e8), (50.0, 1.5e3, 9e8)
            )
        ),
        "leg": leg(),
        "clump": Line(
            segments((300.0, 1e3, 8e8), (200.0, 700.0, 6e8), (100.0, 1.2e3, 9e8)),
            [PointLoad(300.0, 5e4)],
        ),
    }


def leg() -> Any:
    """Return a leg of the FSO of Rang Dong."""
    from catopt.model import Line, Segment

    rows = ((750.0, 30.4, 382.09e6), (194.0, 137.2, 721.98e6), (80.0, 155.4, 801.2e6))
    whole = (*rows, (58.0, 155.4, 801.2e6))
    return Line([Segment(L, q * 9.80665, EA=EA) for L, q, EA in whole])


def curve() -> Run:
    """Follow the leg over 50 spans, 50 times."""
    import numpy as np

    from catopt.catenary.batch import solve_many

    spans = np.linspace(1070.0, 1085.0, 50)
    return lambda: [solve_many(leg(), height=71.4, span=spans) for _ in range(50)]


def one(**known: float) -> Run:
    """Solve one line a hundred times in a loop of plain Python."""
    import catopt

    line = lines()["single"]
    return lambda: [catopt.solve(line, height=200.0, **known) for _ in range(100)]


def nine_legs() -> Run:
    """Settle the FSO under 2,000 forces."""
    import numpy as np

    from catopt.model import System
    from catopt.mooring.batch import Batch

    azimuths = [math.radians(angle) for angle in (-3, 0, 3, 117, 120, 123, 237, 240, 243)]
    around = System.around(leg(), azimuths=azimuths, anchor_radius=1056.0, fairlead_height=71.4)
    batch = Batch(around)
    random = np.random.default_rng(20)
    size, side = random.uniform(0.0, 4.281e6, 2000), random.uniform(0.0, 2.0 * math.pi, 2000)
    forces = np.column_stack([size * np.cos(side), size * np.sin(side)])
    return lambda: batch.under(forces)


def designs() -> Run:
    """Evaluate 20,000 designs of the library's buoy."""
    import numpy as np

    from catopt.casefile import read_case
    from catopt.design.evaluation import DesignProblem

    problem = DesignProblem.of(read_case("cases/design-buoy-9.5m/case.toml"))
    generator = np.random.default_rng(1)
    genes = np.stack([generator.integers(0, size, LINES) for size in problem.sizes], axis=1)
    return lambda: problem.assess(genes)


def motion(anchors: int, rows: tuple[tuple[float, ...], ...], **of: float) -> Run:
    """Lead lines in surge: the truss model, 20 s."""
    from catopt.fem import (
        Fluid,
        Harmonic,
        Leg,
        LineProperties,
        MorisonSection,
        Seabed,
        TimeStepping,
        run_dynamics,
        run_system_dynamics,
    )
    from catopt.model import Line, Segment

    line = Line([Segment(L, w, EA=EA, mass=m) for L, m, w, EA, *_ in rows])
    wide = [math.sqrt(4.0 / math.pi * (m - w / G) / 1025.0) for _, m, w, *_ in rows]
    sections = [MorisonSection(d, row[4], 0.0, row[5]) for d, row in zip(wide, rows, strict=True)]
    properties = LineProperties(
        sections, _damping(), Fluid(1025.0, G), Seabed(3e6 * wide[0], 3e5 * wide[0])
    )
    stepping = TimeStepping(20.0, 0.1, ramp_time=of["period"], since=0.0)
    prescribed_motion = Harmonic(
        of["period"], (of["amplitude"], 0.0, 0.0), (-math.pi / 2, 0.0, 0.0)
    )
    bars = [int(row[6]) for row in rows]
    shared: dict[str, Any] = {
        "properties": properties,
        "motion": prescribed_motion,
        "elements": bars,
    }
    if anchors == 1:
        return lambda: run_dynamics(line, stepping, height=of["height"], span=of["span"], **shared)
    angles = [math.radians(angle) for angle in (-3, 0, 3, 117, 120, 123, 237, 240, 243)]
    legs = [Leg(line, (of["span"] * math.cos(a), of["span"] * math.sin(a), 0.0)) for a in angles]
    return lambda: run_system_dynamics(
        legs, stepping, height=of["height"], position=(0.0, 0.0), **shared
    )


def _damping() -> Any:
    from catopt.fem import LineDamping

    try:
        return LineDamping(critical_ratio=0.8, critical_length="bar")
    except TypeError:  # versions that know no other length
        return LineDamping(critical_ratio=0.8)


def storm() -> Run:
    """Five minutes of a storm with 200 waves on the chain."""
    import numpy as np

    from catopt.fem import (
        Fluid,
        Harmonic,
        LineProperties,
        MorisonSection,
        Seabed,
        TimeStepping,
        run_dynamics,
    )
    from catopt.model import Line, Segment
    from catopt.waves import Sea, jonswap, random_waves

    waves = random_waves(jonswap(8.0, 12.0), 200, np.random.default_rng(2), direction=math.pi)
    amplitude = np.zeros((200, 3))
    amplitude[:, 0] = 0.5 * waves.amplitude
    prescribed_motion = Harmonic(tuple(2.0 * math.pi / waves.omega), amplitude)
    wide = math.sqrt(4.0 / math.pi * (115.0 - 1000.0 / G) / 1025.0)
    properties = LineProperties(
        [MorisonSection(wide, 1.33, 0.0, 1.0)], _damping(), Fluid(1025.0, G),
        Seabed(3e6 * wide, 3e5 * wide),
    )  # fmt: skip
    line = Line([Segment(600.0, 1000.0, EA=8e8, mass=115.0)])
    stepping = TimeStepping(300.0, 0.1, ramp_time=60.0, output_interval=0.5)
    return lambda: run_dynamics(
        line, stepping, height=195.0, span=554.5, motion=prescribed_motion, properties=properties,
        sea=Sea(200.0, waves), elements=40,
    )  # fmt: skip


CHAIN = ((600.0, 115.0, 1000.0, 8e8, 1.33, 1.0, 40),)
FSO = tuple(
    (L, m, q * G, EA, 1.0, ca, 5)
    for L, m, q, EA, ca in (
        (750.0, 34.9, 30.4, 382.09e6, 0.0),
        (194.0, 157.7, 137.2, 721.98e6, 1.2),
        (80.0, 178.7, 155.4, 801.2e6, 1.2),
        (58.0, 178.7, 155.4, 801.2e6, 1.2),
    )
)
SLACK = ((60.0, 31.6, 270.0, 1.2e8, 2.4, 1.0, 20),)
"""38 mm chain, slack at every heave of 3 m."""

Spans = tuple[float, float]
FORCES: Spans = (1e5, 4e6)

TASKS: dict[str, tuple[Callable[[], Run], float, str]] = {
    "single line, span given": (lambda: kernel("single", 200.0, span=(420, 560)), LINES, "us"),
    "single line, force given": (
        lambda: kernel("single", 200.0, horizontal_force=FORCES), LINES, "us",
    ),
    "four segments, span given": (lambda: kernel("four", 200.0, span=(1100, 1300)), LINES, "us"),
    "four segments, force given": (
        lambda: kernel("four", 200.0, horizontal_force=FORCES), LINES, "us",
    ),
    "four segments, tension given": (
        lambda: kernel("four", 200.0, fairlead_tension=(6e5, 4e6)), LINES, "us",
    ),
    "four segments, friction, span given": (
        lambda: kernel("four", 200.0, 0.5, span=(1100, 1300)), LINES, "us",
    ),
    "leg of the FSO, span given": (lambda: kernel("leg", 71.4, span=(1070, 1085)), LINES, "us"),
    "leg of the FSO, force given": (
        lambda: kernel("leg", 71.4, horizontal_force=FORCES), LINES, "us",
    ),
    "clump weight, span given": (lambda: kernel("clump", 100.0, span=(480, 580)), LINES, "us"),
    "clump weight, force given": (
        lambda: kernel("clump", 100.0, horizontal_force=FORCES), LINES, "us",
    ),
    "curve of 50 spans": (curve, 2500, "us"),
    "`solve` in a loop, force given": (lambda: one(horizontal_force=3e5), 100, "us"),
    "`solve` in a loop, span given": (lambda: one(span=500.0), 100, "us"),
    "nine legs under a force": (nine_legs, 2000, "us"),
    "one design": (designs, LINES, "us"),
    "motion of a chain, a simulated second": (
        lambda: motion(1, CHAIN, amplitude=2.0, period=10.0, height=200.0, span=554.5), 20, "ms",
    ),
    "motion of the FSO, a simulated second": (
        lambda: motion(9, FSO, amplitude=2.0, period=12.9, height=71.4, span=1056.0), 20, "ms",
    ),
    "motion of a line that snaps, a simulated second": (
        lambda: motion(1, SLACK, amplitude=3.0, period=6.0, height=20.0, span=55.0), 20, "ms",
    ),
    "five minutes of a storm, a simulated second": (storm, 300, "ms"),
}  # fmt: skip
"""What makes each ready to run, how often a run does it, and the unit to say it in."""


def served(asked: Iterator[str]) -> Iterator[str]:
    """Answer each name with the processor seconds of one run, after one that is not timed."""
    ready: dict[str, Run] = {}
    for line in asked:
        name = line.strip()
        try:
            if name not in ready:
                ready[name] = TASKS[name][0]()
                ready[name]()
            began = time.process_time()
            ready[name]()
            yield f"{time.process_time() - began!r}"
        except Exception as error:  # a version that cannot do it is said to
            yield f"- {type(error).__name__}: {str(error)[:80]}".replace("\n", " ")


if __name__ == "__main__":
    sys.path[:] = [
        each for each in sys.path if Path(each or ".").resolve() != Path(__file__).parent
    ]
    for answer in served(iter(sys.stdin)):
        print(answer, flush=True)
