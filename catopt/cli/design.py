"""``catopt design``: the lines that are best in mass and offset at once."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Literal

import typer

from catopt.answers.design import design_answer
from catopt.casefile import read_case, write_case
from catopt.casefile.reading import DESIGN_CASE
from catopt.cli.answering import INTERRUPTED, Asked, answering, refuse_own_case
from catopt.cli.options import CaseArgument, CountOption, OutOption
from catopt.cli.values import by_option, given_ones
from catopt.errors import InputError, Problem
from catopt.words import Message

SearchMethod = Literal["auto", "enumeration", "nsga2", "swarm"]


@answering(OutOption)
def design(
    asked: Asked,
    case: CaseArgument,
    method: Annotated[SearchMethod | None, typer.Option(metavar="METHOD")] = None,
    evaluations: CountOption = None,
    seed: CountOption = None,
) -> None:
    """Search the lines that are best in mass and offset at once."""
    asked.check_place()
    if asked.out is not None:
        refuse_own_case(asked.out)
    how = given_ones(method=method, evaluations=evaluations, seed=seed)
    read = read_case(case)
    if read.design is None:
        allowed = Message("refused_command.missing_table_design_says_what")
        raise InputError([Problem("design", "", allowed)], str(case))
    with by_option():
        read = replace(read, design=replace(read.design, **how))
    from catopt.design.neighbours import NoFeasibleDesignError
    from catopt.design.search import design_case

    try:
        with asked.output.progress("Designs") as tell:
            result = design_case(read, progress=tell, announce=asked.output.note)
    except NoFeasibleDesignError as error:
        if not error.interrupted:
            raise
        # Of those that were not evaluated one may pass, which status 3 would deny.
        asked.output.note(f"catopt: {error}")
        raise typer.Exit(INTERRUPTED) from None
    # Beside the answer, not in it: the same seed is to give the same answer to the last byte.
    asked.output.note(f"{result.evaluations:,} designs evaluated in {result.seconds:.1f} s")

    def further() -> dict[str, bytes]:  # with the case, which catopt solve DIR --design K needs
        from catopt.report.bundle import design_pictures

        return design_pictures(result) | {DESIGN_CASE: write_case(result.case).encode()}

    asked.give(design_answer(result), result.to_dict, further=further)
    if result.interrupted:
        asked.output.note("The front is that of the designs evaluated so far.")
        raise typer.Exit(INTERRUPTED)
