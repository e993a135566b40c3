"""Signals that wait for a place where they do no harm.

An exception raised where compiled code takes over its arguments or hands back its result ends the
process.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from types import FrameType
from typing import Any, TypeVar

__all__ = [
    "asked_to_stop",
    "no_interrupt_from_now",
    "signals_wait",
    "terminate_as_interrupt",
    "uninterrupted",
    "waiting_interrupt",
]

F = TypeVar("F", bound=Callable[..., Any])

_pressed: list[tuple[int, FrameType | None]] = []
"""Ctrl-C as it came while an `uninterrupted` function ran."""


def _note(number: int, frame: FrameType | None) -> None:
    _pressed.append((number, frame))


def asked_to_stop() -> bool:
    """Whether Ctrl-C was pressed since the `uninterrupted` function began that is running."""
    return bool(_pressed)


def uninterrupted(function: F) -> F:
    """Return a function that holds every Ctrl-C back while it runs, and heeds it at its end.

    Whoever minded the signal before is told of it then. It makes no difference outside the main
    thread, where Python raises nothing.
    """

    @wraps(function)
    def call(*arguments: Any) -> Any:
        before = signal.getsignal(signal.SIGINT)
        mine = threading.current_thread() is threading.main_thread()
        if not mine or not callable(before) or before is _note:
            return function(*arguments)
        signal.signal(signal.SIGINT, _note)
        try:
            result = function(*arguments)
        finally:
            signal.signal(signal.SIGINT, before)
            pressed = _pressed.copy()
            _pressed.clear()
        if pressed:
            before(*pressed[0])
        return result

    return call  # type: ignore[return-value]


@contextmanager
def waiting_interrupt() -> Iterator[Callable[[], None]]:
    """Hold Ctrl-C back while the body runs, until it asks for it.

    A second Ctrl-C is not held back.

    Yields
    ------
    callable
        Raises KeyboardInterrupt if Ctrl-C was pressed. Outside the main thread, or where somebody
        else minds the signal, it does nothing.
    """
    mine = threading.current_thread() is threading.main_thread()
    if not mine or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        yield lambda: None
        return
    pressed = False

    def note(number: int, frame: FrameType | None) -> None:
        nonlocal pressed
        if pressed:
            signal.default_int_handler(number, frame)
        pressed = True

    def ask() -> None:
        if pressed:
            raise KeyboardInterrupt

    signal.signal(signal.SIGINT, note)
    try:
        yield ask
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)


@contextmanager
def signals_wait() -> Iterator[None]:
    """Let Ctrl-C and a request to end wait until the body has run, however often they come.

    Outside the main thread, where no signal arrives, it does nothing.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[int] = []
    before = {
        number: signal.signal(number, lambda each, _: came.append(each))
        for number in (signal.SIGINT, signal.SIGTERM)
        if signal.getsignal(number) not in (None, signal.SIG_IGN)
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        if came:
            signal.raise_signal(came[0])


def terminate_as_interrupt() -> None:
    """Treat a request to end (SIGTERM) as Ctrl-C from now on, so that it ends in the same order."""
    signal.signal(signal.SIGTERM, lambda _, __: signal.raise_signal(signal.SIGINT))


def no_interrupt_from_now() -> None:
    """Ignore SIGINT and SIGTERM for the rest of the process: its answer is given.

    While Python takes itself down either would end it as a run that was killed.
    """
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
