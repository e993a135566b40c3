"""Moored bodies for the tests of their calculation note, each held in a way of its own."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from catopt.notes.system import SystemNote, read_system_note
from catopt.words import Language

from .page_cases import CASES
from .page_reader import ReadPage, read_page
from .rendered import page_of

TURRET = "fso-rang-dong"
"""The case file that comes with catopt: nine lines in three bundles, force along one of them."""

ARMS = """
title = "Barge on four chains"
source = "an example"
[site]
water_depth = "40 m"
seabed_friction = 0.4
[line]
fairlead_height = "38 m"
[[line.segments]]
component = "chain studless R3"
diameter = "76 mm"
length = "420 m"
[[line.point_loads]]
name = "clump"
position = "330 m"
submerged_weight = "40 kN"
mass = "6 t"
[system]
anchor_radius = "400 m"
fairlead_radius = "25 m"
azimuths = ["45 deg", "135 deg", "225 deg", "315 deg"]
force = ["500 kN", "300 kN"]
moment = "2000 kN*m"
[checks]
safety_factor = 2.0
max_anchor_uplift_angle = "0 deg"
min_grounded_length = "50 m"
[buoy]
reserve_buoyancy = "700 kN"
"""
"""A body that turns, with checks that pass and that fail; figures of the catalogue."""

RAISED = """
[site]
water_depth = "60 m"
[line]
anchor_height = "6 m"
[[line.segments]]
length = "260 m"
submerged_weight = "800 N/m"
[system]
anchor_radius = "240 m"
azimuths = ["90 deg", "210 deg", "330 deg"]
force = ["20 kN", "-60 kN"]
"""
"""Anchors above the bed, lines that do not stretch and have no strength, a force off every axis."""

IDLE = """
title = "At rest"
[site]
water_depth = "30 m"
[line]
[[line.segments]]
length = "160 m"
submerged_weight = "1 kN/m"
EA = "300 MN"
MBL = "100 kN"
[system]
anchor_radius = "150 m"
azimuths = ["0 deg", "60 deg", "120 deg", "180 deg", "240 deg", "300 deg"]
"""
"""No force: neither a watch circle nor an offset."""

PULLED = """
title = "Six chains, pulled along one"
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "600 m"
submerged_weight = "1 kN/m"
EA = "800 MN"
MBL = "1200 kN"
[system]
anchor_radius = "570 m"
azimuths = ["0 deg", "60 deg", "120 deg", "180 deg", "240 deg", "300 deg"]
force = ["-1 MN", "0 N"]
[checks]
safety_factor = 2.0
"""
"""The rule of practice applies; the strength is overrun."""

LEE = """
title = "Two lines to one side"
[site]
water_depth = "30 m"
[line]
[[line.segments]]
length = "160 m"
submerged_weight = "1 kN/m"
[system]
anchor_radius = "150 m"
azimuths = ["40 deg", "-40 deg"]
force = ["-80 kN", "1 kN"]
"""
"""The body lies at the edge of the drawing; its lines do not stretch and are nearly taut."""

LONE = """
[site]
water_depth = "30 m"
[line]
[[line.segments]]
length = "160 m"
submerged_weight = "1 kN/m"
EA = "50 MN"
[system]
anchor_radius = "150 m"
azimuths = ["90 deg"]
force = ["0 N", "-80 kN"]
"""
"""Nothing is left when its line is gone."""

TEXTS = {"arms": ARMS, "raised": RAISED, "idle": IDLE, "pulled": PULLED, "lee": LEE, "lone": LONE}
"""Case files as texts."""

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
