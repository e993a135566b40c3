"""The tables of an answer as CSV: every row, column and digit, in English."""

from __future__ import annotations

from catopt.answers.blocks import Answer, Facts, Table
from catopt.render.plain import csv_of
from catopt.render.units import as_wanted


def csv_files(answer: Answer) -> dict[str, bytes]:
    """Write every table and list of an answer, by file name."""
    return {
        f"{block.name}.csv": csv_of(block.to_dataframe())
        for block in as_wanted(answer).blocks
        if isinstance(block, Table | Facts) and block.only in {"all", "files"}
    }
