"""Names of before, which are read for one version, each with a DeprecationWarning."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, ParamSpec, TypeVar
from warnings import warn

P = ParamSpec("P")
R = TypeVar("R")


class OldName:
    """An attribute by its old name: ``excess = OldName("exceedance")``."""

    def __init__(self, new: str) -> None:
        self._new = new

    def __set_name__(self, owner: type, old: str) -> None:
        self._said = f"{old} of {owner.__name__} is {self._new} now"

    def __get__(self, of: Any, owner: type) -> Any:
        if of is None:
            return self
        warn(self._said, DeprecationWarning, stacklevel=2)
        return getattr(of, self._new)


def renamed(**new: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let a function take keywords by their old names, too: ``@renamed(old="new")``."""

    def taking_both(function: Callable[P, R]) -> Callable[P, R]:
        @wraps(function)
        def called(*args: P.args, **given: P.kwargs) -> R:
            for old in new.keys() & given.keys():
                said = f"{old} of {function.__name__} is {new[old]} now"
                warn(said, DeprecationWarning, stacklevel=2)
                given[new[old]] = given.pop(old)
            return function(*args, **given)

        return called

    return taking_both


def old_function(old: str, function: Callable[P, R]) -> Callable[P, R]:
    """Make a function that has an old name: ``held_body = old_function("held_body", ...)``."""

    @wraps(function)
    def called(*args: P.args, **given: P.kwargs) -> R:
        warn(f"{old} is {function.__name__} now", DeprecationWarning, stacklevel=2)
        return function(*args, **given)

    return called
