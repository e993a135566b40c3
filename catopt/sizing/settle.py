"""Loads and line settle on each other: the loads of a chain, the chain for those loads."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Final

import numpy as np

from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem, design_point
from catopt.design.front import Outcome
from catopt.design.neighbours import NoFeasibleDesignError, no_feasible_design
from catopt.design.problem import Floats
from catopt.design.result import DesignPoint, DesignResult
from catopt.design.search import design_case, enumerate_designs
from catopt.errors import NotConvergedError
from catopt.model import Case
from catopt.records import Counted, Record
from catopt.sizing.line_choice import LineChoice
from catopt.sizing.posed import Assumed, SizingCase
from catopt.words import Message, Several

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


def settle(
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
