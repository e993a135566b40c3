"""Runs of a case side by side, and what they will take."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import (
    FIRST_COMPLETED,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
    wait,
)
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing import connection, get_context, parent_process
from time import monotonic
from types import ModuleType
from typing import Any, TypeVar

from catopt.errors import CatoptError, InputError, Problem
from catopt.progress import Progress
from catopt.threads import one_thread_each
from catopt.verify.convergence_check import ConvergenceCheck, work_of_check
from catopt.verify.dynamic_lines import LinesAtRest
from catopt.words import Message

SECONDS_PER_BAR_AND_STEP = 6e-6
"""On one core: 4 million bars times steps take 15 to 30 s."""

BYTES_PER_SAMPLE = 160.0
"""Of one line: time, forces and tensions at both ends, the fairlead's place and what lies down."""

MOST_SECONDS, MOST_BYTES = 30.0 * 86400.0, 8e9


@dataclass(frozen=True)
class Effort:
    """Time and memory of a load case.

    `steps`, `bars`, `runs`: of one run, of all lines together, and how many runs; `checking`: how
    often the work of a run its convergence check takes at most: where a line goes slack; `samples`:
    that are kept of each line in each run.
    """

    steps: float
    bars: int
    runs: int
    checking: int
    samples: float
    lines: int

    @property
    def work(self) -> float:
        """Bars times steps of all runs, with the most that proves them."""
        return self.steps * self.bars * self.runs * (1 + self.checking)

    @property
    def seconds(self) -> float:
        """Roughly, on one core."""
        return self.work * SECONDS_PER_BAR_AND_STEP

    @property
    def bytes(self) -> float:
        """Of the samples."""
        return self.samples * self.lines * self.runs * BYTES_PER_SAMPLE

    @property
    def words(self) -> Message:
        """What is to be run, how long it takes and what it keeps."""
        minutes = self.seconds / 60.0
        key, divisor = ("in_minutes", 1.0) if minutes < 120.0 else ("in_hours", 60.0)
        if minutes > 100.0 * 60.0:
            key, divisor = "in_days", 1440.0
        time = Message(f"refused_motion.{key}", time=minutes / divisor)
        effort = "effort_with_proof" if self.checking else "effort"
        return Message(
            f"refused_motion.{effort}",
            steps=self.steps,
            bars=self.bars,
            often=Message("refused_motion.times", count=self.runs),
            proof=self.checking,
            time=time,
            size=self.bytes / 1e9,
        )

    def check(self, duration: float) -> None:
        """Refuse what would not end or not fit.

        Raises InputError by the keys of ``[dynamics]`` that it hangs on.
        """
        problems = []
        if self.seconds > MOST_SECONDS:
            allowed = Message(
                "refused_motion.days_are_most_shorter_duration",
                effort=self.words,
                most_seconds=MOST_SECONDS / 86400.0,
            )
            problems.append(Problem("dynamics.duration", f"{duration:g} s", allowed))
        if self.bytes > MOST_BYTES:
            allowed = Message(
                "refused_motion.gb_are_most_keep_fewer",
                effort=self.words,
                most_bytes=MOST_BYTES / 1000000000.0,
            )
            problems.append(Problem("dynamics.output_interval", "", allowed))
        if problems:
            raise InputError(problems)


def effort_of(lines: LinesAtRest, convergence_check: ConvergenceCheck) -> Effort:
    """Estimate what the runs of a load case take, with those that prove them."""
    drive = lines.drive
    dynamics, sea = drive.dynamics, drive.sea(0)
    stepping = drive.stepping(sea, lines.driven_by(sea))
    return Effort(
        steps=dynamics.duration / stepping.step,
        bars=dynamics.bars * len(lines.legs),
        runs=dynamics.runs,
        checking=work_of_check(convergence_check),
        samples=dynamics.duration / (stepping.output_interval or stepping.step),
        lines=len(lines.legs),
    )


T = TypeVar("T")

_LOOK = 0.1
"""Seconds between two looks at what the runs tell."""
_WHOLE = 1000
"""Progress of one run is told in so many parts."""

_reported: Any = None
_stop: Any = None


def side_by_side(
    task: Callable[[int, Progress], T], count: int, workers: int, progress: Progress
) -> list[T]:
    """Do a task for each number from 0 on, in processes that share nothing: `Crew.each`."""
    with Crew(min(workers, count)) as crew:
        return crew.each(task, count, progress)


class Crew:
    """Processes that do tasks side by side, kept from one call to the next while it is open.

    New processes are started in the same way on every system (spawn), and do not import the script
    that called: it needs no guard. `workers`: processes at most; one does all in this process.
    """

    def __init__(self, workers: int) -> None:
        self.workers = workers
        self._pool: ProcessPoolExecutor | None = None
        if workers > 1:
            context = get_context("spawn")
            self._reported, self._stop = context.SimpleQueue(), context.Event()
            shared = self._reported, self._stop
            self._pool = ProcessPoolExecutor(workers, context, _begin, shared)

    def __enter__(self) -> Crew:
        return self

    def __exit__(self, *_: object) -> None:
        if self._pool is not None:
            self._stop.set()
            self._pool.shutdown(cancel_futures=True)
            # The traceback of an error keeps frames, and these the error: what processes share is
            # not to wait for a collection of such circles.
            self._pool = None
            del self._reported, self._stop

    def each(self, task: Callable[[int, Progress], T], count: int, progress: Progress) -> list[T]:
        """Do a task for each number from 0 on.

        `task`: given a number and what to tell its progress to, which raises KeyboardInterrupt when
        it is to stop before its end; it returns what it has then, or lets the interrupt through if
        that is nothing. It and what it returns go through pickle where there are several processes.
        Returns: what the tasks returned, by number; when `progress` raised KeyboardInterrupt, of
        those that had something by then, and no more is done. Raises CatoptError as a task raises
        it, after all others were stopped, or when a process ended on its own.
        """
        if self._pool is None:
            finished: list[T] = []
            with suppress(KeyboardInterrupt):
                finished.extend(task(k, share_of(progress, k, count)) for k in range(count))
            return finished
        reached = [0.0] * count
        futures: list[Future[T]] = []
        try:
            with no_script(), one_thread_each():
                futures = [self._pool.submit(_do, task, number) for number in range(count)]
            waiting = set(futures)
            while waiting:
                done, waiting = wait(waiting, _LOOK, FIRST_COMPLETED)
                while not self._reported.empty():
                    number, part = self._reported.get()
                    reached[number] = part
                for each in done:
                    each.result()
                progress(round(_WHOLE * sum(reached)), _WHOLE * count)
        except BrokenProcessPool:
            raise CatoptError(Message("refused_motion.process_ended")) from None
        except BaseException as error:
            self._stop.set()
            for each in futures:
                each.cancel()
            wait(futures)
            if not isinstance(error, KeyboardInterrupt):
                raise
        begun = (each for each in futures if not each.cancelled())
        return [
            each.result() for each in begun if not isinstance(each.exception(), KeyboardInterrupt)
        ]


class Threads(Crew):
    """Does tasks side by side in this process: compiled code runs beside itself."""

    def __init__(self) -> None:
        super().__init__(1)

    def each(self, task: Callable[[int, Progress], T], count: int, progress: Progress) -> list[T]:
        """Do a task for each number from 0 on, the first by itself: it compiles what has to be."""
        found = super().each(task, min(count, 1), progress)
        with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            numbers = range(len(found), count)
            rest = pool.map(lambda k: task(k, lambda *_: progress(k, count)), numbers)
            return [*found, *rest]


def silent(*_: int) -> None:
    """Tell nobody how far it is."""


def share_of(progress: Progress | None, done: int, total: int, part: int = 1) -> Progress:
    """Tell of a part of some work as of the whole, of which some is done."""
    if progress is None:
        return silent
    return lambda at, end: progress(done * end + part * at, total * end)


def _begin(reported: Any, stop: Any) -> None:
    global _reported, _stop
    begin_process()
    _reported, _stop = reported, stop


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
            _reported.put((number, at / end))

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
