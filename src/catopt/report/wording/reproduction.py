"""A reproduction in words: the one list behind its tables on the terminal and in the workbook.

Light on purpose: the terminal shows it without pandas.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.report.texts import Words
    from catopt.reproduce import Item

__all__ = ["said_among_numbers", "said_note"]

_WORD = re.compile(r"[^\W\d_]{2}")
"""What tells words from a number, with its exponent or without."""


def said_among_numbers(words: Words, text: str) -> str:
    """Say what stands in a table of numbers and words; a number stays as it is."""
    return words.heading(text) if _WORD.search(text) else text


def said_note(words: Words, item: Item) -> str:
    """Say the reason for a verdict and the remark, each for itself."""
    parts = (item.judgement.reason, item.remark)
    return "; ".join(words.sentence(part).text for part in parts if part)
