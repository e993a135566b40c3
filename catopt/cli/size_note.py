"""Between ``catopt size`` and the calculation note: a sizing out of a file, and what was given."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import typer

    from catopt.casefile.sizing_file import Moored
    from catopt.cli.size_file import Filled
    from catopt.notes.directory import Asked
    from catopt.notes.size import Given, SizeNote
    from catopt.sizing import Sizing

__all__ = ["given_to_size", "note_of_file", "sizing_of_file"]

_OF_THE_OUTPUT = frozenset({"--json", "--out", "--save", "--lang", "--help"})
"""Options that say nothing of what is sized."""


def note_of_file(
    path: Path, moored: Moored, *, date: str = "", verify: bool = True, asked: Asked | None = None
) -> SizeNote:
    """Size what a file describes, and make the note of it.

    Parameters
    ----------
    path : Path
        A file for ``catopt size``.
    moored : {"buoy", "tanker"}
        Which of the two kinds of file it is.
    date : str
        For the title block.
    verify : bool
        Whether the truss model is put beside the closed form.
    asked : Asked, optional
        What else is shown of the recommended line.

    Raises
    ------
    InputError, NoAnswerError, NotConvergedError
        As for `sizing_of_file` and `size_note`.
    """
    from catopt.notes.origin import read_source
    from catopt.notes.size import Given, size_note

    given = Given(read_source(path))
    sizing = sizing_of_file(path, moored)
    return size_note(sizing, given, date=date, verify=verify, asked=asked)


def sizing_of_file(path: Path, moored: Moored) -> Sizing:
    """Size what a file describes: as ``catopt size KIND FILE`` does, but nothing is asked for.

    Parameters
    ----------
    path : Path
        The file.
    moored : {"buoy", "tanker"}
        Which of the two kinds of file it is.

    Raises
    ------
    InputError
        With every mistake, each by its key; what is wanted and is not in the file is one.
    NoAnswerError, NotConvergedError
        As for `catopt.sizing.size_buoy` and `size_tanker`.
    """
    from catopt.cli.size_answer import sized
    from catopt.cli.size_file import fill
    from catopt.cli.size_requests import Wishes, buoy_request, tanker_request, titled
    from catopt.sizing import size_buoy, size_tanker

    context = _context(path, moored)
    filled = fill(context, _defaults(context, moored), str(path), moored)
    given = filled.options
    found = None
    with filled.telling():
        wishes = Wishes.among(given)
        if moored == "buoy":
            request = buoy_request(given, wishes)
            found = sized(size_buoy, titled(request, filled)) if filled.is_sound else None
        else:
            ship = tanker_request(given, wishes)
            found = sized(size_tanker, titled(ship, filled)) if filled.is_sound else None
    assert found is not None
    return found


def _context(path: Path, moored: Moored) -> typer.Context:
    """Parse ``catopt size KIND FILE`` without running it: what each option has when left out."""
    from typer.main import get_command

    from catopt.cli.size import size

    group: Any = get_command(size)
    context: typer.Context = group.commands[moored].make_context(moored, [str(path)])
    return context


def _defaults(context: typer.Context, moored: Moored) -> dict[str, Any]:
    """List the options by name with their defaults, as the commands have them."""
    options = {
        parameter.opts[0]: _plain(context.params.get(parameter.name or ""))
        for parameter in context.command.params
        if parameter.opts[0].startswith("--")
    }
    return options | ({"BUOY": None} if moored == "buoy" else {})


def _plain(value: Any) -> Any:
    """Take an option as the commands hand it on: a choice as its text, none of several as None."""
    if isinstance(value, tuple):
        return list(value) or None
    return getattr(value, "value", value)


def given_to_size(context: typer.Context, filled: Filled, given: dict[str, Any]) -> Given:
    """Say what a run of ``catopt size`` was asked for.

    Parameters
    ----------
    context : typer.Context
        Knows what was typed.
    filled : Filled
        Options and the file.
    given : dict
        The same with what was answered on a terminal.
    """
    from catopt.notes.origin import read_source
    from catopt.notes.size import Given

    source = None if filled.file is None else read_source(Path(filled.file.source))
    return Given(source, tuple(_by_hand(context, filled, given)))


def _by_hand(
    context: typer.Context, filled: Filled, given: dict[str, Any]
) -> Iterator[tuple[str, str]]:
    """Yield what was typed or answered, by its option."""
    typed = {
        parameter.opts[0]
        for parameter in context.command.params
        if (source := context.get_parameter_source(parameter.name or "")) is not None
        and source.name != "DEFAULT"
    }
    for option, value in given.items():
        is_answer = value != filled.options.get(option)
        is_name = option == "BUOY" and "name" in typed and filled.file is None
        if value is None or option in _OF_THE_OUTPUT:
            continue
        if option in typed or is_answer or is_name:
            many = value if isinstance(value, list) else [value]
            for each in many:
                yield option, "" if each is True else str(each)
