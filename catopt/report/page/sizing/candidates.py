"""The recommended size between its neighbours, and what a step to less runs into."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from catopt.answers.check import QUANTITY_OF
from catopt.answers.design import OBJECTIVES
from catopt.notes.size import SizeNote
from catopt.quantities import QUANTITIES
from catopt.render.texts import Phrase, Words
from catopt.report.page.sizing.load_case import load_case_words
from catopt.report.page.table import Cell, Heading, Table, measured, number_heading, said, units

if TYPE_CHECKING:
    from catopt.sizing.candidates import Candidate
    from catopt.sizing.limits import Limit

__all__ = ["candidate_verdict", "candidates", "failing_words"]

ROLES = {
    "smaller": "size_candidates.smaller",
    "recommended": "size_candidates.recommended",
    "larger": "size_candidates.larger",
}
"""Keys of what each candidate is called."""


def candidates(note: SizeNote, words: Words) -> dict[str, Any]:
    """Build the tables of candidates and of the steps that fail."""
    of = note.sizing
    return {
        "table": _table(note, words),
        "limits": _limits(of.limits, words) if of.limits else None,
        "why": words.sentence("" if len(of.settled.result.front) > 1 else of.why),
    }


def _table(note: SizeNote, words: Words) -> Table:
    of = note.sizing
    length, mass, force = (QUANTITIES[key] for key in ("length", "mass", "horizontal_force"))
    headings = (
        Heading(words("size_candidates.which")),
        Heading(words("size_candidates.chain")),
        units(words, length),
        number_heading(words.name("Mass in air"), mass),
        units(words, OBJECTIVES["offset_m"]),
        units(words, force),
        number_heading(words("size_candidates.anchor"), mass),
        Heading(words("checks.verdict")),
    )
    rows = tuple(_row(each, words) for each in of.candidates)
    marked = next(i for i, each in enumerate(of.candidates) if each.role == "recommended")
    return Table("size_candidates", headings, rows, words("size_candidates.table"), marked)


def _row(of: Candidate, words: Words) -> tuple[Cell, ...]:
    length, mass, force = (QUANTITIES[key] for key in ("length", "mass", "horizontal_force"))
    name = Cell(f"{of.component} {of.diameter * 1e3:g} mm", of.diameter)
    point = None if of.settled is None else of.settled.point
    anchor = None if point is None or point.anchor is None else point.anchor.mass
    hardest = (
        None
        if point is None
        else max(solution.horizontal_force for _, solution in point.checks.solutions)
    )
    return (
        Cell(words(ROLES[of.role])),
        name,
        measured(length, None if point is None else point.line.length),
        measured(mass, None if point is None else point.line.mass),
        measured(OBJECTIVES["offset_m"], None if point is None else point.objectives["offset_m"]),
        measured(force, hardest),
        measured(mass, anchor),
        said(
            candidate_verdict(of, words),
            "words fails" if point is None else "words passes",
        ),
    )


def candidate_verdict(of: Candidate, words: Words) -> Phrase:
    """Say what governs a candidate, or why no length of it passes.

    Parameters
    ----------
    of : Candidate
        Any.
    words : Words
        Language.
    """
    if of.settled is None:
        return words.sentence(of.reason)
    governing = of.settled.point.governing
    if governing is None:
        return Phrase(words("checks.passes"))
    name = words.sentence(governing.name)
    text = f"{words('checks.passes')}; {name.text} ({load_case_words(governing.load_case, words)})"
    return Phrase(text, name.lang)


def _limits(of: tuple[Limit, ...], words: Words) -> Table:
    headings = (
        Heading(words("front.change")),
        Heading(words("size_candidates.fails_by")),
        Heading(words("checks.demand"), is_number=True),
        Heading(words("checks.capacity"), is_number=True),
    )
    rows = tuple(_limit(each, words) for each in of)
    return Table("size_limits", headings, rows, words("size_candidates.limits"))


def _limit(of: Limit, words: Words) -> tuple[Cell, ...]:
    change = Cell(words.sentence(of.change).text, style="words")
    if of.check is None:
        return change, said(words.sentence(of.reason), "words"), Cell("–"), Cell("–")
    quantity = QUANTITY_OF[of.check.kind]
    return (
        change,
        said(failing_words(of, words), "words"),
        measured(quantity, of.check.demand, unit=True),
        measured(quantity, of.check.capacity, unit=True),
    )


def failing_words(of: Limit, words: Words) -> Phrase:
    """Name the check that fails with its load case, or why there is no equilibrium."""
    if of.check is None:
        return words.sentence(of.reason)
    name = words.sentence(of.check.name)
    return Phrase(f"{name.text} ({load_case_words(of.check.load_case, words)})", name.lang)
