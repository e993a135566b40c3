"""``catopt study``: many members of one case, computed however often they are stopped."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from catopt.answers.study import members_table, plan_answer, study_answer
from catopt.cli.answering import Asked, answering
from catopt.cli.options import CountOption, OutOption
from catopt.cli.values import refuse, refused
from catopt.errors import Problem
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.study.result import StudyResult
    from catopt.study.store import Store
    from catopt.study.study import Study

MEMBERS = "members.csv"
"""Table of all members, in the directory of a study."""


@answering(OutOption)
def study(
    asked: Asked,
    file: Annotated[Path, typer.Argument(metavar="STUDY")],
    plan: Annotated[bool, typer.Option("--plan")] = False,
    status: Annotated[bool, typer.Option("--status")] = False,
    workers: CountOption = None,
    scheduler: Annotated[str | None, typer.Option(metavar="ADDRESS")] = None,
    notes: Annotated[bool, typer.Option("--notes")] = False,
    parquet: Annotated[bool, typer.Option("--parquet")] = False,
) -> None:
    """Compute a case again and again, with what varies in it."""
    from catopt.study.file import read_study
    from catopt.study.result import StudyResult
    from catopt.study.store import Store, need_parquet

    of_directory = {"--status": status, "--notes": notes, "--parquet": parquet}
    missing = [option for option, given in of_directory.items() if given and asked.out is None]
    refuse(_problems(missing, workers, scheduler, is_both=plan and status))
    if parquet:
        need_parquet()
    asked.check_place()
    read = read_study(file)
    if read.base.compute == "design":
        others = {"--plan": plan, "--workers": workers, "--scheduler": scheduler, **of_directory}
        wanted = Message("refused_command.does_not_go_with_design")
        refuse(Problem(option, "", wanted) for option, given in others.items() if given)
        from catopt.cli.design import give_design
        from catopt.study.robust import design_in_draws

        with asked.output.progress(Message("beside.designs")) as tell:
            front = design_in_draws(read, progress=tell, announce=asked.output.note)
        give_design(asked, front)
        return
    if notes and read.base.moored is None:
        raise refused("--notes", "", Message("refused_command.goes_with_compute_sizing"))
    if plan:
        from catopt.study.run import plan_study

        found = plan_study(read)
        asked.show(plan_answer(found), found.to_dict)
        return
    store = Store(read, asked.out)
    try:
        if not status:
            _run(asked, read, store, workers, scheduler, with_notes=notes)
        result = StudyResult(read, store)
        if not status:
            _write(asked, result, parquet=parquet)
        asked.show(study_answer(result), result.to_dict)
    except KeyboardInterrupt:
        if asked.out is not None:
            values = {"done": StudyResult(read, store).done, "count": len(read)}
            asked.output.note(Message("beside.members_kept", **values, place=asked.out))
        raise
    finally:
        store.close()


def _problems(
    missing: list[str], workers: int | None, scheduler: str | None, *, is_both: bool
) -> Iterator[Problem]:
    """Yield what does not go together; `missing` are options without the --out that they need."""
    if is_both:
        yield Problem("--plan", "", Message("refused_command.does_not_go_with_status"))
    for option in missing:
        yield Problem(option, "", Message("refused_command.goes_with_out_dir_which"))
    if workers is not None and workers < 1:
        yield Problem("--workers", str(workers), Message("refused_command.n_1_or_more_processes"))
    if workers is not None and scheduler is not None:
        wanted = Message("refused_command.does_not_go_with_scheduler")
        yield Problem("--workers", str(workers), wanted)


def _run(
    asked: Asked,
    read: Study,
    store: Store,
    workers: int | None,
    scheduler: str | None,
    *,
    with_notes: bool,
) -> None:
    from catopt.study.run import cluster, processes, run_into, worth

    count = worth(read) if workers is None else workers
    of_sizing = None
    if with_notes and asked.out is not None:
        from catopt.report.bundle import write_member_note

        place = str(asked.out / "notes")
        of_sizing = partial(write_member_note, place, read.base.source, asked.language)
    with ExitStack() as stack:
        executor, at_once = None, 1
        if scheduler is not None:
            executor, at_once = stack.enter_context(cluster(scheduler))
        elif count > 1:
            executor, at_once = stack.enter_context(processes(count))
        tell = stack.enter_context(asked.output.progress(Message("beside.members")))
        run_into(
            read, store, executor=executor, at_once=at_once, of_sizing=of_sizing, progress=tell
        )


def _write(asked: Asked, result: StudyResult, *, parquet: bool) -> None:
    """Write the table of members as it is read from the store, and the tables of the answer."""
    from catopt.render.files import files_of, write_table
    from catopt.report.bundle import pictures_of

    if asked.out is None:
        return
    place = asked.out / MEMBERS
    with asked.output.progress(Message("beside.tables")) as tell:
        parts = (members_table(result.study, piece) for piece in result.store.pieces())
        write_table(place, parts, tell, result.study.pieces)
    files = files_of(study_answer(result), result.to_dict(), asked.language)
    asked.write(files | pictures_of("study", result))
    if parquet:
        import pandas as pd

        pd.read_csv(place).to_parquet(place.with_suffix(".parquet"))
