"""``catopt report``: the calculation note of a case as one page."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.answering import INTERRUPTED, Asked, answering
from catopt.cli.options import CaseArgument, DesignOption, OnceOption, PlaceOption
from catopt.cli.solve import Method
from catopt.cli.values import refused
from catopt.cli.verify import stop_in_doubt
from catopt.notes.origin import file_name
from catopt.verify.motion_words import stopped_words
from catopt.words import Language, Message

if TYPE_CHECKING:
    from catopt.answers.blocks import Answer
    from catopt.notes.note_comparison import ReadNote

PAGE_ENDINGS = (".html", ".htm")
"""What tells a file from a directory in --out."""

OTHER_ENDINGS = (".pdf", ".xlsx", ".xls", ".docx", ".doc", ".odt", ".md", ".txt", ".toml", ".json")
"""Files that somebody may hope for and that a note is not."""


@answering(PlaceOption, without=["full"], language_after="design")
def report(
    asked: Asked,
    case: CaseArgument,
    design: DesignOption = None,
    date: Annotated[str, typer.Option(metavar="TEXT")] = "",
    with_workbook: Annotated[bool, typer.Option("--xlsx")] = False,
    with_pdf: Annotated[bool, typer.Option("--pdf")] = False,
    verify: Annotated[bool, typer.Option("--verify/--no-verify")] = True,
    method: Annotated[Method | None, typer.Option(metavar="METHOD")] = None,
    motion: Annotated[bool | None, typer.Option("--dynamic/--no-dynamic")] = None,
    once: OnceOption = False,
    again: Annotated[bool, typer.Option("--again")] = False,
) -> None:
    """Write the calculation note of a case: one HTML page for a checker, a workbook, a PDF."""
    from catopt.cli.note_kind import answer_of, note_of_file
    from catopt.notes.line import Note
    from catopt.notes.system import NetworkNote, SystemNote
    from catopt.render.page import page
    from catopt.report.bundle import check_directory, write_files

    output, language = asked.output, asked.language
    if again:
        _compare_again(asked, case)
        return
    if asked.out is not None:
        if asked.out.suffix.lower() in OTHER_ENDINGS and not asked.out.exists():
            allowed = Message("refused_command.page_file_ends_html_or")
            raise refused("--out", str(asked.out), allowed)
        check_directory(_place(asked.out, "")[0])
    printer = _browser() if with_pdf else ""  # before all that takes long
    with output.progress(Message("beside.note")) as watched:
        tell = watched or (lambda _, __: None)
        # Three steps: the note, as far as its line in motion is, then its page and its workbook.
        of_first = None if watched is None else lambda done, total: tell(done, 3 * total)
        swarm = None if method is None else method == "pso"
        note = note_of_file(
            case,
            design,
            date=date,
            verify=verify,
            swarm=swarm,
            motion=motion,
            once=once or None,
            progress=of_first,
        )
        moved = note.motion if isinstance(note, SystemNote | NetworkNote) else None
        if isinstance(note, Note) and note.motion is not None:
            moved = note.motion.found
        if moved is not None and not moved.is_complete:
            # A note of half a run is none, and an older one is worth more.
            asked.leave(
                INTERRUPTED,
                Message("beside.no_note_of_a_part", stopped=stopped_words(moved)),
            )
        number = note.chosen.number if isinstance(note, Note) and note.chosen else None
        tell(1, 3)
        folder, name, is_folder = _place(asked.out, file_name(case, number))
        answer = answer_of(note)
        files = {name: page(answer, language)}
        tell(2, 3)
        files |= _beside(answer, name, files[name], language, printer, with_workbook or is_folder)
    places = write_files(folder, files, keep=[case])
    if asked.as_json:
        from catopt.notes.report_document import WrittenNote, written_file

        first, *others = map(written_file, places, files.values())
        sections = tuple(section.name for section in answer.sections)
        beside = {Path(written.path).suffix: written for written in others}
        both = beside.get(".xlsx"), beside.get(".pdf")
        output.json(WrittenNote(note, first, language, sections, *both).to_dict())
    else:
        for path in places:
            output.text(str(path))
    if moved is not None:
        stop_in_doubt(asked, moved)


def _compare_again(asked: Asked, place: Path) -> None:
    """Say which numbers of an old note are otherwise in one of the same file made now."""
    from dataclasses import replace
    from tempfile import TemporaryDirectory

    from catopt.answers.note_comparison import again_answer
    from catopt.cli.note_kind import AnyNote, answer_of, has_table, note_of_file, note_of_options
    from catopt.documents import MOST_BYTES_OF_DATA, read_text
    from catopt.notes.note_comparison import compared_notes, read_written_note
    from catopt.notes.origin import Asked as AskedForNote
    from catopt.render.page import page

    text = read_text(place, str(place), kind="note", most=MOST_BYTES_OF_DATA)
    old = read_written_note(text, str(place))
    with asked.output.progress(Message("beside.note")), TemporaryDirectory() as folder:
        beside = _file_of(old, place.parent, Path(folder)) if old.name else None
        if beside is not None and has_table(beside, "design"):
            raise refused("--again", old.name, Message("refused_command.no_note_of_a_front"))
        has_motion = any("motion" in name for name in old.sections)
        has_truss = any("verification" in name for name in old.sections)
        if beside is None or old.options:
            note: AnyNote = note_of_options(old.options, beside, AskedForNote("", has_truss, False))
        else:
            note = note_of_file(beside, verify=has_truss, motion=has_motion or None)
        now = read_written_note(page(answer_of(note), old.language).decode(), str(place))
    result = compared_notes(str(place), old, now)
    replace(asked, full=True).give(again_answer(result), result.to_dict)


def _file_of(old: ReadNote, beside: Path, folder: Path) -> Path:
    """Give the file of an old note, the one beside it where that is the same, else written anew.

    Beside the note stand the files that it names, too.
    """
    from catopt.notes.origin import source_of

    place = beside / old.name
    if not place.is_file() or source_of("", place.read_text("utf-8")).text != old.text:
        place = folder / old.name
        place.write_text(old.text, "utf-8", newline="")
    return place


def _browser() -> str:
    from catopt.report.pdf import browser

    return browser()


def _beside(
    answer: Answer, name: str, page: bytes, language: Language, printer: str, with_workbook: bool
) -> dict[str, bytes]:
    """Make what stands beside the page of a name: its workbook, and what a browser prints of it."""
    files = {}
    if with_workbook:
        from catopt.render.workbook import workbook

        files[str(Path(name).with_suffix(".xlsx"))] = workbook(answer, language)
    if printer:
        from catopt.report.pdf import printed

        files[str(Path(name).with_suffix(".pdf"))] = printed(page, printer)
    return files


def _place(out: Path | None, name: str) -> tuple[Path, str, bool]:
    """Return the directory and the page's name that --out asks for, and if it is a directory."""
    if out is None:
        return Path(), name, False
    if out.suffix.lower() in PAGE_ENDINGS and not out.is_dir():
        return out.parent, out.name, False
    return out, name, True
