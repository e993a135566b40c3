"""What stands beside the recommended line: other sizes, other preferences, steps that fail."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, Literal

from catopt.casefile.sizing_file import Moored
from catopt.catalogue.choice import chosen
from catopt.checks.result import CheckResult
from catopt.design.evaluation import DesignProblem
from catopt.design.near_miss import NoFeasibleDesignError
from catopt.design.neighbours import neighbour, steps
from catopt.errors import CatoptError, InputError, NoAnswerError
from catopt.quantities import QUANTITIES
from catopt.sizing.line_choice import Prefer
from catopt.sizing.settle import ConvergedSizing, point_diameter
from catopt.words import Measure, Message, Several

Role = Literal["smaller", "recommended", "larger"]

_SAME_SIZE = 1e-6


@dataclass(frozen=True)
class Candidate:
    """One size of chain, with the shortest line of it that passes under its own loads."""

    role: Role
    component: str  # family and grade
    diameter: float  # nominal, m
    settled: ConvergedSizing | None  # None where no length of it passes
    reason: str = ""  # why there is none


def candidates(
    settled: ConvergedSizing, of_size: Callable[[str, float], ConvergedSizing]
) -> tuple[Candidate, ...]:
    """Size the neighbours of a recommended line, by rising size.

    `of_size` settles loads and line for one size (m) of one component. They are less than three
    where no smaller or no larger one is sold.
    """
    component = settled.point.line.segments[0].component
    diameter = point_diameter(settled.point)
    case = settled.posed.case
    sold = chosen(case.catalogue, case.site.water_density).sold(component)
    sizes = [each.nominal_diameter for each in sold]
    smaller = [size for size in sizes if size < diameter - _SAME_SIZE][-1:]
    larger = [size for size in sizes if size > diameter + _SAME_SIZE][:1]

    def candidate(role: Role, size: float) -> Candidate:
        try:
            return Candidate(role, component, size, of_size(component, size))
        except (NoAnswerError, InputError) as error:
            return Candidate(role, component, size, None, _why_none(error))

    return (
        *(candidate("smaller", size) for size in smaller),
        Candidate("recommended", component, diameter, settled),
        *(candidate("larger", size) for size in larger),
    )


def _why_none(error: CatoptError) -> str:
    """Say in one line why no line of what was asked for passes."""
    near_miss = error.near_miss if isinstance(error, NoFeasibleDesignError) else None
    if near_miss is not None and near_miss.failing:
        return Message("sizing.fails", what=near_miss.failing[0].in_case)
    if isinstance(error, InputError):
        what = Several(problem.allowed for problem in error.problems)
        return Message("sizing.fails", what=what)
    said = error.message
    if isinstance(error, NoFeasibleDesignError) and isinstance(said, Several):
        return said.parts[0]
    return said


@dataclass(frozen=True)
class Alternative:
    """A line by another preference, under its own loads."""

    prefer: Prefer
    settled: ConvergedSizing | None  # None where no line passes
    swing: float = 0.0  # swing radius at low water, m; 0 without a line
    reason: str = ""  # why there is none

    @property
    def mass(self) -> float:
        """Of the line in air, kg; 0 without a line."""
        return self.settled.point.objectives["mass_kg"] if self.settled else 0.0

    @property
    def cost(self) -> float | None:
        """Of the line's material, USD; None without a line, or where a price is not known."""
        return self.settled.point.objectives.get("cost_USD") if self.settled else None


_LOOKED_AT: Final[Mapping[Moored, tuple[Prefer, ...]]] = MappingProxyType(
    {
        "buoy": ("practice", "shortest", "cheapest", "lightest"),
        "tanker": ("balanced", "cheapest", "lightest", "least-swing"),
    }
)
"""Preferences whose lines differ. Of a buoy the shortest line swings least."""


def alternatives(
    moored: Moored,
    own: Prefer,
    sized: Callable[[Prefer], tuple[ConvergedSizing, float]],
    *,
    priced: bool,
) -> tuple[Alternative, ...]:
    """Settle the lines of the preferences other than that of the recommended line.

    `sized` settles a line by a preference, and gives its swing radius, m. Where not every price is
    known none is the cheapest, and of one component the lightest is.
    """

    def alternative(prefer: Prefer) -> Alternative:
        try:
            return Alternative(prefer, *sized(prefer))
        except (NoAnswerError, InputError) as error:
            return Alternative(prefer, None, reason=_why_none(error))

    others = (each for each in _LOOKED_AT[moored] if each != own)
    return tuple(alternative(each) for each in others if priced or each != "cheapest")


def trade(swing: float, mass: float, own_swing: float, own_mass: float) -> Message:
    """Say what a line gives and takes beside the recommended one.

    By the swing radius, m, and the mass in air, kg, of both.

    Examples
    --------
    >>> print(trade(369.0, 19.45e3, 382.0, 11.05e3))
    13 m less swing, 3.4 %, for 8.4 t more chain, 76 %
    """
    if (swing, mass) == (own_swing, own_mass):
        return Message("sizing.same_line")
    return Message(
        "sizing.trade",
        swing=_change("swing", "length", swing, own_swing),
        chain=_change("chain", "mass", mass, own_mass),
    )


def _change(what: str, quantity: str, own: float, other: float) -> Message:
    """Say a change in two digits or so, and its share of what changes."""
    way, change = "more" if own > other else "less", abs(own - other)
    digits = _digits(QUANTITIES[quantity].to_field(change))
    share = 100.0 * change / other
    amount = Measure(quantity, change, digits=digits)
    return Message(f"sizing.{way}_{what}", amount=amount, share=f"{share:.{_digits(share)}f}")


def _digits(value: float) -> int:
    return 0 if value >= 10.0 else 1


@dataclass(frozen=True)
class Limit:
    """A step to less that the line cannot take."""

    change: str  # in words: "chain: 28 m for 28.5 m"
    check: CheckResult | None  # that fails by the most; None where there is no equilibrium
    reason: str = ""  # why there is none

    @property
    def words(self) -> str:
        """What it runs into."""
        return self.reason if self.check is None else self.check.in_case


def limits(settled: ConvergedSizing) -> tuple[Limit, ...]:
    """List the steps to less that fail under the settled loads, each with its worst check."""
    problem = DesignProblem.of(settled.posed.case)
    found = []
    for step in steps(problem.space, settled.point.genes):
        if step.direction >= 0:
            continue
        tried = neighbour(problem, step)
        if tried.point is None:
            found.append(Limit(tried.change, None, tried.reason))
        elif not tried.point.checks.passes:
            found.append(Limit(tried.change, tried.point.checks.governing))
    return tuple(found)
