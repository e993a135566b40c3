"""What ``--out`` writes."""

from __future__ import annotations

import csv
import json
import math
import struct
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from catopt.render.picture import DPI, WIDTH

from .conftest import BUOY, Run

ROUNDING = 1e-15
"""Relative: the workbook keeps 16 significant digits, JSON 17; plus one division by 1000."""

TABLES = {"inputs.csv", "segments_given.csv", "summary.csv", "segments.csv", "profile.csv"}
FIGURES = {"line.png", "line.svg", "tension.png", "tension.svg"}
PLAIN = TABLES | FIGURES | {"solution.json", "solution.xlsx", "case.toml"}
OF_SWARM = {
    "swarm_runs.csv",
    "swarm_history.csv",
    "swarm_fitness.png",
    "swarm_fitness.svg",
    "swarm_tension.png",
    "swarm_tension.svg",
}
MOORINGS = ("oc3", "oc4", "volturnus", "steep_chain", "hanging_cable", "moordyn_line")


def names(directory: Path) -> set[str]:
    return {path.name for path in directory.iterdir()}


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def column(sheet: Any, heading: str) -> list[Any]:
    """Read a column of a table that starts in the first row, down to its first empty cell."""
    (found,) = [cell.column for cell in sheet[1] if cell.value == heading]
    values = [sheet.cell(row, found).value for row in range(2, sheet.max_row + 1)]
    return values[: values.index(None)] if None in values else values


def close(first: float, second: float) -> bool:
    return math.isclose(first, second, rel_tol=ROUNDING, abs_tol=0.0)


def test_solve_writes_its_files_and_says_so_beside_the_answer(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "new" / "deep"
    ran = run("solve", BUOY, "--out", out)
    assert ran.status == 0
    assert names(out) == PLAIN
    assert ran.err == f"{len(PLAIN)} files written to {out}\n"
    assert ran.out == run("solve", BUOY).out


def test_the_swarm_adds_its_own(run: Run, tmp_path: Path) -> None:
    ran = run("solve", BUOY, "--method", "pso", "--json", "--out", tmp_path / "out")
    assert ran.status == 0
    assert names(tmp_path / "out") == PLAIN | OF_SWARM
    assert json.loads(ran.out)["method"] == "pso"


@pytest.mark.slow
def test_reproduce_writes_page_tables_and_figures(run: Run, tmp_path: Path) -> None:
    assert run("reproduce", "--out", tmp_path / "out").status == 0
    swarm = {name.replace("swarm", "buoy_9p5m") for name in OF_SWARM}
    page = {f"reproduction.{end}" for end in ("md", "json", "csv", "xlsx")}
    of_lines = ["buoy_9p5m", "ship_200m", "tanker_20m", "tanker_20m_sinker", *MOORINGS]
    drawn = [*(f"{name}_lines" for name in of_lines), "fso_rang_dong_plan"]
    views = {f"{v}.{end}" for v in (*drawn, "fso_rang_dong_elevation") for end in ("png", "svg")}
    assert names(tmp_path / "out") == page | swarm | views
    items = json.loads((tmp_path / "out" / "reproduction.json").read_text("utf-8"))["items"]
    table = rows(tmp_path / "out" / "reproduction.csv")
    assert [row["Verdict"] for row in table] == [item["verdict"] for item in items]
    assert all(row["Unit"] for row in table)
    book = openpyxl.load_workbook(tmp_path / "out" / "reproduction.xlsx")
    studies = ["tanker_20m_loads", "fso_rang_dong", "fso_rang_dong_loads"]
    studies += ["fso_rang_dong_dynamic", "chain_in_waves"]
    assert book.sheetnames == ["Comparison", "Inputs", "Findings", *studies]
    assert column(book["Comparison"], "Verdict") == [item["verdict"] for item in items]


def test_csv_holds_the_document_s_numbers_in_the_field_s_units(run: Run, tmp_path: Path) -> None:
    document = json.loads(run("solve", BUOY, "--json", "--profile", "--out", tmp_path).out)
    (summary,) = rows(tmp_path / "summary.csv")
    tension = document["fairlead"]["tension_N"]
    assert close(float(summary["Fairlead tension T (kN)"]), tension / 1e3)
    assert close(float(summary["Fairlead tension T (tf)"]), tension / 9806.65)
    assert float(summary["Span S (m)"]) == document["span_m"]
    assert summary["Line mass in air (t)"] == "", "not known, so empty"
    profile = rows(tmp_path / "profile.csv")
    heights = [float(row["Height above the seabed z (m)"]) for row in profile]
    assert heights == document["profile"]["z_m"]


def png_size(path: Path) -> tuple[int, int]:
    """Width and height from the header of a PNG file."""
    content = path.read_bytes()
    assert content.startswith(b"\x89PNG\r\n\x1a\n")
    width, height = struct.unpack(">II", content[16:24])
    return width, height


def test_figures_have_the_size_of_the_page(run: Run, tmp_path: Path) -> None:
    run("solve", BUOY, "--method", "pso", "--out", tmp_path)
    for name in ("line", "tension", "swarm_fitness", "swarm_tension"):
        wide, tall = png_size(tmp_path / f"{name}.png")
        assert wide == round(WIDTH * DPI)
        assert 0.3 * wide < tall < wide
    for path in tmp_path.glob("*.svg"):
        assert "</svg>" in path.read_text("utf-8")


def test_other_files_stay_and_files_of_the_same_name_are_replaced(run: Run, tmp_path: Path) -> None:
    (tmp_path / "summary.csv").write_text("old", encoding="utf-8")
    (tmp_path / "notes.txt").write_text("mine", encoding="utf-8")
    assert run("solve", BUOY, "--out", tmp_path).status == 0
    assert names(tmp_path) == PLAIN | {"notes.txt"}
    assert (tmp_path / "notes.txt").read_text("utf-8") == "mine"
    assert "Span S (m)" in (tmp_path / "summary.csv").read_text("utf-8")
