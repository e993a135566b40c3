"""Cases for the tests of the calculation note, each hanging in a way of its own."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from catopt.notes.line import Note, read_note
from catopt.words import Language

from .page_reader import ReadPage, read_page
from .rendered import page_of

CASES = Path(__file__).parents[2] / "cases"
FILES = ("buoy-9.5m", "buoy-9.5m-slack", "ship-200m-sinker", "tanker-20m", "tanker-20m-sinker")
"""Case files that come with catopt."""


def own_case(name: str) -> str:
    """Read one of the case files beside these tests."""
    return (Path(__file__).parent / "cases" / f"{name}.toml").read_text("utf-8")


TEXTS = {name: own_case(name) for name in ("leg", "raised", "slack", "friction", "states")}
"""Case files as texts, each of a line that hangs in another way."""

EVERY = (*FILES, *TEXTS)
"""Names of all cases."""


@cache
def known_note(name: str) -> Note:
    """Read the note of a case, once: it is a value, so that tests may share it."""
    with TemporaryDirectory() as folder:
        return read_note(case_path(Path(folder), name))


@cache
def known_page(name: str, language: Language = "en") -> ReadPage:
    """Read the page of a case back, once."""
    return read_page(page_of(known_note(name), language))


def case_path(folder: Path, name: str) -> Path:
    """Return the path of a case; one of the texts is written to a folder."""
    if name in FILES:
        return CASES / name / "case.toml"
    path = folder / f"{name}.toml"
    path.write_text(TEXTS[name], encoding="utf-8")
    return path


def design_directory(folder: Path, designs: int = 3) -> Path:
    """Write a result directory as ``catopt design --out`` does, with a front by hand."""
    directory = folder / "result"
    directory.mkdir()
    (directory / "case.toml").write_text(TEXTS["states"], encoding="utf-8")
    document = {
        "schema": "catopt.design/1",
        "title": "Buoy chain",
        "objectives": ["mass_kg", "offset_m"],
        "load_cases": [
            {
                "name": name, "kind": kind, "water_level_m": level, "horizontal_force_N": force,
                "fairlead_height_m": 20.0 + level,
            }
            for name, kind, level, force in (
                ("storm (high water)", "extreme", 1.0, 20e3), ("everyday", "reference", 0.0, 5e3),
            )
        ],
        "front": [_design(index, designs) for index in range(designs)],
        "recommended": 1,
        "recommendation": "The knee of the front.",
        "ends": ["Least mass, design 1: the choices end."],
        "neighbours": [
            {
                "change": "chain: 31 m for 30 m", "mass_kg": 3600.0, "offset_m": 29.5,
                "feasible": True, "governing": "", "utilisation": None, "reason": "",
            },
            {
                "change": "chain: 9 m for 30 m", "mass_kg": None, "offset_m": None,
                "feasible": False, "governing": "", "utilisation": None, "reason": "too short",
            },
            {
                "change": "chain: 29 m for 30 m", "mass_kg": 3400.0, "offset_m": 28.5,
                "feasible": False, "governing": "uplift angle at the anchor (storm (high water))",
                "utilisation": None, "reason": "",
            },
        ],
        "present": {
            "change": "the line of the case file", "mass_kg": 3450.0, "offset_m": 61.0,
            "feasible": False, "governing": "offset (storm (high water))", "utilisation": 1.02,
            "reason": "",
        },
        "method": "enumeration",
        "is_exact": True,
        "designs": 1234,
        "evaluations": 1234,
        "feasible": 321,
        "interrupted": False,
        "hypervolume": 1.0,
        "reference_point": [1.0, 1.0],
        "seed": 1,
        "warnings": ["a price was read in no document"],
    }  # fmt: skip
    (directory / "design.json").write_text(json.dumps(document), encoding="utf-8")
    return directory


def _design(index: int, designs: int) -> dict[str, object]:
    """Make one design of a front: the heavier, the nearer."""
    length = 45.0 + index
    return {
        "mass_kg": 4500.0 + 115.0 * index,
        "offset_m": 55.0 - 10.0 * index / designs,
        "spans_m": [55.0 - 10.0 * index / designs, 50.0],
        "genes": [index],
        "excursion_m": 2.0 + 0.1 * index,
        "segments": [
            {
                "name": "", "component": "chain studless R3", "nominal_diameter_m": 0.076,
                "length_m": length, "submerged_weight_N_per_m": 980.0, "mass_kg_per_m": 115.0,
                "EA_N": 4.9e8, "MBL_N": 4.9e6, "proof_load_N": 3.4e6, "price_USD_per_m": None,
                "wear_rate_m_per_s": None,
            }
        ],
        "point_loads": [
            {"position_m": 7.0, "submerged_weight_N": 2000.0, "mass_kg": 250.0, "name": ""}
        ],
        "sinker": None,
        "checks": [],
        "governing": "offset (storm (high water))",
        "feasible": True,
    }  # fmt: skip
