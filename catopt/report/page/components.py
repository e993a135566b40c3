"""The parts of the line: their figures, and for those of the catalogue source and confidence."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from catopt.notes.line import Note
from catopt.quantities import QUANTITIES, Quantity
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, called, measured, units

if TYPE_CHECKING:
    from catopt.catalogue import Component, Source
    from catopt.model import Case, Line, Segment

__all__ = [
    "CatalogueFigure",
    "Part",
    "components",
    "figures_of",
    "looked_up",
    "parts_of",
    "sources_of",
]

_WET = "wet_strength_factor"
_SHOWN = {
    "mass": "mass_per_length",
    "volume_diameter": "volume_diameter",
    "MBL": "MBL",
    _WET: "coefficient",
    "proof_load": "proof_load",
    "EA": "EA",
    "price": "price",
}
"""Quantities of the catalogue that this note rests on, and what each is printed as."""
_OWN = {"mass": "mass", "MBL": "MBL", "proof_load": "proof_load", "EA": "EA", "price": "price"}
"""Of these, what a segment of a case file may have of its own."""


def components(note: Note, words: Words) -> dict[str, Any]:
    """Build the tables of segments and point loads, and of what the catalogue says of them."""
    return parts_of(note.case, note.solution.line, words)


def parts_of(case: Case, line: Line, words: Words) -> dict[str, Any]:
    """Tabulate the parts of a line, and what the catalogue says of those of its case."""
    parts = list(looked_up(case))
    return {
        "segments": _segments(line.segments, words),
        "point_loads": _point_loads(line, words) if line.point_loads else None,
        "catalogue": [_provenance(part, words) for part in parts],
        "sources": sources_of(parts),
        "own": any(not segment.component for segment in line.segments),
    }


def _segments(segments: tuple[Segment, ...], words: Words) -> Table:
    quantities = (
        ("nominal_diameter", [s.nominal_diameter for s in segments]),
        ("length", [s.length for s in segments]),
        ("submerged_weight", [s.submerged_weight for s in segments]),
        ("mass_per_length", [s.mass for s in segments]),
        ("EA", [s.EA if math.isfinite(s.EA) else None for s in segments]),
        ("MBL", [s.MBL for s in segments]),
        ("proof_load", [s.proof_load for s in segments]),
    )
    shown = [
        (QUANTITIES[key], values)
        for key, values in quantities
        if any(value is not None for value in values)
    ]
    rows = []
    for index, segment in enumerate(segments):
        numbers = (measured(quantity, values[index]) for quantity, values in shown)
        name = segment.name or segment.component
        rows.append((Cell(str(index + 1)), Cell(name), *numbers))
    headings = (
        Heading(words("components.segment")),
        Heading(words("components.name")),
        *(units(words, quantity) for quantity, _ in shown),
    )
    return Table("segments", headings, tuple(rows), words("components.segments"))


def point_load_quantities(line: Line) -> list[Quantity]:
    """List what is known of point loads: friction only where one has its own on the bed."""
    own = any(load.friction is not None for load in line.point_loads)
    keys = ("position", "point_weight", "mass", *(("friction",) if own else ()))
    return [QUANTITIES[key] for key in keys]


def _point_loads(line: Line, words: Words) -> Table:
    quantities = point_load_quantities(line)
    rows = []
    for index, load in enumerate(line.point_loads):
        values = (load.position, load.submerged_weight, load.mass, load.friction)
        numbers = zip(quantities, values, strict=False)
        name = called(words, load.submerged_weight, load.name)
        cells = (measured(quantity, value) for quantity, value in numbers)
        rows.append((Cell(str(index + 1)), Cell(name), *cells))
    headings = (
        Heading(words("components.number")),
        Heading(words("components.name")),
        *(units(words, quantity) for quantity in quantities),
    )
    return Table("point_loads", headings, tuple(rows), words("components.point_loads"))


@dataclass(frozen=True)
class Part:
    """A segment with its component in the catalogue."""

    segment: Segment
    component: Component


@dataclass(frozen=True)
class CatalogueFigure:
    """One figure of a component, with where it comes from.

    Attributes
    ----------
    name : str
        In English.
    quantity : Quantity
        What it is printed as.
    value : float
        In SI.
    formula, confidence, source : str
        As the catalogue has them; empty where the case file's own value takes its place.
    """

    name: str
    quantity: Quantity
    value: float
    formula: str = ""
    confidence: str = ""
    source: str = ""


def looked_up(case: Case) -> Iterator[Part]:
    """Look every segment's component up; segments with the same figures once."""
    from catopt.catalogue.choice import chosen

    seen = set()
    catalogue = None
    for segment in case.line.segments:
        own = (getattr(segment, each) for each in _OWN.values())
        key = (segment.component, segment.nominal_diameter, *own)
        if segment.component and segment.nominal_diameter is not None and key not in seen:
            seen.add(key)
            catalogue = catalogue or chosen(case.catalogue, case.site.water_density)
            component = catalogue.component(segment.component, segment.nominal_diameter)
            yield Part(segment, component)


def sources_of(parts: Iterable[Part]) -> list[Source]:
    """List the documents that the shown figures of components rest on, by their keys."""
    sources = {
        source.key: source
        for part in parts
        for key in _SHOWN
        if key in part.component.provenance
        for source in part.component.provenance[key].sources
    }
    return [sources[key] for key in sorted(sources)]


def figures_of(part: Part) -> Iterator[CatalogueFigure]:
    """Yield what this note rests on of a component: the catalogue's figures or the case file's."""
    for key in _SHOWN:
        if key in part.component.provenance:
            yield _figure(key, getattr(part.component, key), part)


def _figure(key: str, value: float, part: Part) -> CatalogueFigure:
    quantity = QUANTITIES[_SHOWN[key]]
    name = "Strength in water over dry" if key == _WET else quantity.name
    own = getattr(part.segment, _OWN[key]) if key in _OWN else None
    expected = part.component.MBL_in_water if key == "MBL" else value
    if own is not None and expected is not None and not math.isclose(own, expected, rel_tol=1e-12):
        return CatalogueFigure(name, quantity, own)
    origin = part.component.provenance[key]
    source = f"{', '.join(source.key for source in origin.sources)}: {origin.place}"
    return CatalogueFigure(name, quantity, value, origin.formula, origin.confidence, source)


def _provenance(part: Part, words: Words) -> Table:
    """Tabulate where each figure of a component comes from."""
    rows = tuple(_row(figure, words) for figure in figures_of(part))
    headings = (
        Heading(words("components.quantity")),
        Heading(words("components.value"), is_number=True),
        Heading(words("components.formula")),
        Heading(words("components.confidence")),
        Heading(words("components.source")),
    )
    return Table("component", headings, rows, part.component.name)


def _row(figure: CatalogueFigure, words: Words) -> tuple[Cell, ...]:
    """Show one figure: the catalogue's with its source, or the case file's in its place."""
    name = Cell(words.name(figure.name))
    value = measured(figure.quantity, figure.value, unit=True)
    if not figure.source:
        given = Cell(words("components.case_file"), style="words")
        return name, value, Cell(""), Cell(""), given
    return (
        name,
        value,
        Cell(figure.formula, lang="en", style="words"),
        Cell(figure.confidence),
        Cell(figure.source, lang="en", style="words"),
    )
