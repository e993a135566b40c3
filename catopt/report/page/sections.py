"""The parts of each kind of page in order; a further part is one more line and a template."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from catopt.notes.line import Note
from catopt.notes.size import SizeNote
from catopt.notes.system import SystemNote
from catopt.render.texts import Words
from catopt.report.page.checks import checks
from catopt.report.page.closing import case_file, warnings
from catopt.report.page.components import components
from catopt.report.page.curve_figure import curve_figure
from catopt.report.page.equations import equations
from catopt.report.page.figures import line_drawing, tension_figure
from catopt.report.page.front_figure import front_figure
from catopt.report.page.identity import identity
from catopt.report.page.inputs import inputs
from catopt.report.page.motion import motion
from catopt.report.page.results import load_cases, results
from catopt.report.page.sizing.parts import OF_A_SIZING
from catopt.report.page.swarm import swarm
from catopt.report.page.system.parts import OF_A_BODY
from catopt.report.page.verification import verification

__all__ = ["SECTIONS", "AnyNote", "Section"]

AnyNote = Note | SizeNote | SystemNote
"""Every kind of note that there is a page for."""


class Section(NamedTuple):
    """One part of the page.

    Attributes
    ----------
    key : str
        Name of its template, of its texts (``"<key>.heading"``) and of its anchor.
    build : callable
        Makes what the template shows, or None where there is nothing to show.
    """

    key: str
    build: Callable[[Any, Words], dict[str, Any] | None]


_OF_A_LINE = (
    Section("identity", identity),
    Section("warnings", warnings),
    Section("line", line_drawing),
    Section("results", results),
    Section("checks", checks),
    Section("load_cases", load_cases),
    Section("tension", tension_figure),
    Section("curve", curve_figure),
    Section("front", front_figure),
    Section("components", components),
    Section("inputs", inputs),
    Section("equations", equations),
    Section("verification", verification),
    Section("swarm", swarm),
    Section("in_motion", motion),
    Section("case_file", case_file),
)

SECTIONS: Mapping[type, tuple[Section, ...]] = MappingProxyType(
    {
        Note: _OF_A_LINE,
        SizeNote: tuple(Section(*each) for each in OF_A_SIZING),
        SystemNote: tuple(Section(*each) for each in OF_A_BODY),
    }
)
"""The parts of a note's page, by the kind of note."""
