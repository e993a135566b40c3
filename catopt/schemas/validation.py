"""Compares a document with its JSON Schema, by the keywords that catopt's own schemas use."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from catopt.documents import Path, dotted
from catopt.errors import Problem
from catopt.words import Listed, Message

Schema = Mapping[str, Any] | bool

_KINDS: Mapping[str, tuple[type | tuple[type, ...], str]] = {
    "object": (dict, "refused.an_object"),
    "array": (list, "refused.a_list"),
    "string": (str, "refused.a_string"),
    "boolean": (bool, "refused.a_boolean"),
    "null": (type(None), "refused.a_null"),
    "number": ((int, float), "refused.a_number"),
    "integer": ((int, float), "refused.a_whole_number"),
}
"""Of values: their types in Python, and what messages call them."""

_BOUNDS: Mapping[str, tuple[Callable[[float, float], bool], str]] = {
    "minimum": (lambda value, bound: value >= bound, "refused.or_more"),
    "maximum": (lambda value, bound: value <= bound, "refused.or_less"),
    "exclusiveMinimum": (lambda value, bound: value > bound, "refused.above"),
    "exclusiveMaximum": (lambda value, bound: value < bound, "refused.below"),
}


def inconsistencies(document: Any, schema: Mapping[str, Any]) -> Iterator[Problem]:
    """Yield what a document, as the JSON reader returns it, has otherwise than its JSON Schema."""
    for path, found, allowed in _misfits(document, schema, (), schema):
        yield Problem(dotted(path) or "document", found, allowed)


_Misfit = tuple[Path, str, Message]


def _misfits(value: Any, schema: Schema, path: Path, whole: Mapping[str, Any]) -> Iterator[_Misfit]:
    if isinstance(schema, bool):
        if not schema:
            yield path, _shown(value), Message("refused.leave_out")
        return
    if "$ref" in schema:
        referred: Any = whole
        for key in schema["$ref"].removeprefix("#/").split("/"):
            referred = referred[key]
        yield from _misfits(value, referred, path, whole)
    if "type" in schema and not _is_of(value, schema["type"]):
        kinds = [schema["type"]] if isinstance(schema["type"], str) else schema["type"]
        what = Listed([Message(_KINDS[kind][1]) for kind in kinds], "or")
        yield path, _shown(value), Message("refused.this_is_wanted", what=what)
        return
    yield from ((path, _shown(value), allowed) for allowed in _of_value(value, schema))
    if isinstance(value, list):
        yield from _of_array(value, schema, path, whole)
    if isinstance(value, dict):
        yield from _of_object(value, schema, path, whole)
    yield from _combined(value, schema, path, whole)


def _of_value(value: Any, schema: Mapping[str, Any]) -> Iterator[Message]:
    """Say what a single value has to be otherwise."""
    if "const" in schema and not _same(value, schema["const"]):
        yield Message("refused.this_is_wanted", what=_shown(schema["const"]))
    if "enum" in schema and not any(_same(value, word) for word in schema["enum"]):
        yield Message("refused.one_of", words=", ".join(map(_shown, schema["enum"])))
    if isinstance(value, str) and not re.search(schema.get("pattern", ""), value):
        yield Message("refused.must_match", pattern=schema["pattern"])
    if _is_of(value, "number"):
        for keyword, (is_kept, words) in _BOUNDS.items():
            if keyword in schema and not is_kept(value, schema[keyword]):
                yield Message(words, bound=schema[keyword])


def _of_array(
    value: list[Any], schema: Mapping[str, Any], path: Path, whole: Mapping[str, Any]
) -> Iterator[_Misfit]:
    if len(value) < schema.get("minItems", 0):
        yield path, _shown(value), Message("refused.at_least_wanted", count=schema["minItems"])
    if len(value) > schema.get("maxItems", len(value)):
        yield path, _shown(value), Message("refused.at_most_wanted", count=schema["maxItems"])
    for index, item in enumerate(value):
        yield from _misfits(item, schema.get("items", True), (*path, index), whole)


def _of_object(
    value: dict[str, Any], schema: Mapping[str, Any], path: Path, whole: Mapping[str, Any]
) -> Iterator[_Misfit]:
    known = schema.get("properties", {})
    for key in schema.get("required", ()):
        if key not in value:
            yield (*path, key), "", Message("refused.is_missing")
    for key, item in value.items():
        further = known.get(key, schema.get("additionalProperties", True))
        if further is False and key not in known:
            yield (*path, key), Message("refused.unknown_key"), Message("refused.leave_out")
        else:
            yield from _misfits(item, further, (*path, key), whole)


def _combined(
    value: Any, schema: Mapping[str, Any], path: Path, whole: Mapping[str, Any]
) -> Iterator[_Misfit]:
    """Hold a value to one of several schemas, and to one that depends on another."""
    for keyword in ("oneOf", "anyOf"):
        if keyword not in schema:
            continue
        tried = [list(_misfits(value, option, path, whole)) for option in schema[keyword]]
        fitting = sum(not misfits for misfits in tried)
        if not fitting:  # the one that fits furthest into the document was meant
            yield from max(tried, key=lambda each: max(len(place) for place, _, _ in each))
        elif keyword == "oneOf" and fitting > 1:
            yield path, _shown(value), Message("refused.only_one_kind")
    if "if" in schema:
        met = not any(_misfits(value, schema["if"], path, whole))
        yield from _misfits(value, schema.get("then" if met else "else", True), path, whole)


def _is_of(value: Any, kinds: str | list[str]) -> bool:
    whole = isinstance(value, int) or (isinstance(value, float) and value.is_integer())
    for kind in [kinds] if isinstance(kinds, str) else kinds:
        if isinstance(value, bool) and kind != "boolean":
            continue
        if isinstance(value, _KINDS[kind][0]) and (whole or kind != "integer"):
            return True
    return False


def _same(value: Any, other: Any) -> bool:
    return type(value) is type(other) and bool(value == other)


def _shown(value: Any) -> str:
    if isinstance(value, dict):
        return Message("refused.an_object")
    if isinstance(value, list):
        return Message("refused.an_array" if value else "refused.an_empty_array", count=len(value))
    if value is None or isinstance(value, bool):
        return str(value).lower().replace("none", "null")
    shown = repr(value)
    return shown if len(shown) <= 40 else f"{shown[:37]}..."
