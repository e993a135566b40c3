"""Running the command line inside the test's own process, as `catopt` would."""

from __future__ import annotations

import csv
import json
import shlex
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jsonschema
import openpyxl
import pytest

from catopt import schemas
from catopt.__main__ import main
from catopt.verify.dynamic import verify_dynamic

CASES = Path(__file__).parents[2] / "cases"
OWN = Path(__file__).parent / "cases"
"""Case files of these tests."""
BROKEN = Path(__file__).parent / "broken_sizing"

NAMED = {
    "BUOY": CASES / "buoy-9.5m" / "case.toml",
    "SLACK": CASES / "buoy-9.5m-slack" / "case.toml",
    "TANKER": CASES / "tanker-20m-sinker" / "case.toml",
    "SOUGHT": CASES / "tanker-20m-find-length" / "case.toml",
    "FSO": CASES / "fso-rang-dong" / "case.toml",
    "DESIGN": CASES / "design-buoy-9.5m" / "case.toml",
    "FATIGUE": CASES / "fatigue-chain-20m" / "case.toml",
    "FLEET": CASES / "study-fleet" / "study.toml",
    "STUDY": CASES / "study-buoy-9.5m" / "study.toml",
    "CASES": CASES,
    "NOTES": Path(__file__).parents[1] / "report" / "cases",
    "BROKEN": BROKEN,
}
BUOY, SLACK, TANKER, SOUGHT, FSO, DESIGN, *_ = NAMED.values()

OPTIONS = dict(
    line.split(": ", 1)
    for line in Path(__file__).with_name("options.txt").read_text("utf-8").splitlines()[1:]
)
"""What many commands begin with."""


def typed(line: str) -> list[str]:
    """Split a command as a shell does; words in capitals stand for files and options above."""
    found: list[str] = []
    for word in shlex.split(line):
        if word in OPTIONS:
            found += typed(OPTIONS[word])
        else:
            name, *below = word.split("/")
            found.append(str(NAMED[name].joinpath(*below)) if name in NAMED else word)
    return found


CHAIN_IN_MOTION = (OWN / "moving.toml").read_text("utf-8")
"""Three periods of a line that stays taut."""


FULL = "1"
"""CATOPT_FULL of the environment: whether all of an answer is printed."""


@dataclass(frozen=True)
class Ran:
    """What a run of the command left behind."""

    status: int
    out: str
    err: str


Run = Callable[..., Ran]


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run the command line with arguments; what it printed before is forgotten.

    All of each answer is printed, but for a sizing, as the environment may ask for.
    """

    def command(*arguments: object) -> Ran:
        monkeypatch.setenv("CATOPT_FULL", "0" if arguments[:1] == ("size",) else FULL)
        capsys.readouterr()
        status = main([str(argument) for argument in arguments])
        printed = capsys.readouterr()
        return Ran(status, printed.out, printed.err)

    return command


@pytest.fixture
def inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Work in an empty folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    """Press Ctrl-C in the middle of a run in motion."""

    def tell(done: int, total: int) -> None:
        if done > total / 40:  # within the run: its proof takes up to some twenty times as much
            raise KeyboardInterrupt

    def stops(*args: Any, **options: Any) -> Any:
        return verify_dynamic(*args, **options | {"progress": tell})

    monkeypatch.setattr("catopt.verify.dynamic.verify_dynamic", stops)


def changed(case: Path, folder: Path, *changes: tuple[str, str]) -> Path:
    """Write a case of its own into a folder: another one with some of its text replaced."""
    text = case.read_text("utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = folder / "changed.toml"
    path.write_text(text, encoding="utf-8")
    return path


# ------------------------------------------------------------------ what was printed and written


def words(text: str) -> str:
    """Undo the breaking of lines and the spaces between columns."""
    return " ".join(text.split())


def fits(text: str, width: int = 80) -> bool:
    """Whether no line is too long, no word cut off and nothing coloured."""
    return max(map(len, text.splitlines())) <= width and "…" not in text and "\x1b" not in text


def validate(document: dict[str, Any]) -> None:
    jsonschema.Draft202012Validator(schemas.schema(document["schema"])).validate(document)


def read_document(text: str) -> dict[str, Any]:
    """Read one valid document and nothing else."""
    document: dict[str, Any] = json.loads(text)
    validate(document)
    return document


def document_of(run: Run, *arguments: object, status: int = 0) -> dict[str, Any]:
    """Run a command with --json; nothing stands beside the document but what is written."""
    ran = run(*arguments, "--json")
    assert ran.status == status, ran.err
    assert not ran.err or status or "--out" in arguments
    return read_document(ran.out)


def refused(run: Run, *arguments: object) -> Ran:
    """Run a command that has no answer, for its input is wrong."""
    ran = run(*arguments)
    assert (ran.status, ran.out) == (2, "")
    assert "Traceback" not in ran.err
    return ran


def without_digest(path: Path) -> dict[str, Any]:
    """Read a document that --out wrote; it has the digest of its case beside what is printed."""
    document: dict[str, Any] = json.loads(path.read_text("utf-8"))
    if (path.parent / "case.toml").exists():
        assert len(document.pop("case_sha256")) == 64
    return document


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def names(directory: Path) -> set[str]:
    return {path.name for path in directory.iterdir()}


def sheets(path: Path) -> dict[str, list[list[Any]]]:
    """Every sheet of a workbook, as rows of values."""
    book = openpyxl.load_workbook(path)
    found = {sheet.title: [list(r) for r in sheet.iter_rows(values_only=True)] for sheet in book}
    book.close()
    return found
