"""Every face shows what an answer or a note holds, whatever kind it is, in both languages."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest

from catopt import catalogue, check_case, read_case
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
from catopt.answers.catalogue import catalogue_answer
from catopt.answers.check import check_answer
from catopt.answers.curve import curve_answer
from catopt.answers.design import design_answer
from catopt.answers.fatigue import fatigue_answer
from catopt.answers.loads import loads_answer
from catopt.answers.motion import front_in_motion_answer, motion_answer
from catopt.answers.reproduction import reproduction_answer
from catopt.answers.size import size_answer
from catopt.answers.solution import solution_answer
from catopt.answers.study import plan_answer, study_answer
from catopt.answers.system import system_answer
from catopt.answers.verification import front_answer, verification_answer
from catopt.casefile import parse_case
from catopt.catalogue.document import Answer as Found
from catopt.catenary.case import solve_case
from catopt.catenary.case_curve import curve_case
from catopt.design.search import design_case
from catopt.loads import Headings, SeaState, Ship, SurfaceCurrent, Wind, ship_loads
from catopt.mooring.case import report_system
from catopt.notes.front_in_motion import front_in_motion
from catopt.render.files import csv_files
from catopt.render.terminal import show
from catopt.render.trail import in_numbers, in_symbols
from catopt.render.workbook import workbook
from catopt.reproduce import reproduce
from catopt.study.axis import Axis
from catopt.study.file import read_study
from catopt.study.run import plan_study, run_study
from catopt.study.study import Study
from catopt.verify.case import Design, verify_case, verify_front
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.fatigue import verify_fatigue
from catopt.words import LANGUAGES, Cited, Language, Message, say
from tests.cli.conftest import CHAIN_IN_MOTION
from tests.report.notes import LONG, NOTES, answer_named, page_named

from .sizings import around, by_force

CASES = Path(__file__).parents[2] / "cases"
DESIGN = CASES / "design-buoy-9.5m" / "case.toml"


def _solution() -> Answer:
    case = read_case(CASES / "buoy-9.5m" / "case.toml")
    return solution_answer(case, solve_case(case, "pso"), with_profile=True)


def _check() -> Answer:
    return check_answer(check_case(read_case(CASES / "design-tanker-20m" / "case.toml")))


def _curve() -> Answer:
    return curve_answer(curve_case(read_case(CASES / "tanker-20m-sinker" / "case.toml")))


def _system() -> Answer:
    case = read_case(CASES / "fso-rang-dong" / "case.toml")
    return system_answer(
        report_system(
            case, with_line_out=True, with_circle=True, directions=[math.pi], levels=[1.0]
        ),
        check_case(case),
    )


def _checks_of_a_body() -> Answer:
    return check_answer(check_case(read_case(CASES / "fso-rang-dong" / "case.toml")))


def _design() -> Answer:
    return design_answer(design_case(read_case(DESIGN)))


def _loads() -> Answer:
    ship = Ship("ship", 234.0, 227.0, 31.3, 12.4, 70e3, 380.0, 1200.0, 580.0, "tanker")
    sea, askew = SeaState(8.0, 2.0), Headings(0.5, 0.0, 0.3)
    return loads_answer(
        ship_loads(
            ship,
            Wind(20.0),
            SurfaceCurrent(1.0),
            sea,
            20.0,
            wind_on="tanker loaded",
            headings=askew,
        )
    )


def _component() -> Answer:
    chain = catalogue.component("chain studless R4", 0.076)
    families = (catalogue.standard().family("chain studless"),)
    return catalogue_answer(Found("show", families, (chain,)), in_full=True)


def _sizes() -> Answer:
    families = (catalogue.standard().family("nylon"),)
    return catalogue_answer(Found("show", families, catalogue.standard().sold("nylon")))


def _search() -> Answer:
    found = catalogue.search(MBL_at_least=1e6)
    return catalogue_answer(Found("search", tuple(catalogue.families()), tuple(found)))


def _list() -> Answer:
    return catalogue_answer(Found("list", tuple(catalogue.families())))


def _reproduction() -> Answer:
    return reproduction_answer(reproduce("load_sharing"))


def _size() -> Answer:
    return size_answer(around())


def _size_by_force() -> Answer:
    return size_answer(by_force())


def _verification() -> Answer:
    """Three load cases."""
    return verification_answer(verify_case(read_case(DESIGN), elements=20))


def _verified_body() -> Answer:
    case = read_case(CASES / "fso-rang-dong" / "case.toml")
    return verification_answer(verify_case(case, elements=40))


def _front() -> Answer:
    """Two designs, of which one has no answer."""
    case = read_case(CASES / "buoy-9.5m" / "case.toml")
    too_short = replace(case, fairlead_height=30.0)
    designs = [Design(1, case), Design(2, too_short)]
    return front_answer(verify_front("Front", designs, elements=20))


_LOADED = '[load]\nhorizontal_force = "300 kN"\n'
MOVING = CHAIN_IN_MOTION.replace(_LOADED, "").replace("elements = 20", "elements = 6")
AT_SEA = """
duration_of_interest = "1 h"
runs = 5
[waves]
spectrum = "jonswap"
height = "2 m"
period = "3 s"
components = 10
[load]
horizontal_force = "300 kN"
"""
ON_THREE = """
[system]
anchor_radius = "117 m"
fairlead_radius = "4 m"
azimuths = ["180 deg", "60 deg", "-60 deg"]
force = ["30 kN", "0 kN"]
"""


def _motion() -> Answer:
    """Five short runs in random waves."""
    case = parse_case(MOVING + AT_SEA)
    return motion_answer(verify_dynamic(case, proof="none"), with_series=True)


def _fatigue() -> Answer:
    return fatigue_answer(
        verify_fatigue(read_case(CASES / "fatigue-chain-20m" / "case.toml"), proof="none")
    )


def _body_in_motion() -> Answer:
    return motion_answer(verify_dynamic(parse_case(MOVING + ON_THREE)), with_series=True)


def _front_in_motion() -> Answer:
    """Two designs, of which one has no answer."""
    strong = MOVING.replace('mass = "130 kg/m"', 'mass = "130 kg/m"\nMBL = "3000 kN"')
    moving = strong + _LOADED + "[checks]\nsafety_factor = 2.0\n"
    case, too_short = parse_case(moving), parse_case(moving.replace("120 m", "19 m"))
    designs = [(1, case, (1.0, 2.0)), (2, too_short, (2.0, 1.0))]
    return front_in_motion_answer(front_in_motion(designs, 2, proof="none"))


def _study() -> Answer:
    """Lay out a line on lengths of which one does not reach, with a limit."""
    return study_answer(run_study(_studied(), workers=1))


def _studied() -> Study:
    base = read_study(CASES / "study-buoy-9.5m" / "study.toml").base
    axes = (
        Axis({"line.segments[0].length": np.array([9.0, 20.0, 21.0])}, np.array([1.0, 2.0, 3.0])),
        Axis({"load.horizontal_force": np.array([2e3, 3e3])}),
    )
    return Study("Marker buoy", base, axes, {"anchor_uplift": 500.0})


def _fleet() -> Answer:
    return study_answer(run_study(CASES / "study-fleet" / "study.toml", workers=1))


def _plan() -> Answer:
    return plan_answer(plan_study(_studied()))


ANSWERS: dict[str, Callable[[], Answer]] = {
    "solution": _solution, "check": _check, "checks of a body": _checks_of_a_body,
    "curve": _curve, "system": _system, "loads": _loads,
    "component": _component, "sizes": _sizes, "search": _search,
    "list": _list, "design": _design, "reproduction": _reproduction, "size": _size,
    "size by force": _size_by_force, "verification": _verification,
    "verified body": _verified_body, "verified front": _front, "motion": _motion,
    "body in motion": _body_in_motion, "fatigue": _fatigue, "front in motion": _front_in_motion,
    "study": _study, "fleet": _fleet, "plan of a study": _plan,
}  # fmt: skip


@cache
def made(kind: str) -> Answer:
    return answer_named(kind) if kind in NOTES else ANSWERS[kind]()


BY_TRUSS = (
    "verified body", "motion", "body in motion", "front in motion", "fatigue", "fleet", *LONG,
)  # fmt: skip
"""They run the truss model, or take seconds each."""


def each_of(kinds: Iterable[str]) -> list[Any]:
    """List kinds, with those that take long among the slow tests."""
    return [pytest.param(k, marks=pytest.mark.slow) if k in BY_TRUSS else k for k in kinds]


@pytest.fixture(params=each_of(ANSWERS))
def answer(request: pytest.FixtureRequest) -> Answer:
    """Lay out the answer of a command."""
    return made(request.param)


@pytest.fixture(params=each_of((*ANSWERS, *NOTES)))
def of_any_kind(request: pytest.FixtureRequest) -> Answer:
    """Lay out an answer or a note."""
    return made(request.param)


@pytest.fixture(params=each_of(NOTES))
def note(request: pytest.FixtureRequest) -> str:
    return str(request.param)


class Paper:
    """Keeps what is printed."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def text(self, text: str, *, bold: bool = False) -> None:  # noqa: ARG002 - as printed
        self.lines.append(text)

    def line(self) -> None:
        self.lines.append("")

    def table(
        self,
        columns: Sequence[str],
        rows: Sequence[Sequence[str]],
        *,
        title: str = "",
        numbers: Sequence[int] = (),  # noqa: ARG002 - as printed
    ) -> None:
        self.lines += [title, *columns, *(cell for row in rows for cell in row)]


def tables(answer: Answer) -> Iterator[Table]:
    """Every table and list of facts, as tables."""
    for block in answer.blocks:
        if isinstance(block, Facts):
            yield block.as_table()
        elif isinstance(block, Table):
            yield block


def number(text: str) -> float:
    return math.nan if text == "" else float(text)


def alike(first: float, second: float) -> bool:
    """Equal to the 16 digits that files keep."""
    return (math.isnan(first) and math.isnan(second)) or math.isclose(first, second, rel_tol=1e-15)


def test_csv_holds_every_number(answer: Answer) -> None:
    files = csv_files(answer)
    for table in tables(answer):
        if table.only in {"people", "workbook", "not csv"}:
            assert f"{table.name}.csv" not in files
            continue
        rows = list(csv.DictReader(io.StringIO(files[f"{table.name}.csv"].decode())))
        assert len(rows) == table.length
        for column in table.for_files():
            for place, row in enumerate(rows):
                value = column.in_files(place)
                if isinstance(value, int | float) and not isinstance(value, str):
                    assert alike(number(row[column.heading]), value), column.heading
                else:
                    kept = row[column.heading]  # after an apostrophe where it began a formula
                    assert kept in {value or "", f"'{value}"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_people_see_every_number_that_is_for_them(answer: Answer, language: Language) -> None:
    paper = Paper()
    show(paper, answer, language)
    printed = "\n".join(paper.lines)
    for table in tables(answer):
        if table.only not in {"all", "people", "not csv"}:
            continue
        rows = range(table.length) if table.shown is None else table.shown
        for column in table.columns:
            if column.only == "files" or column.priority:
                continue
            for row in rows:
                value, quantity = column.values[row], column.quantity_of(row)
                if isinstance(value, float) and quantity is not None and math.isfinite(value):
                    assert quantity.format(value) in printed, column.heading


def users_words(value: Value) -> bool:
    """Whether a text is in no table of texts: somebody's own words, or cited."""
    return (
        isinstance(value, str) and not isinstance(value, Message) and any(map(str.isalpha, value))
    )


OWN = {
    "Title", "Source", "Name", "Load case", "Code", "By", "Capacity and source", "Note",
    "Method", "Boundary handling", "Refusal", "Formula", "Numbers", "Symbol", "Unit", "Conf.",
    "Component", "Family", "Grade", "Grades", "Variant", "Also", "Sources", "Sizes", "Place",
    "Confidence", "Confidence of MBL", "Confidence of the sizes", "Sources of the sizes",
    "Quantity", "Study", "Recalled, read in no document", "Also published: --variant",
    "Reference point (SI units)",
    "Chain", "On", "Governing load case", "Design factor by",
}  # fmt: skip
"""Columns that may hold the user's own words, keys of documents, or what is cited."""

USERS = {
    "Name", "Load case", "File", "Source", "Date", "Seed", "Chain", "Line", "By", "Formula",
    "Boundary handling", "Code", "Confidence", "Segments from the anchor; clump weights",
    "Sinker (mass in air)", "Design",
    "Governing check", "Change", "Verdict", "Symbol", "Mooring lines", "Title",
    "Fails by",
}  # fmt: skip
"""Headings over what users wrote, documents that are cited, or a document read from a file."""


def test_all_other_words_are_messages(answer: Answer) -> None:
    """What is plain text would stay English in Vietnamese."""
    for block in answer.blocks:
        if isinstance(block, Text | Verdict):
            assert isinstance(block.said, Message), block.said
    for table in tables(answer):
        assert isinstance(table.caption, Message) or not table.caption
        assert plain_words(table, OWN) == []


@pytest.mark.slow
def test_all_other_words_of_notes_are_messages(note: str) -> None:
    for table in tables(made(note)):
        if table.name != "pieces":  # the equations that they are by
            found = plain_words(table, OWN | USERS)
            assert not [each for each in found if not re.match(r"[\d(<]", each)]
    for block in made(note).blocks:
        if isinstance(block, Trail):
            assert all(isinstance(step.name, Message) for step in block.steps)


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
def test_the_page_holds_every_number_and_every_word(note: str, language: Language) -> None:
    answer, read = made(note), page_named(note, language)
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


def cells(answer: Answer, language: Language = "en") -> Iterator[Any]:
    """Yield what the cells of the workbook hold."""
    book = openpyxl.load_workbook(io.BytesIO(workbook(answer, language)), data_only=True)
    yield from (cell.value for sheet in book for row in sheet.iter_rows() for cell in row)


def test_the_workbook_holds_every_number(of_any_kind: Answer) -> None:
    there = cells(of_any_kind)
    numbers = {float(f"{each:.16g}") for each in there if isinstance(each, int | float)}
    for value in in_files(of_any_kind):
        assert float(f"{value:.16g}") in numbers


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_workbook_of_a_note_holds_every_word(note: str, language: Language) -> None:
    answer = made(note)
    said = plain(" ".join(each for each in cells(answer, language) if isinstance(each, str)))
    for block in answer.blocks:
        if isinstance(block, Text | Verdict):
            assert plain(say(block.said, language)) in said
        elif isinstance(block, Points | Warnings):
            assert all(plain(say(each, language)) in said for each in block.said)


def test_both_languages_have_the_same_numbers(note: str) -> None:
    english, vietnamese = (
        [cell.value for table in page_named(note, language).tables for row in table.rows
         for cell in row]
        for language in LANGUAGES
    )  # fmt: skip
    assert english == vietnamese
