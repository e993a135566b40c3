"""``catopt solve``: one line at rest."""

from __future__ import annotations

from enum import StrEnum
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.options import (
    CaseArgument,
    DesignOption,
    JsonOption,
    LangOption,
    OutOption,
    ReportLanguage,
)

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.cli.output import Output
    from catopt.model import Case


class Method(StrEnum):
    """How the line is solved."""

    CLOSED_FORM = "closed-form"
    PSO = "pso"


def solve(
    context: typer.Context,
    case: CaseArgument,
    method: Annotated[
        Method,
        typer.Option(
            metavar="METHOD",
            help="closed-form, or pso for the particle swarm, which wants a known horizontal "
            "force and the anchor on the bed.",
        ),
    ] = Method.CLOSED_FORM,
    runs: Annotated[
        int | None, typer.Option(metavar="N", help="pso: independent runs; overrides the case.")
    ] = None,
    particles: Annotated[
        int | None, typer.Option(metavar="N", help="pso: size of the swarm; overrides the case.")
    ] = None,
    iterations: Annotated[
        int | None, typer.Option(metavar="N", help="pso: iterations a run; overrides the case.")
    ] = None,
    seed: Annotated[
        int | None, typer.Option(metavar="N", help="pso: seed; overrides the case.")
    ] = None,
    boundary: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="pso: what happens to a particle beyond a bound: nearest, reflective, shrink, "
            "random, intermediate or periodic; overrides the case.",
        ),
    ] = None,
    load_case: Annotated[
        str | None,
        typer.Option(
            "--load-case",
            metavar="NAME",
            help="Solve under this load case; when left out under [load], or else the first one.",
        ),
    ] = None,
    design: DesignOption = None,
    profile: Annotated[
        bool, typer.Option("--profile", help="Add the shape and the tension along the line.")
    ] = False,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Solve one mooring line at rest.

    Prints the inclination at the anchor, the span, the tensions and how the line lies, with the
    residuals of the equilibrium. Forces are shown in kN and tf, the JSON document is in SI.
    """
    from catopt.answers.solution import solution_answer
    from catopt.casefile.design_directory import read_case_or_design
    from catopt.cli.result_files import Asked
    from catopt.cli.state import in_state, with_known_codes
    from catopt.report.bundle import solution_pictures

    asked = Asked(context.obj, lang, as_json, out)
    settings: dict[str, Any] = {
        "runs": runs,
        "particles": particles,
        "iterations": iterations,
        "seed": seed,
        "boundary": boundary,
    }
    given = {key: value for key, value in settings.items() if value is not None}
    whole = with_known_codes(read_case_or_design(case, design))
    read = _with_settings(in_state(whole, load_case), given, method)
    solution = _solved(read, method, asked.output)
    given_case, read = read, _as_solved(read)
    answer = solution_answer(read, solution, with_profile=profile)
    asked.give(
        answer,
        partial(solution.to_dict, profile=True),
        given_case,
        partial(solution_pictures, read, solution),
        printed=partial(solution.to_dict, profile=profile),
    )


def _with_settings(case: Case, given: dict[str, Any], method: Method) -> Case:
    from dataclasses import replace

    from catopt.cli.values import by_option
    from catopt.errors import InputError, Problem

    if given and method is not Method.PSO:
        raise InputError(
            [Problem(f"--{key}", str(value), "needs --method pso") for key, value in given.items()],
            "options",
        )
    with by_option():
        return replace(case, swarm=replace(case.swarm, **given)) if given else case


def _solved(case: Case, method: Method, output: Output) -> Solution:
    from catopt.catenary.case import solve_case

    if method is Method.CLOSED_FORM:
        return solve_case(case)
    runs = case.swarm.runs
    with output.progress("Swarm runs") as tell:
        return solve_case(
            case, "pso", progress=None if tell is None else lambda done: tell(done, runs)
        )


def _as_solved(case: Case) -> Case:
    from catopt.catenary.case import under_a_load

    return under_a_load(case)[0]
