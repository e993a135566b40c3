"""Which texts were asked for in Vietnamese and are missing."""

from __future__ import annotations

import re

import pytest

from catopt.report.texts import Phrase, Words

__all__ = ["gathered", "untranslated"]

CITED = re.compile(r"(IALA CALMAR technical reference|UFC 4-159-03|API RP 2SK) .*|IALA-CALMAR")
"""Titles of documents, and names of codes."""
THE_SAME = {"", "-", "reflective", "chain stud-link U1 22 mm"}
"""Nothing to translate; names of the swarm's settings."""


def gathered(monkeypatch: pytest.MonkeyPatch) -> set[str]:
    """Gather every text that was asked for in Vietnamese and came back in English."""
    found: set[str] = set()
    name, sentence, heading = Words.name, Words.sentence, Words.heading

    def note(words: Words, english: str, said: str) -> None:
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
    return sorted(text for text in found if not CITED.fullmatch(text))
