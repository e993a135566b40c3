"""Sizings for the tests of their calculation note, each held or loaded in a way of its own."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from catopt.casefile.sizing_file import Moored
from catopt.cli.note_kind import note_of_sizing
from catopt.notes.size import SizeNote
from catopt.words import Language

from .page_cases import CASES
from .page_reader import ReadPage, read_page
from .rendered import page_of

FILES: dict[str, Moored] = {"size-buoy": "buoy", "size-tanker": "tanker"}
"""Sizing files that come with catopt."""

GIVEN = """
title = "A buoy whose force is given"
[site]
water_depth = "12 m"
[environment]
hs = "1 m"
[buoy]
horizontal_force = "15 kN"
reserve_buoyancy = "30 kN"
[sinker]
friction = 0.5
"""

SHIP = """
[site]
water_depth = "20 m"
low_water = "18.5 m"
[environment]
wind = "20 m/s"
current = "1.2 m/s"
hmax = "3.5 m"
period = "8 s"
[ship]
length = "234 m"
breadth = "31.3 m"
draught = "12.4 m"
moulded_depth = "16 m"
"""

HAWSER = f"""
title = "Two conditions on a mooring buoy, with a clump weight"
{SHIP}
ballast_draught = "3.2 m"
[buoy]
name = "mooring buoy 5.0 m"
[line]
clump_weights = ["10 t"]
prefer = "lightest"
"""

SIX = f"""
title = "Six lines around a turret"
{SHIP}
[line]
diameter_min = "50 mm"
[system]
lines = 6
"""

SINKER = f"""
title = "A tanker on a sinker"
{SHIP}
[sinker]
"""

TEXTS: dict[str, tuple[str, Moored]] = {
    "given": (GIVEN, "buoy"),
    "hawser": (HAWSER, "tanker"),
    "six": (SIX, "tanker"),
    "sinker": (SINKER, "tanker"),
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
