"""A result described once: unit, bounds and meaning stand at its attributes, and documents follow.

A record says in `DOCUMENT` what its document has, in its order: attributes, each by its name with
its unit behind it, so that ``tension``, a force, is ``tension_N``. A dotted name is an attribute of
an attribute, None where that is; ``swarm=pso`` has another key; ``line+1`` counts from 1 what
Python counts from 0; ``parts(name length)`` has these attributes of each part, which needs no
document of its own then. Behind a name, ``?`` leaves the key out where the value is None or empty,
``*`` where nobody asks for it, and ``~`` is for a key that older documents lack. What is a method
is put in by whoever lays the record out. The JSON schemas are written from the same lines
(`python -m tests.schemas`): type and bounds from the annotation, meaning from the docstring.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from functools import cached_property
from types import FunctionType
from typing import Annotated, Any, ClassVar, NamedTuple, get_args, get_type_hints

from catopt._version import identity


class From(NamedTuple):
    """Least value of a whole number, or fewest values of an array; stands in ``Annotated``."""

    least: int


class Matching(NamedTuple):
    """Pattern of a text; stands in ``Annotated``."""

    pattern: str


class OrNull:
    """Stands in ``Annotated`` of an array that may have nan: null in documents."""


Digest = Annotated[str, Matching("^[0-9a-f]{64}$")]
"""SHA-256."""
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
    inner: str = ""
    """What is laid out of it, where that is not its own document."""
    is_counted: bool = False
    """Whether it counts from 1 what the attribute counts from 0."""


def laid_out(of: object, document: str = "") -> dict[str, Any]:
    """Lay a record out by its `DOCUMENT`, or anything by another one.

    Numbers that are not finite are null.
    """
    found: dict[str, Any] = {}
    if isinstance(of, Record) and not document:
        document = of.DOCUMENT
        found |= {"schema": of.SCHEMA, "catopt": identity()} if of.SCHEMA else {}
    for part in parts(type(of), document):
        value: Any = of
        for name in part.path:
            value = None if value is None else getattr(value, name)
        if part.is_counted and value is not None:
            value += 1
        is_none = value is None or (isinstance(value, tuple | list | Mapping) and not value)
        if not callable(value) and part.mark != "*" and not (part.mark == "?" and is_none):
            found[part.key] = _plain(value, part.inner)
    return found


def within(path: str, document: str) -> str:
    """Name the attributes of a document by the path of attributes that leads to what has them."""
    return " ".join(f"{path}.{word}" for word in document.split())


_READ: dict[tuple[type, str], tuple[Key, ...]] = {}
_WORD = re.compile(r"([\w.]+)(\+1)?(?:=(\w+))?(?:\(([^()]*)\))?([?*~]?)(?:\s+|$)")


def parts(of: type, document: str) -> tuple[Key, ...]:
    """Read what a document of a class has; once."""
    if (of, document) not in _READ:
        assert not _WORD.sub("", document), f"{of.__name__}: {document}"
        _READ[of, document] = tuple(_part(of, *each) for each in _WORD.findall(document))
    return _READ[of, document]


def _part(of: type, name: str, counted: str, key: str, inner: str, mark: str) -> Key:
    path = tuple(name.split("."))
    owner, hint, may_lack = of, _hint(of, path[0]), False
    for each in path[1:]:
        may_lack = may_lack or type(None) in get_args(hint)
        owner = next(kind for kind in _types(hint) if _is_described(kind))
        hint = _hint(owner, each)
    unit = unit_of(hint) if not inner else ""
    key = key or path[-1] + (f"_{unit}" if unit else "")
    return Key(path, key, mark, hint | None if may_lack else hint, owner, inner, bool(counted))


def _hint(of: type, name: str) -> Any:
    found = next((vars(each)[name] for each in of.__mro__ if name in vars(each)), None)
    if isinstance(found, property):
        found = found.fget
    if isinstance(found, cached_property):
        found = found.func
    if isinstance(found, FunctionType):
        return get_type_hints(found, include_extras=True)["return"]
    # By attribute: Python 3.14 makes annotations when asked, and a class's namespace has none.
    owner = next(each for each in of.__mro__ if name in getattr(each, "__annotations__", {}))
    # Of this attribute alone: others may be of types that are not there at run time.
    alone = {"__annotations__": {name: owner.__annotations__[name]}, "__module__": owner.__module__}
    return get_type_hints(type("_", (), alone), include_extras=True)[name]


def _is_described(kind: Any) -> bool:
    """Whether it is a class of Python code, which has attributes of a known type."""
    return isinstance(kind, type) and kind.__module__ != "builtins"


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


def _plain(value: Any, inner: str = "") -> Any:
    if isinstance(value, Record) and not inner:
        return value.to_dict()
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {key: _plain(each, inner) for key, each in value.items()}
    if isinstance(value, tuple | list) and not (inner and hasattr(value, "_fields")):
        return [_plain(each, inner) for each in value]
    if inner and value is not None:
        return laid_out(value, inner)
    return _plain(value.tolist()) if hasattr(value, "tolist") else value
