"""What tests of processes have done there; a process that begins imports little for them."""

from __future__ import annotations

import os
import time
from pathlib import Path

from catopt.errors import InputError, NotConvergedError, Problem
from catopt.progress import Progress

__all__ = [
    "double",
    "ends",
    "fails",
    "has_nothing_yet",
    "refuses",
    "says_it_is_through",
    "silent",
    "writes_on",
]


def silent(*_: object) -> None:
    """Tell nothing."""


def says_it_is_through(number: int, tell: Progress) -> int:
    time.sleep(1.0)
    tell(1, 1)
    return number


def double(number: int, _: Progress) -> int:
    return 2 * number


def has_nothing_yet(_: int, tell: Progress) -> int:
    while True:
        tell(0, 1)
        time.sleep(0.05)


def fails(number: int, tell: Progress) -> int:
    tell(0, 1)
    if number == 1:
        raise NotConvergedError("the step at t = 3 s did not converge")
    return number


def ends(number: int, tell: Progress) -> int:
    tell(number, 2)
    os._exit(3)


def refuses(number: int, tell: Progress) -> int:
    tell(number, 1)
    raise InputError([Problem("workers", "0", "must be 1 or more")], "verify_dynamic")


def writes_on(number: int, tell: Progress) -> int:
    """Say that it lives, in a file, until it is stopped."""
    path = Path(os.environ["CATOPT_TEST_ALIVE"])
    while True:
        (path / str(number)).write_text(f"{os.getpid()}", encoding="utf-8")
        tell(0, 1)
        time.sleep(0.05)
