"""NSGA-II and the swarm beside the exact front: hypervolume, and what a search costs.

    python -m benchmarks.search [--seeds 20] [--out benchmarks/results/search.md]

To be run in the project's folder: three of the spaces are those of the tests, tables in which every
design was worked out beforehand; the others are the case files `cases/design-*`. The last table has
a space far too large to enumerate, where all that can be said is who comes furthest.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path

import numpy as np

from benchmarks.common import page
from catopt.casefile import read_case
from catopt.checks.kinds import ROUNDING
from catopt.design import steps
from catopt.design.evaluation import DesignProblem
from catopt.design.front import (
    Floats,
    Outcome,
    Problem,
    hypervolume,
    non_dominated,
    reference_point,
)
from catopt.design.nsga2 import nsga2
from catopt.design.search import enumerate_designs
from catopt.design.swarm import swarm
from catopt.model.design import Objective
from tests.design.known_space import KnownSpace, buoy, leg, tanker

EVALUATIONS = 10_000
METHODS: dict[str, Callable[..., Outcome]] = {"NSGA-II": nsga2, "swarm": swarm}


@dataclass(frozen=True)
class Space:
    """A design space and its exact front."""

    name: str
    designs: int
    feasible: float
    problem: Problem
    front: Floats


@dataclass(frozen=True)
class Runs:
    """Hypervolume relative to the exact one and wall time (s) of one run a seed."""

    volumes: Floats
    seconds: Floats
    infeasible: int


def from_case(name: str, *objectives: Objective) -> DesignProblem:
    """Read a case's design space, with other objectives than its own."""
    case = read_case(Path("cases") / name / "case.toml")
    assert case.design is not None
    return DesignProblem.of(replace(case, design=replace(case.design, objectives=objectives)))


def spaces() -> Iterator[Space]:
    """Yield the spaces whose front is known."""
    tables: tuple[KnownSpace, ...] = (tanker(), leg(), buoy())
    for table in tables:
        feasible = float((table.exceedance <= ROUNDING).mean())
        name = f"{table.name}, table"
        yield Space(name, table.designs, feasible, table, table.front.objectives)
    wanted: list[tuple[str, tuple[Objective, ...]]] = [
        ("design-tanker-20m", ("mass", "offset")),
        ("design-tanker-20m", ("mass", "offset", "excursion")),
        ("design-leg-56m", ("mass", "excursion")),
        ("design-leg-56m", ("mass", "offset", "excursion")),
    ]
    for case, objectives in wanted:
        problem = from_case(case, *objectives)
        exact = enumerate_designs(problem)
        yield Space(
            f"{case}: {', '.join(objectives)}",
            exact.evaluations,
            exact.feasible / exact.evaluations,
            problem,
            exact.objectives,
        )


def study(space: Space, search: Callable[..., Outcome], seeds: int) -> Runs:
    """Search a space once for every seed."""
    reference = reference_point(space.front)
    exact = hypervolume(space.front, reference)
    volumes, seconds, infeasible = [], [], 0
    for seed in range(1, seeds + 1):
        start = time.perf_counter()
        outcome = search(space.problem, evaluations=EVALUATIONS, seed=seed)
        seconds.append(time.perf_counter() - start)
        assert outcome.evaluations <= EVALUATIONS
        volumes.append(hypervolume(outcome.objectives, reference) / exact)
        infeasible += int((space.problem.evaluate(outcome.genes).exceedance > ROUNDING).sum())
    return Runs(np.array(volumes), np.array(seconds), infeasible)


def beside_exact(known: list[Space], seeds: int) -> Iterator[str]:
    """Yield the table of both methods over all spaces."""
    yield f"## Hypervolume over the exact one, {EVALUATIONS:,} evaluations, seeds 1 to {seeds}"
    yield ""
    yield (
        "| space | designs | feasible | exact front | method | min | median | max "
        "| infeasible points | median s a run |"
    )
    yield "|---|---|---|---|---|---|---|---|---|---|"
    for space in known:
        for name, search in METHODS.items():
            runs = study(space, search, seeds)
            low, middle, high = np.quantile(runs.volumes, [0.0, 0.5, 1.0])
            yield (
                f"| {space.name} | {space.designs:,} | {space.feasible:.0%} | {len(space.front)} "
                f"| {name} | {low:.4f} | {middle:.4f} | {high:.4f} | {runs.infeasible} "
                f"| {np.median(runs.seconds):.2f} |"
            )
    yield ""


def shares(known: list[Space], seeds: int) -> Iterator[str]:
    """Yield what the share of roaming does; at 1 there is no local improvement."""
    yield f"## Share of roaming: median and least over all spaces above, seeds 1 to {seeds}"
    yield ""
    yield "| share | " + " | ".join(f"{name} median | least" for name in METHODS) + " |"
    yield "|---" * (1 + 2 * len(METHODS)) + "|"
    own = steps.ROAMING
    for share in (0.3, 0.6, 1.0):
        steps.ROAMING = share
        cells = []
        for search in METHODS.values():
            volumes = np.concatenate([study(space, search, seeds).volumes for space in known])
            cells.append(f"{np.median(volumes):.4f} | {volumes.min():.4f}")
        yield f"| {share:g} | " + " | ".join(cells) + " |"
    steps.ROAMING = own
    yield ""


def large(seeds: int) -> Iterator[str]:
    """Yield how far each method comes where nobody knows the front."""
    problem = finer_leg()
    runs: list[tuple[str, int, float, Floats]] = []
    for name, search in METHODS.items():
        for evaluations in (10_000, 30_000, 100_000):
            for seed in range(1, seeds + 1):
                start = time.perf_counter()
                outcome = search(problem, evaluations=evaluations, seed=seed)
                seconds = time.perf_counter() - start
                runs.append((name, evaluations, seconds, outcome.objectives))
    together = np.concatenate([front for *_, front in runs])
    best = together[non_dominated(together)]
    reference = reference_point(best)
    volume = hypervolume(best, reference)
    yield f"## A space of {problem.space.count:.1e} designs: over the front of all runs together"
    yield ""
    yield f"design-leg-56m with lengths by the metre; mass, offset, excursion; seeds 1 to {seeds}."
    yield ""
    yield "| method | evaluations | least | median | median s a run |"
    yield "|---|---|---|---|---|"
    for name in METHODS:
        for evaluations in (10_000, 30_000, 100_000):
            own = [run for run in runs if run[:2] == (name, evaluations)]
            volumes = [hypervolume(front, reference) / volume for *_, front in own]
            seconds = float(np.median([run[2] for run in own]))
            yield (
                f"| {name} | {evaluations:,} | {min(volumes):.4f} | {np.median(volumes):.4f} "
                f"| {seconds:.2f} |"
            )
    yield ""


def finer_leg() -> DesignProblem:
    """Read the leg of 56 m with both of its free lengths in steps of a metre."""
    case = read_case(Path("cases/design-leg-56m/case.toml"))
    design = case.design
    assert design is not None
    segments = tuple(replace(each, lengths=by_the_metre(each.lengths)) for each in design.segments)
    objectives: tuple[Objective, ...] = ("mass", "offset", "excursion")
    finer = replace(design, segments=segments, objectives=objectives)
    return DesignProblem.of(replace(case, design=finer))


def by_the_metre(lengths: tuple[float, ...]) -> tuple[float, ...]:
    """Lengths from the least to the greatest."""
    return tuple(np.arange(lengths[0], lengths[-1] + 1e-9, 1.0).tolist())


def report(seeds: int, smoke: bool) -> Iterator[str]:
    """Yield the whole page."""
    yield "# NSGA-II and the swarm beside the exact front"
    yield ""
    yield f"pymoo {version('pymoo')}, pyswarms {version('pyswarms')}; one thread."
    yield ""
    yield (
        "Population 100. The reference point is the worst of each objective on the exact front "
        "and a tenth of its range more. Times include the evaluation, of a table or of lines."
    )
    yield ""
    if smoke:
        problem = from_case("design-tanker-20m", "mass", "offset")
        for name, search in METHODS.items():
            yield f"{name}: {search(problem, evaluations=10, seed=1).evaluations} designs"
        return
    known = list(spaces())
    yield from beside_exact(known, seeds)
    yield from shares(known, max(1, seeds // 4))
    yield from large(max(1, seeds // 4))


def main() -> None:
    """Run, and print or write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(parser, lambda of: report(of.seeds, of.smoke), seeds=(20, 1))


if __name__ == "__main__":
    main()
