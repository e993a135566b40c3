"""What ``catopt report`` tells of the note that it wrote, and the note."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

from tests.report.page_reader import ReadPage, read_page

from .conftest import Run, document_of


def note_of(run: Run, *arguments: object) -> tuple[dict[str, Any], ReadPage]:
    """Write a note that is as its document says."""
    document = document_of(run, "report", *arguments)
    return document, compare_files(document)


def compare_files(document: dict[str, Any]) -> ReadPage:
    """Every file is as its document says, and so are the sections of the page."""
    for told in (document, document["workbook"]):
        if told is not None:
            content = Path(told["path"]).read_bytes()
            assert told["bytes"] == len(content)
            assert told["sha256"] == hashlib.sha256(content).hexdigest()
    page = page_at(document["path"])
    assert document["sections"] == list(page.sections)
    assert page.tagged("html")[0].attributes["lang"] == document["language"]
    return page


def page_at(path: str) -> ReadPage:
    return read_page(Path(path).read_bytes())


def digest(file: str) -> list[dict[str, str]]:
    """Say what a document says of the one file that it is of."""
    path = Path(file)
    return [{"name": path.name, "sha256": hashlib.sha256(path.read_bytes()).hexdigest()}]
