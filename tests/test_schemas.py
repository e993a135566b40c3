"""The JSON schemas say what the records say."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.schemas import DEFINITIONS, RECORDS, up_to_date


@pytest.mark.parametrize(("path", "text"), list(up_to_date()), ids=[*RECORDS, *DEFINITIONS])
def test_it_is_as_its_records_have_it(path: Path, text: str) -> None:
    found = path.read_text("utf-8")
    assert json.loads(found) == json.loads(text), "write it anew: python -m tests.schemas"
    assert found == text
