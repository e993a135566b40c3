"""All files of an answer: its document, its tables and its workbook."""

from __future__ import annotations

from typing import Any

from catopt.answers.blocks import Answer
from catopt.render.plain import document_bytes
from catopt.words import Language


def files_of(
    answer: Answer, document: dict[str, Any] | None, language: Language = "en"
) -> dict[str, bytes]:
    """Write an answer as files, by file name.

    `document` is what ``--json`` prints, None where it is part of another answer's. The language is
    the workbook's; the tables (CSV) stay in English.
    """
    from catopt.render.csv import csv_files
    from catopt.render.workbook import workbook

    files = {f"{answer.name}.xlsx": workbook(answer, language), **csv_files(answer)}
    if document is not None:
        files[f"{answer.name}.json"] = document_bytes(document)
    return files
