"""Giving an answer as it is asked for: printed, as a document, and as files with their case."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.answers.blocks import Answer
    from catopt.cli.options import ReportLanguage
    from catopt.cli.output import Output
    from catopt.model import Case


@dataclass(frozen=True)
class Asked:
    """How an answer is asked for; a place that no files can go to is refused at once.

    Attributes
    ----------
    output : Output
        Where it is printed.
    lang : ReportLanguage
        ``--lang``.
    as_json : bool
        ``--json``.
    out : Path or None
        ``--out``.
    """

    output: Output
    lang: ReportLanguage
    as_json: bool
    out: Path | None

    def __post_init__(self) -> None:
        if self.out is not None:
            from catopt.report.files import check_directory

            check_directory(self.out)

    def give(
        self,
        answer: Answer,
        document: Callable[[], dict[str, Any]],
        case: Case | None = None,
        further: Callable[[], dict[str, bytes]] | None = None,
        printed: Callable[[], dict[str, Any]] | None = None,
    ) -> None:
        """Write the files, with the case and `further` ones, then print the document or the answer.

        The document is `printed` with less in it where that is given.
        """
        if self.out is not None:
            self._write(self.out, answer, document, case, further)
        if self.as_json:
            self.output.json((printed or document)())
            return
        from catopt.render.terminal import show

        show(self.output, answer, self.lang.value)

    def _write(
        self,
        out: Path,
        answer: Answer,
        document: Callable[[], dict[str, Any]],
        case: Case | None,
        further: Callable[[], dict[str, bytes]] | None,
    ) -> None:
        from catopt.render.files import files_of

        if further is None:
            files = files_of(answer, document(), self.lang.value)
        else:
            with self.output.progress("Tables and figures"):
                files = files_of(answer, document(), self.lang.value) | further()
        if case is not None:
            write_result(self.output, out, files, case)
        else:
            write_all(self.output, out, files)


def write_all(output: Output, directory: Path, files: Mapping[str, bytes]) -> None:
    """Write files, and tell how many there are."""
    from catopt.report.files import write_files

    written = write_files(directory, files)
    output.note(f"{len(written)} files written to {directory}")


def write_result(
    output: Output,
    directory: Path,
    files: Mapping[str, bytes],
    case: Case,
    front: Path | None = None,
) -> None:
    """Write the files of an answer with its case, and tell how many there are.

    With the case ``catopt report DIR`` makes the note of it. A case file that catopt did not write
    is never replaced, nor is that of a design search, without which its front would be lost: the
    directory `front` of a search goes with the case.
    """
    from catopt.casefile import write_case
    from catopt.casefile.design_directory import DESIGN_CASE, DESIGN_DOCUMENT
    from catopt.report.files import write_files

    stays = _stays(directory, with_front=front is not None)
    whole = dict(files)
    if not stays:
        whole[DESIGN_CASE] = write_case(case).encode()
    if not stays and front is not None:
        whole[DESIGN_DOCUMENT] = (front / DESIGN_DOCUMENT).read_bytes()
    written = write_files(directory, whole, case=write_case(case).encode())
    output.note(f"{len(written)} files written to {directory}")
    if stays and not _is_of(directory / DESIGN_CASE, case):
        output.note(
            f"catopt: {DESIGN_CASE} in {directory} stays as it is, {stays}; "
            f"catopt report {directory} is of that one"
        )


def refuse_own_case(directory: Path) -> None:
    """Raise InputError for a directory whose case file, to be replaced, is the user's own."""
    from catopt.casefile.design_directory import DESIGN_CASE
    from catopt.errors import InputError, Problem

    if _stays(directory, with_front=True):
        allowed = (
            f"has a {DESIGN_CASE} that catopt did not write, in whose place that of the answer "
            "would go; give another directory"
        )
        raise InputError([Problem("--out", str(directory), allowed)], "options")


def _stays(directory: Path, *, with_front: bool) -> str:
    """Say why the case file in a directory must not be replaced; empty where it may."""
    from catopt.casefile import parse_case, write_case
    from catopt.casefile.design_directory import DESIGN_CASE, DESIGN_DOCUMENT
    from catopt.errors import InputError

    place = directory / DESIGN_CASE
    if not place.exists():
        return ""
    if (directory / DESIGN_DOCUMENT).exists() and not with_front:
        return "for the front in design.json goes with it"
    try:
        text = place.read_text("utf-8")
        is_ours = text == write_case(parse_case(text, folder=str(directory)))
    except (OSError, ValueError, InputError):
        is_ours = False
    return "" if is_ours else "for catopt did not write it"


def _is_of(place: Path, case: Case) -> bool:
    """Whether a case file says what a case is."""
    from catopt.casefile import read_case
    from catopt.errors import InputError

    try:
        return read_case(place) == case
    except InputError:
        return False
