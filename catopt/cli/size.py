"""``catopt size``: from buoy or ship, depth and weather to a mooring."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.answering import Asked, answering, refuse_own_case
from catopt.cli.completion import completed
from catopt.cli.help_words import WithWords, group
from catopt.cli.options import OutOption
from catopt.cli.size_options import as_option, by_option, typed, with_inputs
from catopt.cli.values import refused

if TYPE_CHECKING:
    from catopt.answers.blocks import Answer
    from catopt.casefile.sizing_file import Moored
    from catopt.notes.size import Given
    from catopt.sizing import Sizing
    from catopt.sizing.known import Known
    from catopt.sizing.telling import Spelling

size = group("size")

BuoyArgument = typer.Argument(metavar="BUOY", autocompletion=completed("buoy"))
SaveOption = Annotated[Path | None, typer.Option("--save", metavar="CASE")]


@size.command(cls=WithWords)
@answering(OutOption)
@with_inputs("buoy")
def buoy(
    asked: Asked,
    name: Annotated[str | None, BuoyArgument] = None,
    *,
    save: SaveOption = None,
    **inputs: Any,
) -> None:
    """Size the chain and the sinker of a buoy."""
    place = name if is_file(name) else None
    _size(asked, "buoy", place, {"buoy": None if place else name, **inputs}, save)


@size.command(cls=WithWords)
@answering(OutOption)
@with_inputs("tanker")
def tanker(
    asked: Asked,
    file: Annotated[str | None, typer.Argument(metavar="FILE")] = None,
    *,
    save: SaveOption = None,
    **inputs: Any,
) -> None:
    """Size the chain and the anchor of a tanker's mooring."""
    _size(asked, "tanker", file, inputs, save)


def is_file(name: str | None) -> bool:
    """Say whether what stands where a buoy's name may stand is a file of a sizing.

    A buoy that CALMAR saved is none: it takes the place of a name.
    """
    if name is None or name.lower().endswith(".xmlmb"):
        return False
    return name.endswith(".toml") or "/" in name or os.sep in name or Path(name).is_file()


def _size(
    asked: Asked, moored: Moored, place: str | None, options: dict[str, Any], save: Path | None
) -> None:
    from catopt.cli.wizard import answered
    from catopt.sizing.file import read_file
    from catopt.sizing.known import known

    _check_places(asked, save)
    spell = by_option if moored == "buoy" else as_option
    given = typed(moored, options)
    if place is None:
        given = answered(moored, given, {}, spell, asked.language)
        found, answer = _sized(asked, known(moored, given, spell, "options"))
    else:
        file = read_file(place, moored)
        with file.telling():
            if not file.findings:
                given = answered(moored, given, file.given(given), spell, asked.language)
            found, answer = _sized(asked, file.known(given, spell))
    _give(asked, found, answer, save, _as_given(place, given, spell))


def _sized(asked: Asked, of: Known) -> tuple[Sizing, Answer]:
    """Size what is known; where no line passes, say what is nearest and what would help."""
    from catopt.answers.size import size_answer
    from catopt.design.near_miss import NoFeasibleDesignError
    from catopt.sizing.requests import size as size_known
    from catopt.words import Message

    try:
        with asked.working(Message("answers.sizing_now")):
            found = size_known(of)
            return found, size_answer(found)
    except NoFeasibleDesignError as error:
        from catopt.answers.size_miss import miss_answer
        from catopt.render.card import card_lines

        lines = card_lines(miss_answer(error, of), asked.language)
        asked.leave(error.exit_status, "\n".join(each.text for each in lines))


def _check_places(asked: Asked, save: Path | None) -> None:
    """Refuse, before anything is computed, what cannot be written or would replace a case."""
    if save is not None and save.exists():
        raise refused("--save", str(save), "is there already and is kept; give another path")
    if save is not None and not save.parent.is_dir():
        raise refused("--save", str(save), f"there is no directory {save.parent}")
    asked.check_place()
    if asked.out is not None:
        refuse_own_case(asked.out)


def _give(asked: Asked, found: Sizing, answer: Answer, save: Path | None, given: Given) -> None:
    """Write the files and the case, then print the document or the answer."""
    if asked.out is not None:
        from catopt.render.files import files_of
        from catopt.report.bundle import size_files
        from catopt.words import Message

        with asked.working(Message("answers.note_now")):
            files = files_of(answer, found.to_dict(), asked.language)
            files |= size_files(found, asked.language, given)
        asked.write(files)
    if save is not None:
        from catopt.casefile import write_case
        from catopt.report.files import write_files

        write_files(save.parent, {save.name: write_case(found.whole_case).encode()})
        asked.output.note(f"{save} written; refine it with: catopt design {save}")
    asked.show(answer, found.to_dict)


def _as_given(place: str | None, options: Mapping[str, object], spell: Spelling) -> Given:
    """Say for the note what was asked for: by a file, and by what was typed or answered."""
    from catopt.notes.origin import read_source
    from catopt.notes.size import Given

    source = None if place is None else read_source(Path(place))
    rows = [
        (spell(name), "" if each is True else str(each))
        for name, value in options.items()
        for each in (value if isinstance(value, list) else [value])
    ]
    return Given(source, tuple(rows))
