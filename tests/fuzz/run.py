"""Runs broken files through catopt and judges how each one ends."""

from __future__ import annotations

import contextlib
import io
import math
import os
import random
import re
import resource
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import dropwhile
from pathlib import Path
from tempfile import TemporaryDirectory

from catopt.__main__ import main
from catopt.errors import CatoptError
from tests.fuzz.kinds import Kind, kinds
from tests.fuzz.mutations import mutated

__all__ = ["Ended", "Tally", "ended_in", "fault_of", "run"]

STATUSES = (0, 2, 3, 4)
LONGEST, LARGEST = 5.0, 500_000
"""Seconds of processor time and kB of memory that no broken file may take unannounced."""

ANNOUNCED = re.compile("(some|about) [0-9.]+ (s|min|h|days)")
"""How long a search says beforehand that it takes."""

PROBLEM = re.compile(r"^  \S.*?: \S")
"""A line of a refusal: key and reason."""

UNWANTED = ("Traceback", "fault of catopt's own", "Warning", "Error:")
CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f\u202a-\u202e]")


@dataclass(frozen=True)
class Ended:
    """How a run ended."""

    status: int
    out: str
    err: str
    seconds: float
    memory: int = 0  # kB by which the process grew beyond what it ever had


@dataclass
class Tally:
    """What came of all of them."""

    statuses: Counter[tuple[str, int]] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)
    slowest: tuple[float, str] = (0.0, "")


def run(
    count: int,
    seed: int,
    *,
    slow: float = 0.0,
    processes: bool = False,
    first: int = 0,
    seconds: float = math.inf,
) -> Tally:
    """Break `count` files, all kinds in turn, and run each.

    Parameters
    ----------
    count, first : int
        How many, and the number of the first.
    seed : int
        The same seed and number give the same file.
    slow : float
        Part of them for which the kind's slow command is run.
    processes : bool
        Whether each is a process of its own.
    seconds : float
        After which no more is begun.
    """
    tally, until = Tally(), time.monotonic() + seconds
    for number in range(first, first + count):
        if time.monotonic() > until:
            break
        kind = kinds()[number % len(kinds())]
        rng = random.Random(f"{seed} {number}")
        others = [text for each in kinds() if each.form == kind.form for text in each.texts]
        data = mutated(rng, rng.choice(kind.texts), others, kind.form)
        command = kind.slow if kind.slow and rng.random() < slow else kind.command
        ended = ended_in(kind, command, data, processes=processes)
        if ended.seconds > LONGEST:  # what else the machine does takes processor time, too
            again = ended_in(kind, command, data, processes=processes)
            ended = min(ended, again, key=lambda each: each.seconds)
        tally.statuses[kind.name, ended.status] += 1
        tally.slowest = max(tally.slowest, (ended.seconds, f"number {number}, {kind.name}"))
        fault = fault_of(ended)
        if fault:
            tally.faults.append(f"number {number}, {kind.name}, {' '.join(command)}: {fault}")
    return tally


def ended_in(
    kind: Kind, command: tuple[str, ...], data: bytes, *, processes: bool = False
) -> Ended:
    """Say how a command, or the kind's own function, ends with a file."""
    with _folder(kind, data) as path:
        return _as_process(kind, command, path) if processes else _inside(kind, command, path)


def fault_of(ended: Ended) -> str:
    """Say what is wrong with the end of a run; empty when nothing is."""
    if ended.status not in STATUSES:
        return f"status {ended.status}: {ended.err[-400:]}"
    if ended.memory > LARGEST:
        return f"{ended.memory / 1000:.0f} MB"
    if ended.seconds > LONGEST and not ANNOUNCED.search(ended.err):
        return f"{ended.seconds:.0f} s"
    for word in UNWANTED:
        if word in ended.err:
            return f"says {word!r}: {ended.err[-400:]}"
    if CONTROL.search(ended.err):
        return f"control characters reach the terminal: {ended.err!r:.400}"
    if ended.status == 0:
        return ""
    if ended.out:
        return f"prints an answer with status {ended.status}"
    return _fault_of_message(ended)


def _fault_of_message(ended: Ended) -> str:
    """Judge a message; what is announced of a long job may stand before it."""
    lines = ended.err.rstrip("\n").split("\n")
    first, *problems = [*dropwhile(lambda line: not line.startswith("catopt: "), lines)] or [""]
    if len(first) < len("catopt: ") + 10:
        return f"no message: {ended.err[:200]!r}"
    if ended.status == 2 and (not problems or not all(PROBLEM.match(each) for each in problems)):
        return f"a refusal without key and reason: {ended.err[:300]!r}"
    if ended.status == 2 and len(ended.err) > 60_000:
        return f"a refusal of {len(ended.err)} characters"
    return ""


@contextlib.contextmanager
def _folder(kind: Kind, data: bytes) -> Iterator[Path]:
    """Make a folder with the broken file and what stands beside it the working directory."""
    before = Path.cwd()
    with TemporaryDirectory() as made:
        for name, text in kind.beside.items():
            (Path(made) / name).write_text(text, encoding="utf-8")
        path = Path(made) / kind.file
        path.write_bytes(data)
        os.chdir(made)
        try:
            yield path
        finally:
            os.chdir(before)


def _inside(kind: Kind, command: tuple[str, ...], path: Path) -> Ended:
    """Run in this process."""
    out, err = io.StringIO(), io.StringIO()
    start, room = _processor_time(), _most_memory()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        if command:
            status = main(list(command))
        else:
            assert kind.read is not None
            status = _status_of(kind, path, err)
    took, grown = _processor_time() - start, _most_memory() - room
    return Ended(status, out.getvalue(), err.getvalue(), took, grown)


def _most_memory() -> int:
    """Most memory that this process ever had, kB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def _processor_time() -> float:
    """Seconds of this process and those it started, whatever else the machine does."""
    return sum(os.times()[:4])


def _status_of(kind: Kind, path: Path, err: io.StringIO) -> int:
    assert kind.read is not None
    try:
        kind.read(path)
    except CatoptError as error:
        err.write(f"catopt: {error}\n")
        return error.exit_status
    except Exception as error:  # what the command line would call a fault of its own
        err.write(f"{type(error).__name__}: {error}")
        return 1
    return 0


def _as_process(kind: Kind, command: tuple[str, ...], path: Path) -> Ended:
    """Run as a user does."""
    if not command:
        return _inside(kind, command, path)
    start = _processor_time()
    ran = subprocess.run(
        [sys.executable, "-m", "catopt", *command], capture_output=True, text=True, check=False
    )
    return Ended(ran.returncode, ran.stdout, ran.stderr, _processor_time() - start)
