"""A sizing in words and in the field's units: the one list behind its tables and its terminal.

Light on purpose: the terminal shows it without pandas.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from catopt.report.wording.checks import QUANTITY_OF
from catopt.report.wording.design import CHECK_KINDS, check_kinds, governing_words, tightest

if TYPE_CHECKING:
    from catopt.checks.result import CheckResult
    from catopt.sizing import Sizing
    from catopt.sizing.candidates import Candidate

__all__ = [
    "SHOTS",
    "CandidateRow",
    "Fact",
    "candidate_rows",
    "chain_words",
    "check_rows",
    "governing_lines",
    "holding_words",
    "load_rows",
    "summary",
]

SHOTS = "shots"
"""Unit of a length of chain."""


class Fact(NamedTuple):
    """One line of a summary: a number in the field's unit, and how it is said."""

    label: str
    value: float | None
    unit: str
    words: str


class CandidateRow(NamedTuple):
    """One size beside the recommended one; None where no length of it passes."""

    role: str
    chain: str
    length: float | None
    mass: float | None
    swing: float | None
    anchor: float | None
    verdict: str


def summary(of: Sizing) -> list[Fact]:
    """List what was found, in the order of a page."""
    return [*_line(of), *_holding(of), *_positions(of), *_forces(of), *_pattern(of)]


def chain_words(of: Sizing) -> str:
    """Say what the line is: ``"chain open-link 4D Q2 25 mm, 42 m = 1.53 shots"``."""
    line = of.point.line
    return f"{line.segments[0].name}, {line.length:g} m = {of.shots:.2f} shots"


def holding_words(of: Sizing) -> str:
    """Say what holds it: ``"concrete sinker of 20 t (18.2 t are needed)"``."""
    if of.drag_anchor is not None:
        size = of.drag_anchor
        what = f"{size.anchor} of {size.mass / 1e3:g} t in {size.soil}"
        return f"{what} ({size.needed_mass / 1e3:.3g} t are needed)"
    if of.sinker is None:
        return "-"
    mass = _anchor_mass(of) or of.sinker.mass
    needed = of.sinker.needed_mass / 1e3
    return f"{of.sinker.material} sinker of {mass / 1e3:g} t ({needed:.3g} t are needed)"


def _anchor_mass(of: Sizing) -> float | None:
    return None if of.point.anchor is None else of.point.anchor.mass


def _line(of: Sizing) -> Iterator[Fact]:
    line = of.point.line
    diameter = (line.segments[0].nominal_diameter or math.nan) * 1e3
    yield Fact("Chain", diameter, "mm", chain_words(of))
    yield Fact("Length", line.length, "m", "")
    yield Fact("Length in shots", of.shots, SHOTS, "")
    if line.mass is not None:
        yield Fact("Mass of the line in air", line.mass / 1e3, "t", f"{line.mass / 1e3:.3f} t")
    for load in line.point_loads:
        mass = None if load.mass is None else load.mass / 1e3
        words = f"{mass:g} t, {load.position:g} m from the anchor"
        yield Fact("Clump weight", mass, "t", words)


def _holding(of: Sizing) -> Iterator[Fact]:
    label = "Drag anchor" if of.drag_anchor is not None else "Sinker"
    size = of.drag_anchor or of.sinker
    if size is None:
        return
    mass = _anchor_mass(of) or size.mass
    yield Fact(label, mass / 1e3, "t", holding_words(of))
    if size.factor is not None:
        wanted = f"{size.factor:.2f} ({size.safety_factor:g} is wanted)"
        yield Fact("Factor on holding", size.factor, "-", wanted)


def _positions(of: Sizing) -> Iterator[Fact]:
    total = of.swing.total
    parts = " + ".join(f"{name} {length:.1f}" for name, length in of.swing.parts)
    words = f"{total:.1f} m" if len(of.swing.parts) == 1 else f"{total:.1f} m: {parts}"
    yield Fact("Swing radius at low water", total, "m", words)
    if of.excursion is not None:
        yield Fact("Excursion", of.excursion, "m", f"{of.excursion:.1f} m")


def _forces(of: Sizing) -> Iterator[Fact]:
    name, solution = of.hardest
    H, T = solution.horizontal_force, solution.fairlead.tension
    yield Fact("Horizontal force on the line", H / 1e3, "kN", f"{H / 1e3:.2f} kN ({name})")
    yield Fact("Tension at the fairlead", T / 1e3, "kN", f"{T / 1e3:.2f} kN ({name})")
    for label, factor in (("MBL", of.break_factor), ("Proof load", of.proof_factor)):
        if factor is not None:
            yield Fact(f"{label} over tension, new", factor, "-", f"{factor:.2f}")
    pull = max(each.fairlead.vertical_force for _, each in of.point.checks.solutions)
    yield Fact("Pull down at the fairlead", pull / 1e3, "kN", f"{pull / 1e3:.2f} kN")
    if of.reserve_buoyancy is not None:
        reserve = of.reserve_buoyancy / 1e3
        yield Fact("Reserve buoyancy", reserve, "kN", f"{reserve:.2f} kN")


def _pattern(of: Sizing) -> Iterator[Fact]:
    if of.pattern is None:
        return
    found = of.pattern
    yield Fact("Lines, evenly spaced", found.lines, "-", f"{found.lines}")
    radius = f"{found.anchor_radius:.1f} m"
    yield Fact("Anchor radius", found.anchor_radius, "m", radius)
    pretension = found.pretension / 1e3
    yield Fact("Pretension, horizontal", pretension, "kN", f"{pretension:.1f} kN")
    hardest = found.hardest
    if hardest.rule_force is not None:
        rule = hardest.rule_force / 1e3
        yield Fact("Most loaded line by S4's rule", rule, "kN", f"{rule:.1f} kN")
    force = hardest.line_force / 1e3
    yield Fact("Most loaded line in equilibrium", force, "kN", f"{force:.1f} kN")
    pull = found.largest_pull / 1e3
    yield Fact("Pull of all lines on the body", pull, "kN", f"{pull:.1f} kN")


def candidate_rows(of: Sizing) -> list[CandidateRow]:
    """List the recommended size between its neighbours."""
    return [_candidate(each) for each in of.candidates]


def _candidate(of: Candidate) -> CandidateRow:
    chain = f"{of.component} {of.diameter * 1e3:g} mm"
    if of.settled is None:
        return CandidateRow(of.role, chain, None, None, None, None, of.reason)
    point = of.settled.point
    anchor = None if point.anchor is None else point.anchor.mass
    verdict = f"passes; {governing_words(point.governing)}"
    return CandidateRow(
        of.role,
        chain,
        point.line.length,
        point.line.mass,
        point.objectives["offset_m"],
        anchor,
        verdict,
    )


def governing_lines(of: Sizing) -> list[str]:
    """Say what governs: what each step to less runs into, and the check nearest to its limit."""
    found = [f"{each.change}: fails by the {each.words}." for each in of.limits]
    governing = of.point.governing
    if governing is not None and governing.utilisation is not None:
        words = f"{governing_words(governing)}, utilisation {governing.utilisation:.3f}"
        found.append(f"Nearest to its limit: {words}.")
    return found


def check_rows(of: Sizing) -> list[tuple[str, CheckResult, str, str]]:
    """List the tightest check of each kind, with demand and capacity in the field's units."""
    report = of.point.checks
    rows = []
    for kind in check_kinds([report]):
        check = tightest(report, kind)
        if check is not None:
            quantity = QUANTITY_OF[kind]
            demand, capacity = (
                quantity.format(value, unit=True) for value in (check.demand, check.capacity)
            )
            rows.append((CHECK_KINDS[kind], check, demand, capacity))
    return rows


def load_rows(of: Sizing) -> list[tuple[str, str, float, str]]:
    """List the forces of every load case: load case, name, N along the pull, confidence."""
    rows: list[tuple[str, str, float, str]] = []
    for each in of.settled.posed.loads:
        for part in each.parts:
            rows += [
                (each.load_case, load.name, abs(load.force), load.source.confidence)
                for load in part.components
            ]
        if each.given:
            rows.append((each.load_case, "given", each.given, "-"))
        rows.append((each.load_case, "sum", each.horizontal_force, ""))
    return rows
