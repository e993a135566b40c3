"""What all commands that answer have in common."""

from __future__ import annotations

import json
import re
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from catopt.render.picture import DPI, WIDTH

from .cases import write_files
from .conftest import Run, fits, names, read_document, rows, sheets, typed, without_digest


class Command(NamedTuple):
    """A command, its document, and the names of its files by kind; ``others`` are whole names."""

    line: str
    document: str
    tables: str
    figures: str = ""
    others: str = "case.toml"
    workbooks: str = ""
    sheets: str = ""

    @property
    def books(self) -> list[str]:
        return (self.workbooks or self.document).split()

    @property
    def files(self) -> set[str]:
        drawn = {f"{name}.{end}" for name in self.figures.split() for end in ("png", "svg")}
        books = {f"{name}.xlsx" for name in self.books}
        tables = {f"{name}.csv" for name in self.tables.split()}
        return {f"{self.document}.json", *self.others.split()} | books | tables | drawn


def commands() -> Iterator[Command]:
    for part in Path(__file__).with_name("commands.txt").read_text("utf-8").split("\n\n$ ")[1:]:
        line, *below = part.splitlines()
        told = (row.partition(":") for row in below)
        yield Command(line, **{key: value.strip() for key, _, value in told})


COMMANDS = list(commands())
each_command = pytest.mark.parametrize("command", COMMANDS, ids=lambda each: each.line)
SAID_BEFORE = {"design", "study"}
"""Commands that say on standard error how much they have to compute."""
MOORINGS = ("oc3", "oc4", "volturnus", "steep_chain", "hanging_cable", "moordyn_line")
COMPUTES = {
    "solve": "catopt.catenary.case.solve_case", "check": "catopt.checks.case.check_case",
    "curve": "catopt.catenary.case_curve.curve_case", "verify": "catopt.verify.case.verify_case",
    "reproduce": "catopt.reproduce.reproduce", "report": "catopt.cli.note_kind.note_of_file",
}  # fmt: skip


@pytest.fixture(autouse=True)
def _files(inside: Path) -> None:
    write_files(inside)


@each_command
def test_the_answer_fits_and_nothing_stands_beside_it(
    run: Run, monkeypatch: pytest.MonkeyPatch, command: Command
) -> None:
    for width in 60, 80, 140:
        monkeypatch.setenv("COLUMNS", str(width))
        ran = run(*typed(command.line))
        assert (ran.status, fits(ran.out, width)) == (0, True)
        assert not ran.err or command.document in SAID_BEFORE


@each_command
def test_the_document_and_the_files(run: Run, inside: Path, command: Command) -> None:
    out = inside / "new" / "deep"
    ran = run(*typed(command.line), "--json", "--out", out)
    assert ran.status == 0
    assert names(out) == command.files
    of_study = {"members.csv", "study.sqlite"}  # written while it runs
    assert ran.err.endswith(f"{len(command.files - of_study)} files written to {out}\n")
    document = read_document(ran.out)
    assert document["schema"] == f"catopt.{command.document}/1"
    assert without_digest(out / f"{command.document}.json") == document
    found = [sheet for name in command.books for sheet in sheets(out / f"{name}.xlsx")]
    assert not command.sheets or ", ".join(found) == command.sheets
    for name in command.figures.split():
        wide, tall = png_size(out / f"{name}.png")
        assert wide == round(WIDTH * DPI)
        assert 0.3 * wide < tall < (1.0 if command.document == "solution" else 2.0) * wide
        assert "</svg>" in (out / f"{name}.svg").read_text("utf-8")
    for name in command.tables.split():
        assert without_unit(out / f"{name}.csv") == []


def without_unit(path: Path) -> list[str]:
    """List the headings without a unit over numbers that count nothing."""
    table = rows(path)
    return [
        heading
        for heading in (table[0] if table else ())
        if not heading.endswith(")")
        and all(re.fullmatch(r"-?[\d.]*(e-?\d+)?", row[heading]) for row in table)
        and any("." in row[heading] for row in table)
    ]


def png_size(path: Path) -> tuple[int, int]:
    """Width and height from the header of a PNG file."""
    content = path.read_bytes()
    assert content.startswith(b"\x89PNG\r\n\x1a\n")
    width, height = struct.unpack(">II", content[16:24])
    return width, height


@pytest.mark.parametrize("line", [*(each.line for each in COMMANDS), "report BUOY"])
def test_a_file_in_the_way_is_2_before_anything_is_computed(
    run: Run, inside: Path, monkeypatch: pytest.MonkeyPatch, line: str
) -> None:
    def never(*_: object, **__: object) -> None:
        raise AssertionError("computed, although nothing can be written")

    if computes := COMPUTES.get(line.split()[0]):
        monkeypatch.setattr(computes, never)
    path = inside / "file"
    path.write_text("mine", encoding="utf-8")
    for out in (path, path / "below"):
        ran = run(*typed(line), "--json", "--out", out)
        assert (ran.status, ran.out) == (2, "")
        assert "--out: " in ran.err
    assert path.read_text("utf-8") == "mine"


@pytest.mark.slow
@each_command
def test_the_document_is_english_in_every_language(run: Run, command: Command) -> None:
    line = typed(command.line)
    assert run(*line, "--json", "--lang", "vi").out == run(*line, "--json").out


@pytest.mark.slow
def test_reproduce_writes_page_tables_and_figures(
    run: Run, inside: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "132")
    out = inside / "out"
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
    studies += ["fso_rang_dong_dynamic", "chain_in_waves", "calmar"]
    assert list(book) == ["Comparison", "Inputs", "Findings", *studies]
    heading, *below = book["Comparison"]
    verdicts = [row[heading.index("Verdict")] for row in below[: len(items)]]
    assert verdicts == [item["verdict"] for item in items]
