"""``catopt report``: the calculation note of a case as one page."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.options import LANGUAGE_VARIABLE, JsonOption, OnceOption, ReportLanguage
from catopt.cli.solve import Method
from catopt.cli.verify import INTERRUPTED, stop_if_not_converged

if TYPE_CHECKING:
    from catopt.cli.note_kind import AnyNote
    from catopt.cli.output import Output, Progress
    from catopt.notes.line import Note
    from catopt.notes.system import SystemNote
    from catopt.verify.dynamic_result import DynamicVerification

PAGE_ENDINGS = (".html", ".htm")
"""What tells a file from a directory in --out."""

OTHER_ENDINGS = (".pdf", ".xlsx", ".xls", ".docx", ".doc", ".odt", ".md", ".txt", ".toml", ".json")
"""Files that somebody may hope for and that a note is not."""


def report(
    context: typer.Context,
    case: Annotated[
        Path,
        typer.Argument(
            metavar="CASE",
            help="Case file (TOML), file of catopt size, or a directory that --out of catopt "
            "solve, check, curve, verify, system or design wrote.",
        ),
    ],
    design: Annotated[
        int | None,
        typer.Option(
            metavar="K",
            help="Of a result directory, the number of the design; the recommended one when left "
            "out.",
        ),
    ] = None,
    lang: Annotated[
        ReportLanguage,
        typer.Option(
            metavar="LANGUAGE",
            envvar=LANGUAGE_VARIABLE,
            help="Language of page and workbook: en, or vi for Vietnamese.",
        ),
    ] = ReportLanguage.ENGLISH,
    date: Annotated[
        str,
        typer.Option(
            metavar="TEXT",
            help="Date for the title block, as it is to stand there; no date when left out.",
        ),
    ] = "",
    with_workbook: Annotated[
        bool,
        typer.Option(
            "--xlsx",
            help="Write the workbook of the same name beside the page, too; in a directory given "
            "by --out it always is.",
        ),
    ] = False,
    verify: Annotated[
        bool,
        typer.Option(
            "--verify/--no-verify",
            help="Put the truss model beside the closed form, or leave that out, which saves a "
            "second.",
        ),
    ] = True,
    method: Annotated[
        Method | None,
        typer.Option(
            metavar="METHOD",
            help="pso puts the particle swarm beside the closed form, on which the note rests in "
            "any case. When left out: of a result directory, what catopt solve was asked for "
            "there.",
        ),
    ] = None,
    motion: Annotated[
        bool | None,
        typer.Option(
            "--dynamic/--no-dynamic",
            help="Also run the line in time, as catopt verify --dynamic does, or leave that out. "
            "When left out: of a result directory, what catopt verify was asked for there.",
        ),
    ] = None,
    once: OnceOption = False,
    as_json: JsonOption = False,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="PLACE",
            help="File to write, ending in .html, or a directory for page and workbook; the page "
            "in the working directory when left out. Files of the same name are replaced.",
        ),
    ] = None,
) -> None:
    """Write the calculation note of a case: one HTML page for a checker, and a workbook.

    The page holds all it shows, opens from disk without a network and prints to A4: inputs,
    components with their sources, the line to scale, tensions, checks, every result with its
    equation and its numbers put in, and the same line by a truss model. The workbook has its tables
    with native charts. The same case gives the same files to the last byte.
    """
    from catopt.cli.note_kind import Wanted, answer_of, note_of_file
    from catopt.notes.line import Note
    from catopt.notes.origin import file_name
    from catopt.render.page import page
    from catopt.report.files import write_files

    output: Output = context.obj
    _check_place(out)
    with output.progress("Calculation note") as tell:
        swarm = None if method is None else method is Method.PSO
        wanted = Wanted(design, date, verify, swarm, motion, once or None)
        note = note_of_file(case, wanted, _first_of_three(tell))
        number = None
        moved = _moved(note)
        _stop_if_interrupted(moved, output)
        if isinstance(note, Note):
            number = None if note.chosen is None else note.chosen.number
        _tell(tell, 1)
        folder, name, is_folder = _place(out, file_name(case, number))
        answer = answer_of(note)
        files = {name: page(answer, lang.value)}
        _tell(tell, 2)
        if with_workbook or is_folder:
            from catopt.render.workbook import workbook

            files[str(Path(name).with_suffix(".xlsx"))] = workbook(answer, lang.value)
    places = write_files(folder, files, keep=[case])
    written = list(zip(places, files.values(), strict=True))
    if as_json:
        sections = [section.name for section in answer.sections]
        output.json(_document(note, sections, lang.value, written))
    else:
        for path, _ in written:
            output.text(str(path))
    if moved is not None:
        stop_if_not_converged(output, moved, lang)


def _moved(note: AnyNote) -> DynamicVerification | None:
    """Return what is in motion in a note: a line, or all of a body's."""
    from catopt.notes.line import Note
    from catopt.notes.system import SystemNote

    if isinstance(note, SystemNote):
        return note.motion
    return note.motion.found if isinstance(note, Note) and note.motion is not None else None


def _tell(tell: Progress | None, steps: int) -> None:
    """Tell how much is done: the note, its page, its workbook."""
    if tell is not None:
        tell(steps, 3)


def _first_of_three(tell: Progress | None) -> Progress | None:
    """Tell of the line in motion as of the first step."""
    return None if tell is None else lambda done, total: tell(done, 3 * total)


def _stop_if_interrupted(moved: DynamicVerification | None, output: Output) -> None:
    """Write nothing after Ctrl-C: a note of half a run is none, and an older one is worth more."""
    if moved is not None and not moved.is_complete:
        from catopt.verify.motion_words import stopped_words

        output.note(
            f"catopt: {stopped_words(moved)}; no note was written. "
            "catopt verify CASE --dynamic --out DIR keeps what a stopped run has computed"
        )
        raise typer.Exit(INTERRUPTED)


def _check_place(out: Path | None) -> None:
    """Refuse, before anything is computed, a place where no page can go."""
    if out is None:
        return
    from catopt.errors import InputError, Problem
    from catopt.report.files import check_directory

    if out.suffix.lower() in OTHER_ENDINGS and not out.exists():
        allowed = "a page, in a file that ends in .html, or a directory is wanted"
        raise InputError([Problem("--out", str(out), allowed)], "options")
    check_directory(_place(out, "")[0])


def _place(out: Path | None, name: str) -> tuple[Path, str, bool]:
    """Return the directory and the page's name that --out asks for, and if it is a directory."""
    if out is None:
        return Path(), name, False
    if out.suffix.lower() in PAGE_ENDINGS and not out.is_dir():
        return out.parent, out.name, False
    return out, name, True


def _document(
    note: AnyNote, sections: list[str], language: str, written: list[tuple[Path, bytes]]
) -> dict[str, Any]:
    """Say what was written (schema catopt.report/1); of a sizing, of its recommended line."""
    from catopt.cli.note_kind import line_of
    from catopt.notes.document import motion_document, swarm_document
    from catopt.notes.system import SystemNote

    line = line_of(note)
    of = note if isinstance(note, SystemNote) else line
    assert of is not None
    checks = of.checks
    governing = checks.governing
    page, *workbook = [_file(*each) for each in written]
    return {
        "schema": "catopt.report/1",
        "title": note.title,
        **page,
        "workbook": workbook[0] if workbook else None,
        "language": language,
        "date": note.origin.date,
        "version": note.origin.version,
        "sources": [{"name": file.name, "sha256": file.sha256} for file in note.origin.files],
        "design": None if line is None or line.chosen is None else line.chosen.number,
        "load_case": "" if line is None else line.load_case,
        "sections": sections,
        "passes": checks.passes if checks.results else None,
        "governing": "" if governing is None else governing.in_case,
        "verification": _verification(of),
        "swarm": None if line is None else swarm_document(line),
        "motion": motion_document(of),
        "warnings": list(note.warnings),
    }


def _verification(note: Note | SystemNote) -> dict[str, Any] | None:
    """Say what came of the truss model; None where it was left out."""
    if note.verification_failure:
        return {"verdict": "no answer", "worst": None, "failure": note.verification_failure}
    if note.verification is None:
        return None
    worst = note.verification.static.worst
    named = {"quantity": worst.quantity, "unit": worst.unit, "gap": worst.gap}
    return {"verdict": note.verification.verdict, "worst": named, "failure": ""}


def _file(path: Path, content: bytes) -> dict[str, Any]:
    from hashlib import sha256

    return {"path": str(path), "bytes": len(content), "sha256": sha256(content).hexdigest()}
