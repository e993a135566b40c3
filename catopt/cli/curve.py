"""``catopt curve``: span and forces of a line over a range of span, force or offset."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import Annotated, Literal

import typer

from catopt.answers.solution import curve_answer
from catopt.casefile.reading import read_mooring_or_design
from catopt.cli.answering import Asked, answering
from catopt.cli.options import CaseArgument, OutOption
from catopt.cli.system import Wanted, answered_as_mooring
from catopt.cli.values import in_si, with_known_codes
from catopt.errors import InputError
from catopt.units import Dimension

_OPTIONS = {"over": "--over", "start": "--from", "stop": "--to", "points": "--points"}
"""Options by their names in Python."""


Over = Literal["force", "span", "offset"]
"""What is stepped evenly."""


@answering(OutOption)
def curve(
    asked: Asked,
    case: CaseArgument,
    over: Annotated[Over | None, typer.Option(metavar="QUANTITY")] = None,
    start: Annotated[str | None, typer.Option("--from", metavar="VALUE")] = None,
    stop: Annotated[str | None, typer.Option("--to", metavar="VALUE")] = None,
    points: Annotated[int | None, typer.Option(metavar="N")] = None,
) -> None:
    """Compute a line's load curve: its forces over its span; of a body those that hold it off."""
    from catopt.catenary.case_curve import curve_case
    from catopt.report.bundle import pictures_of

    asked.check_place()
    mooring = read_mooring_or_design(case, None)
    along = Wanted(directions=[math.atan2(*mooring.own_force[::-1])])
    of_one_line = {"over": over, "from": start, "to": stop, "points": points}
    if answered_as_mooring(asked, mooring, along, of_one_line):
        return
    read, over = with_known_codes(mooring), over or "force"
    dimension = Dimension.FORCE if over == "force" else Dimension.LENGTH
    limits = in_si({"--from": (start, dimension), "--to": (stop, dimension)})
    try:
        result = curve_case(
            read,
            over=over,
            points=50 if points is None else points,
            start=limits.get("--from"),
            stop=limits.get("--to"),
        )
    except InputError as error:
        if not all(problem.key in _OPTIONS for problem in error.problems):
            raise
        typed = {"start": start, "stop": stop}
        problems = [
            replace(
                problem, key=_OPTIONS[problem.key], found=typed.get(problem.key) or problem.found
            )
            for problem in error.problems
        ]
        raise InputError(problems, "options") from error
    asked.give(curve_answer(result), result.to_dict, read, partial(pictures_of, "curve", result))
