"""Ctrl-C that waits for a place where it does no harm."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

__all__ = ["waiting_interrupt"]


@contextmanager
def waiting_interrupt() -> Iterator[Callable[[], None]]:
    """Hold Ctrl-C back while the body runs, until it asks for it.

    An exception raised where compiled code takes over its arguments or hands back its result
    would end the process. A second Ctrl-C is not held back.

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
