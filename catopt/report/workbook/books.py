"""Results as an .xlsx workbook; every heading carries its unit."""

from __future__ import annotations

from collections.abc import Mapping

import pandas as pd

from catopt.render.sheet import Book
from catopt.render.texts import Language, Words

__all__ = ["verification_workbook"]


def verification_workbook(
    title: str, frames: Mapping[str, pd.DataFrame], language: Language = "en"
) -> bytes:
    """Lay out a verification: a sheet for each of its tables.

    Parameters
    ----------
    title : str
        Of the case or the search.
    frames : mapping of str to DataFrame
        As `said_frames` or `workbook_frames` of `catopt.report.tables` makes them.
    language : {"en", "vi"}
        Of its words.
    """
    book = Book(title, Words(language))
    for name, frame in frames.items():
        said = book.words("tab.runs") if name == "runs" else ""
        sheet = book.sheet(name.capitalize(), said)
        sheet.table(frame, wrap=name in {"designs", "verdicts"})
    return book.close()
