"""Documents and tables as the bytes of a file."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas as pd


def document_bytes(document: dict[str, Any]) -> bytes:
    """Write a JSON document as a file has it."""
    return (json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()


def csv_of(frame: pd.DataFrame) -> bytes:
    """Write every digit of a number, so that nothing is lost on the way to other programs."""
    import pandas as pd

    words = {
        str(name): pd.Series([_as_text(cell) for cell in column], column.index, dtype="object")
        for name, column in frame.items()
        if column.dtype == object
    }
    return str(frame.assign(**words).to_csv(index=False, lineterminator="\n")).encode()


def _as_text(cell: Any) -> Any:
    """Keep a spreadsheet from running a text as a formula: it gets an apostrophe in front."""
    runs = isinstance(cell, str) and cell != "-" and cell.startswith(("=", "+", "-", "@", "\t"))
    return f"'{cell}" if runs else cell
