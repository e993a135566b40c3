"""The front that the recommended line is from."""

from __future__ import annotations

from typing import Any

from catopt.notes.size import SizeNote
from catopt.render.texts import Words
from catopt.report.page.front_figure import front_figure
from catopt.report.page.sizing.load_case import said_line

__all__ = ["front"]


def front(note: SizeNote, words: Words) -> dict[str, Any] | None:
    """Build the figure and the tables of the front; None where one design alone passes."""
    shown = front_figure(said_line(note.line, words), words)
    if shown is None or shown["designs"] < 2:
        return None
    return shown | {"left_out": 0, "more": shown["left_out"]}
