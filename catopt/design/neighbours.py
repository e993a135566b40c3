"""What one size or one step up or down would do to a design, and what a front runs into."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from catopt.checks.result import CheckResult
from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem, design_point, objective_words
from catopt.design.result import DesignPoint, Neighbour
from catopt.design.space import (
    GENES_EACH,
    ClumpWeightVariable,
    DesignSpace,
    LayoutVariable,
    SegmentVariable,
)
from catopt.errors import NoAnswerError, NotConvergedError
from catopt.ties import first_largest
from catopt.words import Listed, Measure, Message, Several

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
    flaw = problem.space.flaw(step.genes)
    if flaw:
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
        _stop(found.point.governing)
        for _, found in around
        if found.point is not None
        and found.point.objectives[key] < here
        and not found.point.checks.passes
    )
    parts = []
    if checks:
        parts.append(Message("design.runs_into", checks=Listed(checks, "or")))
    closed = list(_closed(around, key, here))
    if closed:
        parts.append(Message("design.choices_end", variables=Listed(closed, "and")))
    if not parts:
        parts.append(Message("design.no_step"))
    return Several((Several(parts), *_tightest(point.governing)), " ")


def _closed(around: Sequence[tuple[Step, Neighbour]], key: str, here: float) -> Iterator[str]:
    """Yield the variables at the end of their choices where one more step would give less.

    A step back gives more, and there is none on the other side.
    """
    for variable in dict.fromkeys(step.variable for step, _ in around if step.variable):
        found = [each for step, each in around if step.variable == variable]
        point = found[0].point
        if len(found) == 1 and point is not None and point.objectives[key] > here:
            yield variable


def _stop(worst: CheckResult | None) -> Message:
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
