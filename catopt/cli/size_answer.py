"""From what ``catopt size`` is asked to what it prints and writes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.notes.size import Given
    from catopt.sizing import Sizing
    from catopt.words import Language


def check_places(out: Path | None, save: Path | None) -> None:
    """Make sure, before anything is computed, that files can be written.

    Raises InputError for a case file already there, no such directory, or one with a case of the
    user's own.
    """
    if save is not None:
        _check_save(save)
    if out is not None:
        from catopt.cli.result_files import refuse_own_case
        from catopt.report.files import check_directory

        check_directory(out)
        refuse_own_case(out)


def _check_save(place: Path) -> None:
    from catopt.errors import InputError, Problem

    if place.exists():
        allowed = "is there already and is kept; give another path"
        raise InputError([Problem("--save", str(place), allowed)], "options")
    if not place.parent.is_dir():
        allowed = f"there is no directory {place.parent}"
        raise InputError([Problem("--save", str(place), allowed)], "options")


def give(
    output: Output,
    of: Sizing,
    language: Language,
    *,
    as_json: bool,
    out: Path | None,
    save: Path | None,
    given: Given | None = None,
) -> None:
    """Write the files, then print the document or the view.

    `out` is a directory for all files, `save` the place of the case file; `given`, what was asked
    for, is for the calculation note.
    """
    from catopt.answers.size import size_answer

    answer = size_answer(of)
    if out is not None:
        from catopt.cli.result_files import write_all
        from catopt.render.files import files_of
        from catopt.report.bundle import size_files

        files = files_of(answer, of.to_dict(), language)
        write_all(output, out, files | size_files(of, language, given))
    if save is not None:
        from catopt.casefile import write_case
        from catopt.report.files import write_files

        write_files(save.parent, {save.name: write_case(of.case).encode()})
        output.note(f"{save} written; refine it with: catopt design {save}")
    if as_json:
        output.json(of.to_dict())
        return
    from catopt.render.terminal import show

    show(output, answer, language)
