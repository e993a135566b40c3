"""The JSON schemas say what the records say."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.schemas import FOLDER, up_to_date

FOUND = dict(up_to_date())


@pytest.mark.parametrize("path", FOUND, ids=lambda path: path.name)
def test_it_is_as_its_records_have_it(path: Path) -> None:
    """Also its lists of words, which are those of the program."""
    found = path.read_text("utf-8")
    assert json.loads(found) == json.loads(FOUND[path]), "write it anew: python -m tests.schemas"
    assert found == FOUND[path]


def test_every_schema_is_written_from_records() -> None:
    assert {path.name for path in FOLDER.glob("*.json")} == {path.name for path in FOUND}
