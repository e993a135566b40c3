"""``catopt import``: an input file of another program as a case file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.options import LANGUAGE_VARIABLE, JsonOption, ReportLanguage

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.decks.reading import Asked


def import_deck(
    context: typer.Context,
    file: Annotated[
        Path,
        typer.Argument(
            metavar="FILE", help="Input file of MoorDyn (v1, v2), MAP++ or OrcaFlex, or ontology."
        ),
    ],
    gravity: Annotated[
        str | None,
        typer.Option(metavar="NUMBER", help="In m/s^2, where the file has none (MAP++)."),
    ] = None,
    density: Annotated[
        str | None,
        typer.Option(metavar="DENSITY", help='Of the water, "1025 kg/m^3", where it has none.'),
    ] = None,
    depth: Annotated[
        str | None,
        typer.Option(metavar="LENGTH", help='Of the water, "200 m", where it has none.'),
    ] = None,
    line: Annotated[
        int | None,
        typer.Option(metavar="N", help="Only line N, counted from 1, between its two ends."),
    ] = None,
    lang: Annotated[
        ReportLanguage,
        typer.Option(
            "--lang",
            metavar="LANGUAGE",
            envvar=LANGUAGE_VARIABLE,
            help="Of the remarks: en, or vi.",
        ),
    ] = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="PLACE",
            help="Case file to write, case.toml or a directory; on standard output when left out. "
            "A file of the same name is replaced.",
        ),
    ] = None,
) -> None:
    """Read an input file of another mooring program, and write it as a case file.

    What decides a number is told on standard error, and with its line all of the file that the
    case has not. What changes the answer and has no place in a case is refused.
    """
    from catopt.casefile import write_case
    from catopt.decks.reading import read_any_deck
    from catopt.documents import read_text
    from catopt.report.files import write_files
    from catopt.words import say

    output: Output = context.obj
    asked = _asked(gravity, density, depth, line)
    text = read_text(file, str(file), kind="input file", broken=True)
    _check_is_deck(text, file)
    found, remarks = read_any_deck(text, str(file), asked)
    case = write_case(found)
    path: str | None = None
    if out is not None:
        place = out if out.suffix and not out.is_dir() else out / "case.toml"
        (written,) = write_files(place.parent, {place.name: case.encode()}, keep=[file])
        path = str(written)
    for remark in remarks:
        output.note(f"note: {say(remark, lang.value)}")
    if as_json:
        document = {
            "schema": "catopt.import/1",
            "title": found.title,
            "path": path,
            "remarks": list(remarks),
            "text": case if path is None else None,
        }
        output.json(document)
    else:
        output.file(case if path is None else f"{path}\n")


def _asked(gravity: str | None, density: str | None, depth: str | None, line: int | None) -> Asked:
    """Read the options; all that is wrong with them is reported at once."""
    from catopt.cli.values import in_si
    from catopt.decks.reading import Asked
    from catopt.errors import InputError
    from catopt.model.validity import Findings
    from catopt.units import Dimension

    wanted = {
        "gravity": (gravity, Dimension.NUMBER, "m/s^2"),
        "density": (density, Dimension.DENSITY, "kg/m^3"),
        "depth": (depth, Dimension.LENGTH, "m"),
    }
    found = Findings("options")
    values: dict[str, float] = {}
    for name, (text, dimension, unit) in wanted.items():
        try:
            read = in_si({f"--{name}": (text, dimension)})
        except InputError as error:
            found.problems += error.problems
            continue
        for option, value in read.items():
            found.number(option, value, unit, above=0.0)
            values[name] = value
    if line is not None:
        found.number("--line", line, "", at_least=1)
    found.raise_if_any()
    return Asked(**values, line=line)


def _check_is_deck(text: str, file: Path) -> None:
    from catopt.decks.reading import is_deck
    from catopt.errors import InputError, Problem

    if not is_deck(text):
        allowed = (
            "an input file of MoorDyn or MAP++ is wanted, which has a section LINE TYPES, or YAML "
            "with mooring_systems or LineTypes"
        )
        raise InputError([Problem("FILE", str(file), allowed)], "options")
