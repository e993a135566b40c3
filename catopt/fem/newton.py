"""Newton's method on one state, under one law of the bars."""

from __future__ import annotations

import math

import numpy as np

from catopt.arrays import Array
from catopt.compiled import compiled
from catopt.fem.banded import WIDTH
from catopt.fem.problem import Problem
from catopt.fem.resting import BarLoads, Law, Net, State
from catopt.fem.seabed import Ground
from catopt.fem.step import StepReport, Water, take_steps

_DRAG_IN = 1e-9
"""Stiffness that holds a loose node during one step, over what line and loads weigh per length."""
_SOLVING = 2e-4
"""Time that a bar takes in each iteration as plain Python, s."""
_USUAL = 25
"""Iterations on the way to rest."""


class Newton:
    """Iterations on one state, which they move; counts them, and keeps the last report."""

    def __init__(self, problem: Problem, state: State, most: int) -> None:
        self.problem = problem
        self.state = state
        self.iterations = 0
        self.last: StepReport | None = None
        self._most = most
        count = problem.bars.length.size
        self._visits = _USUAL * count
        varies = problem.current is not None or math.isfinite(problem.surface)
        blocks = (count if varies else 0, 3, 3)
        self.loads = BarLoads(np.zeros((count, 3)), np.zeros(blocks), np.zeros(blocks))
        rows = 4 * count + 3 * (problem.bars.start.size - 1)
        aside = rows if (problem.body.of_end[:, 0] >= 0).any() else 0
        self._room = np.zeros((rows, WIDTH)), np.zeros(rows), np.zeros((aside, 3))
        self._drag_in = _DRAG_IN * problem.soft / float(problem.bars.length.sum())

    @property
    def is_spent(self) -> bool:
        """Whether all iterations are used up."""
        return self.iterations >= self._most

    def run(
        self, ease: float, ground: Ground, limit: int, tolerance: float, *, keep: float
    ) -> bool:
        """Iterate until the forces balance; say whether they do.

        `ease`, `keep`: e of `assembly`, and what a bar may keep there; `limit`: iterations, at
        most; `tolerance`: largest force left over at a node over the largest tension.
        """
        problem = self.problem
        keep = 0.0 if problem.carries_compression else keep
        law = Law(ease, problem.soft, keep, problem.carries_compression, self._drag_in)
        net = Net(problem.bars, self.state, self.loads, problem.nodal, ground, law, *self._room)
        # A current is another one wherever the line goes.
        most = limit if problem.current is None else 1
        for _ in range(0, limit, most):
            water = Water(problem.first_node, problem.surface, self._velocity())
            left = self._most - self.iterations
            iterate = compiled(take_steps, _SOLVING * self._visits)
            report = iterate(net, problem.body, water, most, left, tolerance)
            self.iterations += report.used
            self.last = report.last
            if report.is_settled or report.is_over:
                return bool(report.is_settled)
        return False

    def _velocity(self) -> Array:
        """Of the current at the bars' middles, m/s."""
        problem, x, a = self.problem, self.state.x, self.problem.first_node
        if problem.current is None:
            return np.zeros((0, 3))
        middles = 0.5 * (x[a] + x[a + 1])
        return np.ascontiguousarray(problem.current.velocity(middles), dtype=np.float64)
