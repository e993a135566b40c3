"""How far a command is and how long it will take: a bar for a terminal."""

from __future__ import annotations

from collections.abc import Callable
from time import monotonic

from rich.console import Console
from rich.progress import BarColumn, Progress, ProgressColumn, Task, TextColumn
from rich.text import Text

_WIDTH = 32


class _Done(ProgressColumn):
    """Steps done of those wanted, and how long they took; only the time while none are known."""

    def render(self, task: Task) -> Text:
        """Write the column."""
        elapsed = _clock(task.elapsed or 0.0)
        if task.total is None:
            return Text(elapsed)
        return Text(f"{task.completed:,.0f} of {task.total:,.0f}, {elapsed}")


class _Left(ProgressColumn):
    """How long the rest will take; nothing while that is not known."""

    max_refresh = 0.5

    def render(self, task: Task) -> Text:
        """Write the column."""
        left = task.time_remaining
        return Text("" if left is None or task.finished else f"{_clock(left)} left")


def progress_bar(console: Console, clock: Callable[[], float] = monotonic) -> Progress:
    """Make a bar that goes away when it is done; `clock` gives the time in s."""
    return Progress(
        TextColumn("{task.description}", markup=False),
        BarColumn(_WIDTH),
        _Done(),
        _Left(),
        console=console,
        transient=True,
        get_time=clock,
    )


def _clock(seconds: float) -> str:
    """Write a time: ``1:05``, ``2:00:00``."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"
