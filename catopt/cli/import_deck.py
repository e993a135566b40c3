"""``catopt import``: an input file of another program as a case file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from catopt._version import identity
from catopt.casefile import write_case
from catopt.cli.answering import Asked, answering
from catopt.cli.options import CountOption, LengthOption, PlaceOption
from catopt.cli.values import positive, refused
from catopt.decks.reading import Asked as Missing
from catopt.decks.reading import is_deck, is_yaml, read_any_deck, refuse_yaml
from catopt.documents import parse_toml, read_text
from catopt.errors import InputError
from catopt.model.kinds import Findings
from catopt.units import Dimension, bare_number, to_si
from catopt.words import Message


def _is_case(text: str) -> bool:
    try:
        return bool({"site", "line", "points"} & parse_toml(text, "").keys())
    except InputError:
        return False


@answering(PlaceOption, without=["units"])
def import_deck(
    asked: Asked,
    file: Annotated[Path, typer.Argument(metavar="FILE")],
    gravity: Annotated[str | None, typer.Option(metavar="ACCELERATION")] = None,
    density: Annotated[str | None, typer.Option(metavar="DENSITY")] = None,
    depth: LengthOption = None,
    line: CountOption = None,
    turbine: Annotated[list[str] | None, typer.Option(metavar="X,Y")] = None,
) -> None:
    """Read an input file of another mooring program, and write it as a case file."""
    found = Findings("options")
    missing = Missing(
        gravity=positive(found, "--gravity", gravity, Dimension.ACCELERATION),
        density=positive(found, "--density", density, Dimension.DENSITY),
        depth=positive(found, "--depth", depth, Dimension.LENGTH),
        line=line,
        turbines=tuple(_place(found, place) for place in turbine or ()),
    )
    if line is not None:
        found.number("--line", line, "", at_least=1)
    found.raise_if_any()
    text = read_text(file, str(file), kind="input file", broken=True)
    if not is_deck(text) and is_yaml(text, str(file)):
        raise refuse_yaml(text, str(file))
    if not is_deck(text) and _is_case(text):
        raise refused("FILE", str(file), Message("refused_command.is_a_case_already", file=file))
    if not is_deck(text):
        raise refused("FILE", str(file), Message("refused_command.input_file_moordyn_or_map"))
    read, remarks = read_any_deck(text, str(file), missing)
    case = write_case(read)

    def document(path: str | None) -> dict[str, Any]:
        return {
            "schema": "catopt.import/1",
            "catopt": identity(),
            "title": read.title,
            "path": path,
            "remarks": list(remarks),
            "text": case if path is None else None,
        }

    asked.give_file("case.toml", case, document, remarks, keep=file)


def _place(found: Findings, text: str) -> tuple[float, float]:
    """Read x and y of a turbine, m; what is wrong is noted."""
    parts = [part.strip() for part in text.replace(";", ",").split(",")]
    try:
        x, y = (to_si(bare_number(part), Dimension.LENGTH, "--turbine") for part in parts)
    except InputError as error:
        found.problems += error.problems
    except ValueError:
        found.add("--turbine", text, Message("refused_command.x_and_y_of_turbine"))
    else:
        return x, y
    return 0.0, 0.0
