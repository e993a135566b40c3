"""Between the fields of a form and the text of a file."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

from catopt.casefile.location import parts
from catopt.desk.fields import START, Door, Field, fields_of
from catopt.documents import parse_toml
from catopt.numerals import bare_number

__all__ = ["door_of", "text_of", "values_of"]


def door_of(document: Mapping[str, Any]) -> Door:
    """Say which door a document is for."""
    from catopt.casefile.sizing_file import moored_of

    return moored_of(dict(document)) or ("body" if "system" in document else "line")


def text_of(door: Door, values: Mapping[str, str], base: str = "") -> str:
    """Write the TOML file that the fields of a form come to.

    `values` are by key, as they stand in the fields; what is empty is left out. `base` is the file
    that was opened: what no field has is kept of it, but for comments.

    Examples
    --------
    >>> print(text_of("line", {"site.water_depth": "9,5", "line.segments[0].length": "20 m"}))
    [site]
    water_depth = "9.5 m"
    <BLANKLINE>
    [line]
    <BLANKLINE>
    [[line.segments]]
    length = "20 m"
    <BLANKLINE>
    """
    document = parse_toml(base, "")
    for field in fields_of(door):
        _put(document, parts(field.key), _value(field, values.get(field.key, ""), door))
    return "".join(_tables(document, ())).lstrip("\n")


def values_of(door: Door, text: str) -> dict[str, str]:
    """Read the fields of a form out of a file; those that it leaves out are not there."""
    document = parse_toml(text, "")
    found = ((field.key, _at(document, parts(field.key))) for field in fields_of(door))
    return {key: _shown(value) for key, value in found if value is not None}


def _value(field: Field, text: str, door: Door) -> object:
    """Take what stands in a field as a file has it; a bare number gets the unit of the field."""
    one = [each.strip() for each in text.split(";")] if field.several else [text.strip()]
    taken = [_one(field, each, door) for each in one if each]
    if not taken:
        return None
    return taken if field.several else taken[0]


def _one(field: Field, text: str, door: Door) -> object:
    if field.is_text:
        return text
    if text in ("true", "false"):
        return text == "true"
    number = bare_number(text)
    example = (START[door].get(field.key) or field.example).partition(";")[0]
    _, _, unit = example.partition(" ")
    is_measure = unit and isinstance(bare_number(example.split(" ")[0]), int | float)
    return f"{number} {unit}" if is_measure and not isinstance(number, str) else number


def _put(document: dict[str, Any], path: tuple[str | int, ...], value: object) -> None:
    """Put a value into its table, which is made where there is none; None takes it out."""
    place: Any = document
    for part, below in pairwise(path):
        is_there = part < len(place) if isinstance(part, int) else part in place
        if not is_there:
            if value is None:
                return
            if isinstance(part, int):
                place.append({})
            else:
                place[part] = [] if isinstance(below, int) else {}
        place = place[part]
        if not isinstance(place, dict | list):
            return
    if value is None:
        place.pop(path[-1], None)
    else:
        place[path[-1]] = value


def _at(document: Any, path: tuple[str | int, ...]) -> Any:
    for part in path:
        try:
            document = document[part]
        except (KeyError, IndexError, TypeError):
            return None
    return document


def _shown(value: object) -> str:
    if isinstance(value, list):
        return "; ".join(map(_shown, value))
    return str(value).lower() if isinstance(value, bool) else str(value)


def _tables(table: Mapping[str, Any], path: tuple[str, ...]) -> Iterator[str]:
    """Write a table: its own keys, then the tables below it."""
    for key, value in table.items():
        if not _is_below(value):
            yield f"{_key(key)} = {_written(value)}\n"
    for key, value in table.items():
        if isinstance(value, dict):
            if not value:
                continue
            yield f"\n[{'.'.join(map(_key, (*path, key)))}]\n"
            yield from _tables(value, (*path, key))
        elif _is_below(value):
            for each in value:
                yield f"\n[[{'.'.join(map(_key, (*path, key)))}]]\n"
                yield from _tables(each, (*path, key))


def _is_below(value: Any) -> bool:
    if isinstance(value, list):
        return bool(value) and all(isinstance(each, dict) for each in value)
    return isinstance(value, dict)


def _key(key: str) -> str:
    return key if key.replace("_", "").replace("-", "").isalnum() and key.isascii() else _text(key)


def _written(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return f"[{', '.join(map(_written, value))}]"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{_key(k)} = {_written(v)}' for k, v in value.items())}}}"
    return _text(value) if isinstance(value, str) else str(value)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
