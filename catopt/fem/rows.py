"""Numbers copied and cleared one by one.

The same by slices takes numba two seconds to compile, most of it for the words of its errors.
"""

from __future__ import annotations

from typing import Any


def copy_values(of: Any, to: Any) -> None:
    """Write an array of one axis to another."""
    for n in range(of.shape[0]):
        to[n] = of[n]


def copy_rows(of: Any, to: Any) -> None:
    """Write an array of two axes to another."""
    for n in range(of.shape[0]):
        for i in range(of.shape[1]):
            to[n, i] = of[n, i]


def copy_blocks(of: Any, to: Any) -> None:
    """Write an array of three axes to another."""
    for j in range(of.shape[0]):
        for n in range(of.shape[1]):
            for i in range(of.shape[2]):
                to[j, n, i] = of[j, n, i]


def clear_blocks(to: Any) -> None:
    """Write 0 to an array of three axes."""
    for j in range(to.shape[0]):
        for n in range(to.shape[1]):
            for i in range(to.shape[2]):
                to[j, n, i] = 0.0
