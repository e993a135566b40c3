"""Writes reports/ anew: the reproduction book and a calculation note for each case in cases/.

``python -m tests.reports``; tests/test_reports.py fails when a note is out of date.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

from catopt._version import RELEASE, identity
from catopt.casefile import read_case, write_case
from catopt.casefile.reading import SIZING, moored_in
from catopt.cli.note_kind import answer_of, note_of_sizing
from catopt.design.search import design_case
from catopt.model.network import Network
from catopt.notes.line import Note, SizeNote, read_note
from catopt.notes.system import NetworkNote, SystemNote, read_network_note, read_system_note
from catopt.render.files import document_bytes
from catopt.render.page import page
from catopt.report.bundle import reproduction_pictures, write_files
from catopt.reproduce import book, reproduce

__all__ = ["CASES", "NOTES", "REPORTS", "SIZINGS", "note_of_case", "note_page"]

ROOT = Path(__file__).parents[1]
REPORTS = ROOT / "reports"
NOTES = REPORTS / "notes"
LONG = {"net-cage"}
"""Cases without a shipped note: with each line out in a current theirs takes minutes."""
CASES = tuple(
    path.parent.name
    for path in sorted((ROOT / "cases").glob("*/case.toml"))
    if path.parent.name not in LONG
)
"""Cases of a line, and of a body that several moor."""
SIZINGS = tuple(path.parent.name for path in sorted((ROOT / "cases").glob(f"*/{SIZING}")))
"""What is known of a buoy or a ship before there is a line."""


def note_of_case(name: str) -> Note | SystemNote | NetworkNote:
    """Compute the note of a case; that of the recommended design where one is asked for."""
    path = ROOT / "cases" / name / "case.toml"
    case = read_case(path)
    if isinstance(case, Network):
        return read_network_note(path)
    if case.design is None:
        return read_note(path) if case.system is None else read_system_note(path)
    result = design_case(case)
    document = document_bytes(result.to_dict())
    with TemporaryDirectory() as folder:
        kept = {"case.toml": write_case(result.case).encode(), "design.json": document}
        write_files(Path(folder), kept)
        read = read_note if case.system is None else read_system_note
        return read(Path(folder))


def note_page(name: str) -> bytes:
    """Make the page of a case's note, or of a sizing's."""
    note = size_note_of_case(name) if name in SIZINGS else note_of_case(name)
    # No commit: the page of the same case is the same in the next one.
    return page(answer_of(note)).replace(identity().encode(), RELEASE.encode())


def size_note_of_case(name: str) -> SizeNote:
    """Compute the note of a sizing file."""
    path = ROOT / "cases" / name / SIZING
    moored = moored_in(path)
    assert moored is not None
    return note_of_sizing(path, moored)


def _book() -> dict[str, bytes]:
    """Make the reproduction book with the figures that it shows."""
    result = reproduce()
    written = book(result)
    pictures = reproduction_pictures(result)
    shown = re.findall(r"\((\w+\.svg)\)", written)
    return {"reproduction.md": written.encode(), **{name: pictures[name] for name in shown}}


def _written() -> Iterator[Path]:
    yield from write_files(REPORTS, _book())
    for name in (*CASES, *SIZINGS):
        yield from write_files(NOTES, {f"{name}.html": note_page(name)})


if __name__ == "__main__":
    for place in _written():
        sys.stdout.write(f"{place.relative_to(ROOT)}\n")
