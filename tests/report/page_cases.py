"""Case files for the tests of notes, and the directory of a design search."""

from __future__ import annotations

import json
from pathlib import Path

CASES = Path(__file__).parents[2] / "cases"
"""Case files that come with catopt."""
TEXTS = {
    path.stem: path.read_text("utf-8") for path in (Path(__file__).parent / "cases").glob("*.toml")
}
"""Case files and sizing files beside these tests, each of a line that hangs in another way."""
RAOS = (
    "period,surge,surge_phase,heave,heave_phase\n3,0,90,0.02,40\n8,0.3,90,0.6,10\n20,0.9,90,1,0\n"
)


def case_path(folder: Path, name: str) -> Path:
    """Return the path of a case; one of the texts is written to a folder, with its ship."""
    if name == "designed":
        return design_directory(folder)
    if name not in TEXTS:
        return next((CASES / name).glob("*.toml"))
    (folder / "rao.csv").write_text(RAOS, encoding="utf-8")
    path = folder / f"{name}.toml"
    path.write_text(TEXTS[name], encoding="utf-8")
    return path


def design_directory(folder: Path, designs: int = 3) -> Path:
    """Write a result directory as ``catopt design --out`` does, with a front by hand."""
    too_flat = "uplift angle at the anchor (storm (high water))"
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
            _step("chain: 31 m for 30 m", 3600.0, 29.5, feasible=True),
            _step("chain: 9 m for 30 m", reason="too short"),
            _step("chain: 29 m for 30 m", 3400.0, 28.5, governing=too_flat),
        ],
        "present": _step(
            "the line of the case file", 3450.0, 61.0, governing="offset (storm (high water))",
            utilisation=1.02,
        ),
        "method": "enumeration", "is_exact": True, "designs": 1234, "evaluations": 1234,
        "feasible": 321, "interrupted": False, "hypervolume": 1.0, "reference_point": [1.0, 1.0],
        "seed": 1, "warnings": ["a price was read in no document"],
    }  # fmt: skip
    directory = folder / "result"
    directory.mkdir(parents=True)
    (directory / "case.toml").write_text(TEXTS["states"], encoding="utf-8")
    (directory / "design.json").write_text(json.dumps(document), encoding="utf-8")
    return directory


def _step(
    change: str, mass: float | None = None, offset: float | None = None, **told: object
) -> dict[str, object]:
    """Make a step from the recommended design, which fails unless it is told not to."""
    step = {"change": change, "mass_kg": mass, "offset_m": offset, "feasible": False}
    return {**step, "governing": "", "utilisation": None, "reason": "", **told}


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
