"""Running a study: piece by piece, here, side by side, or on a cluster; and what it asks for."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ProcessPoolExecutor, wait
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from functools import partial
from itertools import islice
from multiprocessing import get_context
from pathlib import Path
from time import perf_counter

import numpy as np

from catopt.errors import InputError, NoAnswerError, NotConvergedError, refused
from catopt.model.kinds import Duration
from catopt.progress import Progress, paced
from catopt.records import Counted, Record
from catopt.study.file import read_study
from catopt.study.member import Base, OfSizing, compute_member, reason_of
from catopt.study.result import StudyResult
from catopt.study.statics import at_rest
from catopt.study.store import Computed, Store
from catopt.study.study import Study, StudyPiece
from catopt.verify.side_by_side import begin_process, no_script
from catopt.words import Message

_AHEAD = 2
"""Pieces that each process is given beyond the one it runs."""


_BYTES = 3
"""On disk beside a number in the store: its digits in the table of members."""


def run_study(
    study: Study | str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    workers: int | None = None,
    progress: Progress | None = None,
) -> StudyResult:
    """Compute a case again and again, with what varies in it.

    Parameters
    ----------
    study : Study or path
        A study file, or what `catopt.study.file.read_study` made of one.
    out : path, optional
        Directory in which what is computed is kept: stopped at any moment, the same call goes on.
        In memory when left out.
    workers : int, optional
        Processes side by side; all cores when left out, one for members at rest. The numbers do
        not hang on it.
    progress : callable, optional
        Told the members done and all.

    Returns
    -------
    StudyResult
        Statistics over the members, the worst of them, and what they hang on.

    Raises
    ------
    InputError
        With every problem of the file; or the directory holds another study.

    Examples
    --------
    >>> import catopt
    >>> result = catopt.run_study("cases/study-buoy-9.5m/study.toml")
    >>> len(result.study), len(result.reasons)
    (2000, 0)
    """
    read = study if isinstance(study, Study) else read_study(study)
    if read.base.compute == "design":
        allowed = Message("refused_study.design_in_draws_does_it")
        raise refused("compute", '"design"', allowed, read.base.source)
    store = Store(read, None if out is None else Path(out))
    count = worth(read) if workers is None else workers
    with processes(count) if count > 1 else nullcontext((None, 1)) as (executor, at_once):
        run_into(read, store, executor=executor, at_once=at_once, progress=progress)
    return StudyResult(read, store)


def run_into(
    study: Study,
    store: Store,
    *,
    executor: Executor | None = None,
    at_once: int = 1,
    of_sizing: OfSizing | None = None,
    progress: Progress | None = None,
) -> None:
    """Compute what a store does not have yet.

    `executor`: what runs the pieces, as of `concurrent.futures`; here and now when left out; the
    numbers do not hang on it; `at_once`: pieces that it is given at a time; `of_sizing`: told each
    sizing, before its piece is stored; it goes through pickle to the executor; `progress`: told the
    members done and all. A member without an answer stops nothing; after a KeyboardInterrupt, what
    was computed by then is in the store.
    """
    done = store.done()
    task = partial(compute_piece, study.base, of_sizing=of_sizing)
    left = (study.piece(k) for k in range(study.pieces) if k not in done)
    reached = sum(study.piece_start(k + 1) - study.piece_start(k) for k in done)
    found_ones = map(task, left) if executor is None else _at_once(task, left, executor, at_once)
    what = Message("words.members", total=len(study))
    for found in paced(what, found_ones, study.pieces - len(done)):
        store.put(found)
        reached += len(found.numbers)
        if progress is not None:
            progress(reached, len(study))


def compute_piece(base: Base, piece: StudyPiece, *, of_sizing: OfSizing | None = None) -> Computed:
    """Compute the members of a piece."""
    measured = [each.name for each in base.kept if each.quantity]
    texts = [each.name for each in base.kept if not each.quantity]
    if base.compute == "statics":
        rest = at_rest(base, piece)
        numbers = np.column_stack([rest.values[name] for name in measured])
        return Computed(piece.number, numbers, (), rest.reasons)
    numbers = np.full((len(piece), len(measured)), np.nan)
    words: list[tuple[str, ...]] = []
    reasons: dict[int, str] = {}
    for member in range(len(piece)):
        tell = None if of_sizing is None else partial(of_sizing, piece.first + member)
        try:
            values = compute_member(base, piece.changes(member), tell)
        except (InputError, NoAnswerError, NotConvergedError) as error:
            reasons[member] = reason_of(error)
            values = {}
        numbers[member] = [values.get(name, np.nan) for name in measured]
        words.append(tuple(str(values.get(name, "")) for name in texts))
    return Computed(piece.number, numbers, tuple(words), reasons)


def _at_once(
    task: Callable[[StudyPiece], Computed],
    pieces: Iterator[StudyPiece],
    executor: Executor,
    count: int,
) -> Iterator[Computed]:
    """Keep an executor busy with a few pieces at a time; what waits costs memory."""
    running: set[Future[Computed]] = {executor.submit(task, each) for each in islice(pieces, count)}
    try:
        while running:
            done, running = wait(running, return_when=FIRST_COMPLETED)
            for each in done:
                yield each.result()
            running |= {executor.submit(task, each) for each in islice(pieces, len(done))}
    finally:
        for each in running:
            each.cancel()


# ------------------------------------------------------------------ what runs the pieces


def worth(study: Study) -> int:
    """Return how many processes a study is worth: one where its members are solved in bulk."""
    return 1 if study.base.in_bulk else min(os.cpu_count() or 1, study.pieces)


@contextmanager
def processes(count: int) -> Iterator[tuple[Executor, int]]:
    """Run pieces in processes; yield what runs them, and the pieces to give it at a time."""
    with no_script(), ProcessPoolExecutor(count, get_context("spawn"), begin_process) as pool:
        try:
            yield pool, _AHEAD * count
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


@contextmanager
def cluster(address: str) -> Iterator[tuple[Executor, int]]:
    """Run pieces on the cluster of a Dask scheduler, such as ``tcp://10.0.0.1:8786``.

    Raises InputError where Dask is not installed, or no scheduler answers there.
    """

    def fails(key: str, **values: object) -> InputError:
        allowed = Message(f"refused_motion.{key}", **values)
        return refused("--scheduler", address, allowed, "options")

    try:
        from distributed import Client
    except ImportError:
        raise fails("needs_dask", package='"catopt[cluster]"') from None
    try:
        client = Client(address, timeout="10s")
    except (OSError, TimeoutError, ValueError) as error:
        raise fails("no_scheduler", reason=str(error)) from None
    with client:
        threads = sum(client.nthreads().values())
        if not threads:
            raise fails("no_workers")
        yield client.get_executor(), _AHEAD * threads


# ------------------------------------------------------------------ how much a study asks for


@dataclass(frozen=True, eq=False)
class Plan(Record):
    """What a study asks for, from a few members that were timed."""

    SCHEMA = "catopt.study_plan/1"
    DOCUMENT = "title members timed seconds=processor_time_s size=disk_bytes"

    study: Study
    timed: Counted
    """How many were computed to know it."""
    seconds: Duration
    """Processor time that all take, on one core."""
    size: float
    """Bytes that they take in the directory, about."""

    @property
    def title(self) -> str:
        """Title of the study."""
        return self.study.title

    @property
    def members(self) -> Counted:
        """How many there are."""
        return len(self.study)


def plan_study(study: Study) -> Plan:
    """Time a few members of a study; of those at rest, a whole piece after a first one."""
    kept = study.base.kept
    width = 8.0 * (len(kept) + len(study.keys)) * (1 + _BYTES)
    if study.base.in_bulk:
        pieces = [study.piece(0)]
    else:  # the first, one in the middle, the last
        members = sorted({0, len(study) // 2, len(study) - 1})
        pieces = [StudyPiece(0, each, study.values(each, each + 1)) for each in members]
    compute_piece(study.base, pieces[0])
    began = perf_counter()
    for piece in pieces:
        compute_piece(study.base, piece)
    timed = sum(map(len, pieces))
    seconds = (perf_counter() - began) / timed * len(study)
    return Plan(study, timed, seconds, width * len(study))
