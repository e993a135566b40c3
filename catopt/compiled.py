"""Kernel functions as plain Python, or compiled where that is the sooner done.

Every kernel function is plain Python. `compiled(f, work)` gives it as it stands while the work is
smaller than compiling would cost; beyond that, or when its machine code is kept on disk, it gives
numba's version of it and of every function of catopt that it names. The digits are the same.
"""

from __future__ import annotations

import math
import os
import sys
import time
from collections.abc import Callable
from contextlib import nullcontext
from functools import cache
from typing import Any, Final, TypeVar

from catopt.errors import refused
from catopt.words import Message

F = TypeVar("F", bound=Callable[..., Any])
C = TypeVar("C", bound=type)

VARIABLE: Final = "CATOPT_COMPILE"
"""Environment variable that chooses the form of all kernel functions."""
MODES: Final = ("auto", "always", "never")
"""What it may say; the first when it is not set."""

_LOADING: Final = 1.0
"""Processor time that importing numba and reading machine code from disk takes, s."""
_READING: Final = 0.2
"""The same of one more function, once another is in use, s."""

_done: dict[Callable[..., Any], float] = {}
"""Processor time that each function has taken so far as plain Python, s."""
_fast: dict[Callable[..., Any], Callable[..., Any]] = {}
"""Compiled functions, by the plain ones."""
_when_compiling: list[Callable[[], None]] = []
_when_damaged: list[Callable[[str], None]] = []


def inlined(function: F) -> F:
    """Mark a short function to be compiled into its callers; as a plain function it stays itself.

    Worth it for what every line passes through: a quarter off each line's time. Doing so with every
    function saves a little more and takes four times as long to compile.
    """
    function.is_inlined = True  # type: ignore[attr-defined]
    return function


def packed(of: C) -> C:
    """Mark a class of named tuples to be handed on by address between compiled functions.

    Worth it for tuples of many arrays, which compiled functions read and neither make nor return.
    """
    of.is_packed = True  # type: ignore[attr-defined]
    return of


def when_compiling(tell: Callable[[], None]) -> None:
    """Have something said once when a function must be compiled; not when it is read from disk.

    Compiling takes some ten seconds, and whoever waits should know why. `tell` takes the place of
    an earlier one.
    """
    _when_compiling[:] = [tell]


def when_cache_is_damaged(tell: Callable[[str], None]) -> None:
    """Have something said once, with the name of the file, when kept machine code is of no use."""
    _when_damaged[:] = [tell]


def compiled(function: Callable[..., Any], work: float = math.inf) -> Callable[..., Any]:
    """Return a kernel function in the form that is the sooner done with some work.

    The function is plain Python on numbers, tuples and arrays; `work` is about the seconds that it
    takes so. What it has taken before is added: many small jobs are one large one. Either form
    gives the same digits; Ctrl-C waits while it runs compiled. InputError when CATOPT_COMPILE says
    something unknown, or "always" where numba is missing.
    """
    mode = _mode()
    if mode == "never":
        return _plain(function)
    if function not in _fast:
        total = math.inf if mode == "always" else _done.get(function, 0.0) + work
        if not _is_worth_compiling(function, total):
            return _plain(function)
        from catopt.machine_code import dispatcher, listen

        listen(_when_compiling, _when_damaged)
        _fast[function] = dispatcher(function)
    return _fast[function]


def is_compiled(function: Callable[..., Any]) -> bool:
    """Whether a kernel function is in use in its compiled form."""
    return function in _fast


def _mode() -> str:
    mode = os.environ.get(VARIABLE) or MODES[0]
    allowed = None
    if mode not in MODES:
        allowed = Message("refused.one_of", words=", ".join(MODES))
    elif mode == "always" and not _has_numba():
        allowed = Message("refused.no_numba")
    if allowed:
        raise refused(VARIABLE, repr(mode), allowed, "environment")
    return mode


@cache
def _has_numba() -> bool:
    # numba colours every error, and of a thousand that it meets on its way it shows none.
    os.environ.setdefault("NUMBA_DISABLE_ERROR_MESSAGE_HIGHLIGHTING", "1")
    try:
        import numba  # noqa: F401
    except ImportError:
        return False
    return True


def _is_worth_compiling(function: Callable[..., Any], work: float) -> bool:
    """Whether it is less work to have the machine code than to do without; see `_LOADING`."""
    loading = _READING if _fast else _LOADING
    if work < loading or not _has_numba():
        return False
    from catopt.machine_code import cost, is_kept

    return work > loading + cost(function) or is_kept(function)


_now: Callable[[], float] = getattr(time, "thread_time", time.process_time)
"""Seconds that this thread took; a browser knows those of the process alone."""


@cache
def _plain(function: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap a function so that numpy divides by zero in it as compiled code does, without a word."""

    def call(*arguments: Any) -> Any:
        numpy = sys.modules.get("numpy")
        began = _now()
        with nullcontext() if numpy is None else numpy.errstate(all="ignore"):
            result = function(*arguments)
        _done[function] = _done.get(function, 0.0) + _now() - began
        return result

    return call
