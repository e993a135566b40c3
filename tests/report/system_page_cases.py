"""Moored bodies for the tests of their calculation note, each held in a way of its own."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from catopt.notes.system import SystemNote, read_system_note
from catopt.words import Language

from .page_cases import CASES, own_case
from .page_reader import ReadPage, read_page
from .rendered import page_of

TURRET = "fso-rang-dong"
"""The case file that comes with catopt: nine lines in three bundles, force along one of them."""

TEXTS = {
    name: own_case({"raised": "raised-anchors"}.get(name, name))
    for name in ("arms", "raised", "idle", "pulled", "lee", "lone")
}
"""Case files as texts, each with a remark of what it is for."""

EVERY = (TURRET, *TEXTS)
"""Names of all cases."""


@cache
def known_note(name: str) -> SystemNote:
    """Read the note of a case, once: it is a value, so that tests may share it."""
    with TemporaryDirectory() as folder:
        return read_system_note(system_path(Path(folder), name))


@cache
def known_page(name: str, language: Language = "en") -> ReadPage:
    """Read the page of a case back, once."""
    return read_page(page_of(known_note(name), language))


def system_path(folder: Path, name: str) -> Path:
    """Return the path of a case; one of the texts is written to a folder."""
    if name == TURRET:
        return CASES / name / "case.toml"
    path = folder / f"{name}.toml"
    path.write_text(TEXTS[name], encoding="utf-8")
    return path
