"""``catopt import``: an input file of another program as a case file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.answering import Asked, answering
from catopt.cli.options import CountOption, LengthOption, PlaceOption
from catopt.cli.values import positive, refused
from catopt.units import Dimension

if TYPE_CHECKING:
    from catopt.decks.reading import Asked as AskedOfDeck


@answering(PlaceOption, without=["units"])
def import_deck(
    asked: Asked,
    file: Annotated[Path, typer.Argument(metavar="FILE")],
    gravity: Annotated[str | None, typer.Option(metavar="NUMBER")] = None,
    density: Annotated[str | None, typer.Option(metavar="DENSITY")] = None,
    depth: LengthOption = None,
    line: CountOption = None,
) -> None:
    """Read an input file of another mooring program, and write it as a case file."""
    from catopt.casefile import write_case
    from catopt.decks.reading import is_deck, read_any_deck
    from catopt.documents import read_text

    missing = _missing(gravity, density, depth, line)
    text = read_text(file, str(file), kind="input file", broken=True)
    if not is_deck(text):
        allowed = (
            "an input file of MoorDyn or MAP++ is wanted, which has a section LINE TYPES, or YAML "
            "with mooring_systems or LineTypes"
        )
        raise refused("FILE", str(file), allowed)
    found, remarks = read_any_deck(text, str(file), missing)
    case = write_case(found)

    def document(path: str | None) -> dict[str, Any]:
        return {
            "schema": "catopt.import/1",
            "title": found.title,
            "path": path,
            "remarks": list(remarks),
            "text": case if path is None else None,
        }

    asked.give_file("case.toml", case, document, remarks, keep=file)


def _missing(
    gravity: str | None, density: str | None, depth: str | None, line: int | None
) -> AskedOfDeck:
    """Read what a file may lack; all that is wrong with the options is reported at once."""
    from catopt.decks.reading import Asked
    from catopt.model.validity import Findings

    wanted = {
        "gravity": (gravity, Dimension.NUMBER, "m/s^2"),
        "density": (density, Dimension.DENSITY, "kg/m^3"),
        "depth": (depth, Dimension.LENGTH, "m"),
    }
    found = Findings("options")
    values = {name: positive(found, f"--{name}", *each) for name, each in wanted.items()}
    if line is not None:
        found.number("--line", line, "", at_least=1)
    found.raise_if_any()
    return Asked(**values, line=line)
