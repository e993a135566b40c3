"""What one size or one step up or down would do to a design."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from catopt.design.evaluation import DesignProblem
from catopt.design.points import design_point
from catopt.design.result import Neighbour
from catopt.design.space import (
    GENES_EACH,
    ClumpWeightVariable,
    DesignSpace,
    LayoutVariable,
    SegmentVariable,
)
from catopt.errors import NoAnswerError, NotConvergedError
from catopt.model import Segment
from catopt.words import Measure, Message

Design = tuple[int, ...]


class Step(NamedTuple):
    """One change of one variable.

    Attributes
    ----------
    change : str
        In words.
    genes : tuple of int
        The design that it leads to.
    variable : str
        What changes, where its values rise: ``"the length of segment 1"``; empty where they do not.
    direction : int
        1 up and -1 down; 0 where values do not rise.
    """

    change: str
    genes: Design
    variable: str = ""
    direction: int = 0


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
        at = GENES_EACH * index
        own = (genes[at], genes[at + 1])
        name = _name(space, index)
        if isinstance(variable, SegmentVariable):
            changes = _of_segment(variable, *own)
        elif isinstance(variable, LayoutVariable):
            changes = _of_layout(variable, *own)
        else:
            changes = _of_weight(variable, *own)
        for change in changes:
            reached = (*genes[:at], *change.pair, *genes[at + GENES_EACH :])
            what = Message(_WHAT[change.what], part=name) if change.what else ""
            said = Message(change.key, part=name, **change.values)
            yield Step(said, reached, what, change.direction)


_WHAT = {
    "size": "design.size",
    "length": "design.length",
    "mass": "design.mass",
    "place": "design.place",
    "lines": "design.lines",
    "radius": "design.radius",
    "pretension": "design.pretension",
}
"""Key of what changes."""


_PUT_IN, _LEFT_OUT, _CHANGED = "design.put_in", "design.left_out", "design.changed"


class _Change(NamedTuple):
    """New genes of one variable."""

    key: str
    values: Mapping[str, str]
    pair: tuple[int, int]
    what: str = ""
    direction: int = 0


def _name(space: DesignSpace, index: int) -> str:
    """Name a variable: as the case does, else by its number."""
    if space.variables[index] is space.layout:
        return Message("design.layout")
    if index < len(space.segments):
        key, number = "checks.segment", index + 1
    else:
        key, number = "design.clump_weight", index - len(space.segments) + 1
    return space.variables[index].name or Message(key, number=number)


def _of_segment(variable: SegmentVariable, kind: int, length: int) -> Iterator[_Change]:
    here = variable.segment(kind, length)
    if here is None:
        added = variable.segment(1, 0)
        assert added is not None
        of_it = Message("design.of_length", length=added.length, segment=_called(added))
        yield _Change(_PUT_IN, {"added": of_it}, (1, 0))
        return
    option = kind - variable.is_optional
    for other, segment in enumerate(variable.options):
        values = {"new": _called(segment), "old": _called(here)}
        pair = (other + variable.is_optional, length)
        if segment.component == here.component:
            if abs(other - option) == 1:
                yield _Change(_CHANGED, values, pair, "size", other - option)
        elif segment.nominal_diameter == here.nominal_diameter:
            yield _Change(_CHANGED, values, pair)
    for other in _beside(length, len(variable.lengths)):
        lengths = (variable.lengths[other], here.length)
        new, old = (Message("design.in_metres", length=each) for each in lengths)
        change = {"new": new, "old": old}
        yield _Change(_CHANGED, change, (kind, other), "length", other - length)
    if variable.is_optional:
        yield _Change(_LEFT_OUT, {}, (0, 0))


def _of_weight(variable: ClumpWeightVariable, kind: int, place: int) -> Iterator[_Change]:
    mass = kind - variable.is_optional
    masses, positions = variable.masses, variable.positions
    if mass < 0:
        least = {"mass": masses[0] / 1e3}
        added = Message("design.in_tonnes", **least)
        if positions:
            added = Message("design.weight_at", position=positions[0], **least)
        yield _Change(_PUT_IN, {"added": added}, (1, 0))
        return
    for other in _beside(mass, len(masses)):
        new, old = (Message("design.in_tonnes", mass=masses[n] / 1e3) for n in (other, mass))
        pair = (other + variable.is_optional, place)
        yield _Change(_CHANGED, {"new": new, "old": old}, pair, "mass", other - mass)
    for other in _beside(place, len(positions)):
        # English names the place once: "at 7 m for 6 m".
        new = Message("design.at", position=positions[other])
        old = Message("design.in_metres", length=positions[place])
        yield _Change(_CHANGED, {"new": new, "old": old}, (kind, other), "place", other - place)
    if variable.is_optional:
        yield _Change(_LEFT_OUT, {}, (0, 0))


def _of_layout(variable: LayoutVariable, lines: int, anchors: int) -> Iterator[_Change]:
    for other in _beside(lines, len(variable.azimuths)):
        counts = (len(variable.azimuths[each]) for each in (other, lines))
        new, old = (Message("design.so_many_lines", count=each) for each in counts)
        yield _Change(_CHANGED, {"new": new, "old": old}, (other, anchors), "lines", other - lines)
    for other in _beside(anchors, variable.sizes[1]):
        new, old = (_anchored(variable, each) for each in (other, anchors))
        what = "pretension" if variable.pretensions else "radius"
        yield _Change(_CHANGED, {"new": new, "old": old}, (lines, other), what, other - anchors)


def _anchored(variable: LayoutVariable, anchors: int) -> Message:
    """Say how far away the anchors are, or by which pretension they are placed."""
    if not variable.pretensions:
        return Message("design.at_radius", radius=variable.radii[anchors])
    force = Measure("horizontal_force", variable.pretensions[anchors])
    return Message("design.at_pretension", force=force)


def _beside(index: int, count: int) -> Iterator[int]:
    """Yield the indices next below and above, as far as they are there."""
    yield from (other for other in (index - 1, index + 1) if 0 <= other < count)


def _called(segment: Segment) -> str:
    return segment.name or Message("design.segment_of_line")
