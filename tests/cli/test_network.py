"""Commands of lines between points: documents of their schemas, and the note."""

from __future__ import annotations

from pathlib import Path

from catopt.casefile.network_file import parse_network
from tests.checks.test_network import FILE

from .conftest import Run, document_of, validate


def written(folder: Path) -> Path:
    place = folder / "network.toml"
    place.write_text(FILE, encoding="utf-8")
    return place


def test_documents_are_of_their_schemas(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    checked = document_of(run, "check", place)
    validate(checked)
    assert {each["line"] for each in checked["checks"]} == {
        1,
        None,
    }  # None: the leg is lost with its one line
    solved = document_of(run, "system", place)
    validate(solved)
    assert solved["checks"]["checks"] == len(checked["checks"])


def test_an_answer_is_written_with_its_case_and_again(run: Run, tmp_path: Path) -> None:
    place, folder = written(tmp_path), tmp_path / "out"
    run("check", place, "--out", folder)
    assert parse_network((folder / "case.toml").read_text("utf-8")) == parse_network(FILE)
    again = run("check", place, "--out", folder)
    assert again.status == 0
    assert "stays as it is" not in again.err
