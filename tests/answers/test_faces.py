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
from typing import Any, Literal

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
    Step,
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
from catopt.catalogue.components import Component
from catopt.catalogue.document import Answer as Found
from catopt.catenary.case import solve_case
from catopt.catenary.case_curve import curve_case
from catopt.design.search import design_case
from catopt.loads import Headings, SeaState, Ship, SurfaceCurrent, Wind, ship_loads
from catopt.model import Case
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

from .results import around, by_force

CASES = Path(__file__).parents[2] / "cases"


def case(name: str) -> Case:
    return read_case(CASES / name / "case.toml")


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


def _solution() -> Answer:
    buoy = case("buoy-9.5m")
    return solution_answer(buoy, solve_case(buoy, "pso"), with_profile=True)


def _system() -> Answer:
    body = case("fso-rang-dong")
    report = report_system(
        body, with_line_out=True, with_circle=True, directions=[math.pi], levels=[1.0]
    )
    return system_answer(report, check_case(body))


def _loads() -> Answer:
    ship = Ship("ship", 234.0, 227.0, 31.3, 12.4, 70e3, 380.0, 1200.0, 580.0, "tanker")
    wind, current, sea = Wind(20.0), SurfaceCurrent(1.0), SeaState(8.0, 2.0)
    askew = Headings(0.5, 0.0, 0.3)
    return loads_answer(
        ship_loads(ship, wind, current, sea, 20.0, wind_on="tanker loaded", headings=askew)
    )


def _families(way: Literal["show", "search", "list"], name: str = "", *found: Component) -> Answer:
    families = (catalogue.standard().family(name),) if name else tuple(catalogue.families())
    return catalogue_answer(Found(way, families, found), in_full=len(found) == 1)


def _front() -> Answer:
    """Two designs, of which one has no answer."""
    buoy = case("buoy-9.5m")
    designs = [Design(1, buoy), Design(2, replace(buoy, fairlead_height=30.0))]
    return front_answer(verify_front("Front", designs, elements=20))


def _front_in_motion() -> Answer:
    """Two designs, of which one has no answer."""
    strong = MOVING.replace('mass = "130 kg/m"', 'mass = "130 kg/m"\nMBL = "3000 kN"')
    moving = strong + _LOADED + "[checks]\nsafety_factor = 2.0\n"
    able, too_short = parse_case(moving), parse_case(moving.replace("120 m", "19 m"))
    designs = [(1, able, (1.0, 2.0)), (2, too_short, (2.0, 1.0))]
    return front_in_motion_answer(front_in_motion(designs, 2, proof="none"))


def _studied() -> Study:
    """Lengths of which one does not reach, with a limit."""
    base = read_study(CASES / "study-buoy-9.5m" / "study.toml").base
    axes = (
        Axis({"line.segments[0].length": np.array([9.0, 20.0, 21.0])}, np.array([1.0, 2.0, 3.0])),
        Axis({"load.horizontal_force": np.array([2e3, 3e3])}),
    )
    return Study("Marker buoy", base, axes, {"anchor_uplift": 500.0})


def _in_motion(text: str, **options: Any) -> Answer:
    return motion_answer(verify_dynamic(parse_case(MOVING + text), **options), with_series=True)


ANSWERS: dict[str, Callable[[], Answer]] = {
    "solution": _solution,
    "check": lambda: check_answer(check_case(case("design-tanker-20m"))),
    "checks of a body": lambda: check_answer(check_case(case("fso-rang-dong"))),
    "curve": lambda: curve_answer(curve_case(case("tanker-20m-sinker"))),
    "system": _system,
    "loads": _loads,
    "component": lambda: _families(
        "show", "chain studless", catalogue.component("chain studless R4", 0.076)
    ),
    "sizes": lambda: _families("show", "nylon", *catalogue.standard().sold("nylon")),
    "search": lambda: _families("search", "", *catalogue.search(MBL_at_least=1e6)),
    "list": lambda: _families("list"),
    "design": lambda: design_answer(design_case(case("design-buoy-9.5m"))),
    "reproduction": lambda: reproduction_answer(reproduce("load_sharing")),
    "size": lambda: size_answer(around()),
    "size by force": lambda: size_answer(by_force()),
    "verification": lambda: verification_answer(  # of three load cases
        verify_case(case("design-buoy-9.5m"), elements=20)
    ),
    "verified body": lambda: verification_answer(verify_case(case("fso-rang-dong"), elements=40)),
    "verified front": _front,
    "motion": lambda: _in_motion(AT_SEA, proof="none"),  # five short runs in random waves
    "body in motion": lambda: _in_motion(ON_THREE),
    "fatigue": lambda: fatigue_answer(verify_fatigue(case("fatigue-chain-20m"), proof="none")),
    "front in motion": _front_in_motion,
    "study": lambda: study_answer(run_study(_studied(), workers=1)),
    "fleet": lambda: study_answer(run_study(CASES / "study-fleet" / "study.toml", workers=1)),
    "plan of a study": lambda: plan_answer(plan_study(_studied())),
}


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


of_an_answer = pytest.mark.parametrize("kind", each_of(ANSWERS))
of_a_note = pytest.mark.parametrize("kind", each_of(NOTES))
of_any_kind = pytest.mark.parametrize("kind", each_of((*ANSWERS, *NOTES)))
in_both_languages = pytest.mark.parametrize("language", LANGUAGES)


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
                value, kept = column.in_files(place), row[column.heading]
                if isinstance(value, int | float) and not isinstance(value, str):
                    assert alike(kept, value), column.heading
                else:
                    assert kept in {value or "", f"'{value}"}  # where it began a formula


@in_both_languages
@of_an_answer
def test_people_see_every_number_that_is_for_them(kind: str, language: Language) -> None:
    paper = Paper()
    show(paper, made(kind), language)
    printed = "\n".join(paper.lines)
    for table in tables(made(kind)):
        rows = range(table.length) if table.shown is None else table.shown
        for column in table.columns if table.only in FOR_PEOPLE else ():
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


@of_an_answer
def test_all_other_words_are_messages(kind: str) -> None:
    """What is plain text would stay English in Vietnamese."""
    for block in made(kind).blocks:
        if isinstance(block, Text | Verdict):
            assert isinstance(block.said, Message), block.said
    for table in tables(made(kind)):
        assert isinstance(table.caption, Message) or not table.caption
        assert plain_words(table, OWN) == []


@pytest.mark.slow
@of_a_note
def test_all_other_words_of_notes_are_messages(kind: str) -> None:
    for table in tables(made(kind)):
        if table.name != "pieces":  # the equations that they are by
            found = plain_words(table, OWN | USERS)
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
    english, vietnamese = (
        [cell.value for table in page_named(kind, language).tables for row in table.rows
         for cell in row]
        for language in LANGUAGES
    )  # fmt: skip
    assert english == vietnamese
