"""Page and workbook show what a note holds, whatever kind it is, in both languages."""

from __future__ import annotations

import io
import math
import re
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import openpyxl
import pytest

from catopt.answers.blocks import (
    Answer,
    Facts,
    Figure,
    FileText,
    Points,
    Table,
    Text,
    Trail,
    Value,
    Verdict,
    Warnings,
)
from catopt.cli.note_kind import answer_of
from catopt.notes.line import read_note
from catopt.render.page import page
from catopt.render.trail import in_numbers, in_symbols
from catopt.render.workbook import workbook
from catopt.words import LANGUAGES, Cited, Language, Message, say
from tests.report.further_cases import further_note
from tests.report.page_cases import design_directory, known_note
from tests.report.page_reader import ReadPage, read_page
from tests.report.size_page_cases import known_size_note
from tests.report.system_page_cases import known_note as known_system_note

from .test_faces import users_words

if TYPE_CHECKING:
    from catopt.cli.note_kind import AnyNote


def _designed() -> AnyNote:
    with TemporaryDirectory() as folder:
        return read_note(design_directory(Path(folder)))


KINDS: dict[str, Callable[[], AnyNote]] = {
    **{name: lambda name=name: known_note(name) for name in ("leg", "states", "slack", "friction")},  # type: ignore[misc]
    **{name: lambda name=name: further_note(name) for name in ("swarm", "harmonic", "random")},  # type: ignore[misc]
    **{
        name: lambda name=name: known_system_note(name)  # type: ignore[misc]
        for name in ("arms", "raised", "idle", "pulled", "lone")
    },
    **{
        name: lambda name=name: known_size_note(name)  # type: ignore[misc]
        for name in ("size-buoy", "given", "hawser", "six", "sinker")
    },
    "designed": _designed,
}


@cache
def made(kind: str) -> Answer:
    return answer_of(KINDS[kind]())


IN_MOTION = ("harmonic", "random")
"""They run the truss model, which is compiled for it."""


@pytest.fixture(
    params=[pytest.param(k, marks=pytest.mark.slow) if k in IN_MOTION else k for k in KINDS]
)
def kind(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def answer(kind: str) -> Answer:
    return made(kind)


@cache
def paged(kind: str, language: Language) -> ReadPage:
    return read_page(page(made(kind), language))


def plain(text: str) -> str:
    """Without what browsers fold."""
    return re.sub(r"\s+", " ", text)


def for_people(table: Table) -> Iterator[tuple[Value, bool]]:
    """Yield every value that people see of a table, and whether it is a number in SI."""
    shown = range(table.length) if table.shown is None else table.shown
    rows = [row for _, part in table.parts for row in part] or shown
    for column in table.columns:
        if column.only in {"all", "people"}:
            for row in rows:
                value = column.values[row]
                is_number = isinstance(value, int | float) and math.isfinite(value)
                yield value, is_number


def numbers_of(answer: Answer) -> Iterator[float]:
    """Yield every number that people see, in SI."""
    for block in answer.blocks:
        if isinstance(block, Table) and block.only in {"all", "not csv", "people"}:
            yield from (float(value) for value, is_number in for_people(block) if is_number)  # type: ignore[arg-type]
        elif isinstance(block, Facts) and block.only in {"all", "not csv", "people"}:
            for fact in block.facts:
                if isinstance(fact.value, int | float) and fact.only != "files":
                    yield float(fact.value)
        elif isinstance(block, Trail):
            for step in block.steps:
                yield from (value for value in (step.value, step.stated) if value is not None)


def words_of(answer: Answer, language: Language) -> Iterator[str]:
    """Yield everything that is said in words."""
    for section in answer.sections:
        yield say(section.title, language)
        for block in section.blocks:
            if (isinstance(block, Text) and block.only in {"all", "people"}) or isinstance(
                block, Verdict
            ):
                yield say(block.said, language)
            elif isinstance(block, Warnings | Points):
                yield from (say(each, language) for each in block.said)
            elif isinstance(block, Trail):
                for step in block.steps:
                    yield from (say(step.name, language), in_symbols(step), in_numbers(step))
            elif isinstance(block, FileText):
                yield block.text


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_holds_every_number_and_every_word(kind: str, language: Language) -> None:
    answer, read = made(kind), paged(kind, language)
    cells = [cell for table in read.tables for row in table.rows for cell in row]
    shown = {cell.value for cell in cells if cell.value is not None}
    assert list(read.sections) == [section.name for section in answer.sections]
    for value in numbers_of(answer):
        assert value in shown
    said = plain(" ".join(element.text for element in read.elements))
    for words in words_of(answer, language):
        assert plain(words) in said
    figures = [each.attributes.get("data-figure") for each in read.tagged("figure")]
    wanted = [block.chart.name for block in answer.blocks if isinstance(block, Figure)]
    assert figures == wanted


def in_files(answer: Answer) -> Iterator[float]:
    """Yield every number that workbooks have, in the unit that they have it in."""
    for block in answer.blocks:
        table = block.as_table() if isinstance(block, Facts) else block
        if isinstance(table, Table) and table.only != "people":
            for column in table.for_files():
                for row in range(table.length):
                    value = column.in_files(row)
                    if isinstance(value, int | float) and math.isfinite(value):
                        yield float(value)
        elif isinstance(block, Trail):
            known = (step for step in block.steps if step.value is not None)
            yield from (step.quantity.in_files(step.value) for step in known)  # type: ignore[arg-type]


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_workbook_holds_every_number_and_every_word(answer: Answer, language: Language) -> None:
    book = openpyxl.load_workbook(io.BytesIO(workbook(answer, language)), data_only=True)
    values = {cell.value for sheet in book for row in sheet.iter_rows() for cell in row}
    numbers = {float(f"{each:.16g}") for each in values if isinstance(each, int | float)}
    for value in in_files(answer):
        assert float(f"{value:.16g}") in numbers
    said = plain(" ".join(each for each in values if isinstance(each, str)))
    for block in answer.blocks:
        if isinstance(block, Text | Verdict):
            assert plain(say(block.said, language)) in said
        elif isinstance(block, Points | Warnings):
            assert all(plain(say(each, language)) in said for each in block.said)
    charts = sum(isinstance(block, Figure) for block in answer.blocks)
    sheets: list[Any] = list(book)
    assert sum(len(sheet._charts) for sheet in sheets) == charts


def test_both_languages_have_the_same_numbers(kind: str) -> None:
    english, vietnamese = (
        [cell.value for table in paged(kind, language).tables for row in table.rows
         for cell in row]
        for language in LANGUAGES
    )  # fmt: skip
    assert english == vietnamese


NO_WORDS = {"", "m", "kN", "C5", "C8"}
USERS = {
    "Name", "Load case", "File", "Source", "Date", "Seed", "Chain", "Line", "By", "Formula",
    "Boundary handling", "Code", "Confidence", "Segments from the anchor; clump weights",
    "Sinker (mass in air)", "Design",
    "Governing check", "Change", "Verdict", "Symbol", "Mooring lines", "Title",
    "Fails by",
}  # fmt: skip
"""Headings over what users wrote, documents that are cited, or a document read from a file."""


def test_every_other_word_is_a_message(answer: Answer) -> None:
    """What is plain text would stay English in Vietnamese."""
    for block in answer.blocks:
        if isinstance(block, Facts):
            block = block.as_table()
        if isinstance(block, Table):
            for column in block.columns:
                assert isinstance(column.name, Message), column.name
                plain_words = [
                    value
                    for value in column.values
                    if users_words(value) and not isinstance(value, Cited)
                ]
                if str(column.name) not in USERS and block.name != "pieces":
                    assert not [each for each in plain_words if not re.match(r"[\d(<]", str(each))]
        elif isinstance(block, Trail):
            assert all(isinstance(step.name, Message) for step in block.steps)
