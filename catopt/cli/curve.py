"""``catopt curve``: span and forces of a line over a range of span, force or offset."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from catopt.cli.answering import Asked, answering
from catopt.cli.options import CaseArgument, OutOption
from catopt.cli.values import in_si, with_known_codes
from catopt.errors import InputError
from catopt.units import Dimension

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.model import Case

_OPTIONS = {"over": "--over", "start": "--from", "stop": "--to", "points": "--points"}
"""Options by their names in Python."""


Over = Literal["force", "span", "offset"]
"""What is stepped evenly."""


@answering(OutOption)
def curve(
    asked: Asked,
    case: CaseArgument,
    over: Annotated[Over, typer.Option(metavar="QUANTITY")] = "force",
    start: Annotated[str | None, typer.Option("--from", metavar="VALUE")] = None,
    stop: Annotated[str | None, typer.Option("--to", metavar="VALUE")] = None,
    points: Annotated[int, typer.Option(metavar="N")] = 50,
) -> None:
    """Compute a line's load curve: its forces over its span."""
    from catopt.answers.curve import curve_answer
    from catopt.casefile import read_case
    from catopt.report.bundle import curve_pictures

    asked.check_place()
    read = with_known_codes(read_case(case))
    result = _curve(read, over, start, stop, points)
    asked.give(curve_answer(result), result.to_dict, read, partial(curve_pictures, result))


def _curve(case: Case, over: Over, start: str | None, stop: str | None, points: int) -> CaseCurve:
    """Compute the curve; what is wrong with the range is told by the options' names."""
    from catopt.catenary.case_curve import curve_case

    dimension = Dimension.FORCE if over == "force" else Dimension.LENGTH
    texts = {"start": start, "stop": stop}
    read = in_si({_OPTIONS[key]: (text, dimension) for key, text in texts.items()})
    limits = {key: read.get(_OPTIONS[key]) for key in texts}
    try:
        return curve_case(case, over=over, points=points, **limits)
    except InputError as error:
        if not all(problem.key in _OPTIONS for problem in error.problems):
            raise
        problems = [
            replace(each, key=_OPTIONS[each.key], found=texts.get(each.key) or each.found)
            for each in error.problems
        ]
        raise InputError(problems, "options") from error
