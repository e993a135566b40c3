"""What is wrong with inputs: gathered until all have been tried, as the caller spells them."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping
from typing import Any, Protocol, TypeVar

from catopt.errors import InputError, Problem
from catopt.sizing.inputs import Input
from catopt.units import as_written

Made = TypeVar("Made")


class Spelling(Protocol):
    """How a caller writes the name of an input."""

    def __call__(self, name: str, index: int | None = None) -> str:
        """Write it; `index` counts several values from 0."""


def as_keyword(name: str, index: int | None = None) -> str:
    """Write an input as a keyword in Python."""
    return name if index is None else f"{name}[{index}]"


class ErrorCollector:
    """Makes values out of inputs and keeps what is wrong with them until all have been tried.

    `spell` writes a name as the caller does, `source` is who is told, for the error; of inputs in
    `reported` a fault is known, and no more is said. `called` has further names by what the model
    calls them: a key, or ``source.key``. `written`: inputs as they were given; text with a unit is
    shown so, not in SI.
    """

    def __init__(
        self,
        inputs: Mapping[str, Input],
        spell: Spelling = as_keyword,
        source: str = "",
        reported: Collection[str] = (),
        called: Mapping[str, str] | None = None,
        written: Mapping[str, object] | None = None,
    ) -> None:
        self._written = written or {}
        self.spell, self.source = spell, source
        self._reported = set(reported)
        self._names = {name: name for name in inputs}
        self._names |= {each: row.name for row in inputs.values() for each in row.called}
        self._names |= called or {}
        self._problems: list[Problem] = []

    def is_reported(self, name: str) -> bool:
        """Say whether something is wrong with an input."""
        return name in self._reported

    def no_more_of(self, name: str) -> None:
        """Keep no further problem of an input."""
        self._reported.add(name)

    def add(self, name: str, found: str, allowed: str, index: int | None = None) -> None:
        """Keep a problem of an input."""
        if name not in self._reported:
            self._problems.append(Problem(self.spell(name, index), found, allowed))

    def read(
        self, name: str, reader: Callable[[Any], Made], value: object, index: int | None = None
    ) -> Made | None:
        """Read a value of an input; None, with what is wrong kept, when it cannot be read."""
        try:
            return reader(value)
        except InputError as error:
            for each in error.problems:
                self.add(name, each.found, each.allowed, index)
        return None

    def make(self, maker: Callable[..., Made], *parts: Any) -> Made | None:
        """Make a value out of others; None when it cannot be made, or one of them was not.

        `maker` may raise InputError, which is kept; None among `parts` means that it was not made.
        """
        if any(part is None for part in parts):
            return None
        try:
            return maker(*parts)
        except InputError as error:
            for each in error.problems:
                key, index = each.key, None
                if one_of_several := re.fullmatch(r"(.+)\[(\d+)\]", key):
                    key, index = one_of_several[1], int(one_of_several[2])
                name = self._names.get(f"{error.source}.{key}", self._names.get(key))
                if name is None:
                    self._problems.append(each)
                else:
                    self.add(name, self._as_given(name, index, each.found), each.allowed, index)
        return None

    def _as_given(self, name: str, index: int | None, found: str) -> str:
        """Return text with a unit as the caller wrote it where a bare number was found."""
        value = self._written.get(name)
        if index is not None and isinstance(value, (list, tuple)) and index < len(value):
            value = value[index]
        is_bare = re.fullmatch(r"-?[\d.]+(e[-+]?\d+)?", found) is not None
        return as_written(value) if isinstance(value, str) and is_bare else found

    def made(self, maker: Callable[..., Made], *parts: Any) -> Made:
        """Make a value as `make` does; raise with all that was kept where anything is wrong."""
        found = self.make(maker, *parts)
        self.raise_if_any()
        assert found is not None
        return found

    def raise_if_any(self) -> None:
        """Raise InputError with all that was kept, each once; with nothing, if all is told."""
        if self._problems or self._reported:
            raise InputError(tuple(dict.fromkeys(self._problems)), self.source)
