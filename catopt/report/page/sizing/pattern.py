"""Several lines around a body: the load on it, the rule of practice, and the equilibrium."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from catopt.notes.size import SizeNote
from catopt.quantities import QUANTITIES
from catopt.render.texts import Words
from catopt.report.page.sizing.load_case import load_case_words
from catopt.report.page.system.drawings import plan_of
from catopt.report.page.table import Cell, Heading, Table, measured, number_heading, units

if TYPE_CHECKING:
    from catopt.mooring.solution import SystemSolution
    from catopt.sizing.pattern import Pattern

__all__ = ["line_rows", "pattern", "states"]

FORCE, TENSION = QUANTITIES["horizontal_force"], QUANTITIES["tension"]
LENGTH, ANGLE = QUANTITIES["length"], QUANTITIES["angle"]


def pattern(note: SizeNote, words: Words) -> dict[str, Any] | None:
    """Build the tables of load cases and of lines; None where there is one line."""
    of = note.sizing.pattern
    if of is None or note.around is None:
        return None
    hardest = of.hardest
    rule = hardest.rule_force
    return {
        "about": words(
            "size_pattern.about",
            lines=of.lines,
            radius=LENGTH.format(of.anchor_radius, unit=True),
            pretension=FORCE.format(of.pretension, unit=True),
        ),
        "rule": ""
        if rule is None
        else words(
            "size_pattern.rule",
            force=FORCE.format(hardest.force),
            lines=of.lines,
            rule=FORCE.format(rule, unit=True),
            found=FORCE.format(hardest.line_force, unit=True),
            ratio=f"{hardest.line_force / rule:.3f}",
        ),
        "plan": plan_of(note.around, words),
        "states": states(of, words),
        "lines": _lines(note.around, hardest.load_case, words),
        "residual": f"{note.around.residual.force:.1e} N",
    }


def states(of: Pattern, words: Words) -> Table:
    """Tabulate the body at rest in each load case."""
    headings = (
        Heading(words("identity.load_case")),
        number_heading(words("size_pattern.force"), FORCE),
        number_heading(words("size_pattern.by_rule"), FORCE),
        number_heading(words("size_pattern.by_equilibrium"), FORCE),
        units(words, TENSION),
        number_heading(words("size_pattern.direction"), ANGLE),
        number_heading(words("size_pattern.offset"), LENGTH),
        number_heading(words("size_pattern.pull"), FORCE),
    )
    rows = tuple(
        (
            Cell(load_case_words(state.load_case, words)),
            measured(FORCE, state.force),
            measured(FORCE, state.rule_force),
            measured(FORCE, state.line_force),
            measured(TENSION, state.tension),
            measured(ANGLE, state.direction),
            measured(LENGTH, state.offset),
            measured(FORCE, state.pull),
        )
        for state in of.states
    )
    marked = of.states.index(of.hardest)
    return Table("size_pattern", headings, rows, words("size_pattern.states"), marked)


def line_rows(of: SystemSolution) -> list[tuple[float, float, float, float, float]]:
    """List each line: direction of its pull, rad, H and T, N, and the two parts of H, N."""
    return [
        (
            line.direction,
            line.horizontal_force,
            line.tension,
            line.horizontal_force * math.cos(line.direction),
            line.horizontal_force * math.sin(line.direction),
        )
        for line in of.lines
    ]


def _lines(of: SystemSolution, load_case: str, words: Words) -> Table:
    headings = (
        Heading(words("components.number")),
        number_heading(words("size_pattern.towards"), ANGLE),
        units(words, FORCE),
        units(words, TENSION),
        number_heading("Hx", FORCE),
        number_heading("Hy", FORCE),
    )
    listed = line_rows(of)
    quantities = (ANGLE, FORCE, TENSION, FORCE, FORCE)
    rows = [
        (
            Cell(str(number)),
            *(measured(quantity, value) for quantity, value in zip(quantities, each, strict=True)),
        )
        for number, each in enumerate(listed, start=1)
    ]
    empty = Cell("")
    total = (math.fsum(each[3] for each in listed), math.fsum(each[4] for each in listed))
    rows += [
        (Cell(words(key)), empty, empty, empty, *(measured(FORCE, value) for value in pair))
        for key, pair in (("size_pattern.total", total), ("size_pattern.load", of.system.force))
    ]
    caption = words("size_pattern.lines", load_case=load_case_words(load_case, words))
    return Table("size_lines", headings, tuple(rows), caption)
