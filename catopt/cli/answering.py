"""Giving an answer as it is asked for: printed, as a document, and as files with their case."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Iterable, Mapping
from contextlib import AbstractContextManager, nullcontext, suppress
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import typer

from catopt.cli import options as option
from catopt.cli.output import Printer, terminal_width
from catopt.cli.values import refused
from catopt.errors import InputError
from catopt.progress import when_long
from catopt.quantities import Units
from catopt.words import Language, Message, say

if TYPE_CHECKING:
    from catopt.answers.blocks import Answer
    from catopt.model import Case
    from catopt.model.network import Network

FAILED = 3
"""The input is right, but the answer is not what ``--strict`` asks for."""
STOPPED = 4
"""A solver did not converge, or a maximum hangs on the step or the bars."""
INTERRUPTED = 130
"""128 + SIGINT: Ctrl-C; what was computed until then is given all the same."""

Documents = Callable[[], dict[str, Any]]
Files = Callable[[], dict[str, bytes]]


@dataclass(frozen=True)
class Asked:
    """How an answer is asked for: where it is printed, and by which of the common options."""

    output: Printer
    language: Language
    as_json: bool
    out: Path | None
    full: bool = False

    def check_place(self, *, for_case: bool = False) -> None:
        """Refuse a place that no files can go to, before anything is computed.

        Where a case file goes there, one that is the user's own is not replaced, either.
        """
        if self.out is None:
            return
        from catopt.report.bundle import check_directory

        check_directory(self.out)
        if for_case and _stays(self.out, with_front=True):
            allowed = Message("refused_command.has_case_toml_catopt_did")
            raise refused("--out", str(self.out), allowed)

    def leave(self, status: int, why: str) -> NoReturn:
        """End with an exit status, and say why on standard error."""
        self.output.note(f"catopt: {say(why, self.language)}")
        raise typer.Exit(status)

    def give(
        self,
        answer: Answer,
        document: Documents,
        case: Case | Network | None = None,
        further: Files | None = None,
        printed: Documents | None = None,
    ) -> None:
        """Write the files, with the case and `further` ones, then print the document or the answer.

        The document is `printed` with less in it where that is given.
        """
        if self.out is not None:
            from catopt.render.files import files_of

            if further is None:
                files = files_of(answer, document(), self.language)
            else:
                with self.output.progress(Message("beside.tables_and_figures")):
                    files = files_of(answer, document(), self.language) | further()
            self.write(files, case)
        self.show(answer, printed or document)

    def show(self, answer: Answer, document: Documents) -> None:
        """Print the document or the answer; its card, where it has one, unless all is asked for."""
        if self.as_json:
            self.output.json(document())
            return
        if self.full:
            from catopt.render.terminal import show

            show(self.output, answer, self.language)
            return
        from catopt.render.card import show_card
        from catopt.words.message import group

        # Below the card: what to type next, and how all of the answer is had.
        key = "answers.more_full" if answer.name == "size" else "answers.more"
        further = Message(key if self.out is None else f"{key}_alone")
        named = f"next_{answer.next or answer.name}"
        if named in group("answers"):
            further = Message("answers.next", next=Message(f"answers.{named}"), whole=further)
        show_card(self.output, answer, self.language, further)

    def working(self, what: str) -> AbstractContextManager[object]:
        """Say what is done while the body runs, once that has taken a second.

        Nothing beside a document. See `Printer.working`.
        """
        return nullcontext() if self.as_json else self.output.working(what)

    def write(
        self,
        files: Mapping[str, bytes],
        case: Case | Network | None = None,
        front: Path | None = None,
    ) -> None:
        """Write files of an answer, with its case if there is one, and tell how many there are.

        With the case ``catopt report DIR`` makes the note of it. A case file that catopt did not
        write is never replaced, nor is that of a design search, without which its front would be
        lost: the directory `front` of a search goes with the case.
        """
        from catopt.report.bundle import write_files

        assert self.out is not None
        whole, text, stays = dict(files), None, None
        if case is not None:
            from catopt.casefile import read_mooring, write_case
            from catopt.casefile.reading import DESIGN_CASE, DESIGN_DOCUMENT

            text = write_case(case).encode()
            stays = _stays(self.out, with_front=front is not None)
            if not stays:
                whole[DESIGN_CASE] = text
            if not stays and front is not None:
                whole[DESIGN_DOCUMENT] = (front / DESIGN_DOCUMENT).read_bytes()
        written = write_files(self.out, whole, case=text)
        self.output.note(Message("beside.files_written", count=len(written), place=self.out))
        if case is None or not stays:
            return
        with suppress(InputError):
            if read_mooring(self.out / DESIGN_CASE) == case:
                return
        self.output.note(Message("beside.case_stays", name=DESIGN_CASE, place=self.out, why=stays))

    def give_file(
        self,
        name: str,
        text: str,
        document: Callable[[str | None], dict[str, Any]],
        remarks: Iterable[str],
        keep: Path,
    ) -> None:
        """Write a text as one file, or print it, and say what has to be known of it.

        The file has its `name` in a directory; `keep` was read, and nothing goes in its place.
        """
        path = None
        if self.out is not None:
            from catopt.report.bundle import write_files

            place = self.out / name if self.out.is_dir() or not self.out.suffix else self.out
            (written,) = write_files(place.parent, {place.name: text.encode()}, keep=[keep])
            path = str(written)
        for remark in remarks:
            self.output.note(f"note: {say(remark, self.language)}")
        if self.as_json:
            self.output.json(document(path))
        else:  # as a whole: a path is not folded
            self.output.file(text if path is None else f"{path}\n")


def answering(
    out: Any,
    *,
    without: Collection[str] = (),
    language_after: str = "",
) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a command the common options at its end, as its `asked`.

    These are ``--lang``, ``--units``, ``--full``, ``--json`` and `out`,
    but for those `without`; the first two follow the parameter `language_after`, if it is given.
    """

    def decorate(command: Callable[..., None]) -> Callable[..., None]:
        @wraps(command)
        def answered(
            context: typer.Context,
            as_json: bool,
            out: Path | None,
            lang: Language = "en",
            units: Units | None = None,
            full: bool = False,
            **options: Any,
        ) -> None:
            from catopt.render.terminal import COLUMNS
            from catopt.render.values import UNITS

            output = context.obj
            when_long(lambda reported: output.note(say(reported, lang)))
            before = UNITS.set(units or "")
            columns = COLUMNS.set(terminal_width())
            try:
                command(Asked(output, lang, as_json, out, full), **options)
            finally:
                UNITS.reset(before)
                COLUMNS.reset(columns)

        _, *own = inspect.signature(command, eval_str=True).parameters.values()
        names = [parameter.name for parameter in own]
        place = names.index(language_after) + 1 if language_after else len(own)
        parameters = [
            keyword("context", typer.Context),
            *own[:place],
            keyword("lang", option.LangOption, "en"),
            keyword("units", option.UnitsOption, None),
            *own[place:],
            keyword("full", option.FullOption, False),
            keyword("as_json", option.JsonOption, False),
            keyword("out", out, None),
        ]
        kept = [
            parameter.replace(kind=parameter.KEYWORD_ONLY)
            for parameter in parameters
            if parameter.name not in without
        ]
        answered.__signature__ = inspect.Signature(kept)  # type: ignore[attr-defined]
        return answered

    return decorate


def keyword(
    name: str, annotation: Any, default: Any = inspect.Parameter.empty
) -> inspect.Parameter:
    """Make a parameter that is given by its name."""
    kind = inspect.Parameter.KEYWORD_ONLY
    return inspect.Parameter(name, kind, default=default, annotation=annotation)


def _stays(directory: Path, *, with_front: bool) -> Message | None:
    """Say why the case file in a directory must not be replaced; None where it may."""
    from catopt.casefile import write_case
    from catopt.casefile.reading import DESIGN_CASE, DESIGN_DOCUMENT, parse_mooring

    place = directory / DESIGN_CASE
    if not place.exists():
        return None
    if (directory / DESIGN_DOCUMENT).exists() and not with_front:
        return Message("beside.front_goes_with_it", name=DESIGN_DOCUMENT)
    try:
        text = place.read_text("utf-8")
        is_ours = text == write_case(parse_mooring(text, folder=str(directory)))
    except (OSError, ValueError, InputError):
        is_ours = False
    return None if is_ours else Message("beside.not_ours")
