"""Water levels: the body floats higher or lower, and its lines hang otherwise."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from catopt.model.kinds import Findings, Place, Stiffness
from catopt.model.system import System
from catopt.mooring.response import Response, response_of
from catopt.mooring.zero_load import zero_load_position
from catopt.patience import paced
from catopt.records import Record
from catopt.words import Message

__all__ = ["AtLevel", "at_levels"]


@dataclass(frozen=True)
class AtLevel(Record):
    """The system under its own load at one water level."""

    DOCUMENT = "level response stiffness"

    level: Place
    """Above that of the case."""
    response: Response
    """The body and its lines at that level, from the zero-load position there."""
    stiffness: tuple[tuple[Stiffness, Stiffness], tuple[Stiffness, Stiffness]]
    """-d(Fx, Fy)/d(x, y)."""


def at_levels(system: System, levels: Sequence[float]) -> tuple[AtLevel, ...]:
    """Solve a system at several water levels; every fairlead rises and falls with the water.

    The system is under its load; levels are above that of the case, m.

    Raises
    ------
    InputError
        When a level brings a fairlead below the bed.
    NoEquilibriumError, NotConvergedError
        As for `solve_system`.
    """
    found = Findings("water levels")
    lowest = min(leg.fairlead_height for leg in system.legs)
    for index, level in enumerate(levels):
        found.number(f"levels[{index}]", float(level), "m", at_least=-lowest)
    found.raise_if_any()
    answers = []
    for level in paced(Message("words.levels", total=len(levels)), levels):
        zero_load = zero_load_position(system.raised(float(level)))
        rest, lines = zero_load.under(system.force, system.moment)
        stiffness = ((rest.pull.xx, rest.pull.xy), (rest.pull.xy, rest.pull.yy))
        response = response_of(zero_load, rest, lines)
        answers.append(AtLevel(float(level), response, stiffness))
    return tuple(answers)
