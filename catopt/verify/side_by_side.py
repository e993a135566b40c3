"""Runs of a case side by side: each in a process of its own, as many at a time as asked for."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import connection, get_context, parent_process
from time import monotonic
from types import ModuleType
from typing import Any, TypeVar

from catopt.errors import CatoptError

T = TypeVar("T")
Progress = Callable[[int, int], None]

_LOOK = 0.1
"""Seconds between two looks at what the runs tell."""
_WHOLE = 1000
"""Progress of one run is told in so many parts."""

_told: Any = None
_stop: Any = None


def side_by_side(
    task: Callable[[int, Progress], T], count: int, workers: int, progress: Progress
) -> list[T]:
    """Do a task for each number from 0 on, in processes that share nothing.

    New processes are started in the same way on every system (spawn), and do not import the script
    that called: it needs no guard.

    `task`: given a number and what to tell its progress to, which raises KeyboardInterrupt when it
    is to stop before its end; it returns what it has then, or lets the interrupt through if that is
    nothing. It and what it returns go through pickle; `workers`: processes at most. Returns: what
    the tasks returned, by number; when `progress` raised KeyboardInterrupt, of those that had
    something by then. Raises CatoptError as a task raises it, after all others were stopped, or
    when a process ended on its own.
    """
    context = get_context("spawn")
    told, stop = context.SimpleQueue(), context.Event()
    reached = [0.0] * count
    futures: list[Future[T]] = []
    pool = ProcessPoolExecutor(min(workers, count), context, _begin, (told, stop))
    try:
        with pool:
            try:
                with no_script():
                    futures = [pool.submit(_do, task, number) for number in range(count)]
                waiting = set(futures)
                while waiting:
                    done, waiting = wait(waiting, _LOOK, FIRST_COMPLETED)
                    while not told.empty():
                        number, part = told.get()
                        reached[number] = part
                    for each in done:
                        each.result()
                    progress(round(_WHOLE * sum(reached)), _WHOLE * count)
            except BaseException as error:
                stop.set()
                for each in futures:
                    each.cancel()
                if not isinstance(error, KeyboardInterrupt):
                    raise
    except BrokenProcessPool:
        words = "a process that ran a seed ended on its own; --workers 1 runs one after the other"
        raise CatoptError(words) from None
    finally:
        # The traceback of an error keeps this frame, and the frame the error: what processes share
        # is not to wait for a collection of such circles.
        del pool, told, stop
    begun = (each for each in futures if not each.cancelled())
    return [each.result() for each in begun if not isinstance(each.exception(), KeyboardInterrupt)]


def _begin(told: Any, stop: Any) -> None:
    global _told, _stop
    begin_process()
    _told, _stop = told, stop


def begin_process() -> None:
    """Set a new process up: Ctrl-C is for the one that started it, with which it ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    starter = parent_process()
    if starter is not None:
        threading.Thread(target=_end_with, args=(starter.sentinel,), daemon=True).start()


def _end_with(sentinel: int) -> None:
    connection.wait([sentinel])
    os._exit(1)


def _do(task: Callable[[int, Progress], T], number: int) -> T:
    last = -_LOOK

    def tell(at: int, end: int) -> None:
        nonlocal last
        if at < end and _stop.is_set():
            raise KeyboardInterrupt
        now = monotonic()
        if now - last >= _LOOK or at >= end:
            last = now
            _told.put((number, at / end))

    return task(number, tell)


@contextmanager
def no_script() -> Iterator[None]:
    """Keep new processes from running the calling script again, guarded or not."""
    script = sys.modules["__main__"]
    sys.modules["__main__"] = ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = script
