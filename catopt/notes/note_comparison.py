"""An old note read again: which of its numbers this version of catopt gives otherwise."""

from __future__ import annotations

import hashlib
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html.parser import HTMLParser
from typing import Final

from catopt.display import Displayable
from catopt.errors import refused
from catopt.records import FromZero, Record
from catopt.words import LANGUAGES, Language, Message

SAME: Final = 1e-6
"""Relative difference below which two numbers are one: far below what notes print, far above what
another machine's rounding leaves."""

Place = tuple[str, str, str, str, int]
"""Section, table, row, column, and which of several that have all of these."""


@dataclass(frozen=True)
class ReadNote:
    """A note as its page has it."""

    version: str
    """Of the catopt that wrote it."""
    language: Language
    sections: tuple[str, ...]
    """Their keys."""
    name: str
    """Of the file that it rests on; empty where a sizing rests on options alone."""
    text: str
    """All of that file."""
    options: tuple[tuple[str, str], ...]
    """Typed for a sizing: each as it was spelt, and its value, empty where it has none."""
    numbers: Mapping[Place, tuple[float, str]]
    """Each in SI, and as the page says it."""


@dataclass(frozen=True)
class Otherwise(Record):
    """A number that two versions give otherwise."""

    DOCUMENT = "section table row column then now then_SI now_SI"

    section: str
    """Key of the section of the note."""
    table: str
    """Key of the table."""
    row: str
    """What the row begins with."""
    column: str
    """Heading of the column."""
    then: str
    """As the old note says it."""
    now: str
    """As a note of this version says it."""
    then_SI: float
    """In SI."""
    now_SI: float
    """In SI."""

    @property
    def change(self) -> float | None:
        """By what part of the old number; None where that was zero."""
        return (self.now_SI - self.then_SI) / abs(self.then_SI) if self.then_SI else None


@dataclass(frozen=True)
class NoteAgain(Displayable, Record):
    """An old note beside one of the same file by this version of catopt."""

    DOCUMENT = "note written_by now same otherwise gone new"
    SCHEMA = "catopt.note_again/1"

    note: str
    """The old note's file."""
    written_by: str
    """Version of catopt that wrote it."""
    now: str
    """This version."""
    same: FromZero
    """Numbers that both have, alike to a millionth."""
    otherwise: tuple[Otherwise, ...]
    """Numbers that both have and that differ, by how much, the largest change first."""
    gone: FromZero
    """Numbers that only the old note has."""
    new: FromZero
    """Numbers that only the new note has."""


def read_written_note(page: str, source: str) -> ReadNote:
    """Read the page of a note; InputError where it is none, or its file is not as it was."""
    reader = _Reader()
    reader.feed(page)
    reader.close()
    version = reader.generator.removeprefix("catopt ")
    if version == reader.generator or not (reader.file_name or reader.options):
        raise refused("--again", source, Message("refused_command.a_note"))
    if reader.file_name and hashlib.sha256(reader.file_text.encode()).hexdigest() != reader.sha256:
        raise refused("--again", reader.file_name, Message("refused_command.a_note_as_it_was"))
    language = next((each for each in LANGUAGES if each == reader.language), LANGUAGES[0])
    return ReadNote(
        version,
        language,
        tuple(reader.sections),
        reader.file_name,
        reader.file_text,
        tuple(reader.options),
        reader.numbers,
    )


def compared_notes(source: str, old: ReadNote, new: ReadNote) -> NoteAgain:
    """Compare two notes of the same file number by number, by where each stands."""
    both = [place for place in old.numbers if place in new.numbers]
    pairs = ((place, *old.numbers[place], *new.numbers[place]) for place in both)
    found = [
        Otherwise(*place[:4], said, said_now, then, now)
        for place, then, said, now, said_now in pairs
        if abs(now - then) > SAME * max(abs(then), abs(now))
    ]
    found.sort(key=lambda each: -abs(each.change if each.change is not None else float("inf")))
    return NoteAgain(
        source,
        old.version,
        new.version,
        len(both) - len(found),
        tuple(found),
        len(old.numbers) - len(both),
        len(new.numbers) - len(both),
    )


_OPTIONS: Final = "size_options"
"""Table of a note that has the options of its sizing."""
_FILE = re.compile(r"^(.*), SHA-256 ([0-9a-f]{64})$")


class _Reader(HTMLParser):
    """Gathers the numbers of a page, its first file and who wrote it."""

    def __init__(self) -> None:
        super().__init__()
        self.generator, self.language = "", "en"
        self.sections: list[str] = []
        self.file_name, self.file_text, self.sha256 = "", "", ""
        self.options: list[tuple[str, str]] = []
        self.numbers: dict[Place, tuple[float, str]] = {}
        self._table, self._headings, self._cells = "", list[str](), 0
        self._row, self._text, self._value, self._in_head = "", "", "", False
        self._seen: Counter[Sequence[str]] = Counter()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        of = {name: value or "" for name, value in attrs}
        match tag:
            case "html":
                self.language = of.get("lang", "en")
            case "meta" if of.get("name") == "generator":
                self.generator = of.get("content", "")
            case "section":
                self.sections.append(of.get("id", ""))
            case "table":
                self._table, self._headings = of.get("data-key", ""), []
            case "thead":
                self._in_head = True
            case "tr":
                self._row, self._cells = "", 0
            case "data":
                self._value = of.get("value", "")
            case "pre" | "p" | "th" | "td":
                self._text = ""

    def handle_data(self, data: str) -> None:
        self._text += data

    def handle_endtag(self, tag: str) -> None:
        match tag:
            case "thead":
                self._in_head = False
            case "th" | "td":
                self._end_cell()
            case "p" if (said := _FILE.match(self._text)) and not self.file_name:
                self.file_name, self.sha256 = said.groups()
            case "pre" if self.file_name and not self.file_text:
                self.file_text = self._text

    def _end_cell(self) -> None:
        said, column = self._text.strip(), self._cells
        self._cells += 1
        if self._in_head:
            self._headings.append(said)
            return
        if not column:
            self._row = said
        elif self._table == _OPTIONS:
            self.options.append((self._row, said))
        if self._value:
            heading = self._headings[column] if column < len(self._headings) else ""
            place = (self.sections[-1] if self.sections else "", self._table, self._row, heading)
            self._seen[place] += 1
            self.numbers[*place, self._seen[place]] = (float(self._value), said)
            self._value = ""
