"""The files of an answer, as bytes: its document, its tables as CSV and its workbook."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from catopt.answers.blocks import Answer, Facts, Table
from catopt.render.values import as_wanted
from catopt.words import Language

if TYPE_CHECKING:
    import pandas as pd


def files_of(
    answer: Answer, document: dict[str, Any] | None, language: Language = "en"
) -> dict[str, bytes]:
    """Write an answer as files, by file name.

    `document` is what ``--json`` prints, None where it is part of another answer's. The language is
    the workbook's; the tables (CSV) stay in English.
    """
    from catopt.render.workbook import workbook

    files = {f"{answer.name}.xlsx": workbook(answer, language), **csv_files(answer)}
    if document is not None:
        files[f"{answer.name}.json"] = document_bytes(document)
    return files


def csv_files(answer: Answer) -> dict[str, bytes]:
    """Write every table and list of an answer, with every row, column and digit, by file name."""
    return {
        f"{block.name}.csv": csv_of(block.to_dataframe())
        for block in as_wanted(answer).blocks
        if isinstance(block, Table | Facts) and block.only in {"all", "files"}
    }


def write_table(
    place: Path, parts: Iterable[Table], progress: Callable[[int, int], None] | None, total: int
) -> None:
    """Write a table whose rows come in parts, of the same columns; never seen half written.

    `progress` is given the parts done, of `total`.
    """
    temporary = place.with_name(f".{place.name}.{os.getpid()}.tmp")  # another may write there, too
    try:
        with temporary.open("wb") as file:
            for number, part in enumerate(parts):
                text = csv_of(as_wanted(part).to_dataframe())
                file.write(text if number == 0 else text.split(b"\n", 1)[1])
                if progress is not None:
                    progress(number + 1, total)
        temporary.replace(place)
    finally:
        temporary.unlink(missing_ok=True)


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
