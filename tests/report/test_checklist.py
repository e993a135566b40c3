"""What a checker looks for in a calculation note, in every note that is shipped and every kind."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from catopt.cli.note_kind import answer_of
from catopt.render.page import page
from catopt.words import Language
from tests.reports import NOTES

from .further_cases import further_note
from .page_cases import known_note
from .page_reader import ReadPage, read_page
from .size_page_cases import known_size_note
from .system_page_cases import known_note as known_system_note

if TYPE_CHECKING:
    from catopt.cli.note_kind import AnyNote

SHIPPED = sorted(NOTES.glob("*.html"))


@pytest.fixture(params=SHIPPED, ids=lambda path: path.stem)
def shipped(request: pytest.FixtureRequest) -> ReadPage:
    path: Path = request.param
    return read_page(path.read_bytes())


IN_BOTH: dict[str, Callable[[], AnyNote]] = {
    "line": lambda: known_note("leg"),
    "load cases": lambda: known_note("states"),
    "motion": lambda: further_note("harmonic"),
    "body": lambda: known_system_note("pulled"),
    "buoy": lambda: known_size_note("size-buoy"),
    "tanker": lambda: known_size_note("size-tanker"),
    "several lines": lambda: known_size_note("six"),
}


@pytest.fixture(params=[(kind, language) for kind in IN_BOTH for language in ("en", "vi")])
def of_a_kind(request: pytest.FixtureRequest) -> ReadPage:
    kind, language = request.param
    return read_page(page(answer_of(IN_BOTH[kind]()), language))


SIGNED: dict[Language, list[str]] = {
    "en": ["Revision", "Date", "Prepared", "Checked", "Approved"],
    "vi": ["Lần sửa đổi", "Ngày", "Người lập", "Người kiểm tra", "Người phê duyệt"],
}
BASIS = 10
"""Rows: analysis, return period, combination, datum, tide, height, bed, water, life, pretension."""
STATED = ("basis", "bill", "anchor_place", "wear", "damaged", "fatigue")
SPAN = re.compile(r"S = \d+\.\d+ (m|ft)")


def check(read: ReadPage) -> None:
    """Go through the list."""
    sections = list(read.sections)
    assert sections[:2] == ["summary", "identity"]
    on_first = [each for each in read.elements if each.section == "summary"]
    # The answer in a sentence, four numbers, the verdict with what governs, the drawing.
    sentence = next(each.text for each in on_first if each.tag == "p")
    assert re.search(r"\d", sentence)
    assert sentence.rstrip().endswith(".")
    numbers = read.table("four").rows
    assert len(numbers) == 4
    assert all(row[1].value is not None for row in numbers)
    (verdict,) = read.styled("verdict", "summary")
    assert re.search(r"Governing: |Quyết định: |Nothing was|Chưa kiểm tra", verdict.text)
    assert sum(each.tag == "figure" for each in on_first) == 1
    # What it does not cover.
    assert sum(each.tag == "li" and len(each.text) > 20 for each in on_first) >= 1
    # No more digits than are known, in the four numbers.
    for row in numbers:
        digits = re.sub(r"[^\d]", "", row[1].text.split()[0]).lstrip("0")
        assert len(digits) <= 5, row[1].text
    # Who answers for it.
    assert read.table("signed").headings in SIGNED.values()
    # What is stated.
    for name in STATED:
        assert len(read.sections[name]) > 30, name
    assert len(read.table("basis").rows) == BASIS
    has_checks = "Nothing was" not in verdict.text and "Chưa kiểm tra" not in verdict.text
    assert bool(read.all("limit_states")) == has_checks
    assert all(cell.text for row in read.table("basis").rows for cell in row)
    assert len(read.table("bill").rows) >= 1
    assert re.search(r"NOT chosen|CHƯA được chọn", read.sections["bill"])
    # A dimension on a drawing.
    assert any(SPAN.search(each.text) for each in read.tagged("text"))
    # Load cases that are equal are shown once.
    for table in read.all("size_sums"):
        told = [tuple(cell.value for cell in row[1:]) for row in table.rows]
        assert len(set(told)) == len(told)


def test_a_shipped_note_has_what_a_checker_looks_for(shipped: ReadPage) -> None:
    check(shipped)


@pytest.mark.slow
def test_every_kind_has_it_in_both_languages(of_a_kind: ReadPage) -> None:
    check(of_a_kind)


def test_every_case_is_shipped() -> None:
    assert len(SHIPPED) >= 14
