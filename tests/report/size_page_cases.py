"""Sizings for the tests of their calculation note, each held or loaded in a way of its own."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from catopt.casefile.sizing_file import Moored
from catopt.cli.note_kind import note_of_sizing
from catopt.notes.size import SizeNote
from catopt.words import Language

from .page_cases import CASES, own_case
from .page_reader import ReadPage, read_page
from .rendered import page_of

FILES: dict[str, Moored] = {"size-buoy": "buoy", "size-tanker": "tanker"}
"""Sizing files that come with catopt."""

TEXTS: dict[str, tuple[str, Moored]] = {
    name: (own_case(f"size-{name}"), "buoy" if name == "given" else "tanker")
    for name in ("given", "hawser", "six", "sinker")
}
"""Sizing files as texts."""

EVERY = (*FILES, *TEXTS)
"""Names of all sizings."""


@cache
def known_size_note(name: str) -> SizeNote:
    """Compute the note of a sizing, once: it is a value, so that tests may share it."""
    with TemporaryDirectory() as folder:
        path, moored = sizing_path(Path(folder), name)
        return note_of_sizing(path, moored)


@cache
def known_size_page(name: str, language: Language = "en") -> ReadPage:
    """Read the page of a sizing back, once."""
    return read_page(page_of(known_size_note(name), language))


def sizing_path(folder: Path, name: str) -> tuple[Path, Moored]:
    """Return the path of a sizing file and its kind; one of the texts is written to a folder."""
    if name in FILES:
        return CASES / name / "sizing.toml", FILES[name]
    text, moored = TEXTS[name]
    path = folder / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    return path, moored
