"""Where the remarks on a deck go that is read as the case of a command."""

from __future__ import annotations

from collections.abc import Callable, Sequence

_when_read: list[Callable[[Sequence[str]], None]] = []


def when_read(told: Callable[[Sequence[str]], None]) -> None:
    """Have the remarks told by this, in place of an earlier one."""
    _when_read[:] = [told]


def tell(remarks: Sequence[str]) -> None:
    """Tell them to whoever wanted to know."""
    for told in _when_read:
        told(remarks)
