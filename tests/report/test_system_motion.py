"""The note of a moored body in motion: its tables, its sheet, its words and its document."""

from __future__ import annotations

import json
from functools import cache
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory

import openpyxl
import pandas as pd
import pytest

from catopt.__main__ import main
from catopt.notes.directory import Asked
from catopt.notes.system import SystemNote, read_system_note
from catopt.render.texts import Language, Words
from catopt.report.page.closing import warnings
from catopt.report.page.render import render_page
from catopt.report.page.system.motion import motion
from catopt.report.workbook.note_system import system_note_workbook
from tests.cli.test_json import validate
from tests.cli.test_lang_verify import FORCE, LED, PUSHED, SHIP
from tests.cli.vietnamese import gathered, untranslated

from .page_reader import read_page

FILES = {"led.toml": LED, "ship.csv": SHIP, "pushed.toml": PUSHED, "force.csv": FORCE}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    return written(tmp_path, monkeypatch)


def written(folder: Path, monkeypatch: pytest.MonkeyPatch | None = None) -> Path:
    for name, text in FILES.items():
        (folder / name).write_text(text, encoding="utf-8")
    if monkeypatch is not None:
        monkeypatch.chdir(folder)
    return folder


@cache
def note_of(name: str) -> SystemNote:
    with TemporaryDirectory() as folder:
        path = written(Path(folder)) / f"{name}.toml"
        return read_system_note(path, verify=False, asked=Asked(motion=True))


@pytest.mark.parametrize("name", ["led", "pushed"])
def test_every_line_has_its_row_and_the_governing_one_is_marked(name: str) -> None:
    note = note_of(name)
    assert note.motion is not None
    page = read_page(render_page(note))
    assert page.unclosed == []
    rows = page.table("system_motion_lines").rows
    assert len(rows) == 3
    for row, part in zip(rows, note.motion.parts, strict=True):
        each = part.of("fairlead_tension")
        assert row[5].value == each.maximum
        assert row[1].value == note.solution.lines[(part.line or 0) - 1].tension
    assert len(page.table("system_motion_body").rows) == 3
    names = [file.name for file in note.origin.files]
    assert names[-1] == {"led": "ship.csv", "pushed": "force.csv"}[name]


@pytest.mark.parametrize("name", ["led", "pushed"])
@pytest.mark.parametrize("language", ["en", "vi"])
def test_the_sheet_has_the_numbers_of_the_page(name: str, language: Language) -> None:
    note = note_of(name)
    assert note.motion is not None
    book = openpyxl.load_workbook(BytesIO(system_note_workbook(note, language)))
    sheet = book[{"en": "Motion", "vi": "Chuyển động"}[language]]
    numbers = {cell.value for row in sheet.iter_rows() for cell in row if cell.data_type == "n"}
    largest = [part.of("fairlead_tension").maximum for part in note.motion.parts]
    for value in largest:
        assert any(n == pytest.approx(value / 1e3, rel=1e-12) for n in numbers if n is not None)


@pytest.mark.parametrize("name", ["led", "pushed"])
def test_nothing_of_it_stays_english(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    missing = gathered(monkeypatch)
    note, words = note_of(name), Words("vi")
    assert motion(note, words) is not None
    warnings(note, words)
    assert untranslated(missing) == []


def run(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, str, str]:
    status = main([str(each) for each in arguments])
    said = capsys.readouterr()
    return status, said.out, said.err


def test_the_document_and_the_note_of_a_result_directory(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    options = ("--dynamic", "--once", "--elements", "40", "--out", "out")
    assert run(capsys, "verify", folder / "led.toml", *options)[0] == 0
    table = pd.read_csv(folder / "out" / "dynamic_statistics.csv")
    assert list(table["Line"]) == [k for k in (1, 2, 3) for _ in range(4)]
    verified = json.loads((folder / "out" / "verify.json").read_text("utf-8"))
    validate(verified)
    way = pd.read_csv(folder / "out" / "dynamic_body.csv")
    assert way["Body x (m)"].max() == verified["dynamic"]["body"][0]["max"]
    figures = [path.name for path in (folder / "out").glob("dynamic*.png")]
    assert figures == ["dynamic.png"]
    status, out, err = run(capsys, "report", "out", "--no-verify", "--out", "note", "--json")
    assert status == 0, err
    document = json.loads(out)
    validate(document)
    assert "system_motion" in document["sections"]
    assert document["motion"]["line"] == 1
    assert any("NOT PROVEN" in warning for warning in document["warnings"])


def test_a_body_without_dynamics_is_told_what_is_missing(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    text = LED[: LED.index("[waves]")]
    (folder / "still.toml").write_text(text, encoding="utf-8")
    status, out, err = run(capsys, "report", "still.toml", "--dynamic", "--no-verify")
    assert (status, out) == (2, "")
    assert "write [dynamics] with a duration" in " ".join(err.split())
