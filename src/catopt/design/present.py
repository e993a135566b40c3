"""The line that stands in the case file, beside the front."""

from __future__ import annotations

from typing import Final

from catopt.checks.case import check_line
from catopt.design.evaluation import DesignProblem
from catopt.design.points import objectives_of
from catopt.design.result import DesignPoint, Neighbour
from catopt.errors import CatoptError

__all__ = ["PRESENT", "present_line"]

PRESENT: Final = "the line in the case file"


def present_line(problem: DesignProblem) -> Neighbour:
    """Check the line of the case by the same checks as the designs.

    Parameters
    ----------
    problem : DesignProblem
        The space. A sinker that the search chooses is not part of the present line.

    Returns
    -------
    Neighbour
        Its `point` is None, with the reason, where the line has no equilibrium or a figure that a
        check needs is missing: that is no error of the search.
    """
    line = problem.case.line
    try:
        checks = check_line(line, problem.case)
    except CatoptError as error:
        return Neighbour(PRESENT, None, str(error))
    objectives = objectives_of(problem, line, checks)
    return Neighbour(PRESENT, DesignPoint(line, problem.case.anchor, (), objectives, checks))
