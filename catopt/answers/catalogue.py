"""What an answer out of the catalogue consists of."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, if_known, measured, section, tabulate
from catopt.catalogue.components import SPECS, weakest
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Cited, Measure, Message, Several, quantity_name, term

if TYPE_CHECKING:
    from catopt.catalogue import Alternative, Component, Family, Figure, Source
    from catopt.catalogue.components import Provenance
    from catopt.catalogue.document import Answer as Found

_COEFFICIENTS = {
    "drag_normal": ("drag_coefficient_across", "drag_diameter_across_the_line"),
    "drag_axial": ("drag_coefficient_along", "drag_diameter_along_the_line"),
    "added_mass_normal": ("added_mass_coefficient_across", ""),
    "added_mass_axial": ("added_mass_coefficient_along", ""),
}
"""What the coefficients are called, and their drag diameters."""

_PLAIN = {
    "mass": ("mass_per_length", "columns.mass_in_air_per_length"),
    "submerged_weight": ("submerged_weight", "quantities.submerged_weight"),
    "volume_diameter": ("volume_diameter", "quantities.volume_diameter"),
    "MBL": ("MBL", "quantities.MBL"),
    "proof_load": ("proof_load", "quantities.proof_load"),
    "EA": ("EA", "quantities.EA"),
    "price": ("price", "columns.price_material_only"),
}
"""Quantity and name of the figures of a component that are a number each."""


def catalogue_answer(found: Found, *, in_full: bool = False) -> blocks.Answer:
    """Lay out families and components, every figure with its source.

    `in_full`: one component was asked for with all that is known of it.
    """
    title: str = Message("captions.catalogue")
    seen: Iterable[blocks.Block]
    how: tuple[blocks.Block, ...] = ()
    if found.question == "list":
        seen = (_list(found.families), for_people("catalogue.of_list"))
    elif found.question == "search":
        seen = _search(found)
    elif found.question != "show":
        title = Message(f"catalogue.title_{found.question}")
        seen = parts_of(found)
    elif in_full:
        (family,), (component,) = found.families, found.components
        title = Message("catalogue.titled", title=family.title, name=Cited(component.name))
        seen, how = _one(family, component), (_how(_figures_of(component)),)
    else:
        (family,) = found.families
        title = family.title
        seen = _family(family, found.components)
        how = (_how(_figures_of_grades(family, found.components)),)
    components = (_components(found.components),) if found.components else ()
    of = Rows(found.sources)
    documents = (of.texts("source", "key"), *of.own("title", "place"))
    sources = tabulate("sources", *documents, only="files")
    return answered(
        "catalog",
        title,
        section("terms.components", *components, *seen),
        section("terms.figures", _figures(found.families), *how),
        section("terms.families", _families(found.families)),
        section("columns.sources", sources, *_documents(found)),
    )


# ------------------------------------------------------------------ tables of files


def _components(components: Sequence[Component]) -> blocks.Table:
    """Tabulate components, a row each; added mass is on the volume-equivalent diameter."""
    of = Rows(components)
    return tabulate(
        "components",
        of.texts("component", lambda each: Cited(each.name)),
        of.texts("family"),
        of.texts("grade", lambda each: each.grade or ""),
        *of.own("nominal_diameter", symbol=""),
        of.measured("mass_per_length", "mass", "mass_in_air_per_length", symbol=""),
        *of.own("submerged_weight", "volume_diameter", "MBL", symbol=""),
        of.measured("MBL", "MBL_in_water", "minimum_breaking_load_in_water", symbol=""),
        *of.own("proof_load", "EA", symbol=""),
        *_coefficients(of),
        *of.own("price", symbol=""),
        of.texts("confidence_of_mbl", lambda each: _confidence(each, "")),
        of.texts("recalled", lambda each: ", ".join(each.recalled)),
        only="files",
    )


def _coefficients(of: Rows) -> Iterator[blocks.Column]:
    for key, (name, diameter) in _COEFFICIENTS.items():
        yield of.measured("coefficient", f"{key}.coefficient", f"{name}_the_line")
        if diameter:
            yield of.measured("drag_diameter", f"{key}.diameter", diameter)


def _figures(families: Sequence[Family]) -> blocks.Table:
    each_family, of = Rows(families).within("figures")
    return tabulate(
        "figures",
        each_family.texts("family", "name"),
        *of.own("quantity"),
        of.texts("grades", lambda each: ", ".join(each.grades)),
        *of.own("variant"),
        of.texts("default", lambda each: blocks.yes_or_no(each.default)),
        of.texts("formula", "text"),
        *_ranges(of),
        *of.own("confidence"),
        of.texts("sources", lambda each: keys(each.sources)),
        *of.own("place", "reason", "note"),
        only="files",
    )


def _families(families: Sequence[Family]) -> blocks.Table:
    of = Rows(families)
    return tabulate(
        "families",
        of.texts("family", "name"),
        of.texts("title"),
        of.texts("also", lambda each: ", ".join(each.also)),
        of.texts("grades", lambda each: ", ".join(each.grades)),
        *_ranges(of),
        of.texts("sizes", lambda each: len(each.sizes.diameters)),
        of.texts("confidence_of_the_sizes", "sizes.confidence"),
        of.texts("sources_of_the_sizes", lambda each: keys(each.sizes.sources)),
        of.texts("note"),
        only="files",
    )


def _ranges(of: Rows) -> Iterator[blocks.Column]:
    for end, name in enumerate(("smallest_nominal_diameter", "largest_nominal_diameter")):
        ends = map(itemgetter(end), of.read("range"))
        yield measured("nominal_diameter", ends, name, symbol="")


# ------------------------------------------------------------------ what people see of a list


def _list(families: Sequence[Family]) -> blocks.Table:
    of = Rows(families)
    shortest = _shortest("nominal_diameter")
    ends = [map(shortest.format, each.range) for each in families]
    ranges = tuple(Message("catalogue.range", low=low, high=high) for low, high in ends)
    return tabulate(
        "list",
        of.texts("family", "name"),
        of.texts("grades", lambda each: ", ".join(each.grades) or "-"),
        blocks.Column(quantity_name("nominal_diameter"), ranges, shortest),
        blocks.texts(
            "sizes",
            [
                f"{len(s.diameters)} ({s.confidence})" if s.diameters else "-"
                for s in of.read("sizes")
            ],
        ),
        of.texts("conf", _strength),
        only="people",
    )


def _strength(family: Family) -> str:
    """Name the confidence of the default breaking loads: the weakest of all grades."""
    found = []
    for grade in family.grades or (None,):
        figure = family.default("MBL", grade)
        while figure is not None:
            found.append(figure.confidence)
            rest = figure.formula.rests_on
            figure = family.default(rest[0], grade) if rest else None
    return weakest(found) if found else "-"


# ------------------------------------------------------------------ of a search


def _search(found: Found) -> Iterator[blocks.Block]:
    components = found.components
    of = Rows(components)
    yield tabulate(
        "found",
        of.texts("component", lambda each: Cited(each.name)),
        *_weights(of),
        of.measured("MBL", "MBL_in_water", "minimum_breaking_load_in_water"),
        *of.own("price"),
        of.texts("conf", lambda each: _confidence(each, "-")),
        only="people",
    )
    yield for_people("catalogue.symbols_found")
    recalled = [each.name for each in found.families if each.sizes.is_recalled]
    if recalled:
        yield for_people("catalogue.recalled_sizes", families=", ".join(recalled))
    yield from _recalled(components)


def _confidence(component: Component, unknown: str) -> str:
    origin = component.provenance.get("MBL")
    return origin.confidence if origin else unknown


def _recalled(components: Sequence[Component]) -> Iterator[blocks.Text]:
    """Name what rests on figures that were read in no document."""
    recalled = {key for component in components for key in component.recalled}
    if recalled:
        every = Several((_name(key) for key in SPECS if key in recalled), ", ")
        yield for_people("catalogue.recalled", quantities=every)


# ------------------------------------------------------------------ of one component


class _Row(NamedTuple):
    """A figure: what it is, its value and where it comes from."""

    name: str
    value: blocks.Value
    quantity: Quantity
    origin: Provenance | None = None


def _one(family: Family, component: Component) -> Iterator[blocks.Block]:
    yield for_people(
        "catalogue.water",
        diameter=_diameter(component.nominal_diameter),
        density=Measure("density", component.water_density),
    )
    if family.note:
        yield blocks.Text(family.note, only="people")
    yield _rows("component", "quantity", list(_known(component)))
    others = [_other(each) for each in component.alternatives]
    if others:
        yield _rows("alternatives", "also_published", others)
    yield from _recalled([component])


def _rows(name: str, heading: str, rows: Sequence[_Row]) -> blocks.Table:
    of = Rows(rows)
    return tabulate(
        name,
        of.texts(heading, "name"),
        of.texts("value", units=tuple(of.read("quantity"))),
        of.texts("conf", lambda each: each.origin.confidence if each.origin else ""),
        of.texts("sources", lambda each: keys(each.origin.sources) if each.origin else ""),
        only="people",
    )


def _known(component: Component) -> Iterator[_Row]:
    origins = component.provenance
    for key, (unit, name) in _PLAIN.items():
        quantity = blocks.named(unit)
        if key in origins:
            label = blocks.labelled(Message(name), quantity.symbol)
            yield _Row(label, getattr(component, key), quantity, origins[key])
        if key == "MBL" and component.wet_strength_factor is not None:
            wet = Message("columns.mbl_in_water")
            yield _Row(wet, component.MBL_in_water, quantity, origins["wet_strength_factor"])
        if key == "EA" and component.EA_dynamic_terms is not None:
            constant, slope = component.EA_dynamic_terms
            said = Message("catalogue.dynamic", constant=constant, slope=slope)
            ratio = Message("columns.dynamic_ea_over_mbl")
            yield _Row(ratio, said, blocks.named("coefficient"), origins["EA_dynamic"])
    for key, (name, of_drag) in _COEFFICIENTS.items():
        found = getattr(component, key)
        if found is not None:
            name = Message(f"columns.{name}")
            yield _Row(name, found.coefficient, _shortest("coefficient"), origins[key])
            other = "drag_diameter" if of_drag else "diameter"
            key = "volume_diameter" if found.name == "volume" else other
            below = Several(("  ", Message(f"catalogue.{key}", name=found.name)), "")
            yield _Row(below, found.diameter, blocks.named("drag_diameter"))


def _other(other: Alternative) -> _Row:
    """Tell what another variant gives, and by which words it is asked for."""
    name = f"{other.quantity}={other.variant}"
    if other.value is None or other.reference is None:
        unit = {"mass": "mass_per_length", "EA_dynamic": "EA"}.get(other.quantity, other.quantity)
        quantity = blocks.named(unit) if unit in QUANTITIES else _shortest("coefficient")
        return _Row(name, other.value, quantity, other.provenance)
    said = Message(
        "catalogue.on",
        coefficient=f"{other.value:g}",
        diameter=Measure("drag_diameter", other.reference),
    )
    return _Row(name, said, blocks.named("drag_diameter"), other.provenance)


# ------------------------------------------------------------------ of a family over its sizes


def _family(family: Family, components: Sequence[Component]) -> Iterator[blocks.Block]:
    if family.note:
        yield blocks.Text(family.note, only="people")
    if not components:
        yield for_people("catalogue.no_sizes", **_ends(family.range))
        return
    grades = list(dict.fromkeys(each.grade for each in components))
    said = [Message("catalogue.symbols")]
    if len(grades) == 1:
        of = Rows(components)
        rest = (*of.own("MBL"), *if_known(*of.own("proof_load")), *of.own("EA", "price"))
        yield tabulate("sizes", *_sizes(of), *rest, only="people")
        factor = components[0].wet_strength_factor
        if factor is not None:
            said.append(Message("catalogue.wet", factor=factor))
    else:
        first = {each.nominal_diameter: each for each in reversed(components)}
        one_each = Rows(first[diameter] for diameter in sorted(first))
        yield tabulate("sizes", *_sizes(one_each), only="people")
        yield _by_grade(components, one_each, [grade for grade in grades if grade])
    yield blocks.Text(Several(said, " "), only="people")
    yield _sizes_from(family)
    yield from _recalled(components)


def _by_grade(
    components: Sequence[Component], one_each: Rows, grades: Sequence[str]
) -> blocks.Table:
    strengths = {(each.nominal_diameter, each.grade): each.MBL for each in components}
    quantity = replace(blocks.named("MBL", ""), digits=0)
    diameters = one_each.read("nominal_diameter")
    return tabulate(
        "by_grade",
        _diameters(one_each),
        *(
            measured(quantity, [strengths.get((d, grade)) for d in diameters], Several((grade,)))
            for grade in grades
        ),
        caption=Message("captions.mbl_by_grade"),
        only="people",
    )


def _sizes(of: Rows) -> Iterator[blocks.Column]:
    yield _diameters(of)
    yield from _weights(of)
    yield from of.own("volume_diameter", symbol="D")


def _diameters(of: Rows) -> blocks.Column:
    return of.measured(_shortest("nominal_diameter"), "nominal_diameter")


def _weights(of: Rows) -> Iterator[blocks.Column]:
    yield of.measured("mass_per_length", "mass", "mass_in_air_per_length")
    yield of.measured(replace(blocks.named("submerged_weight"), digits=1), "submerged_weight")


def _sizes_from(family: Family) -> blocks.Text:
    sizes = family.sizes
    values = {"sources": keys(sizes.sources), "place": sizes.place, "confidence": sizes.confidence}
    said = [Message("catalogue.sizes", **values)]
    if sizes.is_recalled:
        said.append(Message("catalogue.ask"))
    return blocks.Text(Several(said, " "), only="people")


# ------------------------------------------------------------------ how figures follow


def _how(said: Iterable[Message]) -> blocks.Text:
    return blocks.Text(Several(said, "\n"), Message("terms.how_each_figure_follows"), "people")


def _figures_of(component: Component) -> Iterator[Message]:
    for key, origin in component.provenance.items():
        yield _explained(_name(key), origin.formula, origin)
    for key, why in component.missing.items():
        yield Message("catalogue.unknown", quantity=_name(key), why=why)


def _figures_of_grades(family: Family, components: Sequence[Component]) -> Iterator[Message]:
    grades = {each.grade for each in components} or set(family.grades or (None,))
    for figure in family.figures:
        if any(figure.holds_for(grade) for grade in grades):
            name = _name(figure.quantity)
            if figure.grades:
                of = ", ".join(figure.grades)
                name = Message("catalogue.of_grades", quantity=name, grades=of)
            yield _explained(name, figure.text, figure)


def _explained(name: str, formula: str, origin: Provenance | Figure) -> Message:
    """Say how a figure follows, for which diameters, who has it and why it is the default."""
    variant = f" ({origin.variant})" if origin.variant else ""
    known = Message(
        "catalogue.explained",
        quantity=name,
        variant=variant,
        formula=formula,
        **_ends(origin.range),
        confidence=origin.confidence,
        sources=keys(origin.sources),
        place=origin.place,
    )
    reason = Message("catalogue.reason", reason=origin.reason) if origin.reason else ""
    return Several((part for part in (known, reason, origin.note) if part), " ")


def _documents(found: Found) -> Iterator[blocks.Text]:
    """Name the documents, with the places to find them, and say what confidence means."""
    if found.question == "search":
        return
    said = [
        Message("catalogue.source", key=each.key, title=each.title, place=each.place)
        for each in _cited(found)
    ]
    if said:
        yield blocks.Text(Several(said, "\n"), Message("columns.sources"), "people")
    yield for_people("answers.confidence")


def _cited(found: Found) -> Sequence[Source]:
    """List the documents that what people see rests on.

    Those of a component, and of several all of their family's; of anchors and fittings: those of
    components that were found beside them are a command away.
    """
    if found.question == "list":
        return ()
    if found.question != "show":
        used = {source for each in (*found.anchors, *found.fittings) for source in each.sources}
    elif len(found.components) != 1:
        return found.sources
    else:
        (component,) = found.components
        origins = [*component.provenance.values()]
        origins += [each.provenance for each in component.alternatives]
        used = {*found.families[0].sizes.sources, *Rows(origins).within("sources")[1].rows}
    return [each for each in found.sources if each in used]


# ------------------------------------------------------------------ words


def _name(key: str) -> str:
    if key not in SPECS:
        return quantity_name("submerged_weight")
    words = SPECS[key].words
    return term(words[:1].upper() + words[1:])


def _shortest(key: str) -> Quantity:
    """Take a quantity that is written in as few digits as it has."""
    return replace(blocks.named(key), notation="shortest", digits=6)


def _ends(ends: tuple[float, float]) -> dict[str, str]:
    low, high = (_diameter(end) for end in ends)
    return {"low": low, "high": high}


def _diameter(value: float) -> str:
    return _shortest("nominal_diameter").format(value, unit=True)


def parts_of(found: Found) -> Iterator[blocks.Block]:
    """Lay out what was found, kind by kind, and how to read it."""
    if found.components:
        yield _found_components(found)
        yield for_people("catalogue.symbols_named")
    if found.anchors:
        yield from _anchors(found)
    if found.fittings or found.missing:
        yield from _fittings(found)
    if found.sinkers:
        of = Rows(found.sinkers)
        friction = ("-" if value is None else f"{value:g}" for value in of.read("friction"))
        adhesion = ("-" if Pa is None else f"{Pa / 1e3:g} kPa" for Pa in of.read("adhesion"))
        yield tabulate(
            "sinkers",
            of.texts("soil", lambda each: term(each.soil)),
            blocks.texts("friction", map(Cited, friction)),
            *if_known(of.measured("tension", "holding", "ultimate_holding", symbol="")),
            *if_known(of.measured("tension", "pull", "pull_by_factor", symbol="")),
            blocks.texts("adhesion", map(Cited, adhesion)),
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


def _found_components(found: Found) -> blocks.Table:
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


def _of_strength(component: Component) -> str:
    """Name the confidence and the sources of the MBL."""
    origin = component.provenance.get("MBL")
    return f"{origin.confidence}: {keys(origin.sources)}" if origin else "-"


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
    if found.fittings:
        of = Rows(found.fittings)
        yield tabulate(
            "fittings",
            *([blocks.texts("use", map(term, found.uses))] if found.uses else []),
            of.texts("fitting", lambda each: term(each.name)),
            of.measured(replace(blocks.named("nominal_diameter"), symbol=""), "size", "size"),
            of.measured("MBL", "MBL", symbol="MBL"),
            *if_known(*of.own("proof_load")),
            *if_known(of.measured(blocks.in_si(blocks.named("mass", "m"), 2), "mass")),
            *if_known(of.measured("mass", "WLL", "working_load_limit", symbol="WLL")),
            *if_known(of.measured("cost", "price", "price_material_only", symbol="")),
            of.texts("sources", lambda each: f"{each.confidence}: {keys(each.sources)}"),
        )
        for note in dict.fromkeys(each.note for each in found.fittings if each.note):
            yield blocks.Text(note, only="people")
    if found.missing:
        yield blocks.Warnings(tuple(found.missing))


def keys(sources: Iterable[Source]) -> str:
    """List the keys of sources."""
    return ", ".join(source.key for source in sources)


def for_people(key: str, **values: object) -> blocks.Text:
    """Say a text that is for people alone."""
    return blocks.Text(Message(key, **values), only="people")
