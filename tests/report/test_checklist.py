"""What a checker looks for in a calculation note, in every note that is shipped and every kind."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from catopt.words import LANGUAGES, Language
from tests.reports import NOTES

from .notes import page_named
from .page_reader import ReadPage, read_page

POINTS = {
    "hanging-instrument",
    "instrument-mooring",
    "lake-buoy",
    "raft-four-lines",
    "reservoir-raft",
    "ship-at-quay",
}
"""Notes of points and lines: they have no bill, wear or fatigue of their lines yet."""
SHIPPED = sorted(path for path in NOTES.glob("*.html") if path.stem not in POINTS)
KINDS = ("leg", "states", "harmonic", "pulled", "size-buoy", "size-tanker", "six")
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
    assert re.search(
        r"Governing: |Quyết định: |governs|quyết định|khống chế|Nothing was|Chưa kiểm tra",
        verdict.text,
    )
    # A sizing has the swing circle beside it.
    drawings = 2 if "size_loads" in sections else 1
    assert sum(each.tag == "figure" for each in on_first) == drawings
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
    assert re.search(r"NOT chosen|CHƯA được chọn|shackle|ma ní", read.sections["bill"])
    # A dimension on a drawing.
    assert any(SPAN.search(each.text) for each in read.tagged("text"))
    # Load cases that are equal are shown once.
    for table in read.all("size_sums"):
        told = [tuple(cell.value for cell in row[1:]) for row in table.rows]
        assert len(set(told)) == len(told)


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_a_shipped_note_has_what_a_checker_looks_for(path: Path) -> None:
    assert len(SHIPPED) >= 14
    check(read_page(path.read_bytes()))


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", KINDS)
def test_every_kind_has_it_in_both_languages(name: str, language: Language) -> None:
    check(page_named(name, language))
