"""Lines that snap, run again: the mean of the minutes' maxima, each beside the same minute."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from catopt.answers.size_card import proof_words
from catopt.arrays import Array
from catopt.verify.convergence_check import LIMIT, Change, added, largest_changes
from catopt.verify.dynamic_result import DynamicPart
from catopt.verify.snap_rerun import blocks_of, paired_change, storm_block

SEEDS, MINUTES = 3, 9


def snaps(factor: float = 1.0, spread: float = 0.1, seed: int = 1) -> tuple[list[Array], ...]:
    """Draw minutes' maxima of runs, N, and those of the runs again, which chaos moves."""
    draw = np.random.default_rng(seed)
    first = [draw.gumbel(60e3, 20e3, MINUTES) for _ in range(SEEDS)]
    again = [factor * each * (1.0 + spread * draw.standard_normal(MINUTES)) for each in first]
    return first, again


def change(factor: float, spread: float = 0.1, seed: int = 1) -> Change:
    found = paired_change("fairlead_tension", "step", *snaps(factor, spread, seed))
    assert found is not None
    return found


def test_by_hand() -> None:
    """Of 10, 20, 30 and 12, 18, 36: the mean moves by 2 to 22; t(0.95, 2) = 2.920.

    Deviation of 2, -2 and 6: 4, over sqrt(3) and times 2.920: 6.743.
    """
    old, new = [np.array([10.0, 20.0]), np.array([30.0])], [np.array([12.0, 18.0, 36.0])]
    found = paired_change("fairlead_tension", "bars", old, new)
    assert found is not None
    assert found.amount == pytest.approx(2.0)
    assert found.size == pytest.approx(2.0 / 22.0)
    assert found.chance == pytest.approx(2.920 * 4.0 / math.sqrt(3.0), rel=1e-3)
    assert found.by_chance == pytest.approx(2.920 * 4.0 / math.sqrt(3.0) / 22.0, rel=1e-3)
    both = paired_change("fairlead_tension", "both", old, new)
    assert both is not None
    assert both.amount == pytest.approx(8.0 / 3.0)  # three quarters of the error are shown


def test_chaos_alone_is_no_error() -> None:
    """Snaps that only fall otherwise pass nearly always; the largest of each run moves by more."""
    decided, moved = 0, []
    for seed in range(200):
        decided += change(1.0, seed=seed).decides(None)
        old, new = snaps(seed=seed)
        moved.append(max(abs(b.max() / a.max() - 1.0) for a, b in zip(old, new, strict=True)))
    assert decided <= 0.05 * 200  # beyond 5 % and beyond the interval of 90 %
    assert np.mean(np.array(moved) > LIMIT) > 0.9  # what used to be compared


@pytest.mark.parametrize("factor", [0.85, 1.15])
def test_an_error_is_found(factor: float) -> None:
    assert sum(change(factor, seed=seed).decides(None) for seed in range(100)) >= 95


def test_too_few_minutes_prove_nothing() -> None:
    wild = change(1.3, spread=1.5)
    assert wild.is_by_chance
    assert wild.is_too_uncertain
    assert not wild.decides(None)
    assert wild.is_small_beside(1e9)  # a tension that decides nothing need not be known better
    assert not change(1.0).is_too_uncertain


def test_both_ways_together_are_from_the_first_to_the_last_run() -> None:
    first, again = snaps(1.2)
    there = (
        paired_change("anchor_tension", "step", first, again),
        paired_change("anchor_tension", "bars", again, first),
        paired_change("anchor_tension", "both", first, first),
    )
    (found,) = largest_changes(added(each for each in there if each is not None))
    assert (found.way, found.amount) == ("both", 0.0)  # errors that cancel leave none


def test_minutes_that_are_not_the_same_are_not_compared() -> None:
    assert paired_change("offset", "step", [np.ones(3)], [np.ones(4)]) is None
    assert paired_change("offset", "step", [np.zeros(3)], [np.zeros(3)]) is None


def test_of_all_times_that_it_was_run_the_worst_counts() -> None:
    """A mesh that is too coarse is not what a storm is told by."""
    storms = {1: 130e3, 2: 180e3, 3: 170e3}
    part: Any = SimpleNamespace(
        levels=[(None, 1), ("step", 2), ("bars", 3)],
        storm=lambda _, runs: SimpleNamespace(most_probable=storms[runs]),
    )
    worst = DynamicPart.worst_storm(part, "fairlead_tension")
    assert worst is not None
    assert worst.most_probable == 180e3
    part.storm = lambda *_: None
    assert DynamicPart.worst_storm(part, "fairlead_tension") is None


@pytest.mark.parametrize(
    ("size", "chance", "said"),
    [
        (0.04, 3e3, "changes by 4.0% (chance: up to 4.5%), run again at half the step"),
        (0.396, 9e3, "changes by 39.6% (chance: up to 13.5%), no check changes its verdict"),
        (0.12, 9e3, "changes by 12.0% (chance: up to 13.5%), run again at half the step"),
    ],
)
def test_a_proof_is_said_with_its_chance(size: float, chance: float, said: str) -> None:
    """Of a mean of 66.7 kN."""
    over = 2e5 / 3.0
    worst = Change("fairlead_tension", "both", size, size * over, chance, is_paired=True)
    of: Any = SimpleNamespace(worst_change=worst, proof="converged")
    assert said in str(proof_words(of))


def test_the_storm_is_found_from_some_fifteen_blocks() -> None:
    """Of 50 minutes in 5 runs 200 s each, of 10 minutes a minute each."""
    time = np.linspace(0.0, 600.0, 601)
    course = SimpleNamespace(time=time, value=time, duration=600.0)
    run: Any = SimpleNamespace(history=SimpleNamespace(course=lambda _: course))
    assert storm_block("fairlead_tension", [run] * 5) == pytest.approx(200.0)
    assert storm_block("fairlead_tension", [run]) == pytest.approx(60.0)
    (blocks,) = blocks_of("fairlead_tension", [run], 200.0)
    assert blocks.tolist() == [199.0, 399.0, 600.0]
