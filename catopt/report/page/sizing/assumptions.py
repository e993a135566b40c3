"""What the sizing rests on: assumptions, defaults that were taken, figures read in no document."""

from __future__ import annotations

from typing import Any

from catopt.notes.size import SizeNote
from catopt.render.texts import Phrase, Words
from catopt.words import say

__all__ = ["assumptions"]


def assumptions(note: SizeNote, words: Words) -> dict[str, Any]:
    """Build the lists; those of the loads stand with the loads."""
    of = note.sizing
    return {
        "assumptions": [words.sentence(each) for each in of.assumptions],
        "defaults": [Phrase(say(each, words.language)) for each in of.defaults],
        "recalled": [words.sentence(each) for each in of.recalled],
    }
