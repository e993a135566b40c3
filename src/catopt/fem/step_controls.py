"""When a step in time is closed, and what all steps of a run took."""

from __future__ import annotations

from dataclasses import dataclass, field

from catopt.fem.march import MarchReport
from catopt.model.validity import Findings

__all__ = ["StepControls", "StepCounts"]


@dataclass(frozen=True)
class StepControls:
    """When a step is closed, and what is done when it does not close.

    Attributes
    ----------
    tolerance : float
        Largest force left over at a node, over the largest tension or what a line weighs.
    max_iterations : int
        Newton iterations before a step is halved.
    max_halvings : int
        Times that a step may be halved before the run stops.
    max_ringing : float
        Part of the steps in which accelerations may change by more than velocities over the step.
        Beyond it the run stops: what it shows is its own ringing. A step too long for a scheme that
        does not damp goes that way when bars snap taut, with tensions that are off by any factor.
    """

    tolerance: float = 1e-6
    max_iterations: int = 12
    max_halvings: int = 10
    max_ringing: float = 0.2

    def __post_init__(self) -> None:
        found = Findings("StepControls")
        found.number("tolerance", self.tolerance, "", above=0.0)
        found.number("max_iterations", self.max_iterations, "", at_least=1.0)
        found.number("max_halvings", self.max_halvings, "", at_least=0.0)
        found.number("max_ringing", self.max_ringing, "", at_least=0.0, at_most=1.0)
        found.raise_if_any()


@dataclass
class StepCounts:
    """What the steps took.

    Attributes
    ----------
    steps, iterations, halvings : int
        Steps taken, Newton iterations of all, and times that a step was halved.
    ringing : int
        Steps in which accelerations changed by more than velocities over the step.
    shortest : float
        Shortest step, s.
    """

    steps: int = 0
    iterations: int = 0
    halvings: int = 0
    ringing: int = 0
    shortest: float = field(default=float("inf"))

    def add(self, report: MarchReport) -> None:
        """Count what a piece of the run took."""
        self.steps += report.steps
        self.iterations += report.iterations
        self.halvings += report.halvings
        self.ringing += report.ringing
        self.shortest = min(self.shortest, report.shortest)
