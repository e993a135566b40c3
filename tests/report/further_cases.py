"""Cases for tests of what a note shows beside the closed form: the swarm, a line in motion."""

from __future__ import annotations

from functools import cache
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory

import openpyxl

from catopt.notes.line import Note, read_note
from catopt.words import Language

from .page_reader import ReadPage, read_page
from .rendered import page_of, workbook_of

SWARM = """
title = "Chain by the swarm"
[site]
water_depth = "20 m"
[line]
[[line.segments]]
length = "55 m"
submerged_weight = "2100 N/m"
MBL = "770 tf"
[load]
horizontal_force = "100 kN"
[checks]
safety_factor = 5.0
[pso]
particles = 40
runs = 3
seed = 7
"""

HARMONIC = """
title = "A chain in motion"
[site]
water_depth = "20 m"
[line]
[[line.segments]]
name = "chain"
length = "120 m"
submerged_weight = "1110 N/m"
mass = "130 kg/m"
EA = "400 MN"
MBL = "3000 kN"
drag_diameter = "76 mm"
drag_normal = 2.4
drag_axial = 1.15
[load]
horizontal_force = "300 kN"
[checks]
safety_factor = 3.0
[motion]
period = "8 s"
surge = "0.5 m"
heave = "0.2 m"
heave_phase = "90 deg"
[dynamics]
duration = "40 s"
elements = 20
"""
"""The fairlead goes round; at its largest the tension is well above that at rest."""

RANDOM = """
title = "Chain and wire in a sea"
[site]
water_depth = "20 m"
seabed_friction = 0.4
[line]
[[line.segments]]
name = "chain"
length = "80 m"
submerged_weight = "1110 N/m"
mass = "130 kg/m"
EA = "400 MN"
MBL = "2500 kN"
drag_diameter = "76 mm"
drag_normal = 2.4
[[line.segments]]
name = "wire"
length = "40 m"
submerged_weight = "200 N/m"
mass = "25 kg/m"
EA = "200 MN"
MBL = "1500 kN"
drag_diameter = "60 mm"
drag_normal = 1.2
added_mass_normal = 1.0
[[load_cases]]
name = "storm"
horizontal_force = "250 kN"
[[load_cases]]
name = "low water"
horizontal_force = "120 kN"
water_level = "-1 m"
kind = "reference"
[checks]
safety_factor = 2.0
[waves]
spectrum = "jonswap"
height = "2 m"
period = "7 s"
direction = "180 deg"
components = 20
seed = 11
[current]
profile = "table"
depths = ["0 m", "20 m"]
speeds = ["1 m/s", "0.2 m/s"]
[motion]
rao_file = "rao.csv"
[dynamics]
duration = "150 s"
ramp = "15 s"
runs = 2
elements = 12
"""
"""Two load cases in two seas each, led by a ship."""

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
