"""Designs a second: the compiled evaluation beside simpler ways, and whole searches.

    python -m benchmarks.design [--out benchmarks/results/design.md]

A design is a line of 3 segments with 2 clump weights, solved and checked in 4 load cases; one core.
Each figure is the median of several rounds; rounds of all ways alternate, so that a slow moment of
the machine meets them all. Quote the ratios. MoorPy is the optional extra ``peers``.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import page
from catopt.casefile import read_case
from catopt.catenary.batch import solve_many
from catopt.catenary.equilibrium import given_force
from catopt.catenary.pieces import LineProblem, Pieces, cut
from catopt.catenary.solve import solve
from catopt.checks.case import check_line
from catopt.checks.kinds import ROUNDING
from catopt.design.evaluation import DesignProblem
from catopt.design.front import Floats, Genes, Outcome
from catopt.design.search import Found, answer, design_case, enumerate_designs
from catopt.machine_code import _inner
from catopt.model import (
    Case,
    Checks,
    ClumpWeightChoice,
    Design,
    Line,
    LoadCase,
    Segment,
    SegmentChoice,
    Site,
)

SHOTS = tuple(27.5 * number for number in range(1, 7))
CHAIN = SegmentChoice(SHOTS, ("chain studless R3",), diameter_min=0.05, diameter_max=0.09)
DESIGN = Design(
    segments=(CHAIN, SegmentChoice(SHOTS, ("wire spiral-strand",)), CHAIN),
    clump_weights=(
        ClumpWeightChoice((2e3, 5e3, 10e3), 7850.0, positions=(6.0, 12.0, 18.0, 24.0)),
        ClumpWeightChoice((2e3, 5e3, 10e3), 7850.0, positions=(30.0, 45.0, 60.0, 75.0)),
    ),
)
CASE = Case(
    Site(50.0),
    Line([Segment(300.0, 700.0)]),
    None,
    50.0,
    checks=Checks(safety_factor=3.0, max_anchor_uplift_angle=0.0),
    load_cases=(
        LoadCase("storm, high water", 500e3, 2.0),
        LoadCase("storm, low water", 500e3, -2.0),
        LoadCase("gale", 300e3),
        LoadCase("everyday", 100e3, kind="reference"),
    ),
    design=DESIGN,
)
CASES = ("design-buoy-9.5m", "design-tanker-20m", "design-leg-56m")
FRONT = 500


def main() -> None:
    """Time everything and print the report."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(parser, _report, rounds=(7, 1), designs=(40_000, 10))


def _report(of: argparse.Namespace) -> Iterator[str]:
    yield "# Designs a second"
    yield ""
    yield "Medians, one core."
    yield ""
    yield from _evaluation(of.rounds, of.designs)
    if not of.smoke:
        yield from _searches()


def _evaluation(rounds: int, designs: int) -> list[str]:
    """Time the ways to evaluate one design of 3 segments, 2 clump weights, 4 load cases."""
    problem = DesignProblem.of(CASE)
    generator = np.random.default_rng(1)
    genes = np.stack([generator.integers(0, size, designs) for size in problem.sizes], axis=1)
    ways: list[tuple[str, Callable[[], object], int]] = [
        (
            "all checks in all load cases",
            lambda: problem.assess(genes),
            designs,
        ),
        (
            "as enumeration does: left at the first failed check",
            lambda: problem.assess(genes, stops_early=True),
            designs,
        ),
        ("equilibrium alone, the same lines", _kernel_alone(problem, genes), designs),
        (
            "`solve_many`, a call a load case: end forces and span, no check",
            lambda: _by_solve_many(problem, genes),
            designs,
        ),
        (
            "`check_line` in plain Python, design by design",
            lambda: [check_line(_line(problem, row), CASE) for row in genes[:100]],
            min(100, designs),
        ),
    ]
    moorpy = _moorpy(problem, genes[:3])
    if moorpy is not None:
        ways.append(("MoorPy, a solve by span a load case, no check", moorpy, 3))
    for _, run, _ in ways:
        run()
    times: list[list[float]] = [[] for _ in ways]
    for _ in range(rounds):
        for (_, run, count), own in zip(ways, times, strict=True):
            own.append(_seconds(run) / count)
    medians = [statistics.median(own) for own in times]
    rows = ["| one design: 3 segments, 2 clump weights, 4 load cases | time | a second | ratio |"]
    rows.append("|---|---|---|---|")
    for (name, _, _), median in zip(ways, medians, strict=True):
        ratio = median / medians[0]
        rows.append(f"| {name} | {_time(median)} | {1.0 / median:,.0f} | {ratio:,.3g} |")
    feasible = float((problem.assess(genes).exceedance <= ROUNDING).mean())
    rows += [
        "",
        f"{100 * feasible:.0f} % of the designs are feasible. The equilibria take "
        f"{100 * medians[2] / medians[0]:.0f} % of the whole; the rest is looking the genes up, "
        "cutting the line, the largest tension of each segment, checks and objectives.",
        "",
    ]
    return rows


def _line(problem: DesignProblem, genes: Genes) -> Line:
    return problem.space.line(tuple(genes.tolist()))


def _kernel_alone(problem: DesignProblem, genes: Genes) -> Callable[[], object]:
    """Only `given_force`, over lines that were cut before."""
    import numba

    kernel = _inner(given_force)
    cut_lines = [cut(_line(problem, row))[0] for row in genes[:2000]]
    tables = [np.array([getattr(each, key) for each in cut_lines]) for key in Pieces._fields]
    force, height = problem.tables.force, problem.tables.height

    @numba.njit
    def run(length: Any, weight: Any, compliance: Any, load: Any, repeats: int) -> float:
        total = 0.0
        for _ in range(repeats):
            for i in range(len(length)):
                pieces = Pieces(length[i], weight[i], compliance[i], load[i])
                for c in range(len(force)):
                    total += kernel(force[c], LineProblem(pieces, 0.0, height[c], 0.0)).span
        return total

    return lambda: run(*tables, max(1, len(genes) // 2000))


def _by_solve_many(problem: DesignProblem, genes: Genes) -> Floats:
    """Offsets as a user would get them with the public batch call."""
    tables = problem.tables
    at = [(s, genes[:, 2 * s]) for s in range(3)]
    lengths = np.stack([tables.length[s, genes[:, 2 * s + 1]] for s, _ in at], axis=1)
    weights = np.stack([tables.weight[s, kind] for s, kind in at], axis=1)
    EA = 1.0 / np.stack([tables.compliance[s, kind] for s, kind in at], axis=1)
    positions = np.stack([tables.position[c, genes[:, 7 + 2 * c]] for c in range(2)], axis=1)
    hung = np.stack([tables.clump_weight[c, genes[:, 6 + 2 * c]] for c in range(2)], axis=1)
    spans = [
        solve_many(
            _line(problem, genes[0]),
            height=height,
            horizontal_force=force,
            lengths=lengths,
            submerged_weights=weights,
            EA=EA,
            positions=positions,
            point_weights=hung,
        ).span
        for force, height in zip(tables.force, tables.height, strict=True)
    ]
    offsets: Floats = np.max(spans, axis=0)
    return offsets


def _moorpy(problem: DesignProblem, genes: Genes) -> Callable[[], object] | None:
    """One MoorPy subsystem a design, moved to the span of each load case and solved.

    MoorPy takes no horizontal force, so it is given the spans. Clump weights hang on joints.
    """
    try:
        from moorpy.subsystem import Subsystem  # noqa: F401
    except ImportError:
        return None
    lines = [_line(problem, row) for row in genes]
    spans = [
        [
            solve(line, height=height, horizontal_force=force).span
            for force, height in zip(problem.tables.force, problem.tables.height, strict=True)
        ]
        for line in lines
    ]

    def run() -> None:
        for line, own in zip(lines, spans, strict=True):
            _subsystem(line, own)

    return run


def _subsystem(line: Line, spans: list[float]) -> None:
    import contextlib
    import io

    from moorpy.subsystem import Subsystem

    pieces, owner = cut(line)
    depth = CASE.fairlead_height
    with contextlib.redirect_stdout(io.StringIO()):
        leg = Subsystem(depth=depth, rho=1025.0, g=9.80665, span=spans[0], rad_fair=0.0, z_fair=0.0)
        types = [
            {
                "name": "",
                "d_vol": 1e-6,
                "m": line.segments[k].submerged_weight / 9.80665,
                "w": line.segments[k].submerged_weight,
                "EA": line.segments[k].EA,
            }
            for k in owner
        ]
        leg.makeGeneric(list(pieces.length), types)
        for joint, load in enumerate(pieces.load[1 : len(pieces.length)], start=1):
            leg.pointList[joint].m = load / 9.80665
        leg.initialize()
        for span in spans:
            leg.setEndPosition(np.array([-spans[0] + span, 0.0, 0.0]), endB=1)
            with contextlib.suppress(Exception):
                leg.staticSolve()


def _searches() -> list[str]:
    """Time whole runs of the cases that come with catopt, and a long front's answer."""
    rows = [
        "In whole runs enumeration has a thread a core; all else is on one.",
        "",
        "| whole run, compiled code loaded | designs | evaluated | front | search | in all |",
        "|---|---|---|---|---|---|",
    ]
    for name in CASES:
        case = read_case(Path(__file__).parent.parent / "cases" / name / "case.toml")
        methods = ("enumeration", "nsga2", "swarm")
        rows += [_whole(f"{name}, {method}", case, method) for method in methods]
    rows.append(_whole("the space above, nsga2", CASE, "nsga2"))
    rows.append(_whole("the space above, swarm", CASE, "swarm"))
    rows += ["", _millions(), "", _long_front()]
    return rows


def _whole(name: str, case: Case, method: Any) -> str:
    design_case(case, method=method, evaluations=100)
    start = time.perf_counter()
    result = design_case(case, method=method)
    seconds = time.perf_counter() - start
    return (
        f"| {name} | {result.designs:,} | {result.evaluations:,} | {len(result.front)} | "
        f"{_time(result.seconds)} | {_time(seconds)} |"
    )


def _millions() -> str:
    """Enumerate some millions of designs of the same kind."""
    chain, wire, top = DESIGN.segments
    segments = replace(chain, lengths=SHOTS[3:]), replace(wire, lengths=SHOTS[2:4]), top
    weights = (
        ClumpWeightChoice((5e3, 10e3), 7850.0, positions=(12.0, 24.0)),
        ClumpWeightChoice((5e3, 10e3), 7850.0, joint=1, optional=True),
    )
    design = replace(DESIGN, segments=segments, clump_weights=weights)
    problem = DesignProblem.of(replace(CASE, design=design))
    start = time.perf_counter()
    outcome = enumerate_designs(problem)
    seconds = time.perf_counter() - start
    return (
        f"Enumeration of {problem.space.count:,} designs of 3 segments and 2 clump weights in 4 "
        f"load cases: {seconds:.1f} s, {problem.space.count / seconds:,.0f} a second; "
        f"{outcome.feasible:,} are feasible, {len(outcome.genes)} on the front."
    )


def _long_front() -> str:
    """Answer hundreds of designs."""
    problem = DesignProblem.of(CASE)
    generator = np.random.default_rng(2)
    genes = np.stack([generator.integers(0, size, 4 * FRONT) for size in problem.sizes], axis=1)
    objectives, exceedance = problem.evaluate(genes)
    chosen = np.flatnonzero(exceedance <= ROUNDING)[:FRONT]
    outcome = Outcome(genes[chosen], objectives[chosen], len(genes), FRONT, False, None, 0.0)
    start = time.perf_counter()
    result = answer(problem, Found(outcome, "nsga2", 0.0))
    seconds = time.perf_counter() - start
    return (
        f"Answer of {len(result.front)} designs, each solved and checked again in plain Python in "
        f"4 load cases, with ends and neighbours: {seconds:.2f} s."
    )


def _seconds(run: Callable[[], object]) -> float:
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


def _time(seconds: float) -> str:
    for unit, factor in (("us", 1e6), ("ms", 1e3)):
        if seconds * factor < 1e3:
            return f"{seconds * factor:.3g} {unit}"
    return f"{seconds:.3g} s"


if __name__ == "__main__":
    main()
