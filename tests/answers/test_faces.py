"""Every face shows what an answer or a note holds, whatever kind it is, in both languages."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import openpyxl
import pytest

from catopt.__main__ import main
from catopt.answers.blocks import (
    Answer,
    Facts,
    Figure,
    FileText,
    Points,
    Step,
    Table,
    Text,
    Trail,
    Value,
    Verdict,
    Warnings,
)
from catopt.answers.design import front_in_motion_answer
from catopt.answers.size import size_answer
from catopt.answers.verification import front_answer
from catopt.casefile import parse_case
from catopt.cli.answering import STOPPED
from catopt.model import Case
from catopt.notes.front_in_motion import front_in_motion
from catopt.render.files import csv_files
from catopt.render.page import in_numbers, in_symbols
from catopt.render.terminal import show
from catopt.render.values import as_wanted
from catopt.render.workbook import workbook
from catopt.verify.case import Design, verify_front
from catopt.words import LANGUAGES, Cited, Language, Message, say
from tests.cli.conftest import OWN, typed
from tests.report.notes import LONG, NOTES, answer_named, page_named

from .results import around, by_force

CASES = Path(__file__).parent / "cases"
COMMANDS = dict(
    line.split(": ", 1)
    for line in Path(__file__).with_name("commands.txt").read_text("utf-8").splitlines()[1:]
)
"""What is typed for an answer of each kind."""


def told(line: str) -> Answer:
    """Type a command and take the answer that it would print."""
    given: list[Answer] = []
    with pytest.MonkeyPatch.context() as patch, TemporaryDirectory() as out:
        patch.chdir(CASES)
        patch.setattr("catopt.render.terminal.show", lambda _, answer, __: given.append(answer))
        patch.setenv("CATOPT_FULL", "1")
        status = main([out if word == "OUT" else word for word in typed(line)])
    assert status in (0, STOPPED)  # where half the step makes a difference, the answer says so
    (answer,) = given
    return answer


def _two() -> list[Case]:
    """Two designs, of which one has no answer."""
    text = (OWN / "coded.toml").read_text("utf-8").replace("elements = 20", "elements = 6")
    return [parse_case(text), parse_case(text.replace("120 m", "19 m"))]


def _front() -> Answer:
    designs = [Design(number, case) for number, case in enumerate(_two(), 1)]
    return front_answer(verify_front("Front", designs, elements=20))


def _front_in_motion() -> Answer:
    able, too_short = _two()
    designs = [(1, able, (1.0, 2.0)), (2, too_short, (2.0, 1.0))]
    return front_in_motion_answer(front_in_motion(designs, 2, convergence_check="none"))


FROM_PYTHON: dict[str, Callable[[], Answer]] = {
    "size": lambda: size_answer(around()),
    "size by force": lambda: size_answer(by_force()),
    "verified front": _front,
    "front in motion": _front_in_motion,
}
ANSWERS = (*COMMANDS, *FROM_PYTHON)


@cache
def made(kind: str) -> Answer:
    if kind in NOTES:
        return answer_named(kind)
    return FROM_PYTHON[kind]() if kind in FROM_PYTHON else told(COMMANDS[kind])


BY_TRUSS = (
    "verified body", "motion", "body in motion", "ship in motion", "front in motion", "fatigue",
    "fleet",
)  # fmt: skip
"""They run the truss model, or take seconds each."""


def each_of(kinds: Iterable[str]) -> list[Any]:
    """List kinds, with those that take long among the slow tests."""
    return [
        pytest.param(k, marks=pytest.mark.slow) if k in (*BY_TRUSS, *LONG) else k for k in kinds
    ]


of_an_answer = pytest.mark.parametrize("kind", each_of(ANSWERS))
of_a_note = pytest.mark.parametrize("kind", each_of(NOTES))
of_any_kind = pytest.mark.parametrize("kind", each_of((*ANSWERS, *NOTES)))
in_both_languages = pytest.mark.parametrize("language", LANGUAGES)


class Paper:
    """Keeps what is printed."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def text(self, text: str, **_: object) -> None:
        self.lines.append(text)

    def line(self) -> None:
        self.lines.append("")

    def table(
        self, columns: Iterable[str], rows: Iterable[Iterable[str]], *, title: str = "", **_: object
    ) -> None:
        self.lines += [title, *columns, *(cell for row in rows for cell in row)]


FOR_PEOPLE = {"all", "people", "not csv"}


def tables(answer: Answer) -> Iterator[Table]:
    """Every table and list of facts, as tables."""
    for block in answer.blocks:
        if isinstance(block, Facts):
            yield block.as_table()
        elif isinstance(block, Table):
            yield block


def steps(answer: Answer) -> Iterator[Step]:
    """Every step of the equations."""
    for block in answer.blocks:
        if isinstance(block, Trail):
            yield from block.steps


def alike(text: str, value: float) -> bool:
    """Equal to the 16 digits that files keep; what is not known is empty."""
    found = float(text or "nan")
    return (math.isnan(found) and math.isnan(value)) or math.isclose(found, value, rel_tol=1e-15)


@of_an_answer
def test_csv_holds_every_number(kind: str) -> None:
    files = csv_files(made(kind))
    for table in tables(made(kind)):
        if table.only in {"people", "workbook", "not csv"}:
            assert f"{table.name}.csv" not in files
            continue
        rows = list(csv.DictReader(io.StringIO(files[f"{table.name}.csv"].decode())))
        assert len(rows) == table.length
        for column in table.for_files():
            for place, row in enumerate(rows):
                value, kept = column.in_files(place), row[column.said_heading()]
                if isinstance(value, int | float) and not isinstance(value, str):
                    assert alike(kept, value), column.said_heading()
                else:
                    assert kept in {value or "", f"'{value}"}  # where it began a formula


@in_both_languages
@of_an_answer
def test_people_see_every_number_that_is_for_them(kind: str, language: Language) -> None:
    paper = Paper()
    show(paper, made(kind), language)
    printed = "\n".join(paper.lines)
    for table in tables(as_wanted(made(kind))):
        rows = range(table.length) if table.shown is None else table.shown
        for column in table.columns if table.only in FOR_PEOPLE else ():
            if column.only == "files" or column.priority:
                continue
            for row in rows:
                value, quantity = column.values[row], column.quantity_of(row)
                if isinstance(value, float) and quantity is not None and math.isfinite(value):
                    assert quantity.format(value) in printed, column.said_heading()


def users_words(value: Value) -> bool:
    """Whether a text is in no table of texts: somebody's own words, or cited."""
    return (
        isinstance(value, str) and not isinstance(value, Message) and any(map(str.isalpha, value))
    )


PLAIN, MORE_IN_NOTES = (
    set(part.splitlines()[1:])
    for part in Path(__file__).with_name("headings.txt").read_text("utf-8").split("\n\n")
)
"""Headings over what is no message."""


@of_an_answer
def test_all_other_words_are_messages(kind: str) -> None:
    """What is plain text would stay English in Vietnamese."""
    for block in made(kind).blocks:
        if isinstance(block, Text | Verdict):
            assert isinstance(block.said, Message), block.said
    for table in tables(made(kind)):
        assert isinstance(table.caption, Message) or not table.caption
        assert plain_words(table, PLAIN) == []


@pytest.mark.slow
@of_a_note
def test_all_other_words_of_notes_are_messages(kind: str) -> None:
    for table in tables(made(kind)):
        if table.name != "pieces":  # the equations that they are by
            found = plain_words(table, PLAIN | MORE_IN_NOTES)
            assert not [each for each in found if not re.match(r"[\d(<]", each)]
    assert all(isinstance(step.name, Message) for step in steps(made(kind)))


def plain_words(table: Table, own: set[str]) -> list[str]:
    """List what stands in columns that are not for the user's own words and is no message."""
    assert all(isinstance(column.name, Message) for column in table.columns), table.name
    return [
        str(value)
        for column in table.columns
        if str(column.name) not in own
        for value in column.values
        if users_words(value) and not isinstance(value, Cited)
    ]


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
                quantity = column.quantity_of(row)
                is_number = isinstance(value, int | float) and math.isfinite(value)
                if is_number and quantity is not None and abs(float(value or 0)) < quantity.floor:
                    is_number = False  # rounding, which is another on each machine
                yield value, is_number


def numbers_of(answer: Answer) -> Iterator[float]:
    """Yield every number that people see, in SI."""
    for block in answer.blocks:
        if isinstance(block, Table) and block.only in FOR_PEOPLE:
            yield from (float(value) for value, is_number in for_people(block) if is_number)  # type: ignore[arg-type]
        elif isinstance(block, Facts) and block.only in FOR_PEOPLE:
            for fact in block.facts:
                if isinstance(fact.value, int | float) and fact.only != "files":
                    yield float(fact.value)
    for step in steps(answer):
        yield from (value for value in (step.value, step.stated) if value is not None)


def words_of(answer: Answer, language: Language) -> Iterator[str]:
    """Yield everything that is said in words."""
    yield from (say(section.title, language) for section in answer.sections)
    for block in answer.blocks:
        if isinstance(block, Verdict) or (
            isinstance(block, Text) and block.only in {"all", "people"}
        ):
            yield say(block.said, language)
        elif isinstance(block, Warnings | Points):
            yield from (say(each, language) for each in block.said)
        elif isinstance(block, FileText):
            yield block.text
    for step in steps(answer):
        yield from (say(step.name, language), in_symbols(step), in_numbers(step))


@in_both_languages
@of_a_note
def test_the_page_holds_every_number_and_every_word(kind: str, language: Language) -> None:
    answer, read = made(kind), page_named(kind, language)
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
    for table in tables(answer):
        for column in table.for_files() if table.only != "people" else ():
            for row in range(table.length):
                value = column.in_files(row)
                if isinstance(value, int | float) and math.isfinite(value):
                    yield float(value)
    for step in steps(answer):
        if step.value is not None:
            yield float(step.quantity.in_files(step.value))


def cells(answer: Answer, language: Language = "en") -> Iterator[Any]:
    """Yield what the cells of the workbook hold."""
    book = openpyxl.load_workbook(io.BytesIO(workbook(answer, language)), data_only=True)
    yield from (cell.value for sheet in book for row in sheet.iter_rows() for cell in row)


@of_any_kind
def test_the_workbook_holds_every_number(kind: str) -> None:
    there = cells(made(kind))
    numbers = {float(f"{each:.16g}") for each in there if isinstance(each, int | float)}
    for value in in_files(made(kind)):
        assert float(f"{value:.16g}") in numbers


@in_both_languages
@of_a_note
def test_the_workbook_of_a_note_holds_every_word(kind: str, language: Language) -> None:
    answer = made(kind)
    said = plain(" ".join(each for each in cells(answer, language) if isinstance(each, str)))
    for block in answer.blocks:
        if isinstance(block, Text | Verdict):
            assert plain(say(block.said, language)) in said
        elif isinstance(block, Points | Warnings):
            assert all(plain(say(each, language)) in said for each in block.said)


@of_a_note
def test_both_languages_have_the_same_numbers(kind: str) -> None:
    read = (page_named(kind, language).tables for language in LANGUAGES)
    english, vietnamese = (
        [cell.value for table in page for row in table.rows for cell in row] for page in read
    )
    assert english == vietnamese
