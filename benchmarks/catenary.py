"""Lines a second: the compiled kernel beside MoorPy and pycatenary, in one run on one core.

    python -m benchmarks.catenary [--out benchmarks/results/catenary.md]

MoorPy and pycatenary are the optional extra ``peers``; without them their columns stay empty.
Each figure is the median of several rounds; rounds of the sides alternate, so that a slow moment
of the machine meets both. Quote the ratios.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import math
import statistics
import time
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.common import page
from catopt.catenary.batch import solve_many
from catopt.catenary.pieces import LineProblem, Pieces, cut
from catopt.catenary.solve import solve
from catopt.catenary.span_or_tension import given_span
from catopt.machine_code import _inner
from catopt.model import Line, Segment

DEPTH = 71.4
LEG = Line(
    [
        Segment(750.0, 30.4 * 9.80665, EA=382.09e6),
        Segment(194.0, 137.2 * 9.80665, EA=721.98e6),
        Segment(80.0, 155.4 * 9.80665, EA=801.2e6),
        Segment(58.0, 155.4 * 9.80665, EA=801.2e6),
    ]
)
SINGLE = Line([Segment(600.0, 1000.0, EA=800e6)])


@dataclass(frozen=True)
class Task:
    """One thing to time: seconds a line for us and for a peer."""

    name: str
    ours: Callable[[], float]
    peer: str = ""
    theirs: Callable[[], float] | None = None


def main() -> None:
    """Run all tasks and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(parser, _report, rounds=(7, 1), lines=(20_000, 50))


def _tasks(n: int, smoke: bool) -> list[Task]:
    forces = np.geomspace(1e5, 4e6, n)
    spans = np.linspace(1070.0, 1085.0, n)
    single_spans = np.linspace(420.0, 560.0, n)
    curve = np.linspace(1070.0, 1085.0, 2 if smoke else 50)
    return [
        Task(
            "single elastic line on the bed, span given, cold",
            lambda: _per_line(lambda: solve_many(SINGLE, height=200.0, span=single_spans), n),
            "MoorPy",
            _moorpy_single(),
        ),
        Task("4-segment leg, force given", lambda: _batch(horizontal_force=forces)),
        Task("4-segment leg, span given, cold", lambda: _batch(span=spans), "MoorPy", _subsystem()),
        Task("4-segment leg, span given, after a small move", _warm(n), "MoorPy", _subsystem()),
        Task(
            "50-point load curve of the leg",
            lambda: _per_line(
                lambda: [solve_many(LEG, height=DEPTH, span=curve) for _ in range(50)], 50
            ),
            "MoorPy",
            _subsystem_curve(curve.size),
        ),
        Task("one line from Python, plain scalars", _scalar, "MoorPy", _moorpy_single()),
        *(Task(f"{k} segments, force given", _segments(k, n)) for k in (1, 2, 4, 8, 16, 32)),
    ]


def _per_line(call: Callable[[], object], lines: int) -> float:
    start = time.process_time()
    call()
    return (time.process_time() - start) / lines


def _batch(**known: Any) -> float:
    lines = next(iter(known.values())).size
    return _per_line(lambda: solve_many(LEG, height=DEPTH, **known), lines)


def _warm(n: int) -> Callable[[], float]:
    """Follow a leg whose fairlead moves by 1 mm a step, each start being the last answer."""
    import numba

    kernel = _inner(given_span)
    pieces = Pieces(*(np.array(column) for column in cut(LEG)[0]))

    @numba.njit
    def follow(pieces: Any, n: int) -> float:
        H, V = math.nan, math.nan
        for i in range(n):
            state = kernel(1070.0 + 1e-3 * (i % 15000), LineProblem(pieces, 0.0, DEPTH, 0.0), H, V)
            H, V = state.H, state.V
        return H

    follow(pieces, 2)
    return lambda: _per_line(lambda: follow(pieces, n), n)


def _scalar() -> float:
    spans = np.linspace(420.0, 560.0, 300).tolist()
    return _per_line(lambda: [solve(SINGLE, height=200.0, span=span) for span in spans], 300)


def _segments(count: int, n: int) -> Callable[[], float]:
    line = Line([Segment(1082.0 / count, 400.0 + 10.0 * k, EA=5e8) for k in range(count)])
    forces = np.geomspace(1e5, 4e6, n)
    return lambda: _per_line(lambda: solve_many(line, height=DEPTH, horizontal_force=forces), n)


def _moorpy_single() -> Callable[[], float] | None:
    try:
        from moorpy.Catenary import catenary
    except ImportError:
        return None
    spans = np.linspace(420.0, 560.0, 100).tolist()

    def run() -> float:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return _per_line(
                lambda: [catenary(x, 200.0, 600.0, 800e6, 1000.0) for x in spans], len(spans)
            )

    return run


def _leg_subsystem() -> Any:
    from moorpy.subsystem import Subsystem

    leg = Subsystem(depth=DEPTH, rho=1025.0, g=9.80665, span=1060.0, rad_fair=0.0, z_fair=0.0)
    types = []
    for segment in LEG.segments:
        weight = segment.submerged_weight
        types.append(
            {"name": "", "d_vol": 1e-6, "m": weight / 9.80665, "w": weight, "EA": segment.EA}
        )
    leg.makeGeneric([segment.length for segment in LEG.segments], types)
    leg.initialize()
    return leg


def _subsystem() -> Callable[[], float] | None:
    try:
        leg = _leg_subsystem()
    except ImportError:
        return None

    def run() -> float:
        return _per_line(lambda: _follow(leg, [1077.0 + 0.01 * i for i in range(20)]), 20)

    return run


def _subsystem_curve(points: int) -> Callable[[], float] | None:
    try:
        leg = _leg_subsystem()
    except ImportError:
        return None
    spans = np.linspace(1070.0, 1085.0, points).tolist()
    return lambda: _per_line(lambda: _follow(leg, spans), 1)


def _follow(leg: Any, spans: list[float]) -> None:
    for span in spans:
        _place(leg, span)


def _place(leg: Any, span: float) -> None:
    """Move the fairlead end and solve, at MoorPy's default tolerance; it prints as it goes."""
    with contextlib.redirect_stdout(io.StringIO()):
        leg.setEndPosition(np.array([-1060.0 + span, 0.0, 0.0]), endB=1)
        leg.staticSolve()


def _subsystem_error(points: int) -> str:
    """How far MoorPy's tension is off over the timed curve, in words; nothing when it is absent."""
    try:
        leg = _leg_subsystem()
    except ImportError:
        return ""
    spans = np.linspace(1070.0, 1085.0, points)
    ours = solve_many(LEG, height=DEPTH, span=spans).tension
    theirs = []
    for span in spans.tolist():
        _place(leg, span)
        theirs.append(float(np.linalg.norm(leg.fB_L)))
    off = np.abs(np.array(theirs) / ours - 1.0)
    return (
        f"\nOver the curve MoorPy's fairlead tension, at its default tolerance, is off by "
        f"{100 * np.median(off):.2g} % in the median and {100 * off.max():.2g} % at most.\n"
    )


def _timed(task: Task, rounds: int) -> tuple[Task, float, float | None]:
    task.ours()
    ours, theirs = [], []
    for _ in range(rounds):
        ours.append(task.ours())
        if task.theirs is not None:
            theirs.append(task.theirs())
    return task, statistics.median(ours), statistics.median(theirs) if theirs else None


def _report(of: argparse.Namespace) -> Iterator[str]:
    yield "# Lines a second"
    yield ""
    yield "Medians of processor time, one core."
    yield ""
    yield "| task | catopt | peer | ratio |"
    yield "|---|---|---|---|"
    for task, ours, theirs in (_timed(task, of.rounds) for task in _tasks(of.lines, of.smoke)):
        peer = "-" if theirs is None else f"{task.peer} {_time(theirs)}"
        ratio = "-" if theirs is None else f"{theirs / ours:,.0f}"
        yield f"| {task.name} | {_time(ours)} | {peer} | {ratio} |"
    yield _subsystem_error(2 if of.smoke else 50)


def _time(seconds: float) -> str:
    unit, factor = ("us", 1e6) if seconds < 1e-3 else ("ms", 1e3)
    return f"{seconds * factor:.3g} {unit}"


if __name__ == "__main__":
    main()
