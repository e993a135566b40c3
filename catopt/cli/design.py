"""``catopt design``: the lines that are best in mass and offset at once."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from catopt.answers.design import design_answer
from catopt.casefile import write_case
from catopt.casefile.reading import DESIGN_CASE, read_mooring_or_design
from catopt.cli.answering import INTERRUPTED, Asked, answering
from catopt.cli.options import CaseArgument, CountOption, OutOption
from catopt.cli.values import by_option, given_ones
from catopt.errors import refused
from catopt.model import Case
from catopt.model.network import Network, require_case
from catopt.words import Message, say

if TYPE_CHECKING:
    from catopt.design.result import DesignResult

SearchMethod = Literal["auto", "enumeration", "nsga2", "swarm"]


@answering(OutOption)
def design(
    asked: Asked,
    case: CaseArgument,
    method: Annotated[SearchMethod | None, typer.Option(metavar="METHOD")] = None,
    evaluations: CountOption = None,
    seed: CountOption = None,
    in_motion: Annotated[bool, typer.Option("--in-motion")] = False,
) -> None:
    """Search the lines that are best in mass and offset at once."""
    asked.check_place(for_case=True)
    how = given_ones(method=method, evaluations=evaluations, seed=seed)
    how |= {"in_motion": True} if in_motion else {}
    read = read_mooring_or_design(case, None)
    if read.design is None:
        allowed = Message("refused_command.missing_table_design_says_what")
        raise refused("design", "", allowed, str(case))
    with by_option():
        read = replace(read, design=replace(read.design, **how))  # type: ignore[arg-type]
    from catopt.design.neighbours import NoFeasibleDesignError

    try:
        result = _found(asked, read)
    except NoFeasibleDesignError as error:
        if not error.interrupted:
            raise
        # Of those that were not evaluated one may pass, which status 3 would deny.
        asked.output.note(f"catopt: {say(error.message, asked.language)}")
        raise typer.Exit(INTERRUPTED) from None
    # Beside the answer, not in it: the same seed is to give the same answer to the last byte.
    values = {"count": result.evaluations, "time": result.seconds}
    asked.output.note(Message("beside.designs_evaluated", **values))
    if result.in_motion is not None:
        asked.output.note(Message("beside.run_in_motion", count=result.in_motion.run))

    give_design(asked, result)
    if result.interrupted:
        asked.output.note(Message("beside.front_so_far"))
        raise typer.Exit(INTERRUPTED)


def give_design(asked: Asked, result: DesignResult) -> None:
    """Give what a search found, with its case, which ``catopt solve DIR --design K`` needs."""

    def further() -> dict[str, bytes]:
        from catopt.report.bundle import design_pictures

        return design_pictures(result) | {DESIGN_CASE: write_case(result.case).encode()}

    asked.give(design_answer(result), result.to_dict, further=further)


def _found(asked: Asked, case: Case | Network) -> DesignResult:
    """Search designs that pass at rest or, where the case says so, in motion, too."""
    assert case.design is not None
    if not case.design.in_motion:
        from catopt.design.search import design_case

        with asked.output.progress(Message("beside.designs")) as tell:
            return design_case(case, progress=tell, announce=asked.output.note)
    from catopt.study.design_in_motion import design_in_motion

    with asked.output.progress(Message("beside.designs_in_motion")) as tell:
        return design_in_motion(require_case(case), progress=tell, announce=asked.output.note)
