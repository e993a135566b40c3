"""The recommended line between its two neighbours: one size smaller, one size larger."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from catopt.catalogue.choice import chosen
from catopt.design.near_miss import NoFeasibleDesignError
from catopt.errors import CatoptError, InputError, NoAnswerError
from catopt.sizing.settle import Settled, point_diameter
from catopt.words import Message, Several

Role = Literal["smaller", "recommended", "larger"]

_SAME_SIZE = 1e-6


@dataclass(frozen=True)
class Candidate:
    """One size of chain, with the shortest line of it that passes under its own loads.

    Attributes
    ----------
    role : {"smaller", "recommended", "larger"}
        Where it stands.
    component : str
        Family and grade.
    diameter : float
        Nominal, m.
    settled : Settled or None
        Its line and loads; None where no length of it passes.
    reason : str
        Why there is none; else empty.
    """

    role: Role
    component: str
    diameter: float
    settled: Settled | None
    reason: str = ""


def candidates(settled: Settled, of_size: Callable[[str, float], Settled]) -> tuple[Candidate, ...]:
    """Size the neighbours of a recommended line, by rising size.

    `of_size` settles loads and line for one size (m) of one component. They are less than three
    where no smaller or no larger one is sold.
    """
    component = settled.point.line.segments[0].component
    diameter = point_diameter(settled.point)
    case = settled.posed.case
    sizes = [
        each.nominal_diameter
        for each in chosen(case.catalogue, case.site.water_density).sold(component)
    ]
    smaller = [size for size in sizes if size < diameter - _SAME_SIZE][-1:]
    larger = [size for size in sizes if size > diameter + _SAME_SIZE][:1]
    return (
        *(_candidate("smaller", component, size, of_size) for size in smaller),
        Candidate("recommended", component, diameter, settled),
        *(_candidate("larger", component, size, of_size) for size in larger),
    )


def _candidate(
    role: Role, component: str, diameter: float, of_size: Callable[[str, float], Settled]
) -> Candidate:
    try:
        return Candidate(role, component, diameter, of_size(component, diameter))
    except (NoAnswerError, InputError) as error:
        return Candidate(role, component, diameter, None, why_none(error))


def why_none(error: CatoptError) -> str:
    """Say in one line why no line of what was asked for passes."""
    if isinstance(error, NoFeasibleDesignError) and error.near_miss is not None:
        failing = error.near_miss.failing
        if failing:
            return Message("sizing.fails", what=failing[0].in_case)
    if isinstance(error, InputError):
        what = Several(problem.allowed for problem in error.problems)
        return Message("sizing.fails", what=what)
    said = error.message
    if isinstance(error, NoFeasibleDesignError) and isinstance(said, Several):
        return said.parts[0]
    return said
