"""The kernel's functions compiled: the same source, made fast for many lines.

`compiled(f)` gives numba's version of a plain function, with every kernel function that it names
compiled too. One line is solved by the plain functions and never imports numba.
"""

from __future__ import annotations

import hashlib
import inspect
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any

__all__ = ["compiled"]

INLINED = frozenset(
    {
        "_plain",
        "_step",
        "atanh_excess",
        "clump_weight",
        "drop",
        "grounded_guess",
        "has_buoyancy",
        "hung_state",
        "is_inextensible",
        "is_plain",
        "length_below",
        "lie",
        "piece_reach",
        "rise_by_V",
        "total_length",
        "total_weight",
        "walk",
    }
)
"""What a plain line passes through, compiled into its callers: a quarter off each line's time.

Doing so with every function saves a little more and takes four times as long to compile.
"""

KERNEL = __name__.rpartition(".")[0]


@cache
def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile a kernel function, and those it calls.

    The machine code is kept on disk by numba, which looks only at the function's own file to see
    whether it is out of date. The name therefore carries a digest of all kernel sources.
    """
    import numba

    plain = _twin(function)
    inline = function.__name__ in INLINED
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
        name: compiled(value)
        if isinstance(value := function.__globals__[name], FunctionType)
        and value.__module__.startswith(KERNEL)
        else value
        for name in function.__code__.co_names
        if name in function.__globals__
    }
    module = {"__name__": function.__module__, "__builtins__": __builtins__, **names}
    twin = FunctionType(
        function.__code__, module, function.__name__, function.__defaults__, function.__closure__
    )
    twin.__qualname__ = f"{function.__qualname__}_{_digest()}"
    twin.__module__ = function.__module__
    return twin


@cache
def _digest() -> str:
    """Digest of the kernel's sources."""
    folder = Path(inspect.getfile(sys.modules[__name__])).parent
    total = hashlib.sha256()
    for source in sorted(folder.glob("*.py")):
        total.update(source.read_bytes())
    return total.hexdigest()[:12]
