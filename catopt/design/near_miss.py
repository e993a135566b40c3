"""No design passes: which one fails by the least, by which checks and by how much."""

from __future__ import annotations

import math

from catopt.checks.result import CheckResult
from catopt.design.evaluation import DesignProblem
from catopt.design.outcome import Outcome
from catopt.design.result import NearMiss
from catopt.errors import InputError, NoAnswerError, NotConvergedError, Problem
from catopt.words import Measure, Message, Sentence, Several
from catopt.words.measure import number


class NoFeasibleDesignError(NoAnswerError):
    """No design that was evaluated passes every check.

    `near_miss` is the design that fails by the least; None when the search was stopped before it
    was known. `interrupted`: whether it was stopped before its end, so that others may pass.
    `in_motion`: how many lines were run afloat, in words, where lines pass at rest; else None.
    """

    in_motion: Message | None = None

    def __init__(
        self, message: str, near_miss: NearMiss | None, *, interrupted: bool = False
    ) -> None:
        self.near_miss = near_miss
        self.interrupted = interrupted
        super().__init__(message)


def no_feasible_design(problem: DesignProblem, outcome: Outcome) -> NoFeasibleDesignError:
    """Put a search that found nothing into words.

    InputError: every design that was evaluated has a clump weight beyond the line.
    """
    designs = problem.space.count
    head = Message("design.none_passes", count=designs)
    if outcome.evaluations < designs:
        done = outcome.evaluations
        head = Message("design.none_evaluated_passes", done=done, count=designs)
    if outcome.interrupted:
        head = Message("design.search_interrupted", head=head)
    said = Sentence(head)
    if outcome.closest is None:
        return NoFeasibleDesignError(said, None, interrupted=outcome.interrupted)
    flaw = problem.space.flaw(outcome.closest)
    if flaw:
        allowed = Message("refused_case.nearer_anchor_or_longer_segments")
        raise InputError([Problem("design.clump_weights", flaw, allowed)], "design")
    miss = near_miss(problem, outcome.closest)
    reasons = [_check_words(result) for result in miss.failing] or [miss.reason]
    what = [Message("design.indented", said=reason) for reason in reasons]
    key = "design.nearest_so_far" if outcome.interrupted else "design.nearest"
    parts = [
        Message(
            "design.of_length",
            length=segment.length,
            segment=segment.name or Message("checks.segment", number=number),
        )
        for number, segment in enumerate(miss.line.segments, start=1)
    ]
    parts += [
        Message("design.weight_of", mass=(load.mass or 0.0) / 1e3, position=load.position)
        for load in miss.line.point_loads
    ]
    nearest = Message(key, line=Several(parts, ", "))
    message = Several((Several((said, nearest), " "), *what), "\n")
    return NoFeasibleDesignError(message, miss, interrupted=outcome.interrupted)


def near_miss(problem: DesignProblem, genes: tuple[int, ...]) -> NearMiss:
    """Check a design that fails."""
    try:
        return NearMiss(problem.space.line(genes), problem.point(genes).checks.failed)
    except (NoAnswerError, NotConvergedError) as error:
        return NearMiss(problem.space.line(genes), (), error.message)


def _check_words(result: CheckResult) -> str:
    demand, capacity = (_shown(value, result.unit) for value in (result.demand, result.capacity))
    key = "design.beside_wanted" if result.kind == "grounded_length" else "design.beside_allowed"
    how = Message(key, demand=demand, capacity=capacity)
    if result.utilisation is not None:
        how = Message("design.used", beside=how, used=result.utilisation)
    values = {"check": result.name, "load_case": result.load_case, "how": how}
    return Message("design.failing_check", source=result.source.text, **values)


def _shown(value: float, unit: str) -> str:
    """Print a number as the field reads it."""
    if unit == "N":
        return Message("design.about", value=Measure("tension", value))
    if unit == "rad":
        return f"{math.degrees(value):.4g} deg"
    return f"{number(value, '.4g')} {unit}"
