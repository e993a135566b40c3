"""A long table as CSV, written part by part."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from catopt.answers.blocks import Table
from catopt.render.plain import csv_of
from catopt.render.units import as_wanted


def write_table(
    place: Path,
    parts: Iterable[Table],
    progress: Callable[[int, int], None] | None,
    total: int,
) -> None:
    """Write a table whose rows come in parts, of the same columns; never seen half written.

    `progress` is told the parts done, of `total`.
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
