"""What governs a line: what a step less of each of its variables runs into."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.checks.result import CheckResult
from catopt.design.evaluation import DesignProblem
from catopt.design.neighbours import neighbour, steps
from catopt.sizing.settle import Settled


@dataclass(frozen=True)
class Limit:
    """A step to less that the line cannot take.

    Attributes
    ----------
    change : str
        In words: ``"chain: 28 m for 28.5 m"``.
    check : CheckResult or None
        The check that fails by the most; None where there is no equilibrium.
    reason : str
        Why there is none; else empty.
    """

    change: str
    check: CheckResult | None
    reason: str = ""

    @property
    def words(self) -> str:
        """What it runs into."""
        if self.check is None:
            return self.reason
        return self.check.in_case


def limits(settled: Settled) -> tuple[Limit, ...]:
    """List the steps to less that fail under the settled loads, each with its worst check."""
    problem = DesignProblem.of(settled.posed.case)
    found = []
    for step in steps(problem.space, settled.point.genes):
        if step.direction >= 0:
            continue
        tried = neighbour(problem, step)
        if tried.point is None:
            found.append(Limit(tried.change, None, tried.reason))
        elif not tried.point.checks.passes:
            found.append(Limit(tried.change, tried.point.checks.governing))
    return tuple(found)
