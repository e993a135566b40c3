"""One line out: what the others carry when any one of them is gone."""

from __future__ import annotations

from dataclasses import dataclass, replace

from catopt.errors import NoAnswerError
from catopt.model.system import System
from catopt.mooring.response import Response, response_of
from catopt.mooring.solution import SystemSolution
from catopt.mooring.solve import solution_at
from catopt.mooring.zero_load import zero_load_position
from catopt.patience import paced
from catopt.records import Record
from catopt.words import Message

__all__ = ["LineOut", "one_line_out"]


@dataclass(frozen=True)
class LineOut(Record):
    """The system without one of its lines, under its own load; in Python lines count from 0."""

    DOCUMENT = "missing+1=missing_line response refusal"

    missing: int
    """The line that is gone."""
    response: Response | None
    """The body and its lines at rest: the offset counts from the intact system's zero-load
    position, lines as the intact system's; None where there is no equilibrium."""
    refusal: str = ""
    """Why there is no equilibrium; empty where there is one."""
    solution: SystemSolution | None = None
    """The lines that are left, in their order; None where there is no equilibrium."""

    def intact_number(self, index: int) -> int:
        """Turn the number of a line among those left into that of the intact system, from 0."""
        return index + (index >= self.missing)


def one_line_out(system: System) -> tuple[LineOut, ...]:
    """Take each line away in turn, the load as it is, and let the body come to rest anew.

    What happens on the way there, when the line parts, is dynamics and not looked at.

    Raises
    ------
    NoEquilibriumError, NotConvergedError
        When the intact system has no zero-load position, or a solver stopped short.
    """
    zero = zero_load_position(system).neutral
    found = []
    count = len(system.legs)
    for missing in paced(Message("words.lines_out", total=count), range(count)):
        if len(system.legs) == 1:
            found.append(LineOut(missing, None, Message("mooring.no_line_left")))
            continue
        try:
            left = zero_load_position(system.without([missing]))
            rest, lines = left.under(system.force, system.moment)
        except NoAnswerError as error:
            found.append(LineOut(missing, None, error.args[0]))
            continue
        response = response_of(left, rest, lines, zero)
        out = LineOut(missing, response, solution=solution_at(left, rest, lines))
        most_loaded = out.intact_number(response.most_loaded)
        found.append(replace(out, response=replace(response, most_loaded=most_loaded)))
    return tuple(found)
