"""Which texts were asked for in Vietnamese and are missing."""

from __future__ import annotations

import re
from io import BytesIO

import openpyxl
import pytest

from catopt.render.texts import Phrase, Words
from catopt.words import Cited

__all__ = ["gathered", "numbers", "untranslated"]

CITED = re.compile(r"(IALA CALMAR technical reference|UFC 4-159-03|API RP 2SK) .*|IALA-CALMAR")
"""Titles of documents, and names of codes."""
THE_SAME = {"", "-", "reflective", "chain stud-link U1 22 mm"}
"""Nothing to translate; names of the swarm's settings."""
AS_IT_IS = re.compile(
    r"-?[\d.]+( (t|kN|m|mm))?|([\w/]+ = [\d.e+-]+(, )?)+"
    r"|chain (open-link|studless|stud-link) [\w ]+"
)
"""Numbers with their units, those of a formula, and components by their names."""


def gathered(monkeypatch: pytest.MonkeyPatch) -> set[str]:
    """Gather every text that was asked for in Vietnamese and came back in English."""
    found: set[str] = set()
    name, sentence, heading = Words.name, Words.sentence, Words.heading

    def note(words: Words, english: str, said: str) -> None:
        if isinstance(english, Cited):
            return
        if words.language == "vi" and said == english and english not in THE_SAME:
            found.add(english)

    def noted_name(self: Words, english: str) -> str:
        note(self, english, said := name(self, english))
        return said

    def noted_sentence(self: Words, english: str) -> Phrase:
        note(self, english, (said := sentence(self, english)).text)
        return said

    def noted_heading(self: Words, english: str) -> str:
        with monkeypatch.context() as inside:
            inside.setattr(Words, "sentence", sentence)
            note(self, english, said := heading(self, english))
        return said

    monkeypatch.setattr(Words, "name", noted_name)
    monkeypatch.setattr(Words, "sentence", noted_sentence)
    monkeypatch.setattr(Words, "heading", noted_heading)
    return found


def untranslated(found: set[str]) -> list[str]:
    return sorted(
        text for text in found if not CITED.fullmatch(text) and not AS_IT_IS.fullmatch(text)
    )


def numbers(workbook: bytes) -> list[tuple[int, str, object, str]]:
    """List the numbers of a workbook: sheet, cell, value and format."""
    book = openpyxl.load_workbook(BytesIO(workbook))
    return [
        (index, cell.coordinate, cell.value, cell.number_format)
        for index, sheet in enumerate(book)
        for row in sheet.iter_rows()
        for cell in row
        if cell.data_type == "n" and cell.value is not None
    ]
