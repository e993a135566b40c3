"""Signals that wait for a place where they do no harm, and that are not lost on their way.

An exception raised where compiled code takes over its arguments or hands back its result ends the
process; raised in a callback of Python's own (a weak reference, an import's lock) it is printed and
forgotten.
"""

from __future__ import annotations

import _thread
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from types import FrameType
from typing import Any, TypeVar

F = TypeVar("F", bound=Callable[..., Any])

_pressed: list[tuple[int, FrameType | None]] = []
"""Ctrl-C as it came while an `uninterrupted` function ran."""


def _is_main() -> bool:
    return threading.current_thread() is threading.main_thread()


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
        if not _is_main() or not callable(before) or before is _note:
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
    """Hold Ctrl-C back while the body runs, until it asks for it; a second one is not held back.

    What is yielded raises KeyboardInterrupt if Ctrl-C was pressed. Outside the main thread, or
    where somebody else minds the signal, it does nothing.
    """
    before = signal.getsignal(signal.SIGINT)
    if not _is_main() or before not in (signal.default_int_handler, _interrupt):
        yield lambda: None
        return
    pressed = False

    def note(number: int, frame: FrameType | None) -> None:
        nonlocal pressed
        if pressed:
            _interrupt(number, frame)
        pressed = True

    def ask() -> None:
        if pressed:
            raise KeyboardInterrupt

    signal.signal(signal.SIGINT, note)
    try:
        yield ask
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def signals_wait() -> Iterator[None]:
    """Let Ctrl-C and a request to end wait until the body has run, however often they come.

    Outside the main thread, where no signal arrives, it does nothing.
    """
    if not _is_main():
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


_ends: list[int] = []
"""Signals that asked the program to end."""

_AGAIN = 0.01
"""s, after which a Ctrl-C that was lost comes again."""


def _interrupt(number: int, frame: FrameType | None) -> None:
    _ends.append(number)
    signal.default_int_handler(number, frame)


def was_interrupted() -> bool:
    """Whether the program was asked to end, since `heed_signals`.

    An error after that follows from it: a library that is stopped half-way through an import or a
    drawing says anything.
    """
    return bool(_ends)


def _press_again() -> None:
    """Send Ctrl-C to the main thread; where a signal can be sent to it, it wakes from waiting."""
    if sys.platform == "win32":
        _thread.interrupt_main()
    else:
        signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)


def heed_signals() -> None:
    """Let no Ctrl-C be lost, and treat a request to end (SIGTERM) as one; for a whole process."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _interrupt)
    signal.signal(signal.SIGTERM, lambda _, __: signal.raise_signal(signal.SIGINT))
    usual = sys.unraisablehook

    def again(lost: sys.UnraisableHookArgs) -> None:
        if not issubclass(lost.exc_type, KeyboardInterrupt):
            usual(lost)
            return
        timer = threading.Timer(_AGAIN, _press_again)
        timer.daemon = True
        timer.start()

    sys.unraisablehook = again


def no_interrupt_from_now() -> None:
    """Ignore SIGINT and SIGTERM for the rest of the process: its answer is given.

    While Python takes itself down either would end it as a run that was killed.
    """
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
