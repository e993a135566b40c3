"""The front of a design search, with the design that the note is of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from catopt.quantities import Quantity
from catopt.report.page.figure import Figure, Frame, Legend, Point, Shape, axes, frame_in, shape
from catopt.report.page.note import Chosen, Note
from catopt.report.page.table import Cell, Heading, Table, measured, said, units
from catopt.report.texts import Phrase, Words
from catopt.report.wording.design import OBJECTIVES, change_words

__all__ = [
    "composition",
    "front_figure",
    "further_objectives",
    "governing_phrase",
    "sinker_words",
    "verdict_cell",
]

_HEIGHT = 376.0
_MOST = 25
"""Designs of a front that are all in the table; of a longer one some are."""


def front_figure(note: Note, words: Words) -> dict[str, Any] | None:
    """Build the figure and the tables of the front; None where the case is no design of one."""
    if note.chosen is None:
        return None
    document, number = note.chosen.document, note.chosen.number
    front: list[dict[str, Any]] = document["front"]
    keys = [*document["objectives"], *further_objectives(document)]
    shown = _shown(len(front), number - 1, document["recommended"])
    return {
        "figure": _figure(note.chosen, words),
        "table": _table(note.chosen, keys, shown, words),
        "left_out": len(front) - len(shown),
        "designs": len(front),
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


def _figure(chosen: Chosen, words: Words) -> Figure:
    document = chosen.document
    front = document["front"]
    first, second = document["objectives"][:2]
    x, y = OBJECTIVES[first], OBJECTIVES[second]
    places = [(x.to_field(point[first]), y.to_field(point[second])) for point in front]
    frame = _frame(places)
    shapes = axes(frame, units(words, x).text, units(words, y).text)
    shapes += [_dot("design", frame, place, 4.0) for place in places]
    shapes.append(_dot("recommended", frame, places[document["recommended"]], 10.0))
    shapes.append(_dot("chosen", frame, places[chosen.number - 1], 7.0))
    points = tuple(
        Point(*frame.at(*place), _said(index, point, document, words))
        for index, (place, point) in enumerate(zip(places, front, strict=True))
    )
    legend = (
        Legend("design", words("front.design")),
        Legend("recommended", words("front.recommended", number=document["recommended"] + 1)),
        Legend("chosen", words("front.chosen", number=chosen.number)),
    )
    further = tuple(
        words("front.further", objective=words.name(OBJECTIVES[key].name))
        for key in document["objectives"][2:]
    )
    alt = words("front.alt", count=len(front))
    return Figure("front", alt, _HEIGHT, tuple(shapes), points, legend, further)


def _frame(places: Sequence[tuple[float, float]]) -> Frame:
    ranges = []
    for values in zip(*places, strict=True):
        low, high = min(values), max(values)
        spare = 0.06 * (high - low) or 0.05 * abs(high) or 1.0
        ranges.append((low - spare, high + spare))
    return frame_in(_HEIGHT, ranges[0], ranges[1])


def _dot(style: str, frame: Frame, place: tuple[float, float], radius: float) -> Shape:
    x, y = frame.at(*place)
    return shape("circle", style, cx=x, cy=y, r=radius)


def _present(document: Mapping[str, Any], keys: Sequence[str], words: Words) -> str:
    """Say how the line of the case file does beside the front; empty where that is not known."""
    present = document.get("present")
    if present is None:
        return ""
    values = _values([key for key in keys if present.get(key) is not None], present, words)
    verdict = verdict_cell(present, document, words).text
    return words("front.present", values=values or "–", verdict=verdict)


def _values(keys: Sequence[str], point: Mapping[str, Any], words: Words) -> str:
    """Name the objectives of a design with their values."""
    return ", ".join(
        f"{words.name(OBJECTIVES[key].name)} {OBJECTIVES[key].format(point[key], unit=True)}"
        for key in keys
    )


def _said(index: int, point: Mapping[str, Any], document: Mapping[str, Any], words: Words) -> str:
    values = _values(document["objectives"], point, words)
    return words("front.point", number=index + 1, values=values, made=composition(point))


def composition(point: Mapping[str, Any]) -> str:
    """Say what a design is made of: ``"chain studless R3 76 mm, 45 m; 2 t at 7 m"``."""
    parts = [
        f"{segment.get('name') or segment['component'] or '?'}, {segment['length_m']:g} m"
        for segment in point["segments"]
    ]
    parts += [f"{_load(load)}, s = {load['position_m']:g} m" for load in point["point_loads"]]
    return "; ".join(parts)


def _load(load: Mapping[str, Any]) -> str:
    if load["mass_kg"] is not None:
        return f"{load['mass_kg'] / 1e3:g} t"
    return f"{load['submerged_weight_N'] / 1e3:g} kN"


def _shown(count: int, chosen: int, recommended: int) -> list[int]:
    """List the designs of the table by index: all of few; of many some, evenly, and the named."""
    if count <= _MOST:
        return list(range(count))
    step = -(-count // _MOST)
    return sorted({*range(0, count, step), count - 1, chosen, recommended})


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
                said(governing_phrase(point["governing"], chosen.document, words), "words"),
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


def governing_phrase(governing: str, document: Mapping[str, Any], words: Words) -> Phrase:
    """Name a check with its load case, as the document has them: ``"offset (storm)"``."""
    for state in document["load_cases"]:
        ending = f" ({state['name']})"
        if governing.endswith(ending):
            name = words.sentence(governing.removesuffix(ending))
            return Phrase(f"{name.text}{ending}", name.lang)
    return words.sentence(governing)


def _neighbours(document: Mapping[str, Any], keys: Sequence[str], words: Words) -> Table | None:
    """Tabulate what one step of a variable would do to the recommended design."""
    steps = document.get("neighbours", [])
    if not steps:
        return None
    quantities = [(key, OBJECTIVES[key]) for key in keys]
    rows = tuple(
        (
            Cell(change_words(step["change"], words), style="words"),
            *(measured(quantity, step.get(key)) for key, quantity in quantities),
            verdict_cell(step, document, words),
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


def verdict_cell(step: Mapping[str, Any], document: Mapping[str, Any], words: Words) -> Cell:
    """Say whether a changed design passes, or why not."""
    if step["feasible"]:
        return Cell(words("checks.passes"), style="words passes")
    if step["reason"]:
        why = words.sentence(step["reason"])
    else:
        why = governing_phrase(step["governing"], document, words)
    return Cell(f"{words('checks.fails')}: {why.text}", lang=why.lang, style="words fails")
