"""``catopt size``: from buoy or ship, depth and weather to a mooring."""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

from catopt._version import identity
from catopt.cli.answering import Asked, answering, keyword
from catopt.cli.completion import completed, of_input
from catopt.cli.help_words import GroupWithWords, WithWords, group
from catopt.cli.options import OutOption, in_environment
from catopt.cli.values import refused
from catopt.sizing.inputs import Input, inputs_of
from catopt.words import Message, say

if TYPE_CHECKING:
    from catopt.answers.blocks import Answer
    from catopt.casefile.reading import Moored
    from catopt.notes.line import Given
    from catopt.sizing import Sizing
    from catopt.sizing.input_values import ResolvedInputs, Spelling


Command = TypeVar("Command", bound=Callable[..., None])

_NOTHING: Mapping[str, str] = MappingProxyType({})
_NO_OPTIONS = {"buoy": ("title", "source", "buoy"), "tanker": ("title", "source")}
_NAMED = ("depth", "draught", "dwt", "hs", "hmax", "soil")
"""Inputs that stand in what is said of others."""
_METAVARS = {"code": "NAME", "soil": "SOIL", "buoy": "BUOY", "sinker": "MATERIAL", "lines": "N"}


def as_option(name: str, index: int | None = None) -> str:
    """Write an input as an option; one of several values is ``--clump-weight (2)``."""
    flag = f"--{name.replace('_', '-')}"
    return flag if index is None else f"{flag} ({index + 1})"


def by_option(name: str, index: int | None = None) -> str:
    """Do the same where the name of a buoy stands alone."""
    return "BUOY" if name == "buoy" else as_option(name, index)


def spelling_of(moored: Moored) -> Spelling:
    """Give how the inputs of a kind of sizing are written as options."""
    return by_option if moored == "buoy" else as_option


def _parameter(each: Input, taken: str | None) -> inspect.Parameter:
    """Make an option of an input; its help says what is taken, if not its own, when left out."""
    flags = {name: as_option(name) for name in _NAMED}
    left_out = Message(each.left_out, **flags) if each.left_out else each.default
    left_out = left_out if taken is None else taken
    is_shown = each.required or each.name == "buoy"
    said = (
        Message(f"inputs.{each.name}"),
        f": {', '.join(each.words)}" if each.words else "",
        Message("left_out.such_as", example=each.example) if is_shown else "",
        Message("left_out.if_left_out", taken=left_out) if left_out else "",
    )
    words = "".join(say(part, in_environment()) for part in said) + "."
    is_flag = each.takes == "FLAG"
    metavar = None if is_flag else _METAVARS.get(each.name, each.takes)
    kind: Any = bool if is_flag else list[str] | None if each.several else str | None
    option = typer.Option(as_option(each.name), metavar=metavar, help=words, **of_input(each))
    return keyword(each.name, Annotated[kind, option], False if is_flag else None)


def with_inputs(
    moored: Moored, names: Collection[str] = (), taken: Mapping[str, str] = _NOTHING
) -> Callable[[Command], Command]:
    """Give a command the options of inputs in place of its ``**inputs``.

    Of all inputs where no `names` are given; `taken` is what is taken of those that are left out,
    by input, where that is not what a sizing takes.
    """

    def decorate(command: Command) -> Command:
        own = inspect.signature(command, eval_str=True).parameters.values()
        first = [
            parameter for parameter in own if parameter.kind is parameter.POSITIONAL_OR_KEYWORD
        ]
        last = [parameter for parameter in own if parameter.kind is parameter.KEYWORD_ONLY]
        options = [
            _parameter(row, taken.get(name))
            for name, row in inputs_of(moored).items()
            if (name in names or not names) and name not in _NO_OPTIONS[moored]
        ]
        command.__signature__ = inspect.Signature([*first, *options, *last])  # type: ignore[attr-defined]
        return command

    return decorate


def typed(moored: Moored, options: Mapping[str, Any]) -> dict[str, object]:
    """Take what was typed, by input; options that are None, empty or False are left out."""
    from catopt.sizing.kinds import from_text

    inputs = inputs_of(moored)
    found: dict[str, object] = {}
    for name, value in options.items():
        if isinstance(value, list) and value:
            found[name] = [from_text(inputs[name], text) for text in value]
        elif isinstance(value, str):
            found[name] = from_text(inputs[name], value)
        elif value:
            found[name] = value
    return found


class _OfAFile(GroupWithWords):
    """Takes a file in place of a command: what it is of says which."""

    def resolve_command(self, ctx: Any, args: Any) -> Any:
        if args and args[0] not in self.commands and Path(args[0]).is_file():
            from catopt.casefile.reading import moored_in
            from catopt.sizing.form import read_form

            path = args[0]
            moored = read_form(path)[0].moored if is_form(path) else moored_in(path) or "buoy"
            args = [moored, *args]
        return super().resolve_command(ctx, args)


size = group("size", _OfAFile)

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
    return (
        name.endswith((".toml", ".xlsx")) or "/" in name or os.sep in name or Path(name).is_file()
    )


def _size(
    asked: Asked, moored: Moored, place: str | None, options: dict[str, Any], save: Path | None
) -> None:
    from catopt.cli.wizard import answered
    from catopt.sizing.file import read_file
    from catopt.sizing.input_values import input_values

    # Refuse, before anything is computed, what cannot be written or would replace a case.
    if save is not None and save.exists():
        allowed = Message("refused_command.there_already_kept_give_another")
        raise refused("--save", str(save), allowed)
    if save is not None and not save.parent.is_dir():
        allowed = Message("refused_command.there_no_directory", parent=save.parent)
        raise refused("--save", str(save), allowed)
    asked.check_place(for_case=True)
    spell = spelling_of(moored)
    given = typed(moored, options)
    if place is not None and is_form(place):
        _size_form(asked, place, given, spell, save)
        return
    if place is None:
        given = answered(moored, given, {}, spell, asked.language)
        found, answer = _sized(asked, input_values(moored, given, spell, "options"))
    else:
        file = read_file(place, moored)
        with file.reporting():
            if not file.findings:
                given = answered(moored, given, file.given(given), spell, asked.language)
            found, answer = _sized(asked, file.known(given, spell))
    _give(asked, found, answer, save, _as_given(place, given, spell))


def is_form(path: str) -> bool:
    """Say whether a file is a workbook."""
    return path.lower().endswith(".xlsx")


def _size_form(
    asked: Asked, place: str, given: dict[str, object], spell: Spelling, save: Path | None
) -> None:
    """Size what a form asks for, and write the answer beside it; of a fleet a row each."""
    from catopt.render.workbook import workbook
    from catopt.report.bundle import write_files
    from catopt.sizing.form import read_form

    files, found = read_form(place), []
    if save is not None and len(files) > 1:
        raise refused("--save", str(save), Message("refused_command.goes_with_form_one_mooring"))
    for file in files:
        with file.reporting():
            found.append(_sized(asked, file.known(given, spell)))
    _, answer = found[0]
    if len(files) > 1:
        from catopt.answers.size_card import fleet_answer

        answer = fleet_answer([sizing for sizing, _ in found])
        of_all = [sizing.to_dict() for sizing, _ in found]
        document = {"schema": "catopt.fleet/1", "catopt": identity(), "moorings": of_all}
    beside = Path(place).with_name(f"{Path(place).stem}-answer.xlsx")
    write_files(beside.parent, {beside.name: workbook(answer, asked.language)}, keep=[Path(place)])
    asked.output.note(Message("beside.written", place=beside))
    if len(files) > 1:
        asked.show(answer, lambda: document)
    else:
        _give(asked, *found[0], save, _as_given(None, given, spell))


def _sized(asked: Asked, of: ResolvedInputs) -> tuple[Sizing, Answer]:
    """Size what is known; where no line passes, say what is nearest and what would help."""
    from catopt.answers.size import size_answer
    from catopt.design.neighbours import NoFeasibleDesignError
    from catopt.sizing.requests import size as size_known

    try:
        with asked.working(Message("answers.sizing_now")):
            found = size_known(of)
            return found, size_answer(found)
    except NoFeasibleDesignError as error:
        from catopt.answers.size_card import miss_answer
        from catopt.render.card import card_lines

        lines = card_lines(miss_answer(error, of), asked.language)
        asked.leave(error.exit_status, "\n".join(line.text for line in lines))


def _give(asked: Asked, found: Sizing, answer: Answer, save: Path | None, given: Given) -> None:
    """Print the document or the answer; then write the files, with the note, and the case."""
    asked.show(answer, found.to_dict)
    if asked.out is not None:
        from catopt.render.files import files_of
        from catopt.report.bundle import size_files

        with asked.working(Message("answers.note_now")):
            files = files_of(answer, found.to_dict(), asked.language)
            files |= size_files(found, asked.language, given)
        asked.write(files)
    if save is not None:
        from catopt.casefile import write_case
        from catopt.report.bundle import write_files

        case = found.whole_case
        case = replace(case, title=say(case.title, asked.language))
        write_files(save.parent, {save.name: write_case(case).encode()})
        onward = "to_be_run" if case.design is None else "to_be_refined"
        asked.output.note(Message(f"beside.{onward}", place=save))


def _as_given(place: str | None, options: Mapping[str, object], spell: Spelling) -> Given:
    """Say for the note what was asked for: by a file, and by what was typed or answered."""
    from catopt.notes.line import Given
    from catopt.notes.origin import read_source

    source = None if place is None else read_source(Path(place))
    rows = [
        (spell(name), "" if text is True else str(text))
        for name, value in options.items()
        for text in (value if isinstance(value, list) else [value])
    ]
    return Given(source, tuple(rows))
