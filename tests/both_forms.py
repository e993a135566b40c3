"""Every call of a compiled function made twice, plain on copies of what it takes, and compared."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from copy import deepcopy
from typing import Any

import numpy as np
import pytest

from catopt import compiled as module
from catopt.machine_code import dispatcher

__all__ = ["both_forms"]


@contextmanager
def both_forms() -> Iterator[set[str]]:
    """Let every kernel function be called in both forms inside the block.

    Yields
    ------
    set of str
        Names of the functions that were called.

    Raises
    ------
    AssertionError
        When they differ in a bit of what they return or leave in an array.
    """
    called: set[str] = set()

    def beside(function: Callable[..., Any], _: float = 0.0) -> Callable[..., Any]:
        plain, fast = module._plain(function), dispatcher(function)

        def call(*arguments: Any) -> Any:
            called.add(function.__name__)
            copies = deepcopy(arguments)
            expected = plain(*copies)
            found = fast(*arguments)
            unlike = list(_unlike("result", found, expected))
            for number, (one, other) in enumerate(zip(arguments, copies, strict=True)):
                unlike += _unlike(f"[{number}]", one, other)
            assert not unlike, f"{function.__name__}: {unlike}"
            return found

        return call

    with pytest.MonkeyPatch.context() as patch:
        for name, each in list(sys.modules.items()):
            if name.startswith("catopt.") and hasattr(each, "compiled") and each is not module:
                patch.setattr(each, "compiled", beside)
        yield called


def _unlike(where: str, one: Any, other: Any) -> Iterator[str]:
    """Name what differs in a bit."""
    if isinstance(one, tuple):
        names = getattr(one, "_fields", range(len(one)))
        for name, a, b in zip(names, one, other, strict=True):
            yield from _unlike(f"{where}.{name}", a, b)
    elif one is not None:
        a, b = np.asarray(one), np.asarray(other)
        same = (a == b) | ((a != a) & (b != b))
        if not same.all():
            place = np.argwhere(~same)[0]
            yield f"{where}{place.tolist()}: {a[tuple(place)]!r} and {b[tuple(place)]!r}"
