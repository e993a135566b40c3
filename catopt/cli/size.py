"""``catopt size``: from buoy or ship, depth and weather to a mooring."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.completion import buoys, completed
from catopt.cli.options import JsonOption, LangOption, OutOption, ReportLanguage
from catopt.cli.size_options import with_inputs
from catopt.cli.units_option import in_units

if TYPE_CHECKING:
    from catopt.casefile.sizing_file import Moored
    from catopt.words import Language

size = typer.Typer(
    name="size",
    rich_markup_mode=None,
    no_args_is_help=True,
    help="Size the mooring of a buoy or a tanker from its place and its weather.",
    epilog="On a terminal, what is missing is asked for. The loads are those of catopt loads, the "
    "line is searched as by catopt design; --save writes the case of it.",
)

SaveOption = Annotated[
    Path | None,
    typer.Option(
        "--save",
        metavar="CASE",
        help="Write a case file of the recommended line here, which design, check and solve take. "
        "A file that is already there is never overwritten.",
    ),
]


@size.command()
@in_units
@with_inputs("buoy")
def buoy(
    context: typer.Context,
    name: Annotated[
        str | None,
        typer.Argument(
            metavar="BUOY",
            autocompletion=completed(buoys),
            help='Name of the buoy, such as "pillar 1.8 m", or a file (.toml) with what is known; '
            "or give --force and --reserve-buoyancy.",
        ),
    ] = None,
    *,
    save: SaveOption = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
    **inputs: Any,
) -> None:
    """Size the chain and the sinker of a buoy.

    Wind, current and waves come from one side, after IALA's CALMAR reference. The chain is
    checked by IALA's rules under the storm at high and at low water; what is not given is taken,
    and the answer says so. What is given as an option goes before what a file says.
    """
    place = name if is_file(name) else None
    options = {"buoy": None if place else name, **inputs}
    _size(context, "buoy", place, options, lang.value, as_json=as_json, out=out, save=save)


@size.command()
@in_units
@with_inputs("tanker")
def tanker(
    context: typer.Context,
    file: Annotated[
        str | None,
        typer.Argument(metavar="FILE", help="File (.toml) with what is known; or give options."),
    ] = None,
    *,
    save: SaveOption = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
    **inputs: Any,
) -> None:
    """Size the chain and the anchor of a tanker's mooring.

    One line from the bow, one leg from a mooring buoy with a hawser (--buoy), or several lines
    around a buoy or a turret (--lines). The ship lies head to wind, current and waves; what is not
    given is taken or estimated, and the answer says so. What is given as an option goes before
    what a file says.
    """
    _size(context, "tanker", file, inputs, lang.value, as_json=as_json, out=out, save=save)


def is_file(name: str | None) -> bool:
    """Say whether what stands where a buoy's name may stand is a file."""
    import os

    if name is None:
        return False
    return name.endswith(".toml") or "/" in name or os.sep in name or Path(name).is_file()


def _size(
    context: typer.Context,
    moored: Moored,
    place: str | None,
    options: dict[str, Any],
    language: Language,
    *,
    as_json: bool,
    out: Path | None,
    save: Path | None,
) -> None:
    from catopt.cli.size_answer import check_places, give
    from catopt.cli.size_note import given_to_size
    from catopt.cli.size_options import as_option, by_option, typed
    from catopt.cli.wizard import asked
    from catopt.sizing.file import read_file
    from catopt.sizing.known import known
    from catopt.sizing.requests import size as size_known

    check_places(out, save)
    spell = by_option if moored == "buoy" else as_option
    given = typed(moored, options)
    if place is None:
        given = asked(moored, given, {}, spell, language)
        found = size_known(known(moored, given, spell, "options"))
    else:
        file = read_file(place, moored)
        with file.telling():
            if not file.findings:
                given = asked(moored, given, file.given(given), spell, language)
            found = size_known(file.known(given, spell))
    note = given_to_size(place, given, spell)
    give(context.obj, found, language, as_json=as_json, out=out, save=save, given=note)
