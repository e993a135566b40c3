"""What ``--out`` does with what is there, and all that ``catopt reproduce`` writes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from .commands import COMMANDS
from .conftest import BUOY, Run, fits, names, rows, sheets

MOORINGS = ("oc3", "oc4", "volturnus", "steep_chain", "hanging_cable", "moordyn_line")


@pytest.mark.slow
def test_reproduce_writes_page_tables_and_figures(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "132")
    out = tmp_path / "out"
    ran = run("reproduce", "--out", out)
    assert (ran.status, fits(ran.out, 132)) == (0, True)
    tables = {"buoy_9p5m_runs.csv", "buoy_9p5m_history.csv"}
    page = {f"reproduction.{end}" for end in ("md", "json", "csv", "xlsx")}
    of_lines = ["buoy_9p5m", "ship_200m", "tanker_20m", "tanker_20m_sinker", *MOORINGS]
    drawn = [f"{name}_lines" for name in of_lines]
    drawn += ["buoy_9p5m_fitness", "buoy_9p5m_tension"]
    drawn += ["fso_rang_dong_plan", "fso_rang_dong_elevation"]
    assert names(out) == tables | page | {f"{v}.{end}" for v in drawn for end in ("png", "svg")}
    items = json.loads((out / "reproduction.json").read_text("utf-8"))["items"]
    table = rows(out / "reproduction.csv")
    assert [row["Verdict"] for row in table] == [item["verdict"] for item in items]
    assert all(row["Unit"] for row in table)
    book = sheets(out / "reproduction.xlsx")
    studies = ["tanker_20m_loads", "fso_rang_dong", "fso_rang_dong_loads"]
    studies += ["fso_rang_dong_dynamic", "chain_in_waves"]
    assert list(book) == ["Comparison", "Inputs", "Findings", *studies]
    heading, *below = book["Comparison"]
    verdicts = [row[heading.index("Verdict")] for row in below[: len(items)]]
    assert verdicts == [item["verdict"] for item in items]


def test_other_files_stay_and_files_of_the_same_name_are_replaced(run: Run, tmp_path: Path) -> None:
    (tmp_path / "summary.csv").write_text("old", encoding="utf-8")
    (tmp_path / "notes.txt").write_text("mine", encoding="utf-8")
    ran = run("solve", BUOY, "--profile", "--out", tmp_path)
    assert (ran.status, ran.out) == (0, run("solve", BUOY, "--profile").out)
    assert names(tmp_path) == COMMANDS[0].files | {"notes.txt"}
    assert (tmp_path / "notes.txt").read_text("utf-8") == "mine"
    assert "Span S (m)" in (tmp_path / "summary.csv").read_text("utf-8")
