"""What came out: the body as a whole, and what each of its lines carries."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from catopt.notes.rounding import without_rounding
from catopt.notes.system import SystemNote
from catopt.quantities import QUANTITIES, Quantity
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, measured, number_heading, shown_si

__all__ = ["Value", "lines", "results", "values_of"]


class Value(NamedTuple):
    """A result of the body: key of its text, how it is printed, and the value in SI."""

    key: str
    quantity: Quantity
    value: float


def results(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the table of the body; what the rule of practice says, or why it does not apply."""
    headings = (
        Heading(words("table.what")),
        Heading(words("table.value"), is_number=True),
        Heading(words("inputs.si"), is_number=True),
    )
    rows = tuple(
        (
            Cell(words(each.key), style="words"),
            measured(each.quantity, each.value, unit=True),
            Cell(_si(each)),
        )
        for each in values_of(note)
    )
    rule = note.report.rule
    return {
        "table": Table("system_results", headings, rows),
        "rule": rule_words(note, words),
        "why_not": words.sentence(rule.why_not) if rule.why_not else None,
        "steps": note.solution.steps,
    }


def _si(each: Value) -> str:
    """Write a value in SI; where it is no residual, without what rounding left."""
    is_residual = each.quantity.notation == "scientific"
    value = each.value if is_residual else without_rounding(each.value)
    return shown_si(value, each.quantity.si_unit)


def values_of(note: SystemNote) -> Iterator[Value]:
    """Yield what is known of the body."""
    solution = note.solution
    system, stiffness = solution.system, solution.full_stiffness
    force, length, moment = (QUANTITIES[key] for key in ("horizontal_force", "offset", "moment"))
    angle, per_length = QUANTITIES["angle"], QUANTITIES["stiffness"]
    yield Value("system_results.force_x", force, system.force[0])
    yield Value("system_results.force_y", force, system.force[1])
    if system.turns:
        yield Value("system_results.moment", moment, system.moment)
    yield Value("system_results.zero_x", length, solution.neutral.x)
    yield Value("system_results.zero_y", length, solution.neutral.y)
    yield Value("system_results.place_x", length, solution.position.x)
    yield Value("system_results.place_y", length, solution.position.y)
    yield Value("system_results.offset_x", length, solution.offset[0])
    yield Value("system_results.offset_y", length, solution.offset[1])
    yield Value("system_results.offset", length, math.hypot(*solution.offset))
    if system.turns:
        yield Value("system_results.zero_yaw", angle, solution.neutral.yaw)
        yield Value("system_results.yaw", angle, solution.position.yaw)
    yield Value("system_results.kxx", per_length, stiffness[0][0])
    yield Value("system_results.kxy", per_length, stiffness[0][1])
    yield Value("system_results.kyy", per_length, stiffness[1][1])
    if system.turns:
        yield Value("system_results.kxm", TURNING, stiffness[0][2])
        yield Value("system_results.kym", TURNING, stiffness[1][2])
        yield Value("system_results.kmm", YAWING, stiffness[2][2])
    yield Value("system_results.residual", RESIDUAL, solution.residual.force)
    if system.turns:
        yield Value("system_results.residual_moment", RESIDUAL_MOMENT, solution.residual.moment)


TURNING = Quantity("turning", "", "", "N/rad", "kN/rad", 1e3, 3)
YAWING = Quantity("yawing", "", "", "N*m/rad", "kN*m/rad", 1e3, 1)
RESIDUAL = Quantity("force_left", "", "", "N", "N", 1.0, 2, "scientific")
RESIDUAL_MOMENT = Quantity("moment_left", "", "", "N*m", "N*m", 1.0, 2, "scientific")
"""Of the stiffness in yaw, and of what is left of the balance."""


def rule_words(note: SystemNote, words: Words) -> str:
    """Say what the rule of practice makes of the most loaded line; empty where it is barred."""
    rule = note.report.rule
    if rule.horizontal_force is None or rule.line is None:
        return ""
    force = QUANTITIES["horizontal_force"]
    return words(
        "system_results.rule",
        line=rule.line + 1,
        rule=force.format(rule.horizontal_force, unit=True),
        balance=force.format(note.solution.lines[rule.line].horizontal_force, unit=True),
    )


def lines(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the table of the lines; the most loaded is marked."""
    solution = note.solution
    angle, tension = QUANTITIES["angle"], QUANTITIES["tension"]
    rows = []
    for number, line in enumerate(solution.lines, start=1):
        own = line.solution
        used = line.utilisation(solution.safety_factor)
        rows.append(
            (
                Cell(f"{number} {line.leg.name}".strip()),
                measured(angle, line.leg.azimuth),
                measured(QUANTITIES["horizontal_force"], line.horizontal_force),
                measured(tension, line.tension),
                measured(tension, own.anchor.tension),
                measured(QUANTITIES["span"], own.span),
                measured(QUANTITIES["grounded_length"], own.grounded_length),
                Cell("–" if used is None else f"{used:.3f}", used, bar=used),
            )
        )
    force, length = tension.field_unit, QUANTITIES["span"].field_unit
    headings = (
        Heading(words("system_lines.line")),
        number_heading(words("system_lines.azimuth"), angle),
        Heading(f"{words.name('Horizontal force')} H ({force})", is_number=True),
        Heading(f"{words.name('Fairlead tension')} T ({force})", is_number=True),
        Heading(f"{words.name('Anchor tension')} ({force})", is_number=True),
        Heading(f"{words.name('Span')} S ({length})", is_number=True),
        Heading(f"{words.name('Grounded length')} ({length})", is_number=True),
        Heading(words("checks.utilisation"), is_number=True),
    )
    factor = QUANTITIES["safety_factor"].format(solution.safety_factor)
    known = any(row[-1].si is not None for row in rows)
    return {
        "table": Table("system_lines", headings, tuple(rows), marked=solution.most_loaded),
        "legend": words("system_lines.used" if known else "system_lines.unknown", factor=factor),
    }
