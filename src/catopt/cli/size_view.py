"""How a sizing looks on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES
from catopt.report.wording.checks import source_words
from catopt.report.wording.size import (
    candidate_rows,
    check_rows,
    governing_lines,
    load_rows,
    summary,
)

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.report.texts import Words
    from catopt.sizing import Sizing

__all__ = ["show_sizing"]

_CONFIDENCE = (
    "--json and --out have each with formula, numbers and source. Confidence: A read in the "
    "primary document; B in two secondary ones, or in one and checked by numbers; C in one "
    "secondary one; R recalled, read in none."
)


def show_sizing(output: Output, of: Sizing, words: Words) -> None:
    """Print a sizing for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    of : Sizing
        What came out.
    words : Words
        Language.
    """
    output.text(of.case.title, bold=True)
    output.line()
    facts = [
        (words.name(fact.label), words.sentence(fact.words).text)
        for fact in summary(of)
        if fact.words
    ]
    output.table(["", ""], facts, title=words.name("Recommended"))
    output.text(words.name("What governs"), bold=True)
    for line in governing_lines(of):
        output.text(words.sentence(line).text)
    output.text(words.sentence(of.why).text)
    output.line()
    _candidates(output, words, of)
    _checks(output, words, of)
    _pattern(output, words, of)
    _loads(output, words, of)
    _notes(output, words, of)


def _candidates(output: Output, words: Words, of: Sizing) -> None:
    length, tonnes = QUANTITIES["length"], QUANTITIES["mass"]
    rows = [
        (
            words.name(row.role),
            row.chain,
            length.format(row.length, digits=2),
            tonnes.format(row.mass),
            length.format(row.swing, digits=1),
            "-" if row.anchor is None else f"{row.anchor / 1e3:g}",
            words.sentence(row.verdict).text,
        )
        for row in candidate_rows(of)
    ]
    chain = words("size.chain")
    output.table(
        [
            "",
            chain,
            f"{words('size.length')}\n(m)",
            f"{chain}\n(t)",
            f"{words('size.span')}\n(m)",
            f"{words('size.anchor')}\n(t)",
            words.name("Governing"),
        ],
        rows,
        title=words.name(
            "Between its neighbours, each the lightest that passes under its own loads"
        ),
        numbers=[2, 3, 4, 5],
    )


def _checks(output: Output, words: Words, of: Sizing) -> None:
    rows = [
        (
            words.name(kind),
            demand,
            capacity,
            QUANTITIES["utilisation"].format(check.utilisation),
            f"{words.name(check.load_case)}; {source_words(check.source, words)}",
        )
        for kind, check, demand, capacity in check_rows(of)
    ]
    output.table(
        [
            words.name("Check"),
            words("size.demand"),
            words("size.capacity"),
            words("size.used"),
            words.name("Load case, source"),
        ],
        rows,
        title=words.name("Tightest check of each kind"),
        numbers=[1, 2, 3],
    )


def _pattern(output: Output, words: Words, of: Sizing) -> None:
    if of.pattern is None:
        return
    force = QUANTITIES["horizontal_force"]
    rows = [
        (
            words.name(state.load_case),
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
            words.name("Load case"),
            f"{words('size.body_force')}\n(kN)",
            f"{words('size.rule_force')}\n(kN)",
            f"{words('size.line_force')}\n(kN)",
            f"{words('size.line_tension')}\n(kN)",
            f"{words('size.offset')}\n(m)",
        ],
        rows,
        title=words.name("Mooring equilibrium: the most loaded line under the hardest direction"),
        numbers=[1, 2, 3, 4, 5],
    )


def _loads(output: Output, words: Words, of: Sizing) -> None:
    force = QUANTITIES["horizontal_force"]
    rows: list[tuple[str, str, str, str]] = []
    before = ""
    for load_case, name, newtons, confidence in load_rows(of):
        said = words.name(load_case) if load_case != before else ""
        before = load_case
        grade = f"[{confidence}]" if confidence else ""
        rows.append((said, words.name(name), force.format(newtons), grade))
    output.table(
        [words.name("Load case"), words("loads.force"), "kN", ""],
        rows,
        title=words.name("Loads"),
        numbers=[2],
    )
    if of.settled.posed.loads[0].parts:
        output.text(words.name(_CONFIDENCE))
        output.line()


def _notes(output: Output, words: Words, of: Sizing) -> None:
    for text in of.assumptions:
        output.text(words.sentence(text).text)
    if of.defaults:
        items = "; ".join(words.sentence(each).text for each in of.defaults)
        output.text(words("size.taken", items=items), bold=True)
    for warning in of.warnings:
        output.text(words("loads.warning", text=words.sentence(warning).text), bold=True)
    if of.recalled:
        names = ", ".join(words.name(each) for each in of.recalled)
        output.text(words("loads.recalled", names=names), bold=True)
