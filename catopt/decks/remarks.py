"""Where the remarks on a deck go that is read as the case of a command."""

from __future__ import annotations

from collections.abc import Callable, Sequence

_when_read: list[Callable[[Sequence[str]], None]] = []


def when_read(reported: Callable[[Sequence[str]], None]) -> None:
    """Have the remarks reported by this, in place of an earlier one."""
    _when_read[:] = [reported]


def report_remarks(remarks: Sequence[str]) -> None:
    """Report them to whoever asked for them."""
    for reported in _when_read:
        reported(remarks)
