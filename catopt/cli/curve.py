"""``catopt curve``: span and forces of a line over a range of span, force or offset."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.options import JsonOption, LangOption, OutOption, ReportLanguage

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.model import Case

_OPTIONS = {"over": "--over", "start": "--from", "stop": "--to", "points": "--points"}
"""Options by their names in Python."""


class Over(StrEnum):
    """What is stepped evenly."""

    FORCE = "force"
    SPAN = "span"
    OFFSET = "offset"


def curve(
    context: typer.Context,
    case: Annotated[Path, typer.Argument(metavar="CASE", help="Case file (TOML).")],
    over: Annotated[
        Over,
        typer.Option(
            metavar="QUANTITY",
            help="What is stepped evenly: force (the horizontal one at the fairlead), span, or "
            "offset, which is the span less the one that catopt solve gives for the case.",
        ),
    ] = Over.FORCE,
    start: Annotated[
        str | None,
        typer.Option(
            "--from",
            metavar="VALUE",
            help='First value with its unit, such as "100 kN" or "40 m"; a bare number is SI. '
            "When left out, what a low horizontal force gives: 1 % of the one of --to.",
        ),
    ] = None,
    stop: Annotated[
        str | None,
        typer.Option(
            "--to",
            metavar="VALUE",
            help="Last value. When left out, what a horizontal force gives that is 5 % above the "
            "case's and above the one at which a segment reaches MBL over the safety factor.",
        ),
    ] = None,
    points: Annotated[
        int, typer.Option(metavar="N", help="How many, from 2 to 10000, with both ends.")
    ] = 50,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Compute a line's load curve: its forces over its span.

    Prints span, horizontal force, tensions, grounded length and stiffness, and marks where the
    line changes its regime, a clump weight lifts or a limit is reached. A terminal shows about 20
    of the points, --json and --out give all.
    """
    from catopt.answers.curve import curve_answer
    from catopt.casefile import read_case
    from catopt.cli.result_files import Asked
    from catopt.cli.state import with_known_codes
    from catopt.report.bundle import curve_pictures

    asked = Asked(context.obj, lang, as_json, out)
    read = with_known_codes(read_case(case))
    result = _curve(read, over, start, stop, points)
    asked.give(curve_answer(result), result.to_dict, read, partial(curve_pictures, result))


def _curve(case: Case, over: Over, start: str | None, stop: str | None, points: int) -> CaseCurve:
    """Compute the curve; what is wrong with the range is told by the options' names."""
    from catopt.catenary.case_curve import curve_case
    from catopt.cli.values import in_si
    from catopt.errors import InputError
    from catopt.units import Dimension

    dimension = Dimension.FORCE if over is Over.FORCE else Dimension.LENGTH
    texts = {"start": start, "stop": stop}
    read = in_si({_OPTIONS[key]: (text, dimension) for key, text in texts.items()})
    values = {key: read[_OPTIONS[key]] for key in texts if _OPTIONS[key] in read}
    try:
        return curve_case(case, over=over.value, points=points, **values)
    except InputError as error:
        if not all(problem.key in _OPTIONS for problem in error.problems):
            raise
        problems = [
            replace(each, key=_OPTIONS[each.key], found=texts.get(each.key) or each.found)
            for each in error.problems
        ]
        raise InputError(problems, "options") from error
