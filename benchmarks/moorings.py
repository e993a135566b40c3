"""Whole moorings a second: bounds beside brute force, and what legs, headings and designs cost.

    python -m benchmarks.moorings [--designs 100000] [--out benchmarks/results/moorings.md]

Equal chains about a body in 70 m of water, intact and with every line gone; on every core there is.
The first table is the goal: six lines, twelve headings and 10^5 designs in 60 s on two cores.
Compiled code is loaded before the clock starts.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Iterator
from typing import Any

import numpy as np

from benchmarks.common import page
from catopt.compile_jobs import compile_always
from catopt.design.assess import BOUNDS
from catopt.design.front import Outcome
from catopt.design.mooring import MooringProblem
from catopt.design.search import enumerate_designs
from catopt.model import SegmentChoice
from tests.design.mooring_cases import mooring_case

WORKERS = os.cpu_count() or 1


def main() -> None:
    """Time all runs and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(parser, lambda of: _seen(of) if of.smoke else _report(of.designs), designs=(20_000, 20))


def _seen(of: argparse.Namespace) -> Iterator[str]:
    """Look at a few designs, as plain Python."""
    yield "# Whole moorings a second"
    yield ""
    problem = space(of.designs)
    values = problem.assess(problem.space.genes_between(0, 2)).exceedance
    yield f"Two designs of {problem.space.count}: {values.tolist()}"


def space(designs: int, **changes: Any) -> MooringProblem:
    """Make a space of about so many designs: 10 chains, 10 radii, and lengths."""
    lengths = np.linspace(600.0, 690.0, max(2, round(designs / 100)))
    radii = np.linspace(560.0, 650.0, 10)
    sizes = (0.07, 0.081, 0.09, 0.1, 0.12)
    chain = SegmentChoice(
        tuple(lengths.tolist()), ("chain studless R3", "chain studless R4"), sizes
    )
    given = {"segments": (chain,), "anchor_radii": tuple(radii.tolist()), "lines": (6,)}
    return MooringProblem.of(mooring_case(**given | changes))


def timed(problem: MooringProblem, *, bounds: bool) -> tuple[float, Outcome]:
    """Search a space; seconds, and what was found."""
    problem.assess(problem.space.genes_between(0, 1))
    start = time.perf_counter()
    outcome = enumerate_designs(problem, bounds=bounds, workers=WORKERS)
    return time.perf_counter() - start, outcome


def _report(designs: int) -> Iterator[str]:
    """Compile before the clock starts."""
    with compile_always():
        yield from _tables(designs)


def _tables(designs: int) -> Iterator[str]:
    yield "# Whole moorings a second"
    yield ""
    yield (f"One run each, {WORKERS} threads.")
    yield ""
    yield "Six lines, twelve headings, intact and every line out."
    yield ""
    head = ["body", "designs", "with bounds", "designs a second", "evaluated", *BOUNDS]
    yield _row([*head, "brute force", "a second", "the same front"])
    yield _row(["---"] * (len(head) + 3))
    for name, arm in (("does not turn", 0.0), ("turns, fairleads at 5 m", 5.0)):
        problem = space(designs, fairlead_radius=arm)
        count = problem.space.count
        fast, found = timed(problem, bounds=True)
        slow, whole = timed(problem, bounds=False)
        same = np.array_equal(found.genes, whole.genes)
        same = same and np.array_equal(found.objectives, whole.objectives)
        done = [f"{n:,}" for n in (found.evaluations, *found.excluded)]
        yield _row(
            [
                *(name, f"{count:,}", f"{fast:.1f} s", f"{count / fast:,.0f}", *done),
                *(f"{slow:.1f} s", f"{count / slow:,.0f}", "yes" if same else "NO"),
            ]
        )
    yield ""
    yield from _growth(max(1000, designs // 20))


def _growth(designs: int) -> Iterator[str]:
    """Vary one thing at a time about six lines and twelve headings; the body does not turn."""
    yield "One thing changed at a time; states are those that differ."
    yield ""
    yield _row(["", "designs", "states", "with bounds", "brute force", "a design"])
    yield _row(["---"] * 6)
    runs: list[tuple[str, int, dict[str, Any]]] = [
        *((f"{n} lines", designs, {"lines": (n,)}) for n in (3, 6, 9, 12)),
        *((f"{n} headings", designs, {"headings": n}) for n in (1, 12, 36)),
        *((f"{n:,} designs", n, {}) for n in (designs, 2 * designs, 4 * designs)),
    ]
    for name, count, changes in runs:
        problem = space(count, **changes)
        assert problem.mooring is not None
        fast, _ = timed(problem, bounds=True)
        slow, _ = timed(problem, bounds=False)
        states = str(len(problem.mooring.missing))
        each = f"{slow / problem.space.count * 1e6:.0f} us"
        times = [f"{fast:.2f} s", f"{slow:.2f} s", each]
        yield _row([name, f"{problem.space.count:,}", states, *times])


def _row(cells: list[str]) -> str:
    return f"| {' | '.join(cells)} |"


if __name__ == "__main__":
    main()
