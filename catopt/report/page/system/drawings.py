"""The body from above, and its most loaded line from the side."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.figures.line import line_in_water, magnified
from catopt.figures.mooring import near, plan
from catopt.notes.system import SystemNote
from catopt.render.svg import Figure, svg
from catopt.render.texts import Words

if TYPE_CHECKING:
    from catopt.figures.chart import Chart
    from catopt.mooring.solution import SystemSolution

__all__ = ["elevation", "plan_of", "plan_section"]


def plan_section(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the plan of the body under the note's load: as `plan_of`."""
    return plan_of(note.solution, words)


def plan_of(solution: SystemSolution, words: Words) -> dict[str, Any]:
    """Build the plan, and the surroundings of the body larger where the offset is small on it."""
    return {"figure": svg(plan(solution), words.language), "near": _if_any(near(solution), words)}


def elevation(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the drawing to scale, and one with heights magnified where the line is flat."""
    solution, depth = note.loaded.solution, note.case.site.water_depth
    drawn = replace(line_in_water(solution, depth), name="system_elevation")
    return {
        "line": note.solution.most_loaded + 1,
        "figure": svg(drawn, words.language),
        "magnified": _if_any(magnified(solution, depth), words),
    }


def _if_any(chart: Chart | None, words: Words) -> Figure | None:
    return None if chart is None else svg(chart, words.language)
