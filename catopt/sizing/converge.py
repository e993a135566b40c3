"""Loads and line settle on each other: the loads of a chain, the chain for those loads."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Final, Literal

import numpy as np

from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem, design_point
from catopt.design.front import Floats, Outcome
from catopt.design.neighbours import NoFeasibleDesignError, no_feasible_design
from catopt.design.result import DesignPoint, DesignResult
from catopt.design.search import design_case, enumerate_designs
from catopt.errors import NotConvergedError
from catopt.loads.component import Loads
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.weathervane import ComparedLoads, ShipHeading
from catopt.model import Case
from catopt.model.kinds import Force, Height, Length, SomeForce
from catopt.records import Counted, Record
from catopt.sizing.line_choice import LineChoice
from catopt.words import Message, Several

Water = Literal["high", "low"]
"""At which level of the still water."""

_ROUNDING = 1e-9


@dataclass(frozen=True)
class LoadsAt(Record):
    """The loads of one load case."""

    DOCUMENT = "load_case depth horizontal_force given lying=heading laid_out=parts"

    load_case: str
    """Its name."""
    depth: Length
    """Of the still water."""
    water: Water = "high"
    condition: str = ""  # of a ship: ``"loaded"`` or ``"ballast"``
    parts: tuple[Loads, ...] = ()  # on the ship, on the buoy; empty where the force was given
    given: SomeForce = 0.0
    """Force that was given instead of weather; 0 otherwise."""
    lying: ShipHeading | None = None
    """Of a ship: how it lies under the largest force of all directions and stable headings; None
    for a buoy."""

    @property
    def laid_out(self) -> tuple[ComparedLoads, ...]:
        """On the ship, on the buoy: each as catopt loads has it."""
        return tuple(map(ComparedLoads, self.parts))

    @property
    def horizontal_force(self) -> SomeForce:
        """Sum of all parts and of what was given, along one direction."""
        return math.fsum([self.given, *(part.horizontal_force for part in self.parts)])


@dataclass(frozen=True)
class SizingCase:
    """What goes to the design search."""

    case: Case  # with load cases, checks and design
    loads: tuple[LoadsAt, ...]
    """The forces of each extreme load case, in the order of the case: of all lines together where
    there are several."""
    drag_anchor: DragAnchorSize | None = None  # that the case is held by, where it is one


@dataclass(frozen=True)
class Assumed:
    """The line that the loads were computed for."""

    diameter: Height = 0.0
    """Nominal, of the chain that the water moves; 0 where it is not counted."""
    pull: SomeForce = 0.0
    """Of the line, or of all lines, downwards on the buoy."""
    forces: tuple[Force, ...] = ()
    """Least horizontal force of one of several lines in each load case; empty where it is that of
    the loads."""

    def covers(self, other: Assumed) -> bool:
        """Whether the loads for this are on the safe side of those for another."""
        own, others = self._values(other), other._values(self)
        return all(a >= b * (1.0 - _ROUNDING) for a, b in zip(own, others, strict=True))

    def raised_to(self, other: Assumed) -> Assumed:
        """Return the larger of each."""
        diameter, pull, *forces = map(max, self._values(other), other._values(self))
        return Assumed(diameter, pull, tuple(forces))

    def _values(self, other: Assumed) -> tuple[float, ...]:
        forces = self.forces or (0.0,) * len(other.forces)
        return self.diameter, self.pull, *forces


def rounded_up(value: float, digits: int = 2) -> float:
    """Round a positive number up to so many digits: 4231 becomes 4300."""
    if value <= 0.0:
        return 0.0
    unit = 10.0 ** (math.floor(math.log10(value)) - digits + 1)
    return float(unit * math.ceil(value / unit * (1.0 - _ROUNDING)))


MOST_ROUNDS: Final = 40

_ADVICE: Final = ("buoyancy", "tension", "uplift_angle", "sliding", "grounded_length", "span")
"""Checks against which something helps when no design passes them."""


_BY_SIZE: Final = frozenset({"tension", "uplift_angle", "grounded_length", "span"})
"""Those against which a larger size helps, where one is sold that was not tried."""


@dataclass(frozen=True)
class ConvergedSizing(Record):
    """The line that the loads were computed for; the recommended one comes to no more."""

    DOCUMENT = (
        "assumed.diameter=nominal_diameter_m assumed.pull assumed.forces=line_forces_N rounds"
    )

    posed: SizingCase
    point: DesignPoint  # the recommended design of its case
    assumed: Assumed  # what the loads were computed for
    needed: Assumed  # what the recommended line comes to: never more
    rounds: Counted
    """Searches until loads and line settled on each other."""
    choice: LineChoice  # what the line might be, and which design of the front was wanted

    @cached_property
    def result(self) -> DesignResult:
        """The whole answer of the design search for that case; computed when it is first asked."""
        return _whole(self.posed.case)

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """What an engineer should know of the search, without the rest of its answer."""
        problem, outcome = _enumerated(self.posed.case)
        if outcome is None:
            return self.result.warnings
        unsolved = (Message("design.unsolved", count=outcome.unsolved),) if outcome.unsolved else ()
        return (*problem.warnings, *unsolved)

    @property
    def index(self) -> int:
        """The recommended design on the front of `result`."""
        return [point.genes for point in self.result.front].index(self.point.genes)

    @property
    def case(self) -> Case:
        """What was searched, with the recommended line and anchor in their places."""
        return replace(self.posed.case, line=self.point.line, anchor=self.point.anchor)


def converge(
    pose: Callable[[Assumed], SizingCase],
    needed: Callable[[SizingCase, DesignPoint], Assumed],
    choice: LineChoice,
    start: Assumed | None = None,
) -> ConvergedSizing:
    """Search until the loads were computed for no less than the line that comes out.

    From the start, or from no chain at all, each round computes the loads for the largest chain
    and pull that any round before came to. When a round comes to no more than it assumed, that is
    the answer, on the safe side; when it comes to less, the loads of just that line are tried, and
    it is taken if it holds itself. The nearer the start to what comes out, the fewer rounds; what
    is assumed only rises, so that it comes to an end before `MOST_ROUNDS`.

    InputError: the case cannot be made, such as a pull above the reserve buoyancy.
    NoFeasibleDesignError: nothing that is sold passes every check. NotConvergedError: after
    `MOST_ROUNDS`.
    """

    def search(assumed: Assumed, rounds: int) -> ConvergedSizing:
        posed = pose(assumed)
        try:
            point = _best(posed.case, choice)
        except NoFeasibleDesignError as error:
            raise _advised(error, choice) from error
        return ConvergedSizing(posed, point, assumed, needed(posed, point), rounds, choice)

    assumed = start or Assumed()
    for rounds in range(1, MOST_ROUNDS + 1):
        found = search(assumed, rounds)
        if not assumed.covers(found.needed):
            assumed = assumed.raised_to(found.needed)
            continue
        if found.needed.covers(found.assumed):
            return found
        try:
            exact = search(found.needed, rounds + 1)
        except NoFeasibleDesignError:
            return found
        return exact if exact.assumed.covers(exact.needed) else found
    raise NotConvergedError(Message("sizing.not_settled", rounds=MOST_ROUNDS))


def point_diameter(point: DesignPoint) -> float:
    """Return the largest nominal diameter of a design's line, m."""
    return max(segment.nominal_diameter or 0.0 for segment in point.line.segments)


def point_pull(point: DesignPoint) -> float:
    """Return the largest pull of a design's line downwards at its fairlead, N."""
    return max(solution.fairlead.vertical_force for _, solution in point.checks.solutions)


def _preferred(objectives: Floats, choice: LineChoice) -> int:
    """Pick a design of a front that rises in mass or cost and falls in length or swing.

    Every way of choosing keeps to a line that is chosen when others no longer pass: a harder load
    never leads to a line that withstands less.
    """
    rows = objectives.tolist()
    short = next((k for k, (_, second) in enumerate(rows) if second <= choice.aim), None)
    match choice.looks_for:
        case "lightest":
            return 0
        case "practice" if short is not None:
            return short
        case "balanced":
            swept = [mass * (second + choice.rest) ** 2 for mass, second in rows]
            return swept.index(min(swept)) if short is None else short
        case "cheapest":
            prices = [mass + choice.swing_price * second for mass, second in rows]
            return prices.index(min(prices))
    return len(rows) - 1  # shortest, least swing


def best_of(points: Sequence[DesignPoint], choice: LineChoice) -> DesignPoint:
    """Pick the design that a preference chooses of some that pass, whatever they were sought by."""

    def objectives(point: DesignPoint) -> list[float]:
        known = {**point.objectives, OBJECTIVE_KEYS["length"]: point.line.length}
        return [known[OBJECTIVE_KEYS[name]] for name in choice.objectives]

    front: list[tuple[list[float], DesignPoint]] = []
    for each in sorted(((objectives(one), one) for one in points), key=lambda pair: pair[0]):
        if not front or each[0][1] < front[-1][0][1]:
            front.append(each)
    return front[_preferred(np.array([values for values, _ in front]), choice)][1]


def _best(case: Case, choice: LineChoice) -> DesignPoint:
    """Search one case for its recommended design alone: what `design_case` says without the rest.

    Only the last case's whole front is shown; to check and explain that of every round costs more
    than the rounds themselves.
    """
    assert case.design is not None
    problem, outcome = _enumerated(case)
    if outcome is None:
        front = _whole(case).front
        keys = [OBJECTIVE_KEYS[name] for name in problem.names]
        objectives = np.array([[point.objectives[key] for key in keys] for point in front])
        return front[_preferred(objectives, choice)]
    if not len(outcome.genes):
        raise no_feasible_design(problem, outcome)
    best = _preferred(outcome.objectives, choice)
    return design_point(problem, tuple(outcome.genes[best].tolist()))


@lru_cache(maxsize=16)
def _enumerated(case: Case) -> tuple[DesignProblem, Outcome | None]:
    """Enumerate the designs of a case, of which several preferences choose; None: too many."""
    problem = DesignProblem.of(case)
    assert case.design is not None
    if problem.space.count > case.design.max_enumerated:
        return problem, None
    outcome = enumerate_designs(problem, workers=os.cpu_count() or 1)
    if outcome.interrupted:
        raise KeyboardInterrupt
    return problem, outcome


def _whole(case: Case) -> DesignResult:
    """Search a case to its end: of a search that was stopped a sizing has no use."""
    try:
        result = design_case(case)
    except NoFeasibleDesignError as error:
        if error.interrupted:
            raise KeyboardInterrupt from error
        raise
    if result.interrupted:
        raise KeyboardInterrupt
    return result


def _advised(error: NoFeasibleDesignError, choice: LineChoice) -> NoFeasibleDesignError:
    """Add what would help against the checks that fail."""
    kinds = [each.kind for each in error.near_miss.failing] if error.near_miss else []
    advice = [Message(f"sizing.helps_{kind}") for kind in dict.fromkeys(kinds) if kind in _ADVICE]
    if not _BY_SIZE.isdisjoint(kinds) and choice.is_bounded:
        advice.append(Message("sizing.larger_size"))
    if not advice:
        return error
    helps = Message("sizing.may_help", advice=Several(advice))
    said = error.message
    parts = said.parts if isinstance(said, Several) else (said,)
    return NoFeasibleDesignError(Several((*parts, helps), "\n"), error.near_miss)
