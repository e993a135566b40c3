"""The sections of a sizing's page in order: its own, and those of its line's note as they are."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from catopt.notes.size import SizeNote
from catopt.render.texts import Words
from catopt.report.page.checks import checks
from catopt.report.page.closing import case_file, warnings
from catopt.report.page.components import components
from catopt.report.page.curve_figure import curve_figure
from catopt.report.page.equations import equations
from catopt.report.page.figures import line_drawing, tension_figure
from catopt.report.page.results import load_cases, results
from catopt.report.page.sizing.assumptions import assumptions
from catopt.report.page.sizing.candidates import candidates
from catopt.report.page.sizing.front import front
from catopt.report.page.sizing.hold import hold
from catopt.report.page.sizing.identity import identity
from catopt.report.page.sizing.inputs import inputs
from catopt.report.page.sizing.load_case import said_line
from catopt.report.page.sizing.loads import loads
from catopt.report.page.sizing.pattern import pattern
from catopt.report.page.sizing.swing import swing
from catopt.report.page.swarm import swarm
from catopt.report.page.verification import verification

__all__ = ["OF_A_SIZING"]

Build = Callable[[Any, Words], dict[str, Any] | None]


def _of_the_line(build: Build) -> Build:
    """Make a section of the recommended line out of one of a line's note."""

    def build_it(note: SizeNote, words: Words) -> dict[str, Any] | None:
        return build(said_line(note.line, words), words)

    return build_it


OF_A_SIZING: tuple[tuple[str, Build], ...] = (
    ("size_identity", identity),
    ("warnings", warnings),
    ("size_loads", loads),
    ("size_candidates", candidates),
    ("size_front", front),
    ("line", _of_the_line(line_drawing)),
    ("checks", _of_the_line(checks)),
    ("load_cases", _of_the_line(load_cases)),
    ("size_hold", hold),
    ("size_swing", swing),
    ("size_pattern", pattern),
    ("size_assumptions", assumptions),
    ("size_inputs", inputs),
    ("results", _of_the_line(results)),
    ("tension", _of_the_line(tension_figure)),
    ("curve", _of_the_line(curve_figure)),
    ("components", _of_the_line(components)),
    ("equations", _of_the_line(equations)),
    ("verification", _of_the_line(verification)),
    ("swarm", _of_the_line(swarm)),
    ("size_file", case_file),
)
"""Key and builder of each section."""
