"""``catopt catalog``: chain, wire and fibre rope with the source of every figure."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.answering import Asked, answering
from catopt.cli.completion import completed
from catopt.cli.help_words import WithWords, group
from catopt.cli.options import ForceOption, LengthOption, TablesOutOption
from catopt.cli.values import by_option, given_ones, in_si, refuse, refused
from catopt.errors import InputError, NoAnswerError, Problem
from catopt.units import Dimension, as_written
from catopt.words import Measure, Message, say, typed_name

if TYPE_CHECKING:
    from catopt.catalogue import Catalogue, Component, Family

catalog = group("catalog")

FamiliesOption = Annotated[Path | None, typer.Option("--families", metavar="FILE")]
VariantOption = Annotated[list[str] | None, typer.Option("--variant", metavar="QUANTITY=NAME")]
RecalledOption = Annotated[bool, typer.Option("--recalled")]
WaterOption = Annotated[str | None, typer.Option("--water-density", metavar="DENSITY")]
_FAMILY = typer.Argument(metavar="FAMILY", autocompletion=completed("family"))
_GRADE = typer.Argument(metavar="GRADE", autocompletion=completed("grade"))
_ANCHOR = typer.Argument(metavar="ANCHOR", autocompletion=completed("anchor"))
MassOption = Annotated[str | None, typer.Option(metavar="MASS")]
SoilOption = Annotated[str | None, typer.Option(metavar="SOIL")]


@catalog.command("list", cls=WithWords)
@answering(TablesOutOption)
def list_families(asked: Asked, families: FamiliesOption = None) -> None:
    """List the families, their grades and diameters."""
    _give(asked, "list", _catalogue(families).families)


@catalog.command(cls=WithWords)
@answering(TablesOutOption)
def show(
    asked: Asked,
    family: Annotated[str, _FAMILY],
    grade: Annotated[str | None, _GRADE] = None,
    size: Annotated[str | None, typer.Argument(metavar="SIZE")] = None,
    diameter: LengthOption = None,
    variant: VariantOption = None,
    recalled: RecalledOption = False,
    water_density: WaterOption = None,
    families: FamiliesOption = None,
) -> None:
    """Show a component in full, or a family over its sizes."""
    known = _catalogue(families)
    family, grade, size = _sized(known, family, grade, size)
    if size is not None and diameter is not None:
        allowed = Message("refused_command.size_named_already_leave")
        raise refused("--diameter", as_written(diameter), allowed)
    diameter = diameter if size is None else size
    values = in_si(
        {
            "--diameter": (diameter, Dimension.LENGTH),
            "--water-density": (water_density, Dimension.DENSITY),
        }
    )
    settings = _settings(variant, recalled, values)
    nominal = values.get("--diameter")
    components: tuple[Component, ...]
    with _by_option({"component": "FAMILY", "grade": "GRADE"}):
        parsed = known.parse_name(family)
        found = known.family(family)
        settings["grade"] = grade if grade is not None else parsed.grade
        if nominal is not None:
            components = (known.component(found.name, nominal, **settings),)
        else:
            components = known.sold(found.name, **settings)
    _give(asked, "show", (found,), components, in_full=nominal is not None)


@catalog.command(cls=WithWords)
@answering(TablesOutOption)
def find(
    asked: Asked,
    words: Annotated[list[str], typer.Argument(metavar="WORDS")],
    families: FamiliesOption = None,
) -> None:
    """Find components, anchors and fittings by what they are called."""
    from catopt.catalogue.finding import find as find_all
    from catopt.loads.holding_table import anchor_holdings

    known = _catalogue(families)
    with _by_option({"component": "WORDS", "size": "WORDS"}):
        found = find_all(" ".join(words), known)
        query = found.query
        fitting = [
            kind
            for kind in found.anchors
            if query.mass is None or kind.range[0] <= query.mass <= kind.range[1]
        ]
        held = anchor_holdings(
            fitting or found.anchors, query.soil, query.mass, allow_recalled=True
        )
    theirs = _families_of(found.components, known)
    _give(asked, "find", theirs, found.components, anchors=held, fittings=found.fittings)
    if found.left_out:
        more = Message("catalogue.left_out", count=found.left_out)
        asked.output.note(f"note: {say(more, asked.language)}")


@catalog.command(cls=WithWords)
@answering(TablesOutOption)
def anchor(
    asked: Asked,
    name: Annotated[str, _ANCHOR],
    mass: MassOption = None,
    soil: SoilOption = None,
    recalled: RecalledOption = False,
) -> None:
    """Show what a drag anchor holds."""
    from catopt.catalogue.finding import SOILS
    from catopt.loads.holding_table import anchor_holdings, named_anchors

    values = in_si({"--mass": (mass, Dimension.MASS)})
    with _by_option({"anchor": "ANCHOR", "mass": "--mass", "soil": "--soil"}):
        of = None if soil is None else SOILS.get(typed_name(soil).casefold(), soil)
        held = anchor_holdings(
            named_anchors(name), of, values.get("--mass"), allow_recalled=recalled
        )
    _give(asked, "anchor", (), anchors=held)


@catalog.command(cls=WithWords)
@answering(TablesOutOption)
def fittings(
    asked: Asked,
    family: Annotated[str, _FAMILY],
    grade: Annotated[str | None, _GRADE] = None,
    size: Annotated[str | None, typer.Argument(metavar="SIZE")] = None,
    families: FamiliesOption = None,
) -> None:
    """Find the shackle, the swivel and the sinker ring that go with a chain."""
    from catopt.catalogue.fittings import fittings_for

    known = _catalogue(families)
    family, grade, size = _sized(known, family, grade, size)
    if size is None:
        raise refused("SIZE", "", Message("refused_command.missing_nominal_diameter_wanted_such"))
    nominal = in_si({"SIZE": (size, Dimension.LENGTH)})["SIZE"]
    with _by_option({"component": "FAMILY", "grade": "GRADE", "diameter": "SIZE"}):
        parsed = known.parse_name(family)
        own = grade if grade is not None else parsed.grade
        chain = known.component(parsed.family, nominal, grade=own)
        chain.need("MBL")
        assert chain.MBL is not None
        found = fittings_for(chain.name, nominal, chain.MBL)
    theirs = (known.family(chain.family),)
    _give(
        asked, "fittings", theirs, (chain,), fittings=tuple(found.found.values()),
        uses=tuple(found.found), missing=tuple(found.missing.values()),
    )  # fmt: skip


@catalog.command(cls=WithWords)
@answering(TablesOutOption)
def sinker(
    asked: Asked,
    mass: Annotated[str, typer.Argument(metavar="MASS")],
    material: Annotated[str, typer.Option(metavar="MATERIAL")] = "concrete",
    soil: SoilOption = None,
    base_area: Annotated[str | None, typer.Option(metavar="AREA")] = None,
    water_density: WaterOption = None,
) -> None:
    """Show what a sinker holds on each soil."""
    from catopt.loads.holding_table import sinker_holdings
    from catopt.loads.sinker import soil_named

    values = in_si(
        {
            "MASS": (mass, Dimension.MASS),
            "--base-area": (base_area, Dimension.AREA),
            "--water-density": (water_density, Dimension.DENSITY),
        }
    )
    density = given_ones(water_density=values.get("--water-density"))
    with _by_option({"material": "--material"}):
        held = sinker_holdings(
            values["MASS"], typed_name(material), base_area=values.get("--base-area"), **density
        )
    named = soil if soil is None else soil_named(soil)
    own = [
        holding
        for holding in held
        if named is None or named in holding.soil.split() or named == holding.soil
    ]
    if not own:
        allowed = Message(
            "refused_command.one_mud", listed=", ".join(holding.soil for holding in held)
        )
        raise refused("--soil", as_written(soil), allowed)
    _give(asked, "sinker", (), sinkers=tuple(own))


@catalog.command(cls=WithWords)
@answering(TablesOutOption)
def search(
    asked: Asked,
    mbl: ForceOption = None,
    proof_load: ForceOption = None,
    mass: Annotated[str | None, typer.Option(metavar="MASS")] = None,
    price: Annotated[float | None, typer.Option(metavar="USD")] = None,
    min_diameter: LengthOption = None,
    max_diameter: LengthOption = None,
    family: Annotated[list[str] | None, typer.Option(metavar="FAMILY")] = None,
    grade: Annotated[list[str] | None, typer.Option(metavar="GRADE")] = None,
    all_sizes: Annotated[bool, typer.Option("--all-sizes")] = False,
    variant: VariantOption = None,
    recalled: RecalledOption = False,
    water_density: WaterOption = None,
    families: FamiliesOption = None,
) -> None:
    """Find components that are strong or light enough."""
    values = in_si(
        {
            "--mbl": (mbl, Dimension.FORCE),
            "--proof-load": (proof_load, Dimension.FORCE),
            "--mass": (mass, Dimension.MASS_PER_LENGTH),
            "--min-diameter": (min_diameter, Dimension.LENGTH),
            "--max-diameter": (max_diameter, Dimension.LENGTH),
            "--water-density": (water_density, Dimension.DENSITY),
        }
    )
    if price is not None:
        values["--price"] = price
    known = _catalogue(families)
    wanted = {"family": family, "grade": grade, **_settings(variant, recalled, values)}
    found = _search(known, values, wanted, all_sizes=all_sizes)
    _give(asked, "search", _families_of(found, known), found)


# ------------------------------------------------------------------ parts of the commands

_LIMITS = {
    "--mbl": "MBL_at_least",
    "--proof-load": "proof_load_at_least",
    "--mass": "mass_at_most",
    "--price": "price_at_most",
    "--min-diameter": "diameter_at_least",
    "--max-diameter": "diameter_at_most",
}
"""Options of a search by what they are called in Python."""


def _catalogue(families: Path | None) -> Catalogue:
    """Take catopt's catalogue, with the user's own families where there are any."""
    from catopt import catalogue

    if families is None:
        return catalogue.standard()
    return catalogue.standard().with_families(catalogue.read_families(families))


def _sized(
    known: Catalogue, family: str, grade: str | None, size: str | None
) -> tuple[str, str | None, str | None]:
    """Tell family, grade and size apart, wherever the size was named; a bare number is in mm."""
    from catopt.catalogue.family import split_size

    name, own = split_size(family)
    given = [text for text in (own, size) if text is not None]
    if grade is not None:
        grades: tuple[str, ...] = ()
        with suppress(InputError):  # which says later that there is no such family
            grades = known.family(name).grades
        is_size = grade.casefold() not in {sold.casefold() for sold in grades}
        if is_size and split_size(grade)[1] is not None:
            given.append(grade)
            grade = None
    if len(given) > 1:
        allowed = Message("refused_command.size_already", value=given[0])
        raise refused("SIZE", as_written(given[1]), allowed)
    family = family if own is None else name
    if not given:
        return family, grade, None
    bare = given[0].casefold().removeprefix("dn").strip()  # makers write mm, with DN before it
    return family, grade, f"{bare} mm" if bare.replace(".", "", 1).isdigit() else bare


def _families_of(components: Sequence[Component], known: Catalogue) -> tuple[Family, ...]:
    of = {component.family for component in components}
    return tuple(known_family for known_family in known.families if known_family.name in of)


def _settings(
    variants: Sequence[str] | None, recalled: bool, values: dict[str, float]
) -> dict[str, Any]:
    """Gather what a look-up and a search have in common."""
    pairs = [text.partition("=") for text in variants or ()]
    wanted = Message("refused_command.quantity_name_wanted_such_ea")
    refuse(
        Problem("--variant", as_written("".join(pair)), wanted)
        for pair in pairs
        if not (pair[0] and pair[2])
    )
    chosen = {name.strip(): variant.strip() for name, _, variant in pairs}
    density = given_ones(water_density=values.get("--water-density"))
    return {"allow_recalled": recalled, "variants": chosen, **density}


def _search(
    known: Catalogue, values: dict[str, float], wanted: dict[str, Any], *, all_sizes: bool
) -> tuple[Component, ...]:
    """Search; an empty answer is an error that names the nearest miss."""
    from catopt import catalogue

    limits: dict[str, Any] = {
        name: values[option] for option, name in _LIMITS.items() if option in values
    }
    with _by_option({name: option for option, name in _LIMITS.items()}):
        found = catalogue.search(among=known, all_sizes=all_sizes, **limits, **wanted)
        every = found or catalogue.search(among=known, all_sizes=True, **wanted)
    if found:
        return found
    strong = [component for component in every if component.MBL_in_water is not None]
    if not strong:
        raise NoAnswerError(Message("refused_command.no_component_fits"))
    strongest = max(strong, key=lambda component: component.MBL_in_water or 0.0)
    load = Measure("MBL", strongest.MBL_in_water or 0.0)
    raise NoAnswerError(Message("refused_command.strongest_is", name=strongest.name, load=load))


def _by_option(names: dict[str, str]) -> AbstractContextManager[None]:
    """Tell what is wrong by the names of arguments and options."""
    names = {
        "variants": "--variant",
        "diameter": "--diameter",
        "water_density": "--water-density",
        "family": "--family",
        "grade": "--grade",
    } | names

    def named(key: str) -> str:
        first, _, rest = key.partition(".")
        return f"{names[first]} {rest}".rstrip() if first in names else key

    return by_option(named, source="")


def _give(asked: Asked, *parts: Any, in_full: bool = False, **further: Any) -> None:
    from catopt.answers.catalogue import catalogue_answer
    from catopt.catalogue.document import Answer

    asked.check_place()
    answer = Answer(*parts, **further)
    asked.give(catalogue_answer(answer, in_full=in_full), answer.to_dict)
