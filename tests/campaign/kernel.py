"""`catopt.solve` with its kernel compiled: the same source, some ten times as fast."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any
from unittest.mock import patch

import numpy as np

from catopt.catenary import equilibrium, layout, pieces, span_or_tension
from catopt.catenary.pieces import LineProblem
from catopt.catenary.state import State
from catopt.compiled import compiled
from catopt.model import Line

__all__ = ["compiled_kernel"]

_KERNEL: dict[str, Any] = {
    "catopt.catenary.solve.given_force": equilibrium.given_force,
    "catopt.catenary.solve.given_span": span_or_tension.given_span,
    "catopt.catenary.solve.given_tension": span_or_tension.given_tension,
    "catopt.catenary.solve.other_forces": span_or_tension.other_forces,
    "catopt.catenary.solve.least_tension": span_or_tension.least_tension,
}

A_LINE = 5e-4
"""Time that a line takes with the kernel as it stands, s."""


@contextmanager
def compiled_kernel(lines: int) -> Iterator[None]:
    """Let `catopt.solve` call the compiled kernel inside the block, where it has enough to do."""
    with ExitStack() as stack:
        for name, function in _KERNEL.items():
            stack.enter_context(patch(name, _on_floats(compiled(function, A_LINE * lines))))
        stack.enter_context(patch("catopt.catenary.solve.cut", _cut_to_arrays))
        stack.enter_context(patch("catopt.catenary.layout.runs_of", _runs_of))
        yield


_RUNS_OF = layout.runs_of
"""As it is before it is replaced."""


def _cut_to_arrays(line: Line) -> tuple[pieces.Pieces, tuple[int, ...]]:
    cut, owner = pieces.cut(line)
    return pieces.Pieces(*(np.array(column) for column in cut)), owner


def _runs_of(state: State, setting: LineProblem, lists: layout.LineIntervals) -> int:
    """Write the runs of a line into lists, by way of arrays."""
    arrays = layout.LineIntervals(*(np.array(column) for column in lists))
    count: int = compiled(_RUNS_OF)(state, _with_floats(setting), arrays)
    for column, found in zip(lists, arrays, strict=True):
        column[:] = found.tolist()
    return count


def _on_floats(function: Any) -> Any:
    """Pass whole numbers as floats, so that one compiled version serves every call."""

    def called(*arguments: Any) -> Any:
        return function(*map(_with_floats, arguments))

    return called


def _with_floats(argument: Any) -> Any:
    if isinstance(argument, LineProblem):
        numbers = (argument.anchor_height, argument.fairlead_height, argument.friction)
        return LineProblem(argument.pieces, *map(float, numbers))
    return argument
