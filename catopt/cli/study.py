"""``catopt study``: many members of one case, computed however often they are stopped."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.options import JsonOption, LangOption, ReportLanguage

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.study.result import StudyResult
    from catopt.study.store import Store
    from catopt.study.study import Study
    from catopt.words import Language

MEMBERS = "members.csv"
"""Table of all members, in the directory of a study."""


def study(
    context: typer.Context,
    file: Annotated[Path, typer.Argument(metavar="STUDY", help="Study file (TOML).")],
    plan: Annotated[
        bool,
        typer.Option(
            "--plan", help="Say how many members there are and what they take; run none of them."
        ),
    ] = False,
    status: Annotated[
        bool,
        typer.Option("--status", help="Say what is computed in --out DIR by now; run nothing."),
    ] = False,
    workers: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            help="Processes side by side; all cores when left out, one for members at rest.",
        ),
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option(
            metavar="ADDRESS",
            help="Run on the cluster of this Dask scheduler, such as tcp://10.0.0.1:8786.",
        ),
    ] = None,
    notes: Annotated[
        bool,
        typer.Option(
            "--notes",
            help="Of a study of sizings: write the calculation note of each, to DIR/notes.",
        ),
    ] = False,
    parquet: Annotated[
        bool,
        typer.Option(
            "--parquet", help="Write the table of members as Parquet, too: DIR/members.parquet."
        ),
    ] = False,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="DIR",
            help="Keep what is computed here, and write its tables. Stopped at any moment, the "
            "same command goes on where it was.",
        ),
    ] = None,
) -> None:
    """Compute a case again and again, with what varies in it: at rest, checked, in motion, sized.

    A member without an answer stops nothing; it is listed with its reason.
    """
    from catopt.cli.result_files import Asked
    from catopt.report.files import check_directory
    from catopt.study.file import read_study
    from catopt.study.result import StudyResult
    from catopt.study.store import Store

    asked = Asked(context.obj, lang, as_json, None)
    output = asked.output
    _check_options(
        {"--status": status, "--notes": notes, "--parquet": parquet},
        plan=plan, workers=workers, scheduler=scheduler, out=out,
    )  # fmt: skip
    if parquet:
        from catopt.study.table import need_parquet

        need_parquet()
    if out is not None:
        check_directory(out)
    read = read_study(file)
    if notes and read.base.moored is None:
        raise _refused("--notes", 'goes with compute = "sizing"')
    if plan:
        from catopt.answers.study import plan_answer
        from catopt.study.run import plan_study

        found = plan_study(read)
        asked.give(plan_answer(found), found.to_dict)
        return
    store = Store(read, out)
    try:
        if not status:
            _run(output, read, store, workers, scheduler, out if notes else None, lang.value)
        result = StudyResult(read, store)
        if out is not None and not status:
            _write(output, out, result, lang.value)
            if parquet:
                _write_parquet(out)
        from catopt.answers.study import study_answer

        asked.give(study_answer(result), result.to_dict)
    except KeyboardInterrupt:
        if out is not None:
            done = StudyResult(read, store).done
            output.note(f"catopt: {done:,} of {len(read):,} members are in {out}; "
                        "the same command goes on")  # fmt: skip
        raise
    finally:
        store.close()


def _check_options(
    of_directory: Mapping[str, bool],
    *,
    plan: bool,
    workers: int | None,
    scheduler: str | None,
    out: Path | None,
) -> None:
    from catopt.errors import InputError, Problem

    problems = []
    if plan and of_directory["--status"]:
        problems.append(Problem("--plan", "", "does not go with --status"))
    for option, is_given in of_directory.items():
        if is_given and out is None:
            problems.append(Problem(option, "", "goes with --out DIR, which is missing"))
    if workers is not None and workers < 1:
        problems.append(Problem("--workers", str(workers), "1 or more processes"))
    if workers is not None and scheduler is not None:
        problems.append(Problem("--workers", str(workers), "does not go with --scheduler"))
    if problems:
        raise InputError(problems, "options")


def _refused(option: str, allowed: str) -> Exception:
    from catopt.errors import InputError, Problem

    return InputError([Problem(option, "", allowed)], "options")


def _run(
    output: Output,
    read: Study,
    store: Store,
    workers: int | None,
    scheduler: str | None,
    notes: Path | None,
    language: Language,
) -> None:
    from catopt.study.run import cluster, processes, run_into, worth

    count = worth(read) if workers is None else workers
    of_sizing = None
    if notes is not None:
        from catopt.report.study_notes import StudyNotes

        of_sizing = StudyNotes(str(notes / "notes"), read.base.source, language)
    with ExitStack() as stack:
        executor, at_once = None, 1
        if scheduler is not None:
            executor, at_once = stack.enter_context(cluster(scheduler))
        elif count > 1:
            executor, at_once = stack.enter_context(processes(count))
        tell = stack.enter_context(output.progress("Members"))
        run_into(
            read,
            store,
            executor=executor,
            at_once=at_once,
            of_sizing=of_sizing,
            progress=tell,
        )


def _write_parquet(out: Path) -> None:
    """Write the table of members anew, as it stands in its CSV."""
    import pandas as pd

    place = out / MEMBERS
    pd.read_csv(place).to_parquet(place.with_suffix(".parquet"))


def _write(output: Output, out: Path, result: StudyResult, language: Language) -> None:
    """Write the table of members as it is read from the store, and the tables of the answer."""
    from catopt.answers.study import members_table, study_answer
    from catopt.cli.result_files import write_all
    from catopt.render.files import files_of, write_table
    from catopt.report.bundle import study_pictures

    with output.progress("Tables") as tell:
        parts = (members_table(result.study, each) for each in result.store.pieces())
        write_table(out / MEMBERS, parts, None if tell is None else tell, result.study.pieces)
    files = files_of(study_answer(result), result.to_dict(), language)
    write_all(output, out, files | study_pictures(result))
