"""Kernel functions compiled: the same source, made fast for many lines, elements or time steps.

`compiled(f)` gives numba's version of a plain function, with every function of catopt that it names
compiled too. One line is solved by the plain functions and never imports numba.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from functools import cache
from types import FunctionType
from typing import Any, TypeVar

__all__ = ["compiled", "inlined", "when_compiling"]

F = TypeVar("F", bound=Callable[..., Any])

_PACKAGE = __name__.partition(".")[0] + "."


def inlined(function: F) -> F:
    """Mark a short function to be compiled into its callers; as a plain function it stays itself.

    Worth it for what every line passes through: a quarter off each line's time. Doing so with every
    function saves a little more and takes four times as long to compile.
    """
    function.is_inlined = True  # type: ignore[attr-defined]
    return function


_waiting: list[Callable[[], None]] = []
"""To be called before the first function that has to be compiled."""


def when_compiling(tell: Callable[[], None]) -> None:
    """Have something said once when a function must be compiled; not when it is read from disk.

    The first use of a part on a machine compiles for some ten seconds, and whoever waits should
    know why.

    Parameters
    ----------
    tell : callable
        Takes the place of an earlier one.
    """
    _waiting[:] = [tell]


@cache
def _listen() -> None:
    """Hear of numba's compilations."""
    from numba.core import event

    class Listener(event.Listener):
        def on_start(self, event: object) -> None:  # noqa: ARG002 - as numba calls it
            while _waiting:
                _waiting.pop()()

        def on_end(self, event: object) -> None:
            """Nothing is said at the end."""

    event.register("numba:compile", Listener())  # type: ignore[no-untyped-call]


@cache
def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile a kernel function, and those it calls.

    The machine code is kept on disk by numba, which looks only at the function's own file to see
    whether it is out of date. The name therefore carries a digest of every source file that the
    function reaches.
    """
    import numba

    _listen()
    plain = _twin(function)
    inline = hasattr(function, "is_inlined")
    try:
        fast: Any = numba.njit(
            plain, cache=True, error_model="numpy", nogil=True, forceinline=inline
        )
    except RuntimeError:
        # No folder to keep the machine code in: compile anew in each process.
        fast = numba.njit(plain, error_model="numpy", nogil=True, forceinline=inline)
    result: Callable[..., Any] = fast
    return result


def _twin(function: Callable[..., Any]) -> FunctionType:
    """Copy of a function whose globals hold compiled functions where it names kernel functions."""
    assert isinstance(function, FunctionType)
    names = {
        name: compiled(value) if _is_kernel(value) else value
        for name, value in _named(function).items()
    }
    module = {"__name__": function.__module__, "__builtins__": __builtins__, **names}
    twin = FunctionType(
        function.__code__, module, function.__name__, function.__defaults__, function.__closure__
    )
    twin.__qualname__ = f"{function.__qualname__}_{_digest(function)}"
    twin.__module__ = function.__module__
    return twin


def _named(function: FunctionType) -> dict[str, Any]:
    """Globals of its module that a function names."""
    names = function.__code__.co_names
    return {name: function.__globals__[name] for name in names if name in function.__globals__}


def _is_kernel(value: object) -> bool:
    return isinstance(value, FunctionType) and value.__module__.startswith(_PACKAGE)


def _digest(function: FunctionType) -> str:
    """Digest of the source files of a function, of what it reaches and of the tuples it handles."""
    import hashlib
    from pathlib import Path

    reached = list(_reached(function))
    sources = {each.__code__.co_filename for each in reached}
    sources |= _tuple_sources({each.__module__ for each in reached})
    total = hashlib.sha256()
    for source in sorted(sources):
        total.update(Path(source).read_bytes())
    return total.hexdigest()[:12]


def _tuple_sources(modules: set[str]) -> set[str]:
    """Source files of the named tuples that modules know, and of those that these hold in turn.

    Machine code is kept under the layout of its tuples, which is none of the functions' sources.
    """
    sources = set()
    waiting = set(modules)
    known: set[str] = set()
    while waiting:
        module = sys.modules[waiting.pop()]
        known.add(module.__name__)
        for value in vars(module).values():
            if not isinstance(value, type) or not issubclass(value, tuple):
                continue
            if value.__module__.startswith(_PACKAGE):
                sources.add(str(sys.modules[value.__module__].__file__))
                waiting |= {value.__module__} - known
    return sources


def _reached(function: FunctionType) -> Iterator[FunctionType]:
    """Yield a function and every kernel function that it calls, over any number of steps."""
    known: set[FunctionType] = set()
    waiting = [function]
    while waiting:
        each = waiting.pop()
        if each not in known:
            known.add(each)
            waiting += [value for value in _named(each).values() if _is_kernel(value)]
            yield each
