"""``catopt catalog``: chain, wire and fibre rope with the source of every figure."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.answering import Asked, answering
from catopt.cli.completion import completed
from catopt.cli.help_words import WithWords, group
from catopt.cli.options import ForceOption, LengthOption, TablesOutOption
from catopt.cli.values import by_option, given_ones, in_si, refuse
from catopt.errors import NoAnswerError, Problem
from catopt.units import Dimension, as_written

if TYPE_CHECKING:
    from catopt.catalogue import Catalogue, Component

catalog = group("catalog")

FamiliesOption = Annotated[Path | None, typer.Option("--families", metavar="FILE")]
VariantOption = Annotated[list[str] | None, typer.Option("--variant", metavar="QUANTITY=NAME")]
RecalledOption = Annotated[bool, typer.Option("--recalled")]
WaterOption = Annotated[str | None, typer.Option("--water-density", metavar="DENSITY")]
_FAMILY = typer.Argument(metavar="FAMILY", autocompletion=completed("family"))
_GRADE = typer.Argument(metavar="GRADE", autocompletion=completed("grade"))


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
    diameter: LengthOption = None,
    variant: VariantOption = None,
    recalled: RecalledOption = False,
    water_density: WaterOption = None,
    families: FamiliesOption = None,
) -> None:
    """Show a component in full, or a family over its sizes."""
    values = in_si(
        {
            "--diameter": (diameter, Dimension.LENGTH),
            "--water-density": (water_density, Dimension.DENSITY),
        }
    )
    known = _catalogue(families)
    settings = _settings(variant, recalled, values)
    size = values.get("--diameter")
    components: tuple[Component, ...]
    with _by_option({"component": "FAMILY", "grade": "GRADE"}):
        parsed = known.parse_name(family)
        found = known.family(family)
        settings["grade"] = grade if grade is not None else parsed.grade
        if size is not None:
            components = (known.component(found.name, size, **settings),)
        else:
            components = known.sold(found.name, **settings)
    _give(asked, "show", (found,), components, in_full=size is not None)


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
    of = {component.family for component in found}
    theirs = tuple(each for each in known.families if each.name in of)
    _give(asked, "search", theirs, found)


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


def _settings(
    variants: Sequence[str] | None, recalled: bool, values: dict[str, float]
) -> dict[str, Any]:
    """Gather what a look-up and a search have in common."""
    pairs = [text.partition("=") for text in variants or ()]
    wanted = "QUANTITY=NAME is wanted, such as EA=orcaflex"
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
    from catopt.quantities import QUANTITIES

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
        raise NoAnswerError("no component fits")
    strongest = max(strong, key=lambda component: component.MBL_in_water or 0.0)
    load = QUANTITIES["MBL"].format(strongest.MBL_in_water, unit=True)
    raise NoAnswerError(
        f"no component fits; the strongest that was searched is {strongest.name} with {load}"
    )


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


def _give(asked: Asked, *parts: Any, in_full: bool = False) -> None:
    from catopt.answers.catalogue import catalogue_answer
    from catopt.catalogue.document import Answer

    asked.check_place()
    answer = Answer(*parts)
    asked.give(catalogue_answer(answer, in_full=in_full), answer.to_dict)
