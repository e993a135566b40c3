"""``catopt report``: the calculation note of a case as one page."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.options import JsonOption

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.report.page.note import Note

__all__ = ["report"]

PAGE_ENDINGS = (".html", ".htm")
"""What tells a file from a directory in --out."""


class PageLanguage(StrEnum):
    """Language of the page."""

    ENGLISH = "en"
    VIETNAMESE = "vi"


def report(
    context: typer.Context,
    case: Annotated[
        Path,
        typer.Argument(
            metavar="CASE",
            help="Case file (TOML), or a directory that catopt design --out wrote.",
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
        PageLanguage,
        typer.Option(metavar="LANGUAGE", help="Language of the page: en, or vi for Vietnamese."),
    ] = PageLanguage.ENGLISH,
    date: Annotated[
        str,
        typer.Option(
            metavar="TEXT",
            help="Date for the title block, as it is to stand there; no date when left out.",
        ),
    ] = "",
    as_json: JsonOption = False,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="PLACE",
            help="File to write, ending in .html, or a directory for it; the working directory "
            "when left out. A file of the same name is replaced.",
        ),
    ] = None,
) -> None:
    """Write the calculation note of a case: one HTML page for a checker.

    It holds all it shows, opens from disk without a network and prints to A4: inputs, components
    with their sources, the line to scale, tensions, checks, and every result with its equation and
    its numbers put in. The same case gives the same page to the last byte.
    """
    from catopt.report.files import write_files
    from catopt.report.page.note import file_name, read_note
    from catopt.report.page.render import render_page

    output: Output = context.obj
    note = read_note(case, design, date=date)
    number = None if note.chosen is None else note.chosen.number
    folder, name = _place(out, file_name(case, number))
    page = render_page(note, lang.value)
    (written,) = write_files(folder, {name: page})
    if as_json:
        output.json(_document(note, lang.value, written, page))
    else:
        output.text(str(written))


def _place(out: Path | None, name: str) -> tuple[Path, str]:
    """Return the directory and the file's name that --out asks for."""
    if out is None:
        return Path(), name
    if out.suffix.lower() in PAGE_ENDINGS and not out.is_dir():
        return out.parent, out.name
    return out, name


def _document(note: Note, language: str, written: Path, page: bytes) -> dict[str, Any]:
    """Say what was written (schema catopt.report/1)."""
    from hashlib import sha256

    from catopt.report.page.render import sections_of
    from catopt.report.texts import Words

    words = Words("vi" if language == "vi" else "en")
    checks = note.checks
    governing = checks.governing
    return {
        "schema": "catopt.report/1",
        "title": note.case.title,
        "path": str(written),
        "bytes": len(page),
        "sha256": sha256(page).hexdigest(),
        "language": language,
        "date": note.date,
        "version": note.version,
        "sources": [{"name": file.name, "sha256": file.sha256} for file in note.files],
        "design": None if note.chosen is None else note.chosen.number,
        "load_case": note.load_case,
        "sections": [key for key, _ in sections_of(note, words)],
        "passes": checks.passes if checks.results else None,
        "governing": "" if governing is None else f"{governing.name} ({governing.load_case})",
        "warnings": list(note.warnings),
    }
