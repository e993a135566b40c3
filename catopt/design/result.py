"""The answer of a design search, as a value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from catopt.checks.result import CheckReport, CheckResult
from catopt.design.document import design_document
from catopt.design.mooring_point import MooringPoint
from catopt.model import Anchor, Case, Line
from catopt.shown import Displayable

__all__ = ["DesignPoint", "DesignResult", "NearMiss", "Neighbour"]


@dataclass(frozen=True, repr=False)
class DesignPoint(Displayable):
    """One line of the front."""

    # its segments and clump weights, with component and nominal diameter in each segment
    line: Line
    anchor: Anchor | None  # the sinker that was chosen for it, or the anchor of the case
    genes: tuple[int, ...]  # its place in the design space
    # ``mass_kg``, ``offset_m``, ``excursion_m``, ``cost_USD``: all that are known, wanted as
    # objective or not
    objectives: Mapping[str, float]
    # the same report that ``catopt check`` gives for this line; of a whole mooring the
    # hardest of each check over all lines, headings and states
    checks: CheckReport
    # of a whole mooring: the state that takes the body farthest
    mooring: MooringPoint | None = None

    @property
    def governing(self) -> CheckResult | None:
        """The check that is nearest to its limit."""
        return self.checks.governing


@dataclass(frozen=True)
class Neighbour:
    """What one step of one variable would do to a design."""

    change: str  # in words: ``"segment 1: chain studless R3 81 mm for 76 mm"``
    point: DesignPoint | None  # the changed design; None where it has no equilibrium
    reason: str = ""  # why there is none; else empty


@dataclass(frozen=True)
class NearMiss:
    """The design that misses feasibility by least, when none is feasible."""

    line: Line  # the design
    # the checks that it fails, the worst first; empty where it has no equilibrium
    failing: tuple[CheckResult, ...]
    reason: str = ""  # why there is no equilibrium; else empty


@dataclass(frozen=True, repr=False)
class DesignResult(Displayable):
    """The front and how it was found."""

    case: Case  # what was asked
    objectives: tuple[str, ...]  # keys of `DesignPoint.objectives` that were made small
    # by rising first objective; every one is feasible, none is beaten in all objectives
    front: tuple[DesignPoint, ...]
    recommended: int  # number of the recommended design, from 1 as everywhere: see `best`
    recommendation: str  # why, in words
    method: str  # ``"enumeration"``, ``"nsga2"`` or ``"swarm"``
    is_exact: bool  # whether every design of the space was evaluated, or proved needless
    designs: int  # designs that the space holds
    evaluations: int  # designs that were evaluated, each under all load cases
    feasible: int  # how many of those passed every check
    # of the front, in the units of the objectives multiplied, up to `reference_point`
    hypervolume: float
    reference_point: tuple[float, ...]  # the worst corner that the hypervolume is measured from
    seed: int  # of the random numbers
    interrupted: bool  # whether the search was stopped before its end
    # for each objective: which check the end of the front runs into there, in words
    ends: tuple[str, ...]
    # what one size or one step up or down would do to the recommended design
    neighbours: tuple[Neighbour, ...]
    # the line that stands in the case file, by the same checks; no part of the front
    present: Neighbour
    seconds: float  # wall time of the search
    # what an engineer should know, such as figures that were read in no document
    warnings: tuple[str, ...] = ()
    # of whole moorings: how many designs were not evaluated because a bound proves them
    # needless, by bound (`catopt.design.bounds.BOUNDS`)
    excluded: Mapping[str, int] = field(default_factory=dict)

    @property
    def best(self) -> DesignPoint:
        """The recommended design: the knee of the front."""
        return self.front[self.recommended - 1]

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt design --json`` prints (schema catopt.design/1)."""
        return design_document(self)
