"""The JSON schemas say what the records say."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.schemas import FOLDER, up_to_date, worded

FOUND = dict(up_to_date())


@pytest.mark.parametrize("path", FOUND, ids=lambda path: path.name)
def test_it_is_as_its_records_have_it(path: Path) -> None:
    """Also its lists of words, which are those of the program."""
    found = path.read_text("utf-8")
    assert json.loads(found) == json.loads(FOUND[path]), "write it anew: python -m tests.schemas"
    assert found == FOUND[path]


def test_no_list_of_words_is_tied_to_nothing() -> None:
    """Schemas that are neither written from records nor named with the places of their words."""
    others = [each for each in FOLDER.glob("*.json") if each not in FOUND]
    assert [path.name for path in others if list(worded(json.loads(path.read_text())))] == []
