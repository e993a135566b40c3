"""When a step in time is closed, and what all steps of a run took."""

from __future__ import annotations

from dataclasses import dataclass, field

from catopt.fem.march import MarchReport
from catopt.model.validity import Findings


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
    surprise : float
        Difference of a bar's tension from what it was heading for in the last step beyond which a
        step is halved, over the largest tension of the run so far or what a line weighs.
    max_refinements : int
        Times that a step may be halved for that. A step as short as that is taken as it is.
    max_ringing : float
        Part of the strain energy, over time, that such differences may hold. Beyond it the run
        stops: what it shows is ringing that its steps do not resolve.
    """

    tolerance: float = 1e-6
    max_iterations: int = 30
    max_halvings: int = 10
    surprise: float = 0.05
    max_refinements: int = 10
    max_ringing: float = 0.2

    def __post_init__(self) -> None:
        found = Findings("StepControls")
        found.number("tolerance", self.tolerance, "", above=0.0)
        found.number("max_iterations", self.max_iterations, "", at_least=1.0)
        found.number("max_halvings", self.max_halvings, "", at_least=0.0)
        found.number("surprise", self.surprise, "", above=0.0)
        found.number("max_refinements", self.max_refinements, "", at_least=0.0)
        found.number("max_ringing", self.max_ringing, "", at_least=0.0, infinite=True)
        found.raise_if_any()


@dataclass
class StepCounts:
    """What the steps took.

    Attributes
    ----------
    steps, iterations, halvings : int
        Steps taken, Newton iterations of all, and times that a step was halved.
    refinements, unresolved : int
        Times that a step was halved because a tension surprised; steps as short as allowed in which
        one still did.
    ringing, strain : float
        Strain energy over time, J s: of what in the tensions changes from step to step, and all.
    shortest : float
        Shortest step, s.
    """

    steps: int = 0
    iterations: int = 0
    halvings: int = 0
    refinements: int = 0
    unresolved: int = 0
    ringing: float = 0.0
    strain: float = 0.0
    shortest: float = field(default=float("inf"))

    def add(self, report: MarchReport) -> None:
        """Count what a piece of the run took."""
        self.steps += report.steps
        self.iterations += report.iterations
        self.halvings += report.halvings
        self.refinements += report.refinements
        self.unresolved += report.unresolved
        self.ringing += report.ringing
        self.strain += report.strain
        self.shortest = min(self.shortest, report.shortest)
