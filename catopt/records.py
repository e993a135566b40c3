"""A result described once: unit, bounds and meaning stand at its attributes, and documents follow.

A record says in `DOCUMENT` what its document has, in its order: attributes, each by its name with
its unit behind it, so that ``tension``, a force, is ``tension_N``. A dotted name is an attribute of
an attribute; ``swarm=pso`` has another key. Behind a name, ``?`` leaves the key out where the value
is None, ``*`` where nobody asks for it, and ``~`` is for a key that older documents lack. What is a
method is put in by whoever lays the record out. The JSON schemas are written from the same lines
(`python -m tests.schemas`): type and bounds from the annotation, meaning from the docstring.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import cache, cached_property
from types import FunctionType
from typing import Annotated, Any, ClassVar, NamedTuple, get_args, get_type_hints

MARKS = "?*~"


class From(NamedTuple):
    """Least value of a whole number, or fewest values of an array; stands in ``Annotated``."""

    least: int


class Matching(NamedTuple):
    """Pattern of a text; stands in ``Annotated``."""

    pattern: str


class OrNull:
    """Stands in ``Annotated`` of an array that may have nan: null in documents."""


Counted = Annotated[int, From(1)]
FromZero = Annotated[int, From(0)]


class Record:
    """A result, or a part of one, that is described once."""

    DOCUMENT: ClassVar[str] = ""
    """What its document has."""
    SCHEMA: ClassVar[str] = ""
    """Name of its document, where it is a whole one."""

    def to_dict(self) -> dict[str, Any]:
        """Lay it out as its document has it, in SI."""
        return laid_out(self)


class Key(NamedTuple):
    """One key of a document: the attributes that lead to it, its key, its mark and its type."""

    path: tuple[str, ...]
    key: str
    mark: str
    hint: Any
    owner: type
    """Class of the last attribute."""


def laid_out(of: Record, document: str = "") -> dict[str, Any]:
    """Lay a record out by its `DOCUMENT`, or another one; numbers that are not finite are null."""
    found: dict[str, Any] = {"schema": of.SCHEMA} if of.SCHEMA and not document else {}
    for part in parts(type(of), document or of.DOCUMENT):
        value: Any = of
        for name in part.path:
            value = None if value is None else getattr(value, name)
        if not callable(value) and part.mark != "*" and (part.mark != "?" or value is not None):
            found[part.key] = _plain(value)
    return found


_READ: dict[tuple[type, str], tuple[Key, ...]] = {}


def parts(of: type, document: str) -> tuple[Key, ...]:
    """Read what a document of a class has; once."""
    if (of, document) not in _READ:
        _READ[of, document] = tuple(_part(of, word) for word in document.split())
    return _READ[of, document]


def _part(of: type, word: str) -> Key:
    mark = word[-1] if word[-1] in MARKS else ""
    name, _, key = word.removesuffix(mark).partition("=")
    path = tuple(name.split("."))
    owner, hint = of, _hint(of, path[0])
    for each in path[1:]:
        owner = next(kind for kind in _types(hint) if hasattr(kind, "__annotations__"))
        hint = _hint(owner, each)
    unit = unit_of(hint)
    return Key(path, key or path[-1] + (f"_{unit}" if unit else ""), mark, hint, owner)


def _hint(of: type, name: str) -> Any:
    found = next((vars(each)[name] for each in of.__mro__ if name in vars(each)), None)
    if isinstance(found, property):
        found = found.fget
    if isinstance(found, cached_property):
        found = found.func
    if isinstance(found, FunctionType):
        return get_type_hints(found, include_extras=True)["return"]
    return _hints(of)[name]


@cache
def _hints(of: type) -> Mapping[str, Any]:
    return get_type_hints(of, include_extras=True)


def _types(hint: Any) -> Iterator[Any]:
    """Yield a type and all that it is made of, with what stands in ``Annotated``."""
    yield hint
    yield from getattr(hint, "__metadata__", ())
    for each in get_args(hint):
        yield from _types(each)


def unit_of(hint: Any) -> str:
    """Return the SI unit of a type as keys have it: ``N_per_m``; empty where there is none."""
    units = (each.si_unit for each in _types(hint) if hasattr(each, "si_unit"))
    return next(units, "").replace("/", "_per_").replace("^", "").replace("*", "")


def _plain(value: Any) -> Any:
    if isinstance(value, Record):
        return value.to_dict()
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {key: _plain(each) for key, each in value.items()}
    if isinstance(value, tuple | list):
        return [_plain(each) for each in value]
    return _plain(value.tolist()) if hasattr(value, "tolist") else value
