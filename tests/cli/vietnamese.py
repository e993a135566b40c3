"""What the answers and workbooks of both languages have in common."""

from __future__ import annotations

import re
from io import BytesIO

import openpyxl


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
