"""How the catalogue looks on a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.catalogue.family import in_mm
from catopt.catalogue.figure import RECALLED, SPECS, weakest
from catopt.quantities import QUANTITIES
from catopt.report.wording.catalogue import said_cited, said_formula, said_text

if TYPE_CHECKING:
    from catopt.catalogue import Alternative, Component, Family, Figure, Hydrodynamic, Source
    from catopt.catalogue.components import Provenance
    from catopt.catalogue.document import Answer
    from catopt.cli.output import Output
    from catopt.report.texts import Words

__all__ = ["show_answer"]

_LEGEND = (
    "Confidence: A read in the primary or official document; B in two independent secondary "
    "sources, or in one and checked by numbers; C in one secondary source; R recalled, read in no "
    "document."
)

_COLUMNS = (
    "d is the nominal diameter, Sizes the number of those that are sold with the confidence of the "
    "list, MBL the confidence of the breaking load. A list of sizes that is only recalled (R) is "
    "used, for it is no figure of strength."
)

_SYMBOLS = "d nominal diameter, D volume-equivalent diameter, w weight in water per length."

_SYMBOLS_FOUND = (
    "m mass in air, w weight in water per length, MBL in water, new; Conf. is that of the MBL. "
    "catopt catalog show has the sources."
)

_COEFFICIENTS = {
    "drag_normal": "Drag coefficient across",
    "drag_axial": "Drag coefficient along",
    "added_mass_normal": "Added-mass coefficient across",
    "added_mass_axial": "Added-mass coefficient along",
}
"""Names of the coefficients, across and along the line, that are referred to a diameter."""

Row = tuple[str, str, str, str]


def show_answer(output: Output, answer: Answer, words: Words, *, in_full: bool) -> None:
    """Print an answer for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    answer : Answer
        What was found.
    words : Words
        Language; names of components, their sources and keys are the same in both.
    in_full : bool
        Whether one component was asked for with all that is known of it.
    """
    if answer.question == "list":
        _list(output, words, answer)
    elif answer.question == "search":
        _search(output, words, answer)
    elif in_full:
        _component(output, words, answer.families[0], answer.components[0])
        _sources(output, words, answer)
    else:
        _sizes(output, words, answer.families[0], answer.components)
        _figures(output, words, answer.families[0], answer.components)
        _sources(output, words, answer)
    if answer.question != "search":
        output.text(words.name(_LEGEND))


# ------------------------------------------------------------------ list


def _list(output: Output, words: Words, answer: Answer) -> None:
    rows = []
    for family in answer.families:
        low, high = (f"{round(end * 1e3, 6):g}" for end in family.range)
        count = len(family.sizes.diameters)
        rows.append(
            (
                family.name,
                ", ".join(family.grades) or "-",
                words("catalog.range", low=low, high=high),
                f"{count} ({family.sizes.confidence})" if count else "-",
                _strength(family),
            )
        )
    names = [words.name(each) for each in ("Family", "Grades")]
    output.table([*names, "d (mm)", words.name("Sizes"), "MBL"], rows, numbers=[2, 3, 4])
    output.text(words.name(_COLUMNS))


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


# ------------------------------------------------------------------ one component


def _component(output: Output, words: Words, family: Family, component: Component) -> None:
    output.text(f"{said_text(words, family.title)}: {component.name}", bold=True)
    density = QUANTITIES["density"].format(component.water_density, unit=True)
    diameter = in_mm(component.nominal_diameter)
    output.text(words("catalog.water", diameter=diameter, density=density))
    if family.note:
        output.text(said_text(words, family.note))
    output.line()
    columns = [words.name(each) for each in ("Quantity", "Value", "Conf.", "Sources")]
    output.table(columns, list(_rows(words, component)), numbers=[1])
    others = [_other(words, each) for each in component.alternatives]
    if others:
        columns[0] = words.name("Also published: --variant")
        output.table(columns, others, numbers=[1])
    output.text(words.name("How each figure follows"), bold=True)
    for key, origin in component.provenance.items():
        head = f"{_named(words, key)}{_variant(origin.variant)}"
        output.text(f"  {head}: {_explained(words, origin.formula, origin)}")
    for key, why in component.missing.items():
        said = words("catalog.unknown", quantity=_named(words, key), why=said_text(words, why))
        output.text(f"  {said}")
    output.line()
    _warn(output, words, [component])


def _rows(words: Words, component: Component) -> Iterator[Row]:
    origins = component.provenance
    plain = {
        "mass": ("mass_per_length", "Mass in air per length m", component.mass),
        "submerged_weight": (
            "submerged_weight",
            QUANTITIES["submerged_weight"].label,
            component.submerged_weight,
        ),
        "volume_diameter": (
            "volume_diameter",
            QUANTITIES["volume_diameter"].name,
            component.volume_diameter,
        ),
        "MBL": ("MBL", "Minimum breaking load MBL", component.MBL),
        "proof_load": ("proof_load", "Proof load", component.proof_load),
        "EA": ("EA", "Axial stiffness EA", component.EA),
        "price": ("price", "Price, material only", component.price),
    }
    for key, (unit, name, value) in plain.items():
        if key in origins:
            shown = QUANTITIES[unit].format(value, unit=True)
            yield _row(words.heading(name), shown, origins[key])
        if key == "MBL" and component.wet_strength_factor is not None:
            wet = QUANTITIES["MBL"].format(component.MBL_in_water, unit=True)
            yield _row(words.name("MBL in water"), wet, origins["wet_strength_factor"])
        if key == "EA" and component.EA_dynamic_terms is not None:
            constant, slope = component.EA_dynamic_terms
            text = f"{constant:g} + {slope:g} Lm"
            yield _row(words.name("Dynamic EA over MBL"), text, origins["EA_dynamic"])
    for key, name in _COEFFICIENTS.items():
        found: Hydrodynamic | None = getattr(component, key)
        if found is not None:
            yield _row(words.name(name), f"{found.coefficient:g}", origins[key])
            yield f"  {_which(words, key, found)}", _in_mm(found.diameter), "", ""


def _which(words: Words, key: str, found: Hydrodynamic) -> str:
    """Name the diameter that a coefficient is referred to."""
    if found.name == "volume":
        return words("catalog.volume_diameter")
    text = "catalog.drag_diameter" if key.startswith("drag") else "catalog.diameter"
    return words(text, name=found.name)


def _in_mm(diameter: float) -> str:
    return QUANTITIES["drag_diameter"].format(diameter, unit=True)


def _row(name: str, value: str, origin: Provenance) -> Row:
    return name, value, origin.confidence, _keys(origin.sources)


def _other(words: Words, other: Alternative) -> Row:
    value = "-" if other.value is None else _value(other.quantity, other.value)
    if other.reference is not None:
        value = words("catalog.on", coefficient=value, diameter=_in_mm(other.reference))
    return _row(f"{other.quantity}={other.variant}", value, other.provenance)


def _value(key: str, value: float) -> str:
    quantity = {"mass": "mass_per_length", "EA_dynamic": "EA"}.get(key, key)
    if quantity in QUANTITIES:
        return QUANTITIES[quantity].format(value, unit=True)
    return f"{value:g}"


def _keys(sources: Iterable[Source]) -> str:
    return ", ".join(source.key for source in sources)


def _variant(variant: str) -> str:
    return f" ({variant})" if variant else ""


def _named(words: Words, key: str) -> str:
    """Name a quantity of the catalogue, with a capital."""
    text = SPECS[key].words if key in SPECS else "submerged weight per length"
    return words.name(text[:1].upper() + text[1:])


def _explained(words: Words, formula: str, origin: Provenance | Figure) -> str:
    """Say how a figure follows, for which diameters, who has it and why it is the default."""
    low, high = (in_mm(end) for end in origin.range)
    known = words(
        "catalog.explained",
        formula=said_formula(words, formula),
        low=low,
        high=high,
        confidence=origin.confidence,
        sources=_keys(origin.sources),
        place=said_cited(words, origin.place),
    )
    reason = said_text(words, origin.reason)
    if reason:
        reason = words("catalog.reason", reason=reason)
    return " ".join(part for part in (known, reason, said_text(words, origin.note)) if part)


# ------------------------------------------------------------------ a family over its sizes


def _sizes(output: Output, words: Words, family: Family, components: Sequence[Component]) -> None:
    output.text(said_text(words, family.title), bold=True)
    if family.note:
        output.text(said_text(words, family.note))
    if not components:
        low, high = (in_mm(end) for end in family.range)
        output.text(words("catalog.no_sizes", low=low, high=high))
        output.line()
        return
    output.line()
    grades = list(dict.fromkeys(component.grade for component in components))
    if len(grades) == 1:
        _one_grade(output, words, components)
    else:
        _all_grades(output, words, components, [grade for grade in grades if grade])
    _sizes_from(output, words, family)
    _warn(output, words, components)


def _one_grade(output: Output, words: Words, components: Sequence[Component]) -> None:
    with_proof = any(component.proof_load is not None for component in components)
    columns = ["d (mm)", "m (kg/m)", "w (N/m)", "D (mm)", "MBL (kN)"]
    rows = [
        [
            *_common(component),
            QUANTITIES["MBL"].format(component.MBL),
            *([QUANTITIES["proof_load"].format(component.proof_load)] if with_proof else []),
            QUANTITIES["EA"].format(component.EA),
            QUANTITIES["price"].format(component.price),
        ]
        for component in components
    ]
    columns += [*([words("catalog.proof")] if with_proof else []), "EA (MN)", "USD/m"]
    output.table(columns, rows, numbers=range(len(columns)))
    factor = components[0].wet_strength_factor
    said = words.name(_SYMBOLS)
    if factor is not None:
        said += " " + words("catalog.wet", factor=f"{factor:g}")
    output.text(said)


def _all_grades(
    output: Output, words: Words, components: Sequence[Component], grades: Sequence[str]
) -> None:
    by_size: dict[float, dict[str | None, Component]] = {}
    for component in components:
        by_size.setdefault(component.nominal_diameter, {})[component.grade] = component
    first = [next(iter(by_size[diameter].values())) for diameter in sorted(by_size)]
    output.table(
        ["d (mm)", "m (kg/m)", "w (N/m)", "D (mm)"],
        [_common(component) for component in first],
        numbers=range(4),
    )
    output.text(words.name(_SYMBOLS))
    output.line()
    rows = [
        [
            f"{round(diameter * 1e3, 6):g}",
            *(_MBL(by_size[diameter].get(grade)) for grade in grades),
        ]
        for diameter in sorted(by_size)
    ]
    columns = ["d (mm)", *grades]
    title = words.name("MBL (kN) by grade")
    output.table(columns, rows, title=title, numbers=range(len(columns)))


def _common(component: Component) -> list[str]:
    return [
        f"{round(component.nominal_diameter * 1e3, 6):g}",
        QUANTITIES["mass_per_length"].format(component.mass),
        QUANTITIES["submerged_weight"].format(component.submerged_weight, digits=1),
        QUANTITIES["volume_diameter"].format(component.volume_diameter),
    ]


def _MBL(component: Component | None) -> str:
    return QUANTITIES["MBL"].format(component.MBL if component else None, digits=0)


def _sizes_from(output: Output, words: Words, family: Family) -> None:
    sizes = family.sizes
    said = words(
        "catalog.sizes",
        sources=_keys(sizes.sources),
        place=said_cited(words, sizes.place),
        confidence=sizes.confidence,
    )
    if sizes.confidence == RECALLED:
        said += " " + words("catalog.ask")
    output.text(said)
    output.line()


def _figures(output: Output, words: Words, family: Family, components: Sequence[Component]) -> None:
    """Explain every figure of the grades that are shown."""
    grades = {component.grade for component in components} or set(family.grades or (None,))
    output.text(words.name("How each figure follows"), bold=True)
    for figure in family.figures:
        if any(figure.holds_for(grade) for grade in grades):
            head = _named(words, figure.quantity)
            if figure.grades:
                head = words("catalog.grades", quantity=head, grades=", ".join(figure.grades))
            head += _variant(figure.variant)
            output.text(f"  {head}: {_explained(words, figure.text, figure)}")
    output.line()


# ------------------------------------------------------------------ search


def _search(output: Output, words: Words, answer: Answer) -> None:
    rows = [
        (
            component.name,
            QUANTITIES["mass_per_length"].format(component.mass),
            QUANTITIES["submerged_weight"].format(component.submerged_weight, digits=1),
            QUANTITIES["MBL"].format(component.MBL_in_water),
            QUANTITIES["price"].format(component.price),
            component.provenance["MBL"].confidence if "MBL" in component.provenance else "-",
        )
        for component in answer.components
    ]
    columns = ["m (kg/m)", "w (N/m)", "MBL (kN)", "USD/m"]
    columns = [words.name("Component"), *columns, words.name("Conf.")]
    output.table(columns, rows, numbers=[1, 2, 3, 4])
    output.text(words.name(_SYMBOLS_FOUND))
    recalled = [f.name for f in answer.families if f.sizes.confidence == RECALLED]
    if recalled:
        output.text(words("catalog.recalled_sizes", families=", ".join(recalled)))
    _warn(output, words, answer.components)


# ------------------------------------------------------------------ common


def _warn(output: Output, words: Words, components: Iterable[Component]) -> None:
    """Name what rests on figures that were read in no document."""
    recalled = {key for component in components for key in component.recalled}
    if recalled:
        named = ", ".join(_named(words, key).lower() for key in SPECS if key in recalled)
        output.text(words("catalog.recalled", quantities=named))
        output.line()


def _sources(output: Output, words: Words, answer: Answer) -> None:
    used = {s for c in answer.components for p in c.provenance.values() for s in p.sources}
    if len(answer.components) == 1:
        used |= {s for a in answer.components[0].alternatives for s in a.provenance.sources}
        used |= set(answer.families[0].sizes.sources)
    output.text(words.name("Sources"), bold=True)
    for source in answer.sources:
        if source in used or len(answer.components) != 1:
            title, place = (said_cited(words, text) for text in (source.title, source.place))
            output.text(f"  {source.key}: {title}. {place}.")
    output.line()
