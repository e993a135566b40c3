"""``catopt catalog``: chain, wire and fibre rope with the source of every figure."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.completion import completed, grades
from catopt.cli.completion import families as families_of_all
from catopt.cli.options import JsonOption, LangOption, ReportLanguage, TablesOutOption
from catopt.cli.units_option import in_units

if TYPE_CHECKING:
    from catopt.catalogue import Catalogue, Component
    from catopt.catalogue.document import Answer

catalog = typer.Typer(
    name="catalog",
    rich_markup_mode=None,
    no_args_is_help=True,
    help="Look up chain, wire and fibre rope, every figure with its source.",
    epilog="Confidence: A read in the primary or official document; B in two independent "
    "secondary sources, or in one and checked by numbers; C in one secondary source; R recalled, "
    "read in no document, and used only with --recalled.",
)

FamiliesOption = Annotated[
    Path | None,
    typer.Option(
        "--families", metavar="FILE", help="File of families of your own (TOML), beside catopt's."
    ),
]

VariantOption = Annotated[
    list[str] | None,
    typer.Option(
        "--variant",
        metavar="QUANTITY=NAME",
        help="Where sources disagree, which one to follow, such as EA=orcaflex; all=NAME for every "
        "quantity that has it. May be given several times.",
    ),
]

RecalledOption = Annotated[
    bool,
    typer.Option("--recalled", help="Also use figures that were read in no document (R)."),
]

WaterOption = Annotated[
    str | None,
    typer.Option(
        "--water-density",
        metavar="DENSITY",
        help='For the weight in water, such as "1000 kg/m^3"; 1025 kg/m^3 when left out.',
    ),
]


@catalog.command("list")
@in_units
def list_families(
    context: typer.Context,
    families: FamiliesOption = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: TablesOutOption = None,
) -> None:
    """List the families, their grades and diameters."""
    from catopt.catalogue.document import Answer

    _give(context, Answer("list", _catalogue(families).families), lang, as_json, out)


@catalog.command()
@in_units
def show(
    context: typer.Context,
    family: Annotated[
        str,
        typer.Argument(
            metavar="FAMILY",
            autocompletion=completed(families_of_all),
            help='Family, such as "chain studless".',
        ),
    ],
    grade: Annotated[
        str | None,
        typer.Argument(
            metavar="GRADE",
            autocompletion=completed(grades),
            help="Grade, such as R3; all when left out.",
        ),
    ] = None,
    diameter: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help='Nominal diameter, such as "76 mm", for one component in full; a table over the '
            "sizes that are sold when left out.",
        ),
    ] = None,
    variant: VariantOption = None,
    recalled: RecalledOption = False,
    water_density: WaterOption = None,
    families: FamiliesOption = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: TablesOutOption = None,
) -> None:
    """Show a component in full, or a family over its sizes.

    Every figure comes with its source and confidence. Diameters are said in full: nominal,
    volume-equivalent, and the one that each coefficient is referred to.
    """
    from catopt.catalogue.document import Answer
    from catopt.cli.values import in_si
    from catopt.units import Dimension

    values = in_si(
        {
            "--diameter": (diameter, Dimension.LENGTH),
            "--water-density": (water_density, Dimension.DENSITY),
        }
    )
    known = _catalogue(families)
    settings = _settings(variant, recalled, values)
    with _by_option({"component": "FAMILY", "grade": "GRADE"}):
        parsed = known.parse_name(family)
        found = known.family(family)
        settings["grade"] = grade if grade is not None else parsed.grade
        if "--diameter" in values:
            one = known.component(found.name, values["--diameter"], **settings)
            components: tuple[Component, ...] = (one,)
        else:
            components = known.sold(found.name, **settings)
    answer = Answer("show", (found,), components)
    _give(context, answer, lang, as_json, out, in_full="--diameter" in values)


@catalog.command()
@in_units
def search(
    context: typer.Context,
    mbl: Annotated[
        str | None,
        typer.Option(
            "--mbl", metavar="FORCE", help='Least breaking load in water, such as "500 kN".'
        ),
    ] = None,
    proof_load: Annotated[
        str | None, typer.Option(metavar="FORCE", help="Least proof load.")
    ] = None,
    mass: Annotated[
        str | None,
        typer.Option(metavar="MASS", help='Largest mass in air per length, such as "50 kg/m".'),
    ] = None,
    price: Annotated[
        float | None, typer.Option(metavar="USD", help="Largest price per metre, in dollars.")
    ] = None,
    min_diameter: Annotated[
        str | None, typer.Option(metavar="LENGTH", help="Least nominal diameter.")
    ] = None,
    max_diameter: Annotated[
        str | None, typer.Option(metavar="LENGTH", help="Largest nominal diameter.")
    ] = None,
    family: Annotated[
        list[str] | None,
        typer.Option(
            metavar="FAMILY", help="Only this family, or family and grade; several may be given."
        ),
    ] = None,
    grade: Annotated[
        list[str] | None,
        typer.Option(metavar="GRADE", help="Only this grade; several may be given."),
    ] = None,
    all_sizes: Annotated[
        bool,
        typer.Option(
            "--all-sizes", help="Every size that fits, not the smallest of each family and grade."
        ),
    ] = False,
    variant: VariantOption = None,
    recalled: RecalledOption = False,
    water_density: WaterOption = None,
    families: FamiliesOption = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: TablesOutOption = None,
) -> None:
    """Find components that are strong or light enough.

    In the sizes that are sold, from the lightest to the heaviest. When nothing fits, the exit
    status is 3 and the message names the strongest there is.
    """
    from catopt.catalogue.document import Answer
    from catopt.cli.values import in_si
    from catopt.units import Dimension

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
    asked = {"family": family, "grade": grade, **_settings(variant, recalled, values)}
    found = _search(known, values, asked, all_sizes=all_sizes)
    of = {component.family for component in found}
    theirs = tuple(each for each in known.families if each.name in of)
    _give(context, Answer("search", theirs, found), lang, as_json, out)


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
    from catopt.errors import InputError, Problem
    from catopt.units import as_written

    pairs = [text.partition("=") for text in variants or ()]
    wrong = ["".join(pair) for pair in pairs if not (pair[0] and pair[2])]
    if wrong:
        wanted = "QUANTITY=NAME is wanted, such as EA=orcaflex"
        raise InputError(
            [Problem("--variant", as_written(text), wanted) for text in wrong], "options"
        )
    settings: dict[str, Any] = {"allow_recalled": recalled}
    settings["variants"] = {pair[0].strip(): pair[2].strip() for pair in pairs}
    if "--water-density" in values:
        settings["water_density"] = values["--water-density"]
    return settings


def _search(
    known: Catalogue, values: dict[str, float], asked: dict[str, Any], *, all_sizes: bool
) -> tuple[Component, ...]:
    """Search; an empty answer is an error that names the nearest miss."""
    from catopt import catalogue
    from catopt.errors import NoAnswerError

    limits: dict[str, Any] = {
        name: values[option] for option, name in _LIMITS.items() if option in values
    }
    with _by_option({name: option for option, name in _LIMITS.items()}):
        found = catalogue.search(among=known, all_sizes=all_sizes, **limits, **asked)
        every = found or catalogue.search(among=known, all_sizes=True, **asked)
    if not found:
        raise NoAnswerError(_nothing(every))
    return found


def _nothing(every: Sequence[Component]) -> str:
    """Say that nothing fits, and what the strongest is that was searched."""
    from catopt.quantities import QUANTITIES

    strong = [component for component in every if component.MBL_in_water is not None]
    if not strong:
        return "no component fits"
    strongest = max(strong, key=lambda component: component.MBL_in_water or 0.0)
    load = QUANTITIES["MBL"].format(strongest.MBL_in_water, unit=True)
    return f"no component fits; the strongest that was searched is {strongest.name} with {load}"


@contextmanager
def _by_option(names: dict[str, str]) -> Iterator[None]:
    """Tell what is wrong by the names of arguments and options."""
    from dataclasses import replace

    from catopt.errors import InputError

    names = {
        "variants": "--variant",
        "diameter": "--diameter",
        "water_density": "--water-density",
        "family": "--family",
        "grade": "--grade",
    } | names
    try:
        yield
    except InputError as error:
        problems = []
        for problem in error.problems:
            key, dot, rest = problem.key.partition(".")
            shown = f"{names[key]} {rest}" if dot and key in names else names.get(key, problem.key)
            problems.append(replace(problem, key=shown))
        raise InputError(problems, error.source) from error


def _give(
    context: typer.Context,
    answer: Answer,
    lang: ReportLanguage,
    as_json: bool,
    out: Path | None,
    *,
    in_full: bool = False,
) -> None:
    from catopt.answers.catalogue import catalogue_answer
    from catopt.cli.result_files import Asked

    asked = Asked(context.obj, lang, as_json, out)
    asked.give(catalogue_answer(answer, in_full=in_full), answer.to_dict)
