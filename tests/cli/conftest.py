"""Running the command line inside the test's own process, as `catopt` would."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from catopt.__main__ import main

CASES = Path(__file__).parents[2] / "cases"
BUOY = CASES / "buoy-9.5m" / "case.toml"
SLACK = CASES / "buoy-9.5m-slack" / "case.toml"

CHAIN_AND_WIRE = """
title = "Chain, wire and a clump weight"
[site]
water_depth = "56 m"
[line]
fairlead_height = "71.4 m"
[[line.segments]]
name = "wire"
length = "750 m"
submerged_weight = "30.4 kgf/m"
mass = "34.9 kg/m"
EA = "382 MN"
MBL = "6140 kN"
[[line.segments]]
name = "chain"
length = "332 m"
submerged_weight = "150 kgf/m"
mass = "178.7 kg/m"
[[line.point_loads]]
name = "clump"
position = "800 m"
submerged_weight = "50 kN"
[load]
horizontal_force = "1.2 MN"
[checks]
safety_factor = 2.0
"""


CHAIN_IN_MOTION = """
title = "A chain in motion"
[site]
water_depth = "20 m"
[line]
[[line.segments]]
length = "120 m"
submerged_weight = "1110 N/m"
mass = "130 kg/m"
EA = "400 MN"
drag_diameter = "76 mm"
drag_normal = 2.4
[load]
horizontal_force = "300 kN"
[motion]
period = "8 s"
surge = "0.5 m"
[dynamics]
duration = "24 s"
elements = 20
"""
"""Three periods of a line that stays taut."""


@dataclass(frozen=True)
class Ran:
    """What a run of the command left behind."""

    status: int
    out: str
    err: str


Run = Callable[..., Ran]


def without_digest(path: Path) -> dict[str, Any]:
    """Read a document that --out wrote; it has the digest of its case beside what is printed."""
    document: dict[str, Any] = json.loads(path.read_text("utf-8"))
    assert len(document.pop("case_sha256")) == 64
    return document


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    """Run the command line with arguments; what it printed before is forgotten."""

    def command(*arguments: object) -> Ran:
        capsys.readouterr()
        status = main([str(argument) for argument in arguments])
        printed = capsys.readouterr()
        return Ran(status, printed.out, printed.err)

    return command


@pytest.fixture
def chain_and_wire(tmp_path: Path) -> Path:
    """Write a case with two segments and a clump weight, of which one segment's MBL is known."""
    path = tmp_path / "chain-and-wire.toml"
    path.write_text(CHAIN_AND_WIRE, encoding="utf-8")
    return path


@pytest.fixture
def sought(tmp_path: Path) -> Path:
    """Write the buoy's case, asking for the length of chain that just lies down at its anchor."""
    path = tmp_path / "sought.toml"
    question = '[find]\nquantity = "length"\nanchor_angle = "0 deg"\n'
    path.write_text(BUOY.read_text("utf-8") + question, encoding="utf-8")
    return path


@pytest.fixture
def too_short(tmp_path: Path) -> Path:
    """Write the buoy's case with 1 m of line too little to reach the fairlead."""
    path = tmp_path / "too-short.toml"
    path.write_text(BUOY.read_text("utf-8").replace('"20 m"', '"8.5 m"'), encoding="utf-8")
    return path
