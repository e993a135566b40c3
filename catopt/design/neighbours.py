"""What one step would do to a design; and where no design passes, the nearest miss."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from catopt.checks.kinds import is_wanted
from catopt.checks.result import CheckResult
from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem, design_point, objective_words
from catopt.design.front import Outcome
from catopt.design.result import DesignPoint, NearMiss, Neighbour
from catopt.design.space import (
    GENES_EACH,
    ClumpWeightVariable,
    DesignSpace,
    LayoutVariable,
    SegmentVariable,
)
from catopt.errors import NoAnswerError, NotConvergedError, refused
from catopt.largest import first_largest
from catopt.words import Listed, Measure, Message, Sentence, Several
from catopt.words.message import number


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
    if flaw := problem.space.flaw(outcome.closest):
        allowed = Message("refused_case.nearer_anchor_or_longer_segments")
        raise refused("design.clump_weights", flaw, allowed, "design")
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
    key = "design.beside_wanted" if is_wanted(result.kind) else "design.beside_allowed"
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


Design = tuple[int, ...]
_Variable = SegmentVariable | ClumpWeightVariable | LayoutVariable


class Step(NamedTuple):
    """One change of one variable."""

    change: str  # in words
    genes: Design  # the design that it leads to
    # what changes, where its values rise: "the length of segment 1"; empty where they do not
    variable: str = ""
    direction: int = 0  # 1 up and -1 down; 0 where values do not rise


def neighbours(problem: DesignProblem, genes: Design) -> tuple[Neighbour, ...]:
    """Check every design that is one step of one variable away."""
    return tuple(neighbour(problem, step) for step in steps(problem.space, genes))


def neighbour(problem: DesignProblem, step: Step) -> Neighbour:
    """Check the design that a step leads to."""
    if flaw := problem.space.flaw(step.genes):
        return Neighbour(step.change, None, flaw)
    try:
        return Neighbour(step.change, design_point(problem, step.genes))
    except (NoAnswerError, NotConvergedError) as error:
        return Neighbour(step.change, None, error.message)


def steps(space: DesignSpace, genes: Design) -> Iterator[Step]:
    """List the steps: a size down and up, the same size of another component, a step of length.

    A part that may be absent is left out, or put in at its least.
    """
    for index, variable in enumerate(space.variables):
        at, end = GENES_EACH * index, GENES_EACH * (index + 1)
        for step in _own_steps(variable, _name(space, index), *genes[at:end]):
            yield step._replace(genes=(*genes[:at], *step.genes, *genes[end:]))


def _name(space: DesignSpace, index: int) -> str:
    """Name a variable: as the case does, else by its number."""
    if space.variables[index] is space.layout:
        return Message("design.layout")
    if index < len(space.segments):
        key, number = "checks.segment", index + 1
    else:
        key, number = "design.clump_weight", index - len(space.segments) + 1
    return space.variables[index].name or Message(key, number=number)


def _own_steps(variable: _Variable, name: str, kind: int, place: int) -> Iterator[Step]:
    """List the steps of a named variable, with its own two genes alone."""
    here = kind - variable.is_optional
    if here < 0:
        yield Step(Message("design.put_in", part=name, added=_least(variable)), (1, 0))
        return
    what, what_of_place = (Message(f"design.{each}", part=name) for each in _what(variable))
    for other, direction in _other_kinds(variable, here):
        values = {"new": _kind(variable, other), "old": _kind(variable, here)}
        said = Message("design.changed", part=name, **values)
        pair = (other + variable.is_optional, place)
        yield Step(said, pair, what if direction else "", direction)
    for other in _beside(place, len(variable.values[1])):
        values = {"new": _place(variable, other, is_new=True), "old": _place(variable, place)}
        said = Message("design.changed", part=name, **values)
        yield Step(said, (kind, other), what_of_place, other - place)
    if variable.is_optional:
        yield Step(Message("design.left_out", part=name), (0, 0))


def _other_kinds(variable: _Variable, here: int) -> Iterator[tuple[int, int]]:
    """Yield what else a part may be made of; whether that is up or down, 0 where it is neither."""
    if not isinstance(variable, SegmentVariable):
        for other in _beside(here, len(variable.values[0])):
            yield other, other - here
        return
    own = variable.options[here]
    for other, segment in enumerate(variable.options):
        if segment.component == own.component:
            if abs(other - here) == 1:
                yield other, other - here
        elif segment.nominal_diameter == own.nominal_diameter:
            yield other, 0


def _what(variable: _Variable) -> tuple[str, str]:
    """Name what the two genes of a variable change."""
    if isinstance(variable, SegmentVariable):
        return "size", "length"
    if isinstance(variable, ClumpWeightVariable):
        return "mass", "place"
    return "lines", "pretension" if variable.pretensions else "radius"


def _kind(variable: _Variable, index: int) -> str:
    """Say what a part is made of."""
    if isinstance(variable, SegmentVariable):
        return variable.options[index].name or Message("design.segment_of_line")
    if isinstance(variable, ClumpWeightVariable):
        return Message("design.in_tonnes", mass=variable.masses[index] / 1e3)
    return Message("design.so_many_lines", count=len(variable.azimuths[index]))


def _place(variable: _Variable, index: int, *, is_new: bool = False) -> str:
    """Say how long a segment is, where a clump weight hangs, or how the anchors are placed."""
    if isinstance(variable, SegmentVariable):
        return Message("design.in_metres", length=variable.lengths[index])
    if isinstance(variable, ClumpWeightVariable):
        # English names the place once: "at 7 m for 6 m".
        if is_new:
            return Message("design.at", position=variable.positions[index])
        return Message("design.in_metres", length=variable.positions[index])
    if not variable.pretensions:
        return Message("design.at_radius", radius=variable.radii[index])
    force = Measure("horizontal_force", variable.pretensions[index])
    return Message("design.at_pretension", force=force)


def _least(variable: _Variable) -> str:
    """Say what is put in where a part is absent."""
    if isinstance(variable, SegmentVariable):
        segment = _kind(variable, 0)
        return Message("design.of_length", length=variable.lengths[0], segment=segment)
    assert isinstance(variable, ClumpWeightVariable)
    if not variable.positions:
        return _kind(variable, 0)
    mass, position = variable.masses[0] / 1e3, variable.positions[0]
    return Message("design.weight_at", position=position, mass=mass)


def _beside(index: int, count: int) -> Iterator[int]:
    """Yield the indices next below and above, as far as they are there."""
    yield from (other for other in (index - 1, index + 1) if 0 <= other < count)


# ------------------------------------------------------------------ the ends of a front


def ends(problem: DesignProblem, front: Sequence[DesignPoint]) -> tuple[Message, ...]:
    """Say for each objective what keeps it from being smaller than at its end of the front."""
    said = []
    for name in problem.names:
        key = OBJECTIVE_KEYS[name]
        index = first_largest([-each.objectives[key] for each in front])
        objective, what = objective_words(name), _end_of_front(problem, front[index], key)
        said.append(Message("design.end", objective=objective, number=index + 1, what=what))
    return tuple(said)


def _end_of_front(problem: DesignProblem, point: DesignPoint, key: str) -> Message:
    """Say what the steps to a smaller value of an objective run into."""
    here = point.objectives[key]
    around = [(step, neighbour(problem, step)) for step in steps(problem.space, point.genes)]
    checks = dict.fromkeys(
        _stop(found.point)
        for _, found in around
        if found.point is not None and found.point.objectives[key] < here and not found.point.passes
    )
    parts = []
    if checks:
        parts.append(Message("design.runs_into", checks=Listed(checks, "or")))
    if closed := list(_closed(around, key, here)):
        parts.append(Message("design.choices_end", variables=Listed(closed, "and")))
    said = Several(parts or [Message("design.no_step")])
    return Several((said, *_tightest(point.governing)), " ")


def _closed(around: Sequence[tuple[Step, Neighbour]], key: str, here: float) -> Iterator[str]:
    """Yield the variables at the end of their choices where one more step would give less.

    A step back gives more, and there is none on the other side.
    """
    for variable in dict.fromkeys(step.variable for step, _ in around if step.variable):
        found = [each for step, each in around if step.variable == variable]
        point = found[0].point
        if len(found) == 1 and point is not None and point.objectives[key] > here:
            yield variable


def _stop(point: DesignPoint) -> Message:
    worst = point.governing
    if point.checks.passes:
        return Message("design.stop_draws")
    assert worst is not None
    return Message(f"design.stop_{worst.kind}", load_case=worst.load_case)


def _tightest(worst: CheckResult | None) -> Iterator[Message]:
    if worst is None:
        return
    values = {"check": worst.name, "load_case": worst.load_case}
    if worst.utilisation is None:
        yield Message("design.tightest", **values)
    else:
        yield Message("design.tightest_used", used=worst.utilisation, **values)
