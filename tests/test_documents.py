"""The one reader of files: what is no file for it, no text, no document."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from catopt import schemas
from catopt.documents import MOST_BYTES, parse_json, parse_toml, read_text
from catopt.errors import InputError
from catopt.schemas.validation import inconsistencies
from tests.fuzz.kinds import kinds
from tests.fuzz.mutations import PARTS


def refused(function: Any, *arguments: Any, **named: Any) -> str:
    with pytest.raises(InputError) as caught:
        function(*arguments, **named)
    return str(caught.value)


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="has no such devices")
@pytest.mark.parametrize("name", ["/dev/zero", "/dev/stdin", "/dev/full"])
def test_what_is_no_regular_file_is_not_opened(name: str) -> None:
    if name == "/dev/stdin" and Path(name).is_file():
        pytest.skip("standard input is a file here")
    assert "case file: it is not a regular file" in refused(read_text, Path(name), name)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="has no pipes with names")
def test_nor_is_a_pipe_that_nobody_writes_to(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert "it is not a regular file" in refused(read_text, tmp_path / "pipe", "pipe")


def test_a_file_beyond_the_limit_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.touch()
    os.truncate(path, MOST_BYTES + 1)  # it takes no room on the disk
    assert "case file: it has 4.0 MB; at most 4 MB" in refused(read_text, path, "case.toml")
    os.truncate(path, 10)
    assert read_text(path, "case.toml") == "\0" * 10


@pytest.mark.parametrize(
    ("parse", "text", "said"),
    [
        (parse_toml, "a = " + "[" * 5000 + "]" * 5000, "file: arrays or tables are nested too"),
        (parse_toml, "a = " + "[" * 40 + "]" * 40, "a[0]: arrays or tables are nested too deeply"),
        (
            parse_toml,
            ".".join("a" * 50) + " = 1",
            "the key has more than 20 parts; tables are nested too deeply",
        ),
        (parse_toml, "a = " + "1" * 5000, "file: a number has too many digits"),
        (parse_json, "[" * 100_000, "file: arrays or tables are nested too deeply"),
        (parse_json, '{"a": ' + "1" * 5000 + "}", "file: a number has too many digits"),
        (parse_json, '{"a": NaN}', "file: NaN is no finite number"),
        (parse_json, '{"a": 1e999}', "file: 1e999 is no finite number"),
        (parse_json, "[1]", "file: an object in braces is required"),
        (parse_json, '{\n "a": 1,\n "b"}', 'line 3, column 5: found `"b"}`; it is no JSON'),
        (parse_json, '{"a": ["\\u0007"]}', "a[0]: found U+0007, a control character"),
        (parse_json, '{"\\ud800": 1}', "found U+D800"),
    ],
)
def test_what_is_no_document_is_refused_with_place_and_reason(
    parse: Any, text: str, said: str
) -> None:
    assert said in refused(parse, text, "file")


def documents() -> list[tuple[str, dict[str, Any]]]:
    made = [json.loads(kind.texts[0]) for kind in kinds() if kind.form == "json"]
    return [(each["schema"], each) for each in made]


def places(part: Any) -> list[tuple[Any, Any]]:
    inner = part.items() if isinstance(part, dict) else enumerate(part)
    found = [(part, key) for key, _ in inner]
    values = list(part.values()) if isinstance(part, dict) else part
    return found + [p for each in values if isinstance(each, dict | list) for p in places(each)]


@pytest.mark.parametrize(("name", "document"), documents(), ids=lambda each: str(each)[:20])
def test_a_document_fits_its_schema_where_jsonschema_says_so(
    name: str, document: dict[str, Any]
) -> None:
    """Each part of it replaced by something else, and left out."""
    schema = schemas.schema(name)
    oracle = jsonschema.Draft202012Validator(schema)
    assert list(inconsistencies(document, schema)) == []
    if "front" in document:
        document["front"] = document["front"][:1]  # the oracle takes its time
    compared = 0
    found = places(document)
    for part, key in found[:: 1 + len(found) // 60]:
        before = part[key]
        for other in PARTS[compared % 3 :: 3]:
            part[key] = other
            assert (list(inconsistencies(document, schema)) == []) == oracle.is_valid(document), (
                key,
                other,
            )
            compared += 1
        part[key] = before
    assert compared > 80
