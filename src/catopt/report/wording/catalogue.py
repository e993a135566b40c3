"""What the catalogue's data say in words: formulas, reasons and notes; what is cited stays.

Light on purpose: the terminal shows it without pandas.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.report.texts import table

if TYPE_CHECKING:
    from catopt.report.texts import Words

__all__ = ["said_cited", "said_formula", "said_text"]


def said_formula(words: Words, formula: str) -> str:
    """Say a formula of a figure; one without words stays as it is.

    The table has formulas behind a word of their own, for ``{number} on d`` would fit too much.
    """
    if words.language == "en" or not any(map(str.isalpha, formula)):
        return formula
    said = words.sentence(f"Formula: {formula}")
    return formula if said.lang else said.text


def said_text(words: Words, text: str) -> str:
    """Say a title, a reason or a note; a user's own, which the table lacks, stays as it is."""
    return words.sentence(text).text


def said_cited(words: Words, text: str) -> str:
    """Say what stands among titles and places but is catopt's own.

    Titles of documents and places in them are cited: the table of texts has none of them.
    """
    return words.name(text) if text in table()["names"] else text
