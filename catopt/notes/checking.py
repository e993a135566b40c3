"""The checks of a moored body: of every line by itself, and of their common pull down."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.checks.case import NO_CHECK, check_case, is_of_load
from catopt.checks.criteria import criteria_of
from catopt.checks.excess import buoyancy_excess
from catopt.checks.result import CheckReport, CheckResult
from catopt.model import Load
from catopt.words import Message, is_said

if TYPE_CHECKING:
    from catopt.model import Case
    from catopt.mooring.solution import LegState, SystemSolution

__all__ = ["BODY", "checks_of", "line_name"]

BODY = "body"
"""In the place of a line's name where a check is of the body."""
_LEAST_SPAN = 1e-9
"""m; of a line that hangs straight down, which pulls to no side."""


def line_name(index: int) -> str:
    """Name a line as the results of `checks_of` do, counted from 0: ``"line 1"``."""
    return Message("motion.of_line", number=index + 1)


def checks_of(case: Case, solution: SystemSolution) -> CheckReport:
    """Check every line by the criteria of its case, at the span that it has under the load.

    What a buoy's reserve of buoyancy is held against is the vertical pull of all lines together.

    Parameters
    ----------
    case : Case
        With a system.
    solution : SystemSolution
        The body under its load.

    Returns
    -------
    CheckReport
        The load case of each result says of which line it is (`line_name`), or `BODY`; without
        results where the case asks for none.

    Raises
    ------
    InputError
        As for `check_case`.
    """
    reports = [check_case(_alone(case, line)) for line in solution.lines]
    results = [
        replace(result, load_case=line_name(index))
        for index, report in enumerate(reports)
        for result in report.results
    ]
    results += _of_the_body(case, solution)
    told = (warning for report in reports for warning in report.warnings)
    return CheckReport(
        title=case.title,
        results=tuple(results),
        solutions=tuple(
            (line_name(index), line.solution) for index, line in enumerate(solution.lines)
        ),
        warnings=tuple(
            dict.fromkeys(
                warning
                for warning in told
                if not is_said(warning, NO_CHECK) and not is_of_load(warning)
            )
        ),
    )


def _alone(case: Case, line: LegState) -> Case:
    """Make a case of one line, held at the span that it has."""
    return replace(
        case,
        line=line.leg.line,
        load=Load(span=max(line.solution.span, _LEAST_SPAN)),
        fairlead_height=line.leg.fairlead_height,
        anchor_height=line.leg.anchor_height,
        system=None,
        buoy=None,
        design=None,
        waves=None,
        current=None,
        motion=None,
        body=None,
        dynamics=None,
    )


def _of_the_body(case: Case, solution: SystemSolution) -> Iterator[CheckResult]:
    """Hold the vertical pull of all lines against the reserve of buoyancy, if that is given."""
    pull = math.fsum(line.solution.fairlead.vertical_force for line in solution.lines)
    for criterion in criteria_of(case).of("buoyancy", "extreme"):
        yield CheckResult(
            name=Message("checks.buoyancy"),
            kind="buoyancy",
            load_case=BODY,
            demand=pull,
            capacity=criterion.value,
            unit="N",
            excess=buoyancy_excess(pull, criterion.value),
            source=criterion.source,
            note=criterion.note,
        )
