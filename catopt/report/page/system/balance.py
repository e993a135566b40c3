"""The balance of forces with its numbers put in, and the equations of the most loaded line."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from catopt.notes.rounding import without_rounding
from catopt.notes.system import SystemNote
from catopt.render.texts import Words
from catopt.report.page.equations import followed, steps_table
from catopt.report.page.table import Cell, Heading, Table
from catopt.report.page.trail import Step, digits, within

if TYPE_CHECKING:
    from catopt.mooring.solution import LegState

__all__ = ["balance", "line_trail", "steps_of"]

_MOST = 12
"""Terms of a sum that are all written out; of more, the table above has them."""


def balance(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the table of what each line pulls with, and the sums against the load."""
    return {
        "table": _pulls(note, words),
        "steps": steps_table(
            "balance", steps_of(note), words, is_numbered=False, stated="system_balance.wanted"
        ),
        "turns": note.solution.system.turns,
        "body": _body_words(note, words),
    }


def line_trail(note: SystemNote, words: Words) -> dict[str, Any]:
    """Follow the most loaded line through the equations of a line."""
    number = note.solution.most_loaded + 1
    return {"line": number, **followed(note.loaded.solution, words)}


def arm_of(line: LegState, note: SystemNote) -> tuple[float, float]:
    """From the body's origin to the fairlead, m."""
    position = note.solution.position
    return line.fairlead[0] - position.x, line.fairlead[1] - position.y


def _pulls(note: SystemNote, words: Words) -> Table:
    """Tabulate H, its direction and its parts along x and y; with arms the moment, too."""
    turns, has_arms = note.solution.system.turns, note.solution.system.has_arms
    rows = []
    for number, line in enumerate(note.solution.lines, start=1):
        fx, fy = pull_of(line)
        (ax, ay), (px, py) = line.leg.anchor, line.fairlead
        fairlead = [px, py] if has_arms else []
        values = [ax, ay, *fairlead, line.solution.span, line.horizontal_force]
        cells = [Cell(_put(value), value) for value in values]
        degrees = _put(math.degrees(line.direction))
        cells.append(Cell(f"{degrees}°", line.direction))
        cells += [Cell(_put(value), value) for value in (fx, fy)]
        if turns:
            moment = moment_of(line, note)
            cells.append(Cell(_put(moment), moment))
        rows.append((Cell(str(number)), *cells))
    names = ["xA (m)", "yA (m)", *(["xF (m)", "yF (m)"] if has_arms else []), "S (m)", "H (N)"]
    names += ["φ", "H cos φ (N)", "H sin φ (N)", *(["M (N m)"] if turns else [])]
    headings = (
        Heading(words("system_lines.line")),
        *(Heading(name, is_number=True) for name in names),
    )
    return Table(
        "pulls", headings, tuple(rows), words("system_balance.pulls"), note.solution.most_loaded
    )


def _put(value: float) -> str:
    """Write a number to be put in; what rounding left in the place of a zero is 0."""
    return digits(without_rounding(value))


def _body_words(note: SystemNote, words: Words) -> str:
    """Say where the body is, and that its fairleads are there too where it has no arms."""
    position = note.solution.position
    key = "system_balance.body" if note.solution.system.has_arms else "system_balance.point"
    return words(key, x=_put(position.x), y=_put(position.y))


def pull_of(line: LegState) -> tuple[float, float]:
    """Force of a line on the body along x and y, N."""
    H = line.horizontal_force
    return H * math.cos(line.direction), H * math.sin(line.direction)


def moment_of(line: LegState, note: SystemNote) -> float:
    """Moment of a line on the body about its origin, N m."""
    (rx, ry), (fx, fy) = arm_of(line, note), pull_of(line)
    return rx * fy - ry * fx


def steps_of(note: SystemNote) -> Iterator[Step]:
    """Follow the balance: the sums over the lines against the load, and the most loaded span."""
    solution = note.solution
    system = solution.system
    pulls = [pull_of(line) for line in solution.lines]
    for axis, function, (name, left_name) in (
        (0, "cos", ("system_balance.sum_x", "system_balance.left_x")),
        (1, "sin", ("system_balance.sum_y", "system_balance.left_y")),
    ):
        terms, force = [pull[axis] for pull in pulls], system.force[axis]
        total = math.fsum(terms)
        formula = f"Σ H {function} φ"
        yield Step(name, "", formula, _sum(terms), total, "N", 0.0 - force)
        left = f"{digits(force)} + {within(total)}"
        yield Step(left_name, "", f"F{'xy'[axis]} + {formula}", left, force + total, "N")
    if system.turns:
        moments = [moment_of(line, note) for line in solution.lines]
        total = math.fsum(moments)
        formula, put_in = "Σ M = Σ (x_r H sin φ − y_r H cos φ)", _sum(moments)
        yield Step("system_balance.sum_m", "", formula, put_in, total, "N m", 0.0 - system.moment)
    yield _span(note)
    x, y = solution.offset
    yield Step(
        "system_balance.offset", "", "d = √(Δx² + Δy²)", f"√({_within(x)}² + {_within(y)}²)",
        math.hypot(x, y), "m",
    )  # fmt: skip


def _sum(terms: Sequence[float]) -> str:
    if len(terms) > _MOST:
        return f"{_put(terms[0])} + {_within(terms[1])} + … + {_within(terms[-1])}"
    return " + ".join(_put(term) for term in terms).replace("+ −", "− ")


def _within(value: float) -> str:
    return within(without_rounding(value))


def _span(note: SystemNote) -> Step:
    line = note.loaded
    (ax, ay), (px, py) = line.leg.anchor, line.fairlead
    return Step(
        "system_balance.span", "", "S = √((x_A − x_F)² + (y_A − y_F)²)",
        f"√(({_put(ax)} − {_within(px)})² + ({_put(ay)} − {_within(py)})²)",
        math.hypot(ax - px, ay - py), "m", line.solution.span,
    )  # fmt: skip
