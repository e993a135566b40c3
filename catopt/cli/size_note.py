"""Between ``catopt size`` and the calculation note: the note of a file, and what was given."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.casefile.sizing_file import Moored
    from catopt.notes.directory import Asked
    from catopt.notes.size import Given, SizeNote
    from catopt.sizing.telling import Spelling

__all__ = ["given_to_size", "note_of_file"]


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
        As for `size_file` and `size_note`.
    """
    from catopt.notes.origin import read_source
    from catopt.notes.size import Given, size_note
    from catopt.sizing.file import size_file

    given = Given(read_source(path))
    return size_note(size_file(path, moored), given, date=date, verify=verify, asked=asked)


def given_to_size(place: str | None, options: Mapping[str, object], spell: Spelling) -> Given:
    """Say what a run of ``catopt size`` was asked for.

    Parameters
    ----------
    place : str or None
        Of the file.
    options : mapping of str to object
        What was typed, or answered on a terminal, by input: texts, lists of them, or flags.
    spell : Spelling
        How they are typed.
    """
    from catopt.notes.origin import read_source
    from catopt.notes.size import Given

    source = None if place is None else read_source(Path(place))
    rows = [
        (spell(name), "" if each is True else str(each))
        for name, value in options.items()
        for each in (value if isinstance(value, list) else [value])
    ]
    return Given(source, tuple(rows))
