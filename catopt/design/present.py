"""The line that stands in the case file, beside the front."""

from __future__ import annotations

from typing import Final

from catopt.checks.case import check_line
from catopt.design.evaluation import DesignProblem
from catopt.design.points import objectives_of
from catopt.design.result import DesignPoint, Neighbour
from catopt.errors import CatoptError
from catopt.words import Message

PRESENT: Final = "design.present"
"""Key of what the line is called."""


def present_line(problem: DesignProblem) -> Neighbour:
    """Check the line of the case by the same checks as the designs.

    A sinker that the search chooses is not part of the present line. Its `point` is None, with the
    reason, where the line has no equilibrium or a figure that a check needs is missing: that is no
    error of the search.
    """
    line = problem.case.line
    try:
        checks = check_line(line, problem.case)
    except CatoptError as error:
        return Neighbour(Message(PRESENT), None, error.message)
    objectives = objectives_of(problem, line, checks)
    point = DesignPoint(line, problem.case.anchor, (), objectives, checks)
    return Neighbour(Message(PRESENT), point)
