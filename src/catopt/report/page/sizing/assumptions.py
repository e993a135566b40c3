"""What the sizing rests on: assumptions, defaults that were taken, figures read in no document."""

from __future__ import annotations

from typing import Any

from catopt.report.page.sizing.note import SizeNote
from catopt.report.texts import Phrase, Words

__all__ = ["assumptions"]


def assumptions(note: SizeNote, words: Words) -> dict[str, Any]:
    """Build the lists; those of the loads stand with the loads."""
    of = note.sizing
    return {
        "assumptions": [words.sentence(each) for each in of.assumptions],
        "defaults": [_taken(each, note, words) for each in of.defaults],
        "recalled": [words.sentence(each) for each in of.recalled],
    }


def _taken(text: str, note: SizeNote, words: Words) -> Phrase:
    """Say what was taken; a component has its name in every language."""
    names = {segment.component for segment in note.sizing.point.line.segments}
    return Phrase(text) if text in names else words.sentence(text)
