"""The front of a design search, with the design that the note is of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from catopt.answers.design import OBJECTIVES, shown_designs
from catopt.figures.front import composition, front
from catopt.notes.line import Chosen, Note
from catopt.quantities import Quantity
from catopt.render.svg import svg
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, measured, said, units

__all__ = [
    "front_figure",
    "further_objectives",
    "sinker_words",
    "verdict_cell",
]


def front_figure(note: Note, words: Words) -> dict[str, Any] | None:
    """Build the figure and the tables of the front; None where the case is no design of one."""
    if note.chosen is None:
        return None
    document, number = note.chosen.document, note.chosen.number
    designs: list[dict[str, Any]] = document["front"]
    keys = [*document["objectives"], *further_objectives(document)]
    shown = shown_designs(len(designs), number - 1, document["recommended"])
    return {
        "figure": svg(front(document, number), words.language),
        "table": _table(note.chosen, keys, shown, words),
        "left_out": len(designs) - len(shown),
        "designs": len(designs),
        "number": number,
        "recommended": document["recommended"] + 1,
        "method": words.name(document["method"]),
        "is_exact": document.get("is_exact", False),
        "evaluations": document["evaluations"],
        "recommendation": words.sentence(document.get("recommendation", "")),
        "ends": [words.sentence(end) for end in document.get("ends", ())],
        "neighbours": _neighbours(document, keys, words),
        "present": _present(document, keys, words),
    }


def further_objectives(document: Mapping[str, Any]) -> list[str]:
    """List objectives that are known beside those wanted."""
    first = document["front"][0]
    return [key for key in OBJECTIVES if key in first and key not in document["objectives"]]


def _present(document: Mapping[str, Any], keys: Sequence[str], words: Words) -> str:
    """Say how the line of the case file does beside the front; empty where that is not known."""
    present = document.get("present")
    if present is None:
        return ""
    values = _values([key for key in keys if present.get(key) is not None], present, words)
    verdict = verdict_cell(present, words).text
    return words("front.present", values=values or "–", verdict=verdict)


def _values(keys: Sequence[str], point: Mapping[str, Any], words: Words) -> str:
    """Name the objectives of a design with their values."""
    return ", ".join(
        f"{words.name(OBJECTIVES[key].name)} {OBJECTIVES[key].format(point[key], unit=True)}"
        for key in keys
    )


def _table(chosen: Chosen, keys: Sequence[str], shown: Sequence[int], words: Words) -> Table:
    front = chosen.document["front"]
    quantities = [(key, OBJECTIVES[key]) for key in keys]
    has_sinker = any(point.get("sinker") for point in front)
    rows = []
    for index in shown:
        point = front[index]
        numbers = (measured(quantity, point[key]) for key, quantity in quantities)
        rows.append(
            (
                Cell(str(index + 1)),
                *numbers,
                Cell(composition(point), style="words"),
                *((Cell(sinker_words(point)),) if has_sinker else ()),
                said(words.sentence(point["governing"]), "words"),
            )
        )
    headings = (
        Heading(words("identity.design")),
        *(units(words, quantity) for _, quantity in quantities),
        Heading(words("front.made")),
        *((Heading(words("front.sinker")),) if has_sinker else ()),
        Heading(words("checks.governing")),
    )
    marked = list(shown).index(chosen.number - 1)
    return Table("front", headings, tuple(rows), words("front.table"), marked)


def sinker_words(point: Mapping[str, Any]) -> str:
    """Say the mass in air of a design's sinker; a dash where there is none."""
    sinker = point.get("sinker")
    return f"{sinker['mass_kg'] / 1e3:g} t" if sinker and sinker["mass_kg"] else "–"


def _neighbours(document: Mapping[str, Any], keys: Sequence[str], words: Words) -> Table | None:
    """Tabulate what one step of a variable would do to the recommended design."""
    steps = document.get("neighbours", [])
    if not steps:
        return None
    quantities = [(key, OBJECTIVES[key]) for key in keys]
    rows = tuple(
        (
            Cell(words.sentence(step["change"]).text, style="words"),
            *(measured(quantity, step.get(key)) for key, quantity in quantities),
            verdict_cell(step, words),
        )
        for step in steps
    )
    headings = (
        Heading(words("front.change")),
        *_headings(quantities, words),
        Heading(words("checks.verdict")),
    )
    caption = words("front.neighbours", number=document["recommended"] + 1)
    return Table("neighbours", headings, rows, caption)


def _headings(quantities: Sequence[tuple[str, Quantity]], words: Words) -> Iterator[Heading]:
    return (units(words, quantity) for _, quantity in quantities)


def verdict_cell(step: Mapping[str, Any], words: Words) -> Cell:
    """Say whether a changed design passes, or why not."""
    if step["feasible"]:
        return Cell(words("checks.passes"), style="words passes")
    why = words.sentence(step["reason"] or step["governing"])
    return Cell(f"{words('checks.fails')}: {why.text}", lang=why.lang, style="words fails")
