"""Running a study: piece by piece, here, in processes side by side, or on a cluster."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from contextlib import ExitStack
from functools import partial
from itertools import islice
from pathlib import Path

import numpy as np

from catopt.errors import InputError, NoAnswerError, NotConvergedError
from catopt.study.base import Base
from catopt.study.executors import processes, worth
from catopt.study.file import read_study
from catopt.study.member import OfSizing, compute_member, reason_of
from catopt.study.result import StudyResult
from catopt.study.statics import at_rest
from catopt.study.store import Computed, Store
from catopt.study.study import Piece, Study

Progress = Callable[[int, int], None]


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
    store = Store(read, None if out is None else Path(out))
    count = worth(read) if workers is None else workers
    with ExitStack() as stack:
        executor, at_once = None, 1
        if count > 1:
            executor, at_once = stack.enter_context(processes(count))
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

    Parameters
    ----------
    study : Study
        What to run.
    store : Store
        Of this study.
    executor : Executor, optional
        What runs the pieces, as of `concurrent.futures`; here and now when left out. The numbers
        do not hang on it.
    at_once : int
        Pieces that the executor is given at a time.
    of_sizing : callable, optional
        Told each sizing, before its piece is stored; it goes through pickle to the executor.
    progress : callable, optional
        Told the members done and all.

    Raises
    ------
    CatoptError
        A fault of catopt's own. A member without an answer stops nothing.
    KeyboardInterrupt
        What was computed by then is in the store.
    """
    done = store.done()
    task = partial(compute_piece, study.base, of_sizing=of_sizing)
    left = (study.piece(k) for k in range(study.pieces) if k not in done)
    reached = sum(study.piece_start(k + 1) - study.piece_start(k) for k in done)
    found_ones = map(task, left) if executor is None else _at_once(task, left, executor, at_once)
    for found in found_ones:
        store.put(found)
        reached += len(found.numbers)
        if progress is not None:
            progress(reached, len(study))


def compute_piece(base: Base, piece: Piece, *, of_sizing: OfSizing | None = None) -> Computed:
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


Task = Callable[[Piece], Computed]


def _at_once(
    task: Task, pieces: Iterator[Piece], executor: Executor, count: int
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
