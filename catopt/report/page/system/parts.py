"""The sections of the page of a moored body in order."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from catopt.render.texts import Words
from catopt.report.page.closing import case_file, warnings
from catopt.report.page.system.balance import balance, line_trail
from catopt.report.page.system.checks import checks
from catopt.report.page.system.drawings import elevation, plan_section
from catopt.report.page.system.given import components, inputs
from catopt.report.page.system.identity import identity
from catopt.report.page.system.line_out import line_out
from catopt.report.page.system.motion import motion
from catopt.report.page.system.restoring import restoring
from catopt.report.page.system.results import lines, results
from catopt.report.page.system.verification import verification
from catopt.report.page.system.watch_circle import watch_circle

__all__ = ["OF_A_BODY"]

Build = Callable[[Any, Words], dict[str, Any] | None]

OF_A_BODY: tuple[tuple[str, Build], ...] = (
    ("system_identity", identity),
    ("warnings", warnings),
    ("system_plan", plan_section),
    ("system_elevation", elevation),
    ("system_results", results),
    ("system_lines", lines),
    ("system_checks", checks),
    ("system_line_out", line_out),
    ("system_watch_circle", watch_circle),
    ("system_restoring", restoring),
    ("components", components),
    ("inputs", inputs),
    ("system_balance", balance),
    ("system_line_trail", line_trail),
    ("system_verification", verification),
    ("system_motion", motion),
    ("case_file", case_file),
)
"""Key and builder of each section."""
