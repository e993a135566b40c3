"""Newton's method on one state, under one law of the bars."""

from __future__ import annotations

import math

import numpy as np

from catopt.compiled import compiled
from catopt.fem.banded import WIDTH
from catopt.fem.loads import bar_loads
from catopt.fem.problem import Problem
from catopt.fem.resting import BarLoads, Law, Net, State
from catopt.fem.seabed import NO_FRICTION, Ground
from catopt.fem.step import StepReport, newton_step, take_step

_DRAG_IN = 1e-9
"""Stiffness that holds a loose node during one step, over what line and loads weigh per length."""
_ASTRAY = 1e4
"""Turn of a bar, rad, after which nothing is to be hoped for with friction: it has no energy."""
_MOVING, _LOADING, _SOLVING = 2e-6, 1e-6, 2e-4
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
        move = compiled(take_step, _MOVING * self._visits)
        if ease == 1.0:
            self._pull_springs()
        for _ in range(limit):
            report = self._look(net)
            if _is_settled(report, tolerance):
                if ease > 0.0:
                    return True
                # The step that is at hand: near the answer it leaves rounding errors only.
                move(net, 1.0)
                report = self._look(net)
                # Where a node touches down or lifts off within the tolerance, there is more to do.
                if _is_settled(report, tolerance):
                    return True
            is_astray = report.turn > _ASTRAY and ground.law != NO_FRICTION
            if report.singular or self.is_spent or is_astray:
                return False
            # A step that turns a bar by more than a radian is not to be followed all the way.
            part = 1.0 if ease == 1.0 or report.turn <= 1.0 else 1.0 / math.sqrt(report.turn)
            move(net, part)
            if ease == 1.0:
                self._pull_springs()
        return False

    def _look(self, net: Net) -> StepReport:
        """Measure what is left over at the present shape, and find the step that balances it."""
        problem, x, a = self.problem, self.state.x, self.problem.first_node
        velocity = np.zeros((0, 3))
        if problem.current is not None:
            middles = 0.5 * (x[a] + x[a + 1])
            velocity = np.ascontiguousarray(problem.current.velocity(middles), dtype=np.float64)
        load = compiled(bar_loads, _LOADING * self._visits)
        load(x, a, problem.bars, problem.surface, velocity, self.loads)
        report: StepReport = compiled(newton_step, _SOLVING * self._visits)(net, problem.body)
        self.iterations += 1
        self.last = report
        return report

    def _pull_springs(self) -> None:
        """Tension of springs without a length of their own at the present shape."""
        a = self.problem.first_node
        size = np.linalg.norm(self.state.x[a + 1] - self.state.x[a], axis=1)
        self.state.tension[:] = self.problem.soft * size / self.problem.bars.length


def _is_settled(report: StepReport, tolerance: float) -> bool:
    return (
        report.changed == 0
        and report.away <= tolerance
        and report.imbalance <= tolerance * report.tension
        and report.strain <= tolerance
    )
