"""The tables of what was found in the catalogue by name: components, anchors, fittings, sinkers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Rows, if_known, tabulate
from catopt.words import Cited, Message, term

if TYPE_CHECKING:
    from catopt.catalogue import Source
    from catopt.catalogue.document import Answer as Found


def parts_of(found: Found) -> Iterator[blocks.Block]:
    """Lay out what was found, kind by kind, and how to read it."""
    if found.components:
        yield _components(found)
        yield for_people("catalogue.symbols_named")
    if found.anchors:
        yield from _anchors(found)
    if found.fittings or found.missing:
        yield from _fittings(found)
    if found.sinkers:
        of = Rows(found.sinkers)
        yield tabulate(
            "sinkers",
            of.texts("soil", lambda each: term(each.soil)),
            of.texts("friction", lambda each: _number(each.friction)),
            *if_known(of.measured("tension", "holding", "ultimate_holding", symbol="")),
            *if_known(of.measured("tension", "pull", "pull_by_factor", symbol="")),
            of.texts("adhesion", lambda each: _kilopascals(each.adhesion)),
            of.texts("conf", "confidence"),
        )
        first = found.sinkers[0]
        yield for_people(
            "catalogue.sinker",
            material=term(first.material),
            mass=f"{first.mass / 1e3:g}",
            weight=f"{first.submerged_weight / 1e3:.1f}",
            factor=f"{first.safety_factor:g}",
        )


def _components(found: Found) -> blocks.Table:
    of = Rows(found.components)
    return tabulate(
        "named",
        of.texts("component", lambda each: Cited(each.name)),
        of.measured("mass_per_length", "mass"),
        of.measured("MBL", "MBL_in_water", symbol="MBL"),
        *if_known(*of.own("proof_load")),
        *if_known(*of.own("price")),
        of.texts("sources", _of_strength),
        only="people",
    )


def _of_strength(component: object) -> str:
    """Name the confidence and the sources of the MBL."""
    origin = component.provenance.get("MBL")  # type: ignore[attr-defined]
    if origin is None:
        return "-"
    return f"{origin.confidence}: {keys(origin.sources)}"


def _anchors(found: Found) -> Iterator[blocks.Block]:
    of = Rows(found.anchors)
    yield tabulate(
        "anchors",
        of.texts("anchor", lambda each: Cited(each.anchor)),
        of.texts("soil", lambda each: term(each.soil)),
        of.measured(replace(blocks.named("mass", "m"), notation="shortest", digits=6), "mass"),
        of.measured("tension", "holding", "ultimate_holding", symbol=""),
        of.measured("tension", "pull", "pull_by_factor", symbol=""),
        of.measured("cost", "price", "price_material_only", symbol=""),
        of.texts("sources", lambda each: f"{each.confidence}: {keys(each.sources)}"),
    )
    ranges = {each.anchor: each for each in found.anchors}
    for each in ranges.values():
        low, high = (f"{end:g}" for end in each.sold)
        factor = f"{each.safety_factor:g}"
        yield for_people(
            "catalogue.anchor_sold", anchor=each.anchor, low=low, high=high, factor=factor
        )
        if each.note:
            yield blocks.Text(each.note, only="people")
    if any(each.confidence == "R" for each in found.anchors):
        yield for_people("catalogue.anchor_recalled")


def _fittings(found: Found) -> Iterator[blocks.Block]:
    pairs = found.used_fittings()
    if pairs:
        of = Rows(each for each, _ in pairs)
        uses = [term(use) for _, use in pairs]
        yield tabulate(
            "fittings",
            *([blocks.texts("use", uses)] if found.uses else []),
            of.texts("fitting", lambda each: term(each.name)),
            of.measured(replace(blocks.named("nominal_diameter"), symbol=""), "size", "size"),
            of.measured("MBL", "MBL", symbol="MBL"),
            *if_known(*of.own("proof_load")),
            *if_known(of.measured(blocks.in_si(blocks.named("mass", "m"), 2), "mass")),
            *if_known(of.measured("mass", "WLL", "working_load_limit", symbol="WLL")),
            *if_known(of.measured("cost", "price", "price_material_only", symbol="")),
            of.texts("sources", lambda each: f"{each.confidence}: {keys(each.sources)}"),
        )
        for note in dict.fromkeys(each.note for each, _ in pairs if each.note):
            yield blocks.Text(note, only="people")
    if found.missing:
        yield blocks.Warnings(tuple(found.missing))


def _number(value: float | None) -> Cited:
    return Cited("-" if value is None else f"{value:g}")


def _kilopascals(pressure: float | None) -> Cited:
    return Cited("-" if pressure is None else f"{pressure / 1e3:g} kPa")


def keys(sources: Iterable[Source]) -> str:
    """List the keys of sources."""
    return ", ".join(source.key for source in sources)


def for_people(key: str, **values: object) -> blocks.Text:
    """Say a text that is for people alone."""
    return blocks.Text(Message(key, **values), only="people")
