"""Cases for tests of what a note shows beside the closed form: the swarm, a line in motion."""

from __future__ import annotations

from functools import cache
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory

import openpyxl

from catopt.notes.line import Note, read_note
from catopt.words import Language

from .page_cases import own_case
from .page_reader import ReadPage, read_page
from .rendered import page_of, workbook_of

SWARM, HARMONIC, RANDOM = (own_case(name) for name in ("swarm", "harmonic", "random"))
"""Of a fairlead that goes round; and of two load cases in two seas each, led by a ship."""

RAOS = (
    "period,surge,surge_phase,heave,heave_phase\n3,0,90,0.02,40\n8,0.3,90,0.6,10\n20,0.9,90,1,0\n"
)

_TEXTS = {"swarm": SWARM, "harmonic": HARMONIC, "random": RANDOM}


def further_case(folder: Path, name: str) -> Path:
    """Write a case with its files to a folder."""
    (folder / "rao.csv").write_text(RAOS, encoding="utf-8")
    path = folder / f"{name}.toml"
    path.write_text(_TEXTS[name], encoding="utf-8")
    return path


@cache
def further_note(name: str) -> Note:
    """Compute the note of a case with what it is for, once."""
    with TemporaryDirectory() as folder:
        path = further_case(Path(folder), name)
        return read_note(path, swarm=name == "swarm", motion=name != "swarm", verify=False)


@cache
def further_page(name: str, language: Language = "en") -> ReadPage:
    """Read the page of a case back, once."""
    return read_page(page_of(further_note(name), language))


def same_words(name: str, english: str, vietnamese: str) -> set[str]:
    """List the words of a sheet of the workbook that are the same in both languages.

    Parameters
    ----------
    name : str
        Of the case.
    english, vietnamese : str
        Names of the sheet.
    """
    found = []
    for language, sheet in (("en", english), ("vi", vietnamese)):
        book = openpyxl.load_workbook(BytesIO(workbook_of(further_note(name), language)))  # type: ignore[arg-type]
        cells = (cell for row in book[sheet].iter_rows(values_only=True) for cell in row)
        found.append(
            {cell for cell in cells if isinstance(cell, str) and not cell.lstrip("-")[:1].isdigit()}
        )
    return {text for text in found[0] & found[1] if not text.startswith("=")}
