"""A moored body at rest: the compiled loop beside nine MoorPy Subsystems, in one run on one core.

    python -m benchmarks.system [--out benchmarks/results/system.md]

The turret of FSO Rang Dong: nine legs of four segments, random horizontal forces, every solve from
the zero-load position. MoorPy (the optional extra ``peers``) has no route of its own that settles
this body: its Subsystems give each leg's force and stiffness to the Newton loop below. Rounds of
the sides alternate; quote the ratios.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import math
import statistics
import time
import warnings
from collections.abc import Iterator
from contextlib import nullcontext
from typing import Any

import numpy as np

from benchmarks.common import page
from catopt.catenary.batch import solve_many
from catopt.catenary.state import CONVERGED
from catopt.compile_jobs import compile_always
from catopt.model import Line, Segment, System
from catopt.mooring.batch import Batch, solve_system_many
from catopt.mooring.solution import solve_system

DEPTH, ANCHOR_RADIUS = 71.4, 1056.0
LEG = Line(
    [
        Segment(750.0, 30.4 * 9.80665, EA=382.09e6),
        Segment(194.0, 137.2 * 9.80665, EA=721.98e6),
        Segment(80.0, 155.4 * 9.80665, EA=801.2e6),
        Segment(58.0, 155.4 * 9.80665, EA=801.2e6),
    ]
)
AZIMUTHS = [math.radians(angle) for angle in (-3, 0, 3, 117, 120, 123, 237, 240, 243)]
TURRET = System.around(LEG, azimuths=AZIMUTHS, anchor_radius=ANCHOR_RADIUS, fairlead_height=DEPTH)
LARGEST = {"up to 1,000 kN": 1e6, "up to 4,281 kN": 4.281e6, "up to 9,824 kN": 9.824e6}
"""N: PEERS' force, the static force of S4 and its largest."""


def main() -> None:
    """Time both sides and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(parser, _report, rounds=(7, 1), loads=(500, 3))


def _report(of: argparse.Namespace) -> Iterator[str]:
    """Compile at once: 500 loads are too few for that to happen by itself."""
    with nullcontext() if of.smoke else compile_always():
        yield from _table(of.rounds, of.loads)


def _table(rounds: int, loads: int) -> Iterator[str]:
    batch = Batch(TURRET)
    rows = [
        f"| {loads} random forces | converged | Newton steps, mean | a solve |",
        "|---|---|---|---|",
    ]
    for name, largest in LARGEST.items():
        forces = _forces(largest, loads)
        answers = batch.under(forces)
        seconds = statistics.median(_timed(lambda f=forces: batch.under(f)) for _ in range(rounds))
        converged = int((answers.status == CONVERGED).sum())
        rows.append(
            f"| {name} | {converged} | {answers.steps.mean():.2f} "
            f"| {seconds / loads * 1e6:.1f} us |"
        )
    yield "# A moored body at rest"
    yield ""
    yield (
        f"Medians of {rounds} rounds, one core. The turret of FSO Rang Dong: nine legs of four "
        "segments, each solve from the zero-load position."
    )
    yield ""
    yield from rows
    yield ""
    yield _single(rounds, 40 * loads)
    yield ""
    yield _beside_moorpy(batch, loads)


def _forces(largest: float, count: int) -> Any:
    random = np.random.default_rng(20)
    size = random.uniform(0.0, largest, count)
    side = random.uniform(0.0, 2.0 * math.pi, count)
    return np.column_stack([size * np.cos(side), size * np.sin(side)])


def _timed(call: Any) -> float:
    start = time.process_time()
    call()
    return time.process_time() - start


def _single(rounds: int, lines: int) -> str:
    loaded = TURRET.under((-4.281e6, 0.0))
    seconds = statistics.median(_timed(lambda: solve_system(loaded)) for _ in range(2 * rounds))
    many = statistics.median(
        _timed(lambda: solve_system_many(TURRET, force=_forces(1e6, 10))) for _ in range(rounds)
    )
    spans = np.linspace(1070.0, 1085.0, lines)
    solve_many(LEG, height=DEPTH, span=spans)
    one = statistics.median(
        _timed(lambda: solve_many(LEG, height=DEPTH, span=spans)) / spans.size
        for _ in range(rounds)
    )
    return (
        f"A yardstick of the same run, one leg from cold with its span given: {one * 1e6:.2f} us. "
        f"One `solve_system`, the zero-load position and the laid-out lines "
        f"included: {seconds * 1e3:.1f} ms; `solve_system_many` with 10 loads, the zero-load "
        f"position included: {many * 1e3:.1f} ms."
    )


def _beside_moorpy(batch: Batch, loads: int) -> str:
    try:
        legs = [_subsystem() for _ in AZIMUTHS]
    except ImportError:
        return "MoorPy is not installed."
    forces = np.array([[1e6, 0.0], [-4.281e6, 0.0], [5e5, 8e5]])[: max(1, min(3, loads // 3))]
    ours, theirs, apart, loops = [], [], [], []
    for force in forces:
        many = np.repeat(force[None, :], loads, axis=0)
        ours.append(_timed(lambda f=many: batch.under(f)) / loads)
        start = time.process_time()
        place, steps = _by_moorpy(legs, force)
        theirs.append(time.process_time() - start)
        apart.append(float(np.linalg.norm(place - batch.under(force[None, :]).offset[0])))
        loops.append(steps)
    mine, other = statistics.median(ours), statistics.median(theirs)
    return (
        f"Beside MoorPy, three forces, medians: catopt {mine * 1e6:.1f} us, nine Subsystems in a "
        f"Newton loop {other:.2f} s, {other / mine:,.0f} times as long; it took "
        f"{', '.join(str(n) for n in loops)} steps (30 at most) and ended "
        f"{', '.join(f'{a:.2g}' for a in apart)} m from our place."
    )


def _subsystem() -> Any:
    from moorpy.subsystem import Subsystem

    leg = Subsystem(depth=DEPTH, rho=1025.0, g=9.80665, span=1056.0, rad_fair=0.0, z_fair=0.0)
    types = [
        {
            "name": "",
            "d_vol": 1e-6,
            "m": segment.submerged_weight / 9.80665,
            "w": segment.submerged_weight,
            "EA": segment.EA,
        }
        for segment in LEG.segments
    ]
    leg.makeGeneric([segment.length for segment in LEG.segments], types)
    leg.initialize()
    return leg


def _by_moorpy(legs: list[Any], force: Any) -> tuple[Any, int]:
    """Newton's method with the forces and end stiffnesses of Subsystems; at most 30 steps."""
    place = np.zeros(2)
    anchors = ANCHOR_RADIUS * np.array([[math.cos(a), math.sin(a)] for a in AZIMUTHS])
    for step in range(30):
        total, stiffness = force.copy(), np.zeros((2, 2))
        for leg, anchor in zip(legs, anchors, strict=True):
            to_anchor = anchor - place
            span = float(np.linalg.norm(to_anchor))
            unit = to_anchor / span
            H, along = _place(leg, span)
            total += H * unit
            across = H / span
            stiffness += along * np.outer(unit, unit) + across * (np.eye(2) - np.outer(unit, unit))
        if np.linalg.norm(total) <= 1e-4 * np.linalg.norm(force):
            return place, step
        move = np.linalg.solve(stiffness, total)
        place = place + move * min(1.0, 15.0 / float(np.linalg.norm(move)))
    return place, 30


def _place(leg: Any, span: float) -> tuple[float, float]:
    """Horizontal force and its derivative by the span, at MoorPy's default tolerance."""
    with warnings.catch_warnings(), contextlib.redirect_stdout(io.StringIO()):
        warnings.simplefilter("ignore")
        leg.setEndPosition(np.array([-ANCHOR_RADIUS + span, 0.0, 0.0]), endB=1)
        leg.staticSolve()
    return abs(float(leg.fB_L[0])), abs(float(leg.KB_L[0, 0]))


if __name__ == "__main__":
    main()
