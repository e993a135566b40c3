"""Mistakes that a newcomer makes with files: nothing is lost, and each message says what to do."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from .conftest import BUOY, Run, changed, fits, refused


def test_a_place_that_no_note_can_go_to_is_told_before_anything_is_computed(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def computed(*_: object, **__: object) -> None:
        raise AssertionError("the note was computed")

    monkeypatch.setattr("catopt.cli.note_kind.note_of_file", computed)
    (tmp_path / "file").write_text("mine")
    for place in ("file", "file/page.html"):
        ran = refused(run, "report", BUOY, "--out", tmp_path / place)
        assert "is a file; give a directory" in ran.err


def test_a_long_name_without_a_space_is_not_cut_off(run: Run, tmp_path: Path) -> None:
    name = "ý" * 150
    ran = run("solve", changed(BUOY, tmp_path, ('name = "chain"', f'name = "{name}"')))
    assert (ran.status, fits(ran.out)) == (0, True)
    assert ran.out.count("ý") == 2 * 150  # in the table of what is given and in that of results


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
