"""Title block of a sizing: what is recommended in a sentence, what governs, and what came out."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from catopt.answers.check import governing_sentence, verdict_sentence
from catopt.notes.size import SizeNote
from catopt.quantities import QUANTITIES, Quantity
from catopt.render.texts import Phrase, Words
from catopt.report.page.identity import made_from, title_block
from catopt.report.page.sizing.candidates import failing_words
from catopt.report.page.sizing.hold import held
from catopt.report.page.sizing.load_case import load_case_words, said_line
from catopt.report.page.table import Cell, Heading, Table, measured
from catopt.ties import largest

if TYPE_CHECKING:
    from catopt.sizing import Sizing

__all__ = ["found", "governing", "identity", "recommendation"]

_LENGTH, _FORCE, _MASS = (QUANTITIES[key] for key in ("length", "tension", "mass"))
_DIAMETER, _FACTOR = QUANTITIES["nominal_diameter"], QUANTITIES["safety_factor"]


def identity(note: SizeNote, words: Words) -> dict[str, Any]:
    """Build the recommendation, what governs it, the results and the title block."""
    source = note.line.case.source
    rows = [
        ("identity.source", Cell(source)),
        ("identity.date", Cell(note.origin.date)),
        *made_from(note.origin),
    ]
    headings = (
        Heading(words("table.what")),
        Heading(words("table.value"), is_number=True),
        Heading(words("identity.load_case")),
    )
    results = tuple(
        (
            Cell(label, style="words"),
            measured(quantity, value, unit=True),
            Cell(load_case_words(load_case, words)),
        )
        for label, quantity, value, load_case in found(note.sizing, words)
    )
    checks = note.line.checks
    return {
        "recommendation": recommendation(note, words),
        "verdict": words.sentence(verdict_sentence(checks)),
        "passes": checks.passes,
        "governing": governing(note, words),
        "found": Table("size_found", headings, results),
        "table": title_block(rows, words),
    }


def recommendation(note: SizeNote, words: Words) -> str:
    """Say what is recommended in a sentence."""
    of = note.sizing
    segment = of.point.line.segments[0]
    weights = "".join(
        words("size_identity.weight", mass=f"{load.mass / 1e3:g}", place=f"{load.position:g}")
        for load in of.point.line.point_loads
        if load.mass is not None
    )
    said = words(
        "size_identity.several" if of.pattern is not None else "size_identity.one",
        lines=1 if of.pattern is None else of.pattern.lines,
        chain=segment.name or segment.component,
        length=f"{of.point.line.length:g}",
        shots=f"{of.shots:.2f}",
        weights=weights,
        held=held(note, words) or "–",
        swing=f"{of.swing.total:.1f}",
    )
    return re.sub(r"(?<=\d) (?=(?:mm|m|t)\b)", "\N{NO-BREAK SPACE}", said)


def governing(note: SizeNote, words: Words) -> list[Phrase]:
    """Say what governs: the check nearest to its limit, and what a step to less runs into."""
    listed = [words.sentence(governing_sentence(said_line(note.line, words).checks))]
    for limit in note.sizing.limits:
        why = failing_words(limit, words)
        change = words.sentence(limit.change).text
        text = words("size_identity.step", change=change, check=why.text)
        listed.append(Phrase(text, why.lang))
    return [each for each in listed if each.text]


def found(of: Sizing, words: Words) -> Iterator[tuple[str, Quantity, float | None, str]]:
    """Yield what came out: what it is called, how it is printed, its value in SI, its load case."""
    line, segment = of.point.line, of.point.line.segments[0]
    name, solution = of.hardest
    pulls = [(each.fairlead.vertical_force, at) for at, each in of.point.checks.solutions]
    pull, pulled = largest(pulls, lambda each: each[0])
    yield words.name(_DIAMETER.name), _DIAMETER, segment.nominal_diameter, ""
    yield words.name(_LENGTH.name), _LENGTH, line.length, ""
    yield words.name("Line mass in air"), _MASS, line.mass, ""
    yield words("size_identity.radius"), _LENGTH, of.swing.total, of.swing.load_case
    if of.excursion is not None:
        yield words.name("Excursion"), _LENGTH, of.excursion, ""
    forces = [(each.horizontal_force, at) for at, each in of.point.checks.solutions]
    force, at = largest(forces, lambda each: each[0])
    yield words("size_identity.force"), _FORCE, force, at
    yield words.name("Fairlead tension"), _FORCE, solution.fairlead.tension, name
    yield words.name("Largest tension"), _FORCE, of.largest_tension, ""
    yield words.name("Fairlead vertical force"), _FORCE, pull, pulled
    if of.reserve_buoyancy is not None:
        yield words.name("Reserve buoyancy"), _FORCE, of.reserve_buoyancy, ""
    for key, factor in (
        ("size_identity.mbl", of.break_factor),
        ("size_identity.proof", of.proof_factor),
    ):
        if factor is not None:
            yield words(key), _FACTOR, factor, ""
