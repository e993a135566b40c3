"""What runs the pieces of a study: processes on this machine, or a cluster."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import connection, get_context, parent_process

from catopt.errors import InputError, Problem
from catopt.study.study import Study
from catopt.verify.side_by_side import no_script

_AHEAD = 2
"""Pieces that each process is given beyond the one it runs."""


def worth(study: Study) -> int:
    """Return how many processes a study is worth: one where its members are solved in bulk."""
    return 1 if study.base.compute == "statics" else min(os.cpu_count() or 1, study.pieces)


@contextmanager
def processes(count: int) -> Iterator[tuple[Executor, int]]:
    """Run pieces in processes of their own.

    Yields
    ------
    Executor, int
        It, and the pieces to give it at a time.
    """
    with no_script(), ProcessPoolExecutor(count, get_context("spawn"), _begin) as pool:
        try:
            yield pool, _AHEAD * count
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _begin() -> None:
    """Set a process up: Ctrl-C is for the one that started it, with which it ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    starter = parent_process()
    if starter is not None:
        threading.Thread(target=_end_with, args=(starter.sentinel,), daemon=True).start()


def _end_with(sentinel: int) -> None:
    connection.wait([sentinel])
    os._exit(1)


@contextmanager
def cluster(address: str) -> Iterator[tuple[Executor, int]]:
    """Run pieces on the cluster of a Dask scheduler.

    Parameters
    ----------
    address : str
        Of the scheduler, such as ``tcp://10.0.0.1:8786``.

    Raises
    ------
    InputError
        Dask is not installed, or no scheduler answers there.
    """
    try:
        from distributed import Client
    except ImportError:
        allowed = 'needs Dask; pip install "catopt[cluster]"'
        raise InputError([Problem("--scheduler", address, allowed)], "options") from None
    try:
        client = Client(address, timeout="10s")
    except (OSError, TimeoutError, ValueError) as error:
        allowed = f"no scheduler answers there: {error}"
        raise InputError([Problem("--scheduler", address, allowed)], "options") from None
    with client:
        threads = sum(client.nthreads().values())
        if not threads:
            allowed = "the scheduler has no workers yet; start some (dask worker)"
            raise InputError([Problem("--scheduler", address, allowed)], "options")
        yield client.get_executor(), _AHEAD * threads
