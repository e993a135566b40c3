"""What is said in Vietnamese, and what the workbooks of both languages have in common."""

from __future__ import annotations

import re
from io import BytesIO

import openpyxl

from catopt.words import Message, is_term, say, term


def in_vietnamese(english: str) -> str:
    """Say what the code says in English; it must be known by its key, or a term."""
    if isinstance(english, Message):
        return say(english, "vi")
    assert is_term(english)
    return say(term(english), "vi")


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


def said_alike(english: str, vietnamese: str) -> set[str]:
    """Lines with words that are the same in both languages."""
    in_words = re.compile(r"[^\W\d_]{3,}")
    lines = (set(text.splitlines()) for text in (english, vietnamese))
    return {line for line in set.intersection(*lines) if in_words.search(line)}
