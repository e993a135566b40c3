"""Which kind of calculation note a file asks for: of a line, of a moored body, or of a sizing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from catopt.answers.blocks import Answer
from catopt.answers.note_line import line_note_answer
from catopt.answers.note_size import size_note_answer
from catopt.answers.note_system import network_note_answer, system_note_answer
from catopt.casefile.reading import DESIGN_CASE, DESIGN_DOCUMENT, Moored, moored_in
from catopt.cli.values import refuse
from catopt.documents import parse_toml, read_text
from catopt.errors import InputError, Problem
from catopt.notes.line import Given, Note, SizeNote, read_note, size_note
from catopt.notes.origin import Asked, asked_in, read_source
from catopt.notes.system import NetworkNote, SystemNote, read_network_note, read_system_note
from catopt.progress import Progress
from catopt.sizing.file import read_file, sized
from catopt.sizing.input_values import input_values
from catopt.sizing.inputs import Input, inputs_of
from catopt.sizing.requests import size
from catopt.words import Message

Options = Sequence[tuple[str, str]]
"""Of a sizing: each as it is spelt, and its value, empty where it has none."""

AnyNote = Note | NetworkNote | SizeNote | SystemNote


def note_of_file(
    path: Path,
    design: int | None = None,
    *,
    date: str = "",
    verify: bool = True,
    swarm: bool | None = None,
    motion: bool | None = None,
    once: bool | None = None,
    progress: Progress | None = None,
) -> AnyNote:
    """Compute the note of a case file, a file for ``catopt size`` or a directory that --out wrote.

    A design counts from 1; of `swarm`, `motion` and `once` (the line in motion without its proof)
    None is what was asked for in a result directory. Raises InputError, NoAnswerError and
    NotConvergedError as the readers of the three kinds do.
    """
    moored = moored_in(path)
    if moored is not None:
        why = Message("refused_command.of_a_known_line", moored=moored)
        refuse(_of_a_line_alone(why, design=design, motion=motion))
        return note_of_sizing(path, moored, Asked(date, verify, bool(swarm)))
    if has_table(path, "points"):
        why = Message("refused_command.for_a_case_of_a_line")
        refuse(_of_a_line_alone(why, design=design, swarm=swarm))
        asked = asked_in(path, date=date, verify=verify).with_options(motion=motion, once=once)
        return read_network_note(path, asked, progress=progress)
    if has_table(path, "system"):
        why = Message("refused_command.for_one_line")
        has_front = path.is_dir() and (path / DESIGN_DOCUMENT).is_file()
        refuse(_of_a_line_alone(why, design=None if has_front else design, swarm=swarm))
        asked = asked_in(path, date=date, verify=verify).with_options(motion=motion, once=once)
        return read_system_note(path, design, asked, progress=progress)
    return read_note(
        path,
        design,
        date=date,
        verify=verify,
        swarm=swarm,
        motion=motion,
        once=once,
        progress=progress,
    )


def has_table(path: Path, key: str) -> bool:
    """Say whether a case file, or the one in a result directory, has a table of a kind of mooring.

    What cannot be read, or is no TOML, has none: reading it as a line says what is wrong.
    """
    place = path / DESIGN_CASE if path.is_dir() else path
    try:
        return key in parse_toml(read_text(place, str(place)), str(place))
    except InputError:
        return False


def note_of_sizing(path: Path, moored: Moored, asked: Asked | None = None) -> SizeNote:
    """Size what a file for ``catopt size`` describes, and make the note of it."""
    given = Given(read_source(path))
    return size_note(sized(read_file(path, moored)), given, asked)


def note_of_options(options: Options, path: Path | None, asked: Asked) -> SizeNote:
    """Size again what options asked for, before what a file has, and make the note of it.

    Raises InputError, with every option that there is no longer.
    """
    from catopt.cli.size import spelling_of
    from catopt.cli.size import typed as from_texts

    moored = _moored_by(options) if path is None else moored_in(path) or "buoy"
    spell, by_label = spelling_of(moored), _by_label(moored)
    refuse(
        Problem(label, value, Message("refused_command.no_such_option_now"))
        for label, value in options
        if label not in by_label
    )
    typed: dict[str, Any] = {}
    for label, value in options:
        each = by_label[label]
        if each.several:
            typed.setdefault(each.name, []).append(value)
        else:
            typed[each.name] = True if each.takes == "FLAG" else value
    given = from_texts(moored, typed)
    if path is None:
        found = input_values(moored, given, spell, "options")
    else:
        found = read_file(path, moored).known(given, spell)
    source = None if path is None else read_source(path)
    return size_note(size(found), Given(source, tuple(options)), asked)


def _by_label(moored: Moored) -> dict[str, Input]:
    from catopt.cli.size import spelling_of

    spell = spelling_of(moored)
    return {spell(name): row for name, row in inputs_of(moored).items()}


def _moored_by(options: Options) -> Moored:
    """Say what is moored where no file does: a tanker by an option that a buoy does not have."""
    of_a_buoy, of_a_tanker = _by_label("buoy"), _by_label("tanker")
    return (
        "tanker"
        if any(label in of_a_tanker and label not in of_a_buoy for label, _ in options)
        else "buoy"
    )


def _of_a_line_alone(
    why: Message, *, design: int | None, swarm: bool | None = None, motion: bool | None = None
) -> Iterator[Problem]:
    """Yield what was asked for and is of one line alone."""
    if design is not None:
        yield Problem("--design", str(design), why)
    if swarm:
        yield Problem("--method", "pso", why)
    if motion:
        yield Problem("--dynamic", Message("refused_command.given"), why)


def answer_of(note: AnyNote) -> Answer:
    """Lay a note out."""
    if isinstance(note, SizeNote):
        return size_note_answer(note)
    if isinstance(note, SystemNote):
        return system_note_answer(note)
    if isinstance(note, NetworkNote):
        return network_note_answer(note)
    return line_note_answer(note)
