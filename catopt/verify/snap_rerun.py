"""A line that snaps run again: the same minutes of the same seas, one beside the other."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final, Literal

import numpy as np
from scipy.special import stdtrit

from catopt.arrays import Array
from catopt.fem.extremes import Extreme, block_maxima, gumbel
from catopt.verify.convergence_check import REMAINS, Change, Way

if TYPE_CHECKING:
    from catopt.verify.dynamic_run import DynamicRun

BLOCK: Final = 60.0
"""s, of a run of a line that goes slack, of which the largest value counts."""
LEAST_BLOCKS: Final = 20
"""From which the storm's largest value is found."""
STORM_BLOCKS: Final = 15
"""Blocks that the storm's largest value is found from, which are then longer, but no longer than a
run: Gumbel's distribution of many short ones is too high (`benchmarks/results/intervals.md`)."""

_ONE_SIDED: Final = 0.95

Levels = Sequence[tuple[Way | None, Sequence["DynamicRun"]]]


def storm_block(quantity: str, runs: Sequence[DynamicRun]) -> float:
    """Length of the blocks of some runs that a storm's largest value is found from, s."""
    time = sum(run.history.course(quantity).duration for run in runs)
    return max(BLOCK, time / STORM_BLOCKS)


def blocks_of(quantity: str, runs: Sequence[DynamicRun], block: float = BLOCK) -> list[Array]:
    """Largest value of a quantity in every block, s, of every run.

    That anywhere along a line is at no time known but as a whole: it is the larger tension of its
    ends in that block, times what the run has more along the line than there.
    """
    if quantity != "largest_tension":
        courses = [run.history.course(quantity) for run in runs]
        return [block_maxima(each.time, each.value, block) for each in courses]
    ends = [blocks_of(each, runs, block) for each in ("fairlead_tension", "anchor_tension")]
    return [
        np.maximum(*pair) * (run.maxima[quantity] / max(pair[0].max(), pair[1].max()))
        for *pair, run in zip(*ends, runs, strict=True)
    ]


def storm_of_blocks(quantity: str, runs: Sequence[DynamicRun], duration: float) -> Extreme | None:
    """Find the largest value in a storm, s, by Gumbel's distribution of the maxima of blocks.

    None for runs of less than 20 minutes in all, or blocks that are alike.
    """
    time = sum(run.history.course(quantity).duration for run in runs)
    if time < LEAST_BLOCKS * BLOCK:
        return None
    maxima = np.concatenate(blocks_of(quantity, runs, storm_block(quantity, runs)))
    fit = gumbel(maxima.tolist(), time / maxima.size, duration)
    return None if fit is None else fit.extreme


def paired_change(
    quantity: str, way: Way | Literal["both"], old: Sequence[Array], new: Sequence[Array]
) -> Change | None:
    """Say how far the mean of the minutes' maxima moved when runs were made again.

    `old`, `new`: of every run its minutes' maxima, N or m. A line that goes slack and snaps is
    chaotic: in a finer run snaps fall otherwise, and the largest of a few minutes is another draw,
    not an error. The mean over all minutes, each beside the same minute of the same sea, moves by
    the error and by a chance that their differences show: Student's interval, 90 %. Both ways
    together are the change from the first run to the last one, a third more. None for fewer than
    two minutes, or a mean of 0.
    """
    before, after = np.concatenate(old), np.concatenate(new)
    count = before.size
    if count != after.size or count < 2 or not after.mean() > 0.0:
        return None
    apart, times = after - before, REMAINS if way == "both" else 1.0
    spread = float(apart.std(ddof=1)) / math.sqrt(count)
    chance = times * float(stdtrit(count - 1, _ONE_SIDED)) * spread
    amount = times * abs(float(apart.mean()))
    return Change(quantity, way, amount / float(after.mean()), amount, chance, is_paired=True)


def paired_changes(quantity: str, levels: Levels) -> list[Change]:
    """Say how far a quantity moved from level to level, and by all of them together."""
    of = [blocks_of(quantity, runs) for _, runs in levels]
    ways = [way for way, _ in levels]
    steps = zip(ways[1:], of, of[1:], strict=False)
    found = [paired_change(quantity, way, *pair) for way, *pair in steps if way is not None]
    if len(of) > 2:
        found.append(paired_change(quantity, "both", of[0], of[-1]))
    return [each for each in found if each is not None]
