"""The most loaded line from the side, drawn to scale."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from catopt.report.page.line_drawing import drawing_of
from catopt.report.page.system.magnified import magnified
from catopt.report.page.system.note import SystemNote
from catopt.report.texts import Words

__all__ = ["elevation"]


def elevation(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the drawing to scale, and one with heights magnified where the line is flat."""
    solution, depth = note.loaded.solution, note.case.site.water_depth
    figure = drawing_of(solution, depth, words)
    return {
        "line": note.solution.most_loaded + 1,
        "figure": replace(figure, key="system_elevation"),
        "magnified": magnified(solution, depth, words),
    }
