"""The answer of a design search, as a value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from catopt.checks.result import CheckReport, CheckResult
from catopt.design.document import design_document
from catopt.design.mooring_point import MooringPoint
from catopt.model import Anchor, Case, Line
from catopt.shown import Shown

__all__ = ["DesignPoint", "DesignResult", "NearMiss", "Neighbour"]


@dataclass(frozen=True, repr=False)
class DesignPoint(Shown):
    """One line of the front.

    Attributes
    ----------
    line : Line
        Its segments and clump weights, with component and nominal diameter in each segment.
    anchor : Anchor or None
        The sinker that was chosen for it, or the anchor of the case.
    genes : tuple of int
        Its place in the design space.
    objectives : mapping of str to float
        ``mass_kg``, ``offset_m``, ``excursion_m``, ``cost_USD``: all that are known, wanted as
        objective or not.
    checks : CheckReport
        The same report that ``catopt check`` gives for this line; of a whole mooring the hardest
        of each check over all lines, headings and states.
    mooring : MooringPoint or None
        Of a whole mooring: the state that takes the body farthest.
    """

    line: Line
    anchor: Anchor | None
    genes: tuple[int, ...]
    objectives: Mapping[str, float]
    checks: CheckReport
    mooring: MooringPoint | None = None

    @property
    def governing(self) -> CheckResult | None:
        """The check that is nearest to its limit."""
        return self.checks.governing


@dataclass(frozen=True)
class Neighbour:
    """What one step of one variable would do to a design.

    Attributes
    ----------
    change : str
        In words: ``"segment 1: chain studless R3 81 mm for 76 mm"``.
    point : DesignPoint or None
        The changed design; None where it has no equilibrium.
    reason : str
        Why there is none; else empty.
    """

    change: str
    point: DesignPoint | None
    reason: str = ""


@dataclass(frozen=True)
class NearMiss:
    """The design that misses feasibility by least, when none is feasible.

    Attributes
    ----------
    line : Line
        The design.
    failing : tuple of CheckResult
        The checks that it fails, the worst first; empty where it has no equilibrium.
    reason : str
        Why there is no equilibrium; else empty.
    """

    line: Line
    failing: tuple[CheckResult, ...]
    reason: str = ""


@dataclass(frozen=True, repr=False)
class DesignResult(Shown):
    """The front and how it was found.

    Attributes
    ----------
    case : Case
        What was asked.
    objectives : tuple of str
        Keys of `DesignPoint.objectives` that were made small.
    front : tuple of DesignPoint
        By rising first objective; every one is feasible, none is beaten in all objectives.
    recommended : int
        Index of the recommended design: the knee of the front.
    recommendation : str
        Why, in words.
    method : str
        ``"enumeration"``, ``"nsga2"`` or ``"swarm"``.
    is_exact : bool
        Whether every design of the space was evaluated, or proved needless.
    designs : int
        Designs that the space holds.
    evaluations : int
        Designs that were evaluated, each under all load cases.
    feasible : int
        How many of those passed every check.
    hypervolume : float
        Of the front, in the units of the objectives multiplied, up to `reference_point`.
    reference_point : tuple of float
        The worst corner that the hypervolume is measured from.
    seed : int
        Of the random numbers.
    interrupted : bool
        Whether the search was stopped before its end.
    ends : tuple of str
        For each objective: which check the end of the front runs into there, in words.
    neighbours : tuple of Neighbour
        What one size or one step up or down would do to the recommended design.
    present : Neighbour
        The line that stands in the case file, by the same checks; no part of the front.
    seconds : float
        Wall time of the search.
    excluded : mapping of str to int
        Of whole moorings: how many designs were not evaluated because a bound proves them needless,
        by bound (`catopt.design.bounds.BOUNDS`).
    warnings : tuple of str
        What an engineer should know, such as figures that were read in no document.
    """

    case: Case
    objectives: tuple[str, ...]
    front: tuple[DesignPoint, ...]
    recommended: int
    recommendation: str
    method: str
    is_exact: bool
    designs: int
    evaluations: int
    feasible: int
    hypervolume: float
    reference_point: tuple[float, ...]
    seed: int
    interrupted: bool
    ends: tuple[str, ...]
    neighbours: tuple[Neighbour, ...]
    present: Neighbour
    seconds: float
    warnings: tuple[str, ...] = ()
    excluded: Mapping[str, int] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt design --json`` prints (schema catopt.design/1)."""
        return design_document(self)
