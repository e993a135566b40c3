"""Time of the truss model's statics: one line over the number of bars, and a mooring of nine.

    python -m benchmarks.truss [--out benchmarks/results/truss.md]

Every solution starts from a straight line. Each figure is the median of several rounds after
compilation, which is timed on its own in a fresh folder of machine code.
"""

from __future__ import annotations

import argparse
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path

from benchmarks.common import page
from catopt.fem import Bed, Leg, RestrainedBed, TrussSolution, solve_line, solve_system
from catopt.fem.solve import SystemSolution
from catopt.model import Line, Segment

G = 9.80665
LEG = Line(
    [
        Segment(750.0, 30.4 * G, EA=382.09e6),
        Segment(194.0, 137.2 * G, EA=721.98e6),
        Segment(80.0, 155.4 * G, EA=801.2e6),
        Segment(58.0, 155.4 * G, EA=801.2e6),
    ]
)
HEIGHT, RADIUS, FORCE = 71.4, 1056.0, (-4281e3, 0.0)
SIZES = (20, 40, 80, 160, 320, 640)
AZIMUTHS = (-3, 0, 3, 117, 120, 123, 237, 240, 243)


def main() -> None:
    """Run all and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(parser, _report, rounds=(9, 1))


def _report(of: argparse.Namespace) -> Iterator[str]:
    yield "# Truss statics"
    yield ""
    yield "Medians, one core. From a straight start, to 1e-10 of the tension at every node."
    if not of.smoke:
        yield f"Compilation, once a machine: {_compilation():.0f} s."
    yield ""
    yield from _one_line(of.rounds, SIZES[:1] if of.smoke else SIZES)
    if not of.smoke:
        yield from _mooring(of.rounds)


def _compilation() -> float:
    """Seconds that the first solution takes where nothing is compiled."""
    code = (
        "import time; from benchmarks.truss import solved; t = time.perf_counter(); "
        "solved(20, 1e6); print(time.perf_counter() - t)"
    )
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "NUMBA_CACHE_DIR": folder}
        done = subprocess.run(
            [sys.executable, "-c", code],
            env=environment,
            cwd=Path(__file__).parents[1],
            capture_output=True,
            text=True,
            check=True,
        )
    return float(done.stdout)


def solved(elements: int, force: float) -> TrussSolution:
    """Solve one leg of the FSO Rang Dong under a horizontal force."""
    return solve_line(LEG, height=HEIGHT, horizontal_force=force, elements=elements)


def _one_line(rounds: int, sizes: Sequence[int]) -> list[str]:
    rows = [
        "| bars of one line | force given | iterations | us per bar and iteration | span given |",
        "|---|---|---|---|---|",
    ]
    span = solved(100, 1.2e6).span
    for elements in sizes:
        force, iterations = _median(partial(solved, elements, 1.2e6), rounds)
        at_span = partial(solve_line, LEG, height=HEIGHT, span=span, elements=elements)
        held, _ = _median(at_span, rounds)
        each = force / iterations / elements * 1e6
        rows.append(
            f"| {elements} | {force * 1e3:.2f} ms | {iterations} | {each:.2f} "
            f"| {held * 1e3:.2f} ms |"
        )
    return [*rows, ""]


def _mooring(rounds: int) -> list[str]:
    angles = [math.radians(azimuth) for azimuth in AZIMUTHS]
    legs = [Leg(LEG, (RADIUS * math.cos(a), RADIUS * math.sin(a), 0.0)) for a in angles]

    def run(elements: int, bed: Bed | RestrainedBed, friction: float = 0.0) -> SystemSolution:
        return solve_system(legs, height=HEIGHT, force=FORCE, elements=[elements // 4] * 4,
                            bed=bed, seabed_friction=friction)  # fmt: skip

    rows = ["| nine legs of FSO Rang Dong | bars | time | iterations |", "|---|---|---|---|"]
    held = RestrainedBed(944.0, EA_multiplier=100.0)
    for name, elements, call in (
        ("as run by the source", 20, lambda: run(20, held)),
        ("bed that only pushes", 20, lambda: run(20, Bed())),
        ("bed that only pushes", 80, lambda: run(80, Bed())),
        ("with friction 0.6", 80, lambda: run(80, Bed(), 0.6)),
    ):
        seconds, iterations = _median(call, rounds)
        rows.append(f"| {name} | {9 * elements} | {seconds * 1e3:.1f} ms | {iterations} |")
    return rows


def _median(call: Callable[[], TrussSolution | SystemSolution], rounds: int) -> tuple[float, int]:
    """Median time of a call and the iterations that it took."""
    iterations = call().iterations
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return statistics.median(times), iterations


if __name__ == "__main__":
    main()
