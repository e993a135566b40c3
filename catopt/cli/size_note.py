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


def note_of_file(
    path: Path, moored: Moored, *, date: str = "", verify: bool = True, asked: Asked | None = None
) -> SizeNote:
    """Size what a file for ``catopt size`` describes, and make the note of it.

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
    """Say what ``catopt size`` was asked for: by its file, and by what was typed or answered."""
    from catopt.notes.origin import read_source
    from catopt.notes.size import Given

    source = None if place is None else read_source(Path(place))
    rows = [
        (spell(name), "" if each is True else str(each))
        for name, value in options.items()
        for each in (value if isinstance(value, list) else [value])
    ]
    return Given(source, tuple(rows))
