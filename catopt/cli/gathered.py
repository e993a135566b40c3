"""Values made of options: what is wrong with any of them is told at once, by the options' names."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from catopt.errors import Problem

__all__ = ["Gathered"]

Made = TypeVar("Made")


class Gathered:
    """Makes values and keeps what is wrong with them until all have been tried.

    Parameters
    ----------
    options : mapping of str to str
        Options by what they are called in Python: by key, or by ``source.key``.
    """

    def __init__(self, options: Mapping[str, str]) -> None:
        self._options = options
        self._problems: list[Problem] = []

    def make(self, maker: Callable[..., Made], *parts: Any) -> Made | None:
        """Make a value out of others; None when it cannot be made, or one of them was not.

        Parameters
        ----------
        maker : callable
            May raise InputError, which is kept.
        *parts
            What it is called with; None among them means that it was not made.
        """
        from catopt.errors import InputError

        if any(part is None for part in parts):
            return None
        try:
            return maker(*parts)
        except InputError as error:
            source = error.source
            self._problems += [replace(p, key=self._option(source, p.key)) for p in error.problems]
        return None

    def add(self, key: str, found: str, allowed: str) -> None:
        """Keep a problem of an option."""
        from catopt.errors import Problem

        self._problems.append(Problem(key, found, allowed))

    def raise_if_any(self) -> None:
        """Raise InputError with all that was kept, each once."""
        from catopt.errors import InputError

        if self._problems:
            raise InputError(tuple(dict.fromkeys(self._problems)), "options")

    def _option(self, source: str, key: str) -> str:
        return self._options.get(f"{source}.{key}", self._options.get(key, key))
