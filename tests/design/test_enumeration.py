"""The exact front against one found design by design in plain Python."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from catopt.casefile import read_case
from catopt.checks.kinds import ROUNDING
from catopt.design.evaluation import LEAST_SHARE, DesignProblem
from catopt.design.mooring import MooringProblem
from catopt.design.search import Estimate, enumerate_designs, estimate
from catopt.model import Checks, SegmentChoice
from tests.design.small_cases import plain_value, small_case

CASES = Path(__file__).parents[2] / "cases"
SAME = 1e-10
"""Relative, as in test_evaluation."""


def plain_front(problem: DesignProblem) -> dict[tuple[int, ...], list[float]]:
    """Feasible designs that no other beats, every pair compared."""
    feasible = {}
    for row in problem.space.genes_between(0, problem.space.count).tolist():
        plain = plain_value(problem, tuple(row))
        if plain is not None and plain[1] <= ROUNDING:
            feasible[tuple(row)] = plain[0]
    return {
        genes: own
        for genes, own in feasible.items()
        if not any(beats(other, own) for other in feasible.values())
    }


def beats(one: list[float], other: list[float]) -> bool:
    """Whether one is as small in every objective and smaller in one, but for rounding."""
    room = [SAME * max(abs(value), 1.0) for value in other]
    as_small = all(a <= b + r for a, b, r in zip(one, other, room, strict=True))
    return as_small and any(a < b - r for a, b, r in zip(one, other, room, strict=True))


@pytest.mark.parametrize(
    "objectives", [("mass", "offset"), ("mass", "excursion"), ("mass", "offset", "cost")]
)
def test_the_front_is_that_of_plain_comparison(objectives: tuple[str, ...]) -> None:
    problem = DesignProblem.of(small_case(objectives=objectives))
    outcome = enumerate_designs(problem)
    found = {
        tuple(genes): values
        for genes, values in zip(outcome.genes.tolist(), outcome.objectives.tolist(), strict=True)
    }
    wanted = plain_front(problem)
    assert len(wanted) > 3
    assert found.keys() <= wanted.keys()
    # Designs that are worth the same stand once on the front.
    for values in wanted.values():
        assert any(values == pytest.approx(other, rel=SAME) for other in found.values())
    for genes, values in found.items():
        assert values == pytest.approx(wanted[genes], rel=SAME)
    assert outcome.evaluations == problem.space.count
    assert not outcome.interrupted


def test_the_size_of_a_chunk_changes_nothing() -> None:
    problem = DesignProblem.of(small_case())
    whole = enumerate_designs(problem)
    for chunk in (1, 7, 299, 300):
        parts = enumerate_designs(problem, chunk=chunk)
        assert np.array_equal(parts.genes, whole.genes)
        assert np.array_equal(parts.objectives, whole.objectives)
        assert parts.feasible == whole.feasible


def test_threads_change_nothing() -> None:
    lengths = tuple(np.arange(110.0, 330.0, 5.0).tolist())
    chain = SegmentChoice(lengths, ("chain studless R3", "chain studless R4"))
    problem = DesignProblem.of(small_case(segments=(chain,)))
    assert problem.space.count > 3 * LEAST_SHARE
    one, three = (enumerate_designs(problem, workers=workers) for workers in (1, 3))
    assert np.array_equal(one.genes, three.genes)
    assert np.array_equal(one.objectives, three.objectives)
    assert one.feasible == three.feasible


def test_progress_is_told() -> None:
    problem = DesignProblem.of(small_case())
    told: list[tuple[int, int]] = []
    enumerate_designs(problem, chunk=100, progress=lambda done, total: told.append((done, total)))
    assert told == [(100, 300), (200, 300), (300, 300)]


def test_an_interrupted_enumeration_keeps_the_front_so_far() -> None:
    problem = DesignProblem.of(small_case())

    def stop(done: int, _: int) -> None:
        if done >= 200:
            raise KeyboardInterrupt

    outcome = enumerate_designs(problem, chunk=100, progress=stop)
    assert outcome.interrupted
    assert outcome.evaluations == 200
    genes = problem.space.genes_between(0, 200)
    objectives, exceedance = problem.evaluate(genes)
    feasible = objectives[exceedance <= ROUNDING]
    assert outcome.feasible == len(feasible) > 0
    for own in outcome.objectives:
        assert (feasible == own).all(axis=1).any()
        assert not ((feasible <= own).all(axis=1) & (feasible < own).any(axis=1)).any()


def test_without_a_feasible_design_the_one_that_fails_by_the_least_is_known() -> None:
    case = replace(small_case(), checks=Checks(safety_factor=20.0))
    problem = DesignProblem.of(case)
    outcome = enumerate_designs(problem, chunk=50)
    assert len(outcome.genes) == outcome.feasible == 0
    exceedances = {}
    for row in problem.space.genes_between(0, problem.space.count).tolist():
        plain = plain_value(problem, tuple(row))
        if plain is not None:
            exceedances[tuple(row)] = plain[1]
    least = min(exceedances.values())
    assert outcome.least_exceedance == pytest.approx(least, rel=SAME)
    assert outcome.closest is not None
    assert exceedances[outcome.closest] == pytest.approx(least, rel=SAME)


def test_what_is_known_of_all_designs_is_kept_when_the_measuring_is_interrupted() -> None:
    """None passes, which the first pass has found; Ctrl-C comes in the second."""
    problem = DesignProblem.of(replace(small_case(), checks=Checks(safety_factor=20.0)))
    told: list[int] = []

    def stop(done: int, _: int) -> None:
        told.append(done)
        if told == [100, 200, 300, 100]:
            raise KeyboardInterrupt

    outcome = enumerate_designs(problem, chunk=100, progress=stop)
    assert len(told) == 4
    assert outcome.interrupted
    assert outcome.evaluations == problem.space.count == 300
    assert outcome.closest is not None


def test_the_estimate_counts_the_designs_and_is_put_into_words() -> None:
    found = estimate(DesignProblem.of(small_case()))
    assert found.designs == 300
    assert found.seconds > 0.0
    assert Estimate(2_000_000, 8.4).words == "2,000,000 designs, about 8 s"
    assert Estimate(300, 0.001).words == "300 designs, less than a second"
    assert Estimate(10**9, 4000.0).words == "1,000,000,000 designs, about 67 min"
    assert Estimate(10**10, 40000.0).words == "10,000,000,000 designs, about 11.1 h"


def test_the_estimate_of_whole_moorings_counts_what_bounds_leave_out() -> None:
    """Of the turret's 70,200 designs bounds spare all but some 4,400: 4 min were told for 3 s."""
    problem = MooringProblem.of(read_case(CASES / "design-turret-56m" / "case.toml"))
    told = estimate(problem).seconds
    genes = problem.space.genes_of(np.linspace(0, problem.space.count - 1, 100).astype(np.int64))
    began = time.perf_counter()
    problem.assess(genes, stops_early=True)
    one_by_one = (time.perf_counter() - began) / 100 * problem.space.count
    assert told < 0.3 * one_by_one
