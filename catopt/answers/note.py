"""The sections that notes of several kinds share."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Block,
    Column,
    Fact,
    Facts,
    FileText,
    Section,
    Table,
    Text,
    Value,
    Warnings,
    exact,
    measured,
)
from catopt.answers.solution import given_tables
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Cited, Message, quantity_name

if TYPE_CHECKING:
    from catopt.catalogue import Component, Source
    from catopt.model import Case, Line, Segment
    from catopt.notes.inputs import Input
    from catopt.notes.origin import Origin


def note_section(name: str, blocks: Iterable[Block], heading: str) -> Section:
    """Make a section of a note by the key of its heading."""
    return Section(Message(heading), tuple(blocks), name)


def column(key: str, values: Iterable[Value], quantity: Quantity | None = None) -> Column:
    """Make a column by the key of its heading."""
    return Column(Message(key), tuple(values), quantity)


def title_block(facts: Sequence[tuple[str, str]], origin: Origin) -> Facts:
    """Lay out what is calculated, when, from which files and by which version.

    A fact is the key of what it is called, and what is said; one that says nothing is left out.
    """
    files = [Cited(f"{each.name}, SHA-256 {each.sha256}") for each in origin.files]
    every = (
        *facts,
        ("note.identity_date", origin.date),
        ("note.identity_version", Cited(f"catopt {origin.version}")),
        *(("note.identity_file", said) for said in files),
    )
    return Facts(
        "identity", tuple(Fact(Message(key), said) for key, said in every if said), only="not csv"
    )


def warnings_section(warnings: tuple[str, ...]) -> Iterator[Section]:
    """Say what is to be known before the note is used; no section where that is nothing."""
    if warnings:
        yield note_section("warnings", [Warnings(warnings)], "note.warnings_heading")


def file_section(origin: Origin, name: str, heading: str) -> Iterator[Section]:
    """Show the first file in full; no section where all was given by options."""
    if origin.files:
        first = origin.files[0]
        text = FileText(first.name, first.sha256, first.text)
        yield note_section(name, [text], heading)


def inputs_section(origin: Origin, design: int | None = None) -> Section:
    """Tabulate every value of the case file; say so where a design takes the line's place."""
    blocks: list[Block] = [Text(Message("note.inputs_about"))]
    if design is not None:
        blocks.append(Text(Message("note.inputs_design", number=design)))
    return note_section("inputs", [*blocks, inputs_table(origin)], "note.inputs_heading")


def _of_input(each: Input) -> Quantity:
    """Show a value with the digits of a hand calculation; wear in mm a year, not 1e-11 m/s."""
    is_wear = each.key.rpartition(".")[2] == "wear_rate"
    return QUANTITIES["wear_rate"] if is_wear else exact(each.unit)


def inputs_table(origin: Origin) -> Table:
    """Tabulate every value of a file, as it stands there and in SI."""
    every = origin.inputs
    in_si = Column(
        Message("page.si"),
        tuple(each.si if isinstance(each.si, float) else Cited(each.si or "") for each in every),
        units=tuple(_of_input(each) for each in every),
    )
    return Table(
        "inputs",
        (
            column("note.inputs_key", (Cited(each.key) for each in every)),
            column("note.inputs_given", (Cited(each.given) for each in every)),
            in_si,
        ),
        only="not csv",
    )


# ------------------------------------------------------------------ parts of a line


def components_section(case: Case, line: Line) -> Section:
    """Tabulate the parts of a line, and what the catalogue says of those of its case."""
    return note_section("components", _components(case, line), "note.components_heading")


def _components(case: Case, line: Line) -> Iterator[Block]:
    segments, *loads = given_tables(line)
    further = [
        measured(key, values)
        for key, values in (
            ("nominal_diameter", [each.nominal_diameter for each in line.segments]),
            ("proof_load", [each.proof_load for each in line.segments]),
        )
        if any(value is not None for value in values)
    ]
    known = (each for each in segments.columns if any(each.values))
    yield replace(segments, columns=(*known, *further), only="not csv")
    yield from (replace(each, only="not csv") for each in loads)
    if any(not each.component for each in line.segments):
        yield Text(Message("note.components_own"), is_small=True)
    parts = list(_looked_up(case))
    if parts:
        yield from map(_provenance, parts)
        yield Text(Message("note.components_legend"), is_small=True)
        yield _sources(parts)


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
"""Quantities of the catalogue that a note rests on, and what each is printed as."""
_OWN = {"mass": "mass", "MBL": "MBL", "proof_load": "proof_load", "EA": "EA", "price": "price"}
"""Of these, what a segment of a case file may have of its own."""


@dataclass(frozen=True)
class _Part:
    """A segment with its component in the catalogue."""

    segment: Segment
    component: Component


@dataclass(frozen=True)
class _Found:
    """A figure of a component; without a source it is the case file's own."""

    name: str
    quantity: Quantity
    value: float
    formula: str = ""
    confidence: str = ""
    source: str = ""


def _looked_up(case: Case) -> Iterator[_Part]:
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
            yield _Part(segment, component)


def _provenance(part: _Part) -> Table:
    """Tabulate where each figure of a component comes from."""
    every = [_figure(key, part) for key in _SHOWN if key in part.component.provenance]
    return Table(
        "component",
        (
            column("columns.quantity", (each.name for each in every)),
            Column(
                Message("columns.value"),
                tuple(each.value for each in every),
                units=tuple(each.quantity for each in every),
            ),
            column("columns.formula", (each.formula for each in every)),
            column("columns.confidence", (each.confidence for each in every)),
            column("columns.source", (each.source for each in every)),
        ),
        Cited(part.component.name),
        only="not csv",
    )


def _figure(key: str, part: _Part) -> _Found:
    """Take a figure of the catalogue, or the case file's in its place."""
    quantity, value = QUANTITIES[_SHOWN[key]], getattr(part.component, key)
    wet = Message("columns.strength_in_water_over_dry")
    name = wet if key == _WET else quantity_name(quantity.key)
    own = getattr(part.segment, _OWN[key]) if key in _OWN else None
    expected = part.component.MBL_in_water if key == "MBL" else value
    if own is not None and expected is not None and not math.isclose(own, expected, rel_tol=1e-12):
        return _Found(name, quantity, own, source=Message("note.components_case_file"))
    origin = part.component.provenance[key]
    source = f"{', '.join(source.key for source in origin.sources)}: {origin.place}"
    return _Found(name, quantity, value, origin.formula, origin.confidence, Cited(source))


def _sources(parts: Iterable[_Part]) -> Table:
    """List the documents that the shown figures of components rest on, by their keys."""
    found: dict[str, Source] = {
        source.key: source
        for part in parts
        for key in _SHOWN
        if key in part.component.provenance
        for source in part.component.provenance[key].sources
    }
    every = [found[key] for key in sorted(found)]
    titles = (Cited(f"{each.title}{f'. {each.place}' if each.place else ''}") for each in every)
    return Table(
        "sources",
        (
            column("columns.source", (Cited(each.key) for each in every)),
            column("columns.title", titles),
        ),
        only="not csv",
    )
