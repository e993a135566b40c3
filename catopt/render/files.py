"""All files of an answer: its document, its tables as CSV and its workbook."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from catopt.answers.blocks import Answer, Facts, Table
from catopt.render.plain import csv_of, document_bytes
from catopt.render.units import as_wanted
from catopt.words import Language


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
    temporary = place.with_name(f".{place.name}.tmp")
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
