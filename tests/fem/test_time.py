"""Work grows with the number of bars, not faster."""

from __future__ import annotations

import time

import pytest

from catopt.fem import solve_line
from catopt.model import Line, Segment

LINE = Line([Segment(600.0, 1000.0, EA=5e8)])


def _seconds_an_iteration(elements: int) -> float:
    """Least of three, which a busy machine disturbs least."""
    best = 1e9
    for _ in range(3):
        start = time.process_time()
        solution = solve_line(LINE, height=100.0, horizontal_force=2e5, elements=elements)
        best = min(best, (time.process_time() - start) / solution.iterations)
    return best


@pytest.mark.slow
def test_time_of_an_iteration_is_linear_in_the_bars() -> None:
    """8 times the bars take 8 times as long; 12 leaves room for caches and a busy machine."""
    _seconds_an_iteration(50)
    assert _seconds_an_iteration(8 * 500) < 12 * _seconds_an_iteration(500)


def test_iterations_hardly_grow_with_the_bars() -> None:
    """The soft bed on the way lets touchdown move many nodes at once: 100 times the bars."""
    few = solve_line(LINE, height=100.0, horizontal_force=2e5, elements=40).iterations
    many = solve_line(LINE, height=100.0, horizontal_force=2e5, elements=4000).iterations
    assert many < 2 * few
