"""A campaign over many lines, by any number of processes with the same result."""

from __future__ import annotations

from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import repeat
from multiprocessing import get_context

from tests.campaign.evaluation import evaluate
from tests.campaign.lines import draw
from tests.campaign.tally import Tally

BLOCK = 1000
"""Lines that are judged together."""


def run(count: int, seed: int, *, workers: int = 1, first: int = 0) -> Tally:
    """Judge lines `first` to `first + count` (not included) of a seed."""
    end = first + count
    blocks = [(a, min(a + BLOCK, end)) for a in range(first, end, BLOCK)]
    tally = Tally()
    if workers <= 1:
        for block in blocks:
            tally.merge(judged(seed, block))
        return tally
    with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
        for part in pool.map(judged, repeat(seed), blocks):
            tally.merge(part)
    return tally


def judged(seed: int, block: tuple[int, int]) -> Tally:
    """Tally of one block of lines."""
    tally = Tally()
    tally.add(evaluate(list(map(partial(draw, seed), range(*block)))))
    return tally
