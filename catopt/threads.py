"""Threads in which numpy's libraries solve equations: one, for catopt's are few hundred at most.

Several threads on so little wait for each other: on a machine of two busy cores a hull's radiation
takes 15 s in two and 0.6 s in one. Runs go side by side on the cores instead.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

_VARIABLES = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "OMP_NUM_THREADS")
"""Environment variables by which the libraries learn how many threads to use, once: at import."""


def one_thread() -> None:
    """Let this process use one, if numpy is not there yet and the user has set nothing else."""
    for name in _VARIABLES:
        os.environ.setdefault(name, "1")


@contextmanager
def one_thread_each() -> Iterator[None]:
    """Let new processes use one each: there is a process for every core."""
    with environment(dict.fromkeys(_VARIABLES, "1")):
        yield


@contextmanager
def environment(variables: Mapping[str, str]) -> Iterator[None]:
    """Set environment variables while the body runs."""
    before = {name: os.environ.get(name) for name in variables}
    os.environ.update(variables)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
