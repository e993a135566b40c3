"""How a sizing looks on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES
from catopt.report.size_words import (
    candidate_rows,
    check_rows,
    governing_lines,
    load_rows,
    summary,
)

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.sizing import Sizing

__all__ = ["show_sizing"]


def show_sizing(output: Output, of: Sizing) -> None:
    """Print a sizing for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    of : Sizing
        What came out.
    """
    output.text(of.case.title, bold=True)
    output.line()
    facts = [(fact.label, fact.words) for fact in summary(of) if fact.words]
    output.table(["", ""], facts, title="Recommended")
    output.text("What governs", bold=True)
    for line in governing_lines(of):
        output.text(line)
    output.text(of.why)
    output.line()
    _candidates(output, of)
    _checks(output, of)
    _pattern(output, of)
    _loads(output, of)
    _notes(output, of)


def _candidates(output: Output, of: Sizing) -> None:
    length, tonnes = QUANTITIES["length"], QUANTITIES["mass"]
    rows = [
        (
            row.role,
            row.chain,
            length.format(row.length, digits=2),
            tonnes.format(row.mass),
            length.format(row.swing, digits=1),
            "-" if row.anchor is None else f"{row.anchor / 1e3:g}",
            row.verdict,
        )
        for row in candidate_rows(of)
    ]
    output.table(
        ["", "Chain", "Length\n(m)", "Chain\n(t)", "Span\n(m)", "Anchor\n(t)", "Governing"],
        rows,
        title="Between its neighbours, each the lightest that passes under its own loads",
        numbers=[2, 3, 4, 5],
    )


def _checks(output: Output, of: Sizing) -> None:
    rows = [
        (
            kind,
            demand,
            capacity,
            QUANTITIES["utilisation"].format(check.utilisation),
            f"{check.load_case}; {check.source.text}",
        )
        for kind, check, demand, capacity in check_rows(of)
    ]
    output.table(
        ["Check", "Demand", "Capacity", "Used", "Load case, source"],
        rows,
        title="Tightest check of each kind",
        numbers=[1, 2, 3],
    )


def _pattern(output: Output, of: Sizing) -> None:
    if of.pattern is None:
        return
    force = QUANTITIES["horizontal_force"]
    rows = [
        (
            state.load_case,
            force.format(state.force, digits=1),
            force.format(state.rule_force, digits=1),
            force.format(state.line_force, digits=1),
            force.format(state.tension, digits=1),
            QUANTITIES["offset"].format(state.offset, digits=2),
        )
        for state in of.pattern.states
    ]
    output.table(
        [
            "Load case",
            "On the\nbody\n(kN)",
            "Line by\nrule, H\n(kN)",
            "Line in\nequil., H\n(kN)",
            "Line,\nT\n(kN)",
            "Offset\n(m)",
        ],
        rows,
        title="Mooring equilibrium: the most loaded line under the hardest direction",
        numbers=[1, 2, 3, 4, 5],
    )


def _loads(output: Output, of: Sizing) -> None:
    force = QUANTITIES["horizontal_force"]
    rows: list[tuple[str, str, str, str]] = []
    before = ""
    for load_case, name, newtons, confidence in load_rows(of):
        said = load_case if load_case != before else ""
        before = load_case
        grade = f"[{confidence}]" if confidence else ""
        rows.append((said, name, force.format(newtons), grade))
    output.table(["Load case", "Force", "kN", ""], rows, title="Loads", numbers=[2])
    if of.settled.posed.loads[0].parts:
        output.text(
            "--json and --out have each with formula, numbers and source. Confidence: A read in "
            "the primary document; B in two secondary ones, or in one and checked by numbers; C in "
            "one secondary one; R recalled, read in none."
        )
        output.line()


def _notes(output: Output, of: Sizing) -> None:
    for text in of.assumptions:
        output.text(text)
    if of.defaults:
        output.text(f"Taken, for it was not given: {'; '.join(of.defaults)}.", bold=True)
    for warning in of.warnings:
        output.text(f"Warning: {warning}", bold=True)
    if of.recalled:
        names = ", ".join(of.recalled)
        output.text(f"Warning: recalled figures (R), read in no document: {names}", bold=True)
