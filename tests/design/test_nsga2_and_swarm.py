"""What both searches promise, whatever the space: compared with a record of every evaluation."""

from __future__ import annotations

import logging
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from catopt.checks.kinds import ROUNDING
from catopt.design.front import Outcome, hypervolume, non_dominated, reference_point
from catopt.design.nsga2 import nsga2
from catopt.design.swarm import swarm

from .known_space import KnownSpace, Recorded, buoy, funnel, leg, scrambled, tanker

Search = Callable[..., Outcome]

both = pytest.mark.parametrize("search", [nsga2, swarm])


def relative_hypervolume(space: KnownSpace, outcome: Outcome) -> float:
    exact = space.front.objectives
    reference = reference_point(exact)
    return hypervolume(outcome.objectives, reference) / hypervolume(exact, reference)


@both
@pytest.mark.parametrize("objectives", [2, 3])
@pytest.mark.parametrize("feasible", [0.01, 0.5])
def test_returns_the_front_of_all_that_it_evaluated(
    search: Search, objectives: int, feasible: float
) -> None:
    space = Recorded(scrambled((9, 8, 7, 6), objectives, feasible))
    outcome = search(space, evaluations=700, population=40, seed=2)
    designs = space.designs
    worth = space.space.evaluate(designs)
    passes = np.flatnonzero(worth.exceedance <= ROUNDING)
    best = passes[non_dominated(worth.objectives[passes])]
    np.testing.assert_array_equal(outcome.genes, designs[best])
    np.testing.assert_array_equal(outcome.objectives, worth.objectives[best])
    assert outcome.feasible == len(passes)
    assert outcome.least_exceedance == worth.exceedance.min()
    assert not outcome.interrupted


@both
@pytest.mark.slow
@pytest.mark.parametrize("budget", [1, 39, 40, 41, 333, 1000])
def test_budget_is_kept_and_no_design_is_evaluated_twice(search: Search, budget: int) -> None:
    space = Recorded(tanker())
    outcome = search(space, evaluations=budget, population=40, seed=2)
    assert len(space.designs) == outcome.evaluations == budget
    assert len(np.unique(space.designs, axis=0)) == budget
    # A clump weight that is absent has no place.
    np.testing.assert_array_equal(space.canonical(space.designs), space.designs)
    assert (space.designs >= 0).all()
    assert (space.designs < space.sizes).all()


@both
@pytest.mark.slow
def test_same_seed_same_front(search: Search) -> None:
    first, again, other = (
        search(buoy(), evaluations=1500, population=50, seed=seed) for seed in (4, 4, 5)
    )
    np.testing.assert_array_equal(first.genes, again.genes)
    np.testing.assert_array_equal(first.objectives, again.objectives)
    assert (first.evaluations, first.feasible) == (again.evaluations, again.feasible)
    assert not np.array_equal(first.objectives, other.objectives)


@pytest.mark.slow
@both
def test_leaves_the_process_as_it_was(
    search: Search,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """No global random number, no file, no logger, nothing printed."""
    monkeypatch.chdir(tmp_path)
    np.random.seed(8)  # noqa: NPY002 - it is the global state that is watched
    expected = np.random.random(3).tolist()  # noqa: NPY002
    np.random.seed(8)  # noqa: NPY002
    root = logging.getLogger()
    before = (root.level, list(root.handlers))
    search(buoy(), evaluations=600, population=50, seed=1)
    assert np.random.random(3).tolist() == expected  # noqa: NPY002
    assert (root.level, list(root.handlers)) == before
    assert list(tmp_path.iterdir()) == []
    assert capsys.readouterr() == ("", "")


@both
def test_no_feasible_design_gives_no_front_and_the_best_miss(search: Search) -> None:
    """The excess falls towards one design, where 0.5 of it is left; both searches go there."""
    space = funnel((30, 30, 30), (21, 4, 13))
    space = KnownSpace("hopeless", space.sizes, -1, -1, space.table, space.exceedance + 0.5)
    outcome = search(space, evaluations=1500, population=40, seed=3)
    assert outcome.genes.shape == (0, 3)
    assert outcome.objectives.shape == (0, 2)
    assert outcome.feasible == 0
    assert outcome.closest == (21, 4, 13)
    assert outcome.least_exceedance == 0.5


@both
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_finds_the_only_feasible_design(search: Search, seed: int) -> None:
    """One of 27,000, from infeasible starts, by the total excess."""
    outcome = search(funnel((30, 30, 30), (21, 4, 13)), evaluations=1500, population=40, seed=seed)
    assert outcome.genes.tolist() == [[21, 4, 13]]
    assert outcome.feasible == 1


@both
def test_no_equilibrium_anywhere(search: Search) -> None:
    space = scrambled((6, 5, 4), 2, 0.0)
    space = KnownSpace("nothing", space.sizes, -1, -1, space.table * np.nan, space.exceedance)
    outcome = search(space, evaluations=100, population=20, seed=1)
    assert len(outcome.genes) == 0
    assert np.isfinite(outcome.least_exceedance)


@both
def test_a_design_without_objectives_is_never_feasible(search: Search) -> None:
    """Even if its checks say so."""
    space = scrambled((6, 5, 4), 2, 0.5)
    table = space.table.copy()
    table[::2] = np.nan
    space = KnownSpace("odd", space.sizes, -1, -1, table, np.full(len(table), -1.0))
    outcome = search(space, evaluations=100, population=20, seed=1)
    assert np.isfinite(outcome.objectives).all()
    assert 0 < outcome.feasible < outcome.evaluations


@both
@pytest.mark.parametrize("sizes", [(1,), (7,), (3, 1), (2, 3, 1, 2), (4, 4, 4)])
def test_a_space_smaller_than_the_budget_ends_the_search(
    search: Search, sizes: tuple[int, ...]
) -> None:
    """The front of so few is found whole; genes of one value are no obstacle."""
    space = scrambled(sizes, 2, 1.0)
    outcome = search(space, evaluations=10_000, population=20, seed=1)
    assert outcome.evaluations <= space.designs
    np.testing.assert_array_equal(outcome.objectives, space.front.objectives)


@both
def test_a_budget_takes_no_memory_before_it_is_used(search: Search) -> None:
    """So many designs would take 24 petabytes."""
    space = scrambled((4, 4), 2, 1.0)
    outcome = search(space, evaluations=10**15, population=20, seed=1)
    np.testing.assert_array_equal(outcome.objectives, space.front.objectives)


@both
@pytest.mark.parametrize("population", [1, 2, 3, 5])
def test_small_populations(search: Search, population: int) -> None:
    outcome = search(buoy(), evaluations=200, population=population, seed=1)
    assert outcome.evaluations == 200


@both
def test_interrupted_search_keeps_its_front(search: Search) -> None:
    def stop(done: int, total: int) -> None:
        assert total == 5000
        if done >= 1000:
            raise KeyboardInterrupt

    space = Recorded(buoy())
    outcome = search(space, evaluations=5000, population=50, seed=1, progress=stop)
    assert outcome.interrupted
    assert len(space.designs) == outcome.evaluations
    assert 1000 <= outcome.evaluations < 5000
    assert len(outcome.genes) > 0


@both
@pytest.mark.slow
def test_progress_rises_to_the_budget(search: Search) -> None:
    told: list[tuple[int, int]] = []
    search(buoy(), evaluations=500, population=50, progress=lambda *numbers: told.append(numbers))
    done = [each for each, _ in told]
    assert done == sorted(set(done))
    assert done[-1] == 500
    assert {total for _, total in told} == {500}


@both
@pytest.mark.parametrize("known", [tanker, leg, buoy])
def test_fronts_are_good(search: Search, known: Callable[[], KnownSpace]) -> None:
    """0.97 is the bar below which no seed may fall; the median's is in the longer study."""
    outcome = search(known(), evaluations=10_000, seed=21)
    assert relative_hypervolume(known(), outcome) >= 0.97


@pytest.mark.slow
@both
@pytest.mark.parametrize("known", [tanker, leg, buoy])
def test_fronts_of_eight_seeds(search: Search, known: Callable[[], KnownSpace]) -> None:
    """10,000 of 200,000 designs or more: median 0.99, none below 0.97, none infeasible."""
    space = known()
    assert space.designs >= 200_000
    volumes = []
    for seed in range(1, 9):
        outcome = search(space, evaluations=10_000, seed=seed)
        assert outcome.evaluations <= 10_000
        assert (space.evaluate(outcome.genes).exceedance <= ROUNDING).all()
        volumes.append(relative_hypervolume(space, outcome))
    assert np.median(volumes) >= 0.99
    assert min(volumes) >= 0.97
    # Nothing is better than the exact front, but for the rounding of the sum.
    assert max(volumes) <= 1.0 + 1e-12
