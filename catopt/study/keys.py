"""Keys of a case file, or of a file for ``catopt size``, that a study varies."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import Any

from catopt.casefile.location import parts
from catopt.casefile.names import hint
from catopt.casefile.schema import CaseTable, Table, entries
from catopt.errors import InputError, Problem
from catopt.model.kinds import Kind, Measured
from catopt.sizing.schema import schema_of
from catopt.study.base import Base


def kind_of_key(base: Base, key: str) -> Kind:
    """Return what a key path takes.

    Raises InputError, about ``key``, for one that the file cannot have, that is no single value, or
    that counts into an array of tables which the file does not have.
    """
    top = CaseTable if base.moored is None else schema_of(base.moored)
    table: type[Table] | None = top
    place: Any = base.document
    entry = None
    for at, part in enumerate(parts(key)):
        if isinstance(part, int):
            if entry is None or not entry.array:
                raise _refused(key, "this is no array")
            if not isinstance(place, list) or part >= len(place):
                there = len(place) if isinstance(place, list) else 0
                raise _refused(key, f"the file has {there} of them, counted from 0")
            place = place[part]
            continue
        if table is None:
            raise _refused(key, "a single value has no keys")
        if part not in entries(table):
            raise _refused(key, f"no such key; {hint(table, part, top)}")
        entry = entries(table)[part]
        table = entry.table
        place = place.get(part) if isinstance(place, dict) else None
        is_last = at == len(parts(key)) - 1
        if is_last and entry.array:
            raise _refused(key, f"an array; one of it is wanted, such as {key}[0]")
    if entry is None or entry.kind is None:
        raise _refused(key, "the key path of a single value, such as load.horizontal_force")
    return entry.kind


def with_changes(base: Base, changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the document of a member: that of the base, with its own values in place."""
    document = copy.deepcopy(base.document)
    for key, value in changes.items():
        place: Any = document
        *above, last = parts(key)
        for part in above:
            place = place[part] if isinstance(part, int) else place.setdefault(part, {})
        place[last] = value
    return document


def in_file(kind: Kind, si: Any) -> Any:
    """Write a value in SI as the file has it: a bare number may be in another unit there."""
    if isinstance(kind, Measured) and kind.bare:
        return f"{si!r} {kind.dimension.si_unit}"
    return si


def _refused(key: str, allowed: str) -> InputError:
    return InputError([Problem("key", f'"{key}"', allowed)])
