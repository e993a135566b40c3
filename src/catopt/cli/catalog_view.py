"""How the catalogue looks on a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.catalogue.family import in_mm
from catopt.catalogue.figure import RECALLED, SPECS, weakest
from catopt.quantities import QUANTITIES

if TYPE_CHECKING:
    from catopt.catalogue import Alternative, Component, Family, Figure, Hydrodynamic, Source
    from catopt.catalogue.components import Provenance
    from catopt.catalogue.document import Answer
    from catopt.cli.output import Output

__all__ = ["show_answer"]

_LEGEND = (
    "Confidence: A read in the primary or official document; B in two independent secondary "
    "sources, or in one and checked by numbers; C in one secondary source; R recalled, read in no "
    "document."
)

_SYMBOLS = "d nominal diameter, D volume-equivalent diameter, w weight in water per length."

_COEFFICIENTS = {
    "drag_normal": "Drag coefficient across",
    "drag_axial": "Drag coefficient along",
    "added_mass_normal": "Added-mass coefficient across",
    "added_mass_axial": "Added-mass coefficient along",
}
"""Names of the coefficients, across and along the line, that are referred to a diameter."""

Row = tuple[str, str, str, str]


def show_answer(output: Output, answer: Answer, *, in_full: bool) -> None:
    """Print an answer for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    answer : Answer
        What was found.
    in_full : bool
        Whether one component was asked for with all that is known of it.
    """
    if answer.question == "list":
        _list(output, answer)
    elif answer.question == "search":
        _search(output, answer)
    elif in_full:
        _component(output, answer.families[0], answer.components[0])
        _sources(output, answer)
    else:
        _sizes(output, answer.families[0], answer.components)
        _figures(output, answer.families[0], answer.components)
        _sources(output, answer)
    if answer.question != "search":
        output.text(_LEGEND)


# ------------------------------------------------------------------ list


def _list(output: Output, answer: Answer) -> None:
    rows = []
    for family in answer.families:
        low, high = (f"{round(end * 1e3, 6):g}" for end in family.range)
        count = len(family.sizes.diameters)
        rows.append(
            (
                family.name,
                ", ".join(family.grades) or "-",
                f"{low} to {high}",
                f"{count} ({family.sizes.confidence})" if count else "-",
                _strength(family),
            )
        )
    output.table(["Family", "Grades", "d (mm)", "Sizes", "MBL"], rows, numbers=[2, 3, 4])
    output.text(
        "d is the nominal diameter, Sizes the number of those that are sold with the confidence "
        "of the list, MBL the confidence of the breaking load. A list of sizes that is only "
        "recalled (R) is used, for it is no figure of strength."
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


# ------------------------------------------------------------------ one component


def _component(output: Output, family: Family, component: Component) -> None:
    output.text(f"{family.title}: {component.name}", bold=True)
    density = QUANTITIES["density"].format(component.water_density, unit=True)
    output.text(f"Nominal diameter d = {in_mm(component.nominal_diameter)}; in water of {density}.")
    if family.note:
        output.text(family.note)
    output.line()
    output.table(["Quantity", "Value", "Conf.", "Sources"], list(_rows(component)), numbers=[1])
    others = [_other(each) for each in component.alternatives]
    if others:
        columns = ["Also published: --variant", "Value", "Conf.", "Sources"]
        output.table(columns, others, numbers=[1])
    output.text("How each figure follows", bold=True)
    for key, origin in component.provenance.items():
        output.text(
            f"  {_words(key)}{_named(origin.variant)}: {_explained(origin.formula, origin)}"
        )
    for key, why in component.missing.items():
        output.text(f"  {_words(key)}: not known; {why}.")
    output.line()
    _warn(output, [component])


def _rows(component: Component) -> Iterator[Row]:
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
            yield _row(name, QUANTITIES[unit].format(value, unit=True), origins[key])
        if key == "MBL" and component.wet_strength_factor is not None:
            wet = QUANTITIES["MBL"].format(component.MBL_in_water, unit=True)
            yield _row("MBL in water", wet, origins["wet_strength_factor"])
        if key == "EA" and component.EA_dynamic_terms is not None:
            constant, slope = component.EA_dynamic_terms
            text = f"{constant:g} + {slope:g} Lm"
            yield _row("Dynamic EA over MBL", text, origins["EA_dynamic"])
    for key, name in _COEFFICIENTS.items():
        found: Hydrodynamic | None = getattr(component, key)
        if found is not None:
            yield _row(name, f"{found.coefficient:g}", origins[key])
            yield f"  {_which(key, found)}", _in_mm(found.diameter), "", ""


def _which(key: str, found: Hydrodynamic) -> str:
    """Name the diameter that a coefficient is referred to."""
    if found.name == "volume":
        return "volume-equivalent diameter"
    return f"{'drag diameter' if key.startswith('drag') else 'diameter'} {found.name}"


def _in_mm(diameter: float) -> str:
    return QUANTITIES["drag_diameter"].format(diameter, unit=True)


def _row(name: str, value: str, origin: Provenance) -> Row:
    return name, value, origin.confidence, _keys(origin.sources)


def _other(other: Alternative) -> Row:
    value = "-" if other.value is None else _value(other.quantity, other.value)
    if other.reference is not None:
        value += f" on {_in_mm(other.reference)}"
    return _row(f"{other.quantity}={other.variant}", value, other.provenance)


def _value(key: str, value: float) -> str:
    quantity = {"mass": "mass_per_length", "EA_dynamic": "EA"}.get(key, key)
    if quantity in QUANTITIES:
        return QUANTITIES[quantity].format(value, unit=True)
    return f"{value:g}"


def _keys(sources: Iterable[Source]) -> str:
    return ", ".join(source.key for source in sources)


def _named(variant: str) -> str:
    return f" ({variant})" if variant else ""


def _words(key: str) -> str:
    text = SPECS[key].words if key in SPECS else "submerged weight per length"
    return text[:1].upper() + text[1:]


def _explained(formula: str, origin: Provenance | Figure) -> str:
    """Say how a figure follows, for which diameters, who has it and why it is the default."""
    low, high = (in_mm(end) for end in origin.range)
    known = f"{formula}; {low} to {high}. {origin.confidence}, {_keys(origin.sources)}: "
    reason = f"Default: {origin.reason}." if origin.reason else ""
    return " ".join(part for part in (f"{known}{origin.place}.", reason, origin.note) if part)


# ------------------------------------------------------------------ a family over its sizes


def _sizes(output: Output, family: Family, components: Sequence[Component]) -> None:
    output.text(family.title, bold=True)
    if family.note:
        output.text(family.note)
    if not components:
        output.text(f"Nominal diameters {family.known_range}; no list of sizes is known.")
        output.line()
        return
    output.line()
    grades = list(dict.fromkeys(component.grade for component in components))
    if len(grades) == 1:
        _one_grade(output, components)
    else:
        _all_grades(output, components, [grade for grade in grades if grade])
    _sizes_from(output, family)
    _warn(output, components)


def _one_grade(output: Output, components: Sequence[Component]) -> None:
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
    columns += [*(["Proof (kN)"] if with_proof else []), "EA (MN)", "USD/m"]
    output.table(columns, rows, numbers=range(len(columns)))
    factor = components[0].wet_strength_factor
    wet = "" if factor is None else f" MBL is that of the dry rope, in water {factor:g} of it."
    output.text(_SYMBOLS + wet)


def _all_grades(output: Output, components: Sequence[Component], grades: Sequence[str]) -> None:
    by_size: dict[float, dict[str | None, Component]] = {}
    for component in components:
        by_size.setdefault(component.nominal_diameter, {})[component.grade] = component
    first = [next(iter(by_size[diameter].values())) for diameter in sorted(by_size)]
    output.table(
        ["d (mm)", "m (kg/m)", "w (N/m)", "D (mm)"],
        [_common(component) for component in first],
        numbers=range(4),
    )
    output.text(_SYMBOLS)
    output.line()
    rows = [
        [
            f"{round(diameter * 1e3, 6):g}",
            *(_MBL(by_size[diameter].get(grade)) for grade in grades),
        ]
        for diameter in sorted(by_size)
    ]
    columns = ["d (mm)", *grades]
    output.table(columns, rows, title="MBL (kN) by grade", numbers=range(len(columns)))


def _common(component: Component) -> list[str]:
    return [
        f"{round(component.nominal_diameter * 1e3, 6):g}",
        QUANTITIES["mass_per_length"].format(component.mass),
        QUANTITIES["submerged_weight"].format(component.submerged_weight, digits=1),
        QUANTITIES["volume_diameter"].format(component.volume_diameter),
    ]


def _MBL(component: Component | None) -> str:
    return QUANTITIES["MBL"].format(component.MBL if component else None, digits=0)


def _sizes_from(output: Output, family: Family) -> None:
    sizes = family.sizes
    keys = _keys(sizes.sources)
    recalled = " Recalled: ask a maker." if sizes.confidence == RECALLED else ""
    output.text(f"Sizes: {keys}, {sizes.place} ({sizes.confidence}).{recalled}")
    output.line()


def _figures(output: Output, family: Family, components: Sequence[Component]) -> None:
    """Explain every figure of the grades that are shown."""
    grades = {component.grade for component in components} or set(family.grades or (None,))
    output.text("How each figure follows", bold=True)
    for figure in family.figures:
        if any(figure.holds_for(grade) for grade in grades):
            of = f" of {', '.join(figure.grades)}" if figure.grades else ""
            head = f"{_words(figure.quantity)}{of}{_named(figure.variant)}"
            output.text(f"  {head}: {_explained(figure.text, figure)}")
    output.line()


# ------------------------------------------------------------------ search


def _search(output: Output, answer: Answer) -> None:
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
    columns = ["Component", "m (kg/m)", "w (N/m)", "MBL (kN)", "USD/m", "Conf."]
    output.table(columns, rows, numbers=[1, 2, 3, 4])
    output.text(
        "m mass in air, w weight in water per length, MBL in water, new; Conf. is that of the MBL. "
        "catopt catalog show has the sources."
    )
    recalled = [f.name for f in answer.families if f.sizes.confidence == RECALLED]
    if recalled:
        output.text(f"Sizes from lists that are only recalled (R): {', '.join(recalled)}.")
    _warn(output, answer.components)


# ------------------------------------------------------------------ common


def _warn(output: Output, components: Iterable[Component]) -> None:
    """Name what rests on figures that were read in no document."""
    recalled = {key for component in components for key in component.recalled}
    if recalled:
        named = ", ".join(_words(key).lower() for key in SPECS if key in recalled)
        output.text(f"R, only recalled and read in no document: {named}. Check before use.")
        output.line()


def _sources(output: Output, answer: Answer) -> None:
    used = {s for c in answer.components for p in c.provenance.values() for s in p.sources}
    if len(answer.components) == 1:
        used |= {s for a in answer.components[0].alternatives for s in a.provenance.sources}
        used |= set(answer.families[0].sizes.sources)
    output.text("Sources", bold=True)
    for source in answer.sources:
        if source in used or len(answer.components) != 1:
            output.text(f"  {source.key}: {source.title}. {source.place}.")
    output.line()
