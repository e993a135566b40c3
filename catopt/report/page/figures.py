"""The drawings of a line at rest, for its page."""

from __future__ import annotations

from typing import Any

from catopt.figures.line import line_in_water, tension_along
from catopt.notes.capacity import allowed_tensions
from catopt.notes.line import Note
from catopt.render.svg import svg
from catopt.render.texts import Words

__all__ = ["capacities", "line_drawing", "tension_figure"]


def line_drawing(note: Note, words: Words) -> dict[str, Any]:
    """Build the drawing of the line in the water."""
    return {"figure": svg(line_in_water(note.solution, note.case.site.water_depth), words.language)}


def capacities(note: Note) -> list[float | None]:
    """Find the least tension that each segment is allowed in the load case drawn, N."""
    return allowed_tensions(note.checks, note.solution, note.load_case)


def tension_figure(note: Note, words: Words) -> dict[str, Any]:
    """Build the figure of the tension beside what each segment may carry."""
    return {"figure": svg(tension_along(note.solution, capacities(note)), words.language)}
