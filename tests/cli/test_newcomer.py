"""Mistakes that a newcomer makes with files: nothing is lost, and each message says what to do."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from .conftest import BUOY, Run


@pytest.mark.parametrize("arguments", [["--to", "dxf"], ["--to", "moordyn", "--EA", "20 MN"]])
def test_an_export_never_takes_the_place_of_its_case(
    run: Run, tmp_path: Path, arguments: list[str]
) -> None:
    case = tmp_path / "line.txt"
    case.write_bytes(BUOY.read_bytes())
    ran = run("export", case, *arguments, "--out", case)
    assert (ran.status, ran.out) == (2, "")
    assert f"--out: found {case}; is the file that is read; give another place" in ran.err
    assert case.read_bytes() == BUOY.read_bytes()
    assert [path.name for path in tmp_path.iterdir()] == ["line.txt"]


def test_a_page_never_takes_the_place_of_its_case(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("line.html").write_bytes(BUOY.read_bytes())
    ran = run("report", "line.html", "--no-verify")
    assert (ran.status, ran.out) == (2, "")
    assert "is the file that is read" in ran.err
    assert Path("line.html").read_bytes() == BUOY.read_bytes()


@pytest.mark.parametrize("name", ["note.pdf", "note.XLSX", "note.docx"])
def test_a_note_is_no_other_kind_of_file(run: Run, tmp_path: Path, name: str) -> None:
    ran = run("report", BUOY, "--no-verify", "--out", tmp_path / name)
    assert (ran.status, ran.out) == (2, "")
    assert "a page, in a file that ends in .html, or a directory is wanted" in ran.err
    assert not list(tmp_path.iterdir())


def test_a_place_that_no_note_can_go_to_is_told_before_anything_is_computed(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def computed(*_: object) -> None:
        raise AssertionError("the note was computed")

    monkeypatch.setattr("catopt.cli.note_kind.note_of_file", computed)
    (tmp_path / "file").write_text("mine")
    for place in ("file", "file/page.html"):
        ran = run("report", BUOY, "--out", tmp_path / place)
        assert (ran.status, ran.out) == (2, "")
        assert "is a file; give a directory" in ran.err


@pytest.mark.parametrize("moored", ["buoy", "tanker"])
@pytest.mark.parametrize("command", [["solve"], ["check"], ["export", "--to", "dxf"]])
def test_a_file_for_catopt_size_is_told_as_one(
    run: Run, tmp_path: Path, moored: str, command: list[str]
) -> None:
    path = tmp_path / "size.toml"
    assert run("new", f"size-{moored}", path).status == 0
    name, *options = command
    ran = run(name, path, *options)
    assert (ran.status, ran.out) == (2, "")
    assert "1 error\n" in ran.err
    assert f"this file is for catopt size {moored}, which finds the line" in ran.err


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "file: found no text; give a case file"),
        (b"<!DOCTYPE html>\n<html>\n", "this is no TOML; give a case file"),
        (b'{\n  "schema": "catopt.solution/1"\n}\n', "this is no TOML; give a case file"),
        (b'{"schema": "catopt.solution/1"}\n', "this is no TOML; give a case file"),
    ],
)
def test_what_is_no_case_file_is_told_as_such(
    run: Run, tmp_path: Path, content: bytes, told: str
) -> None:
    path = tmp_path / "given"
    path.write_bytes(content)
    for command in ("solve", "report"):
        ran = run(command, path)
        assert (ran.status, ran.out) == (2, "")
        assert told in ran.err


def test_a_long_name_without_a_space_is_not_cut_off(run: Run, tmp_path: Path) -> None:
    name = "ý" * 150
    path = tmp_path / "long.toml"
    path.write_text(
        BUOY.read_text("utf-8").replace('name = "chain"', f'name = "{name}"'),
        encoding="utf-8",
    )
    ran = run("solve", path)
    assert ran.status == 0, ran.err
    assert "…" not in ran.out
    assert ran.out.count("ý") == 2 * 150  # in the table of what is given and in that of results
    assert max(map(len, ran.out.splitlines())) <= 80


def test_a_part_without_a_name_has_a_number_in_vietnamese(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "design.toml"
    assert run("new", "design", path).status == 0
    ran = run("design", path, "--lang", "vi")
    assert ran.status == 0
    assert "đoạn 1: " in ran.out
    assert "segment" not in ran.out


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere names of files are always text")
def test_a_name_that_is_no_text_is_replaced(run: Run, tmp_path: Path) -> None:
    """As after unpacking what was packed on an old Windows."""
    case = Path(os.fsdecode(os.fsencode(tmp_path) + b"/phao s\xf4.toml"))
    case.write_bytes(BUOY.read_bytes())
    ran = run("report", case, "--no-verify", "--date", "ng\udce0y 1", "--out", tmp_path / "note")
    assert ran.status == 0, ran.err
    (page,) = (tmp_path / "note").glob("*.html")
    assert "phao s?.toml" in page.read_text("utf-8")
    assert "ng?y 1" in page.read_text("utf-8")
    assert run("export", case, "--to", "dxf").status == 0


@pytest.mark.parametrize(
    ("document", "told"),
    [
        (
            {"schema": "catopt.design/1", "recommended": 0},
            "11 errors\n  title: missing\n",
        ),
        (
            {"schema": "catopt.solution/1"},
            "'catopt.design/1' is wanted",
        ),
        ([], "file: an object in braces is wanted"),
    ],
)
def test_a_damaged_result_directory_is_told_as_one(
    run: Run, tmp_path: Path, document: object, told: str
) -> None:
    (tmp_path / "case.toml").write_bytes(BUOY.read_bytes())
    (tmp_path / "design.json").write_text(json.dumps(document))
    for command in (["report"], ["solve", "--design", "1"]):
        name, *options = command
        ran = run(name, tmp_path, *options)
        assert (ran.status, ran.out) == (2, "")
        assert told in ran.err


INTERRUPTED_AT = """
import sys
class Interrupt:
    def find_spec(self, name, path=None, target=None):
        if name == "{module}":
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interrupt())
from catopt.__main__ import main
sys.exit(main(["--version"]))
"""


@pytest.mark.parametrize("module", ["catopt.errors", "catopt.cli.output", "catopt.cli.app"])
def test_an_interrupt_while_the_program_is_loaded_is_told_in_one_line(module: str) -> None:
    code = INTERRUPTED_AT.format(module=module)
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stdout, ran.stderr) == (130, "", "catopt: interrupted\n")


@pytest.mark.parametrize(("given", "meant"), [("bouy", "buoy"), ("Tanker", "tanker")])
def test_a_misspelt_template_is_guessed(run: Run, given: str, meant: str) -> None:
    ran = run("new", given)
    assert (ran.status, ran.out) == (2, "")
    assert f"is wanted; did you mean {meant}?" in ran.err
