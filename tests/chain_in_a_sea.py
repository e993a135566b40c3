"""A chain in 20 m of water that a ship's bow drags through a short sea, for tests of designs."""

from __future__ import annotations

from pathlib import Path

from catopt.casefile import parse_case
from catopt.model import Case

RAOS = "period (s),surge (m/m),surge_phase (deg)\n2,0.4,0\n30,1.0,0\n"

_TEXT = """
title = "A chain in a sea"
accept = ["safety_factor"]
[site]
water_depth = "20 m"
[line]
[[line.segments]]
component = "chain studless R3"
diameter = "{size} mm"
length = "{length} m"
[load]
horizontal_force = "100 kN"
[waves]
spectrum = "jonswap"
height = "2 m"
period = "7 s"
components = 60
[motion]
rao_file = "{raos}"
[dynamics]
duration = "60 s"
elements = 10
runs = {runs}
[checks]
safety_factor = {factor}
"""


def raos_in(folder: Path) -> Path:
    """Write the RAOs of its fairlead."""
    path = folder / "rao.csv"
    path.write_text(RAOS, "utf-8")
    return path


def chain_in_a_sea(
    raos: Path, size: int, length: int, runs: int, factor: float, further: str = ""
) -> Case:
    """Make the case of a size in mm and a length in m, with further keys of checks and tables."""
    values = {"size": size, "length": length, "runs": runs, "factor": factor, "raos": raos}
    return parse_case(_TEXT.format(**values) + further)
