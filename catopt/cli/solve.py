"""``catopt solve``: one line at rest."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Annotated, Literal

import typer

from catopt.answers.solution import solution_answer
from catopt.casefile.reading import read_mooring_or_design
from catopt.cli import values
from catopt.cli.answering import Asked, answering
from catopt.cli.options import CaseArgument, CountOption, DesignOption, LoadCaseOption, OutOption
from catopt.cli.system import Wanted, answered_as_mooring
from catopt.errors import Problem
from catopt.words import Message

Method = Literal["closed-form", "pso"]


@answering(OutOption)
def solve(
    asked: Asked,
    case: CaseArgument,
    method: Annotated[Method, typer.Option(metavar="METHOD")] = "closed-form",
    runs: CountOption = None,
    particles: CountOption = None,
    iterations: CountOption = None,
    seed: CountOption = None,
    boundary: Annotated[str | None, typer.Option(metavar="NAME")] = None,
    load_case: LoadCaseOption = None,
    design: DesignOption = None,
    profile: Annotated[bool, typer.Option("--profile")] = False,
) -> None:
    """Solve a mooring line at rest; of a body or points what `catopt system` answers."""
    from catopt.catenary.case import solve_case, under_a_load
    from catopt.report.bundle import solution_pictures

    asked.check_place()
    given = values.given_ones(
        runs=runs, particles=particles, iterations=iterations, seed=seed, boundary=boundary
    )
    mooring = read_mooring_or_design(case, design)
    swarm = {"method": "pso"} if method == "pso" else {}
    of_one_line = swarm | given | {"load-case": load_case, "profile": profile or None}
    if answered_as_mooring(asked, mooring, Wanted(), of_one_line):
        return
    read = values.in_state(values.with_known_codes(mooring), load_case)
    if method != "pso":
        needs = Message("refused_command.needs_method_pso")
        values.refuse(Problem(f"--{key}", str(value), needs) for key, value in given.items())
    if given:
        with values.by_option():
            read = replace(read, swarm=replace(read.swarm, **given))
    if method == "closed-form":
        solution = solve_case(read)
    else:
        runs = read.swarm.runs
        with asked.output.progress("Swarm runs") as tell:
            done = None if tell is None else lambda done: tell(done, runs)
            solution = solve_case(read, "pso", progress=done)
    loaded, _ = under_a_load(read)
    asked.give(
        solution_answer(loaded, solution, with_profile=profile),
        partial(solution.to_dict, profile=True),
        read,
        partial(solution_pictures, loaded, solution),
        printed=partial(solution.to_dict, profile=profile),
    )
