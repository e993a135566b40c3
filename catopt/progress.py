"""Searches that take long, and say so before most of the time is gone."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sized
from contextlib import contextmanager
from contextvars import ContextVar
from time import perf_counter
from typing import Final, TypeVar

from catopt.words import Message

T = TypeVar("T")
Progress = Callable[[int, int], None]
"""Told how many steps are done and how many there are at most."""

LONG: Final = 10.0
"""s: what takes longer is announced."""

_SURE: Final = 0.2
"""s, after which the time of the steps so far foretells that of the others."""

_when_long: list[Callable[[Message], None]] = []
_said: set[str] = set()


Watcher = Callable[[float, float], None]
"""Told how much of a search is done of what it takes, about; it may raise KeyboardInterrupt."""

_watching: ContextVar[Watcher | None] = ContextVar("watching", default=None)


@contextmanager
def watched(tell: Watcher) -> Iterator[None]:
    """Have the searches of the body told of their steps."""
    before = _watching.set(tell)
    try:
        yield
    finally:
        _watching.reset(before)


def watcher() -> Watcher:
    """Give whom a search tells of its steps."""
    return _watching.get() or (lambda *_: None)


def when_long(tell: Callable[[Message], None]) -> None:
    """Have what takes long told by this, in place of an earlier one; each search once."""
    _when_long[:] = [tell]
    _said.clear()


def expect(what: Message, seconds: float) -> None:
    """Say that something will take some time, s, where that is long; `what` says what."""
    if seconds <= LONG or what.key in _said:
        return
    _said.add(what.key)
    for tell in _when_long:
        tell(Message("words.takes_long", what=what, time=in_words(seconds)))


def paced(what: Message, steps: Iterable[T], count: int | None = None) -> Iterator[T]:
    """Pass on the steps of a search; by the first of them, say how long all of them take.

    `count`: how many there are, where `steps` does not say so itself. The very first, in which a
    part may still have to be compiled, counts only where it is all that is known after some
    seconds.
    """
    count = len(steps) if isinstance(steps, Sized) else count
    assert count is not None
    began, before = perf_counter(), 0
    for done, step in enumerate(steps):
        passed = perf_counter() - began
        if done > before and passed > (_SURE if before else 0.2 * LONG):
            expect(what, passed / (done - before) * count)
        if done == 1:
            began, before = perf_counter(), 1
        yield step


def in_words(seconds: float) -> Message:
    """Say a time roughly: in seconds, minutes, hours or days."""
    for name, size in (("days", 86400.0), ("hours", 3600.0), ("minutes", 60.0)):
        if seconds >= 2.0 * size:
            return Message(f"words.{name}", number=seconds / size)
    return Message("words.seconds", number=seconds)
