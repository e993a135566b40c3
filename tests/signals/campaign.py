"""Sends signals to commands at random times and looks at what they leave behind."""

from __future__ import annotations

import json
import os
import random
import select
import signal
import subprocess
import sys
import time
import zipfile
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.fuzz.kinds import CASES, MOVING, SMALL_DESIGN

__all__ = ["COMMANDS", "Tally", "run"]

ENDINGS = {
    ".csv": b"\n",
    ".html": b"</html>\n",
    ".png": b"IEND\xaeB`\x82",
    ".svg": b"</svg>\n",
    ".toml": b"\n",
}
INTERRUPTED = 130
MOST_SECONDS = 1200.0

EARLY = 0.1
"""s from that on in which a signal may come before catopt minds it: while it is being loaded."""

MAIN = "import os, sys; os.write(1, b'.'); from catopt.__main__ import main; sys.exit(main())"
"""Says that Python has begun: before that a signal is not the program's."""


@dataclass(frozen=True)
class Command:
    """A command that writes a directory, and the file that it reads."""

    arguments: tuple[str, ...]
    file: str
    text: str

    @property
    def name(self) -> str:
        """What is typed."""
        return " ".join(each for each in self.arguments if each != self.file)


COMMANDS = (
    Command(("design", "case.toml"), "case.toml", SMALL_DESIGN),
    Command(("verify", "case.toml", "--dynamic", "--once"), "case.toml", MOVING),
    Command(("report", "case.toml", "--no-verify"), "case.toml", MOVING),
    Command(
        ("size", "buoy", "sizing.toml", "--at-rest"),
        "sizing.toml",
        (CASES / "size-buoy" / "sizing.toml").read_text("utf-8"),
    ),
    Command(("reproduce", "buoy_9p5m"), "case.toml", ""),
)


@dataclass
class Tally:
    """What came of all of them."""

    ends: Counter[tuple[str, int]] = field(default_factory=Counter)
    mixed: int = 0
    faults: list[str] = field(default_factory=list)


def run(number: signal.Signals, count: int, seed: int) -> Tally:
    """Send a signal to `count` runs, the commands in turn, each at a time drawn at random.

    Each writes over the answer of another case, so that a mixture of the two would be seen.
    """
    tally = Tally()
    for index in range(count):
        command = COMMANDS[index % len(COMMANDS)]
        rng = random.Random(f"{seed} {number} {index}")
        seconds, before, after = _undisturbed(command)
        with _place() as folder:
            out = folder / "out"
            out.mkdir()
            for name, content in before.items():
                (out / name).write_bytes(content)
            (folder / command.file).write_text(_other(command.text), encoding="utf-8")
            delay = rng.uniform(0.0, 1.1 * seconds)
            status, said = _signalled(command, folder, number, delay)
            tally.ends[command.name, status] += 1
            faults = [*_of_the_end(number, status, said, delay), *_of_the_files(out)]
            if _is_mixed(_contents(out), before, after):
                tally.mixed += 1
                if number is not signal.SIGKILL:
                    faults.append("the directory is of two answers")
                elif not _is_refused(out):
                    faults.append("a directory of two answers is taken for one")
            tally.faults += [f"{index}, {command.name} at {delay:.2f} s: {f}" for f in faults]
    return tally


@cache
def _undisturbed(command: Command) -> tuple[float, dict[str, bytes], dict[str, bytes]]:
    """Run a command to its end, on both cases: seconds, and what it writes of each."""
    wrote, seconds = [], 0.0
    for text in (command.text, _other(command.text)):
        with _place() as folder:
            (folder / command.file).write_text(text, encoding="utf-8")
            start = time.perf_counter()
            status, said = _signalled(command, folder, signal.SIGINT, MOST_SECONDS)
            seconds = time.perf_counter() - start
            assert status == 0, said
            wrote.append(_contents(folder / "out"))
    return seconds, wrote[0], wrote[1]


@contextmanager
def _place() -> Iterator[Path]:
    """Make a folder that always has the same name, after which a page is named."""
    with TemporaryDirectory() as made:
        folder = Path(made) / "place"
        folder.mkdir()
        yield folder


def _other(text: str) -> str:
    """Make another case of a case, by its title."""
    return text.replace('title = "', 'title = "Another: ')


def _signalled(
    command: Command, folder: Path, number: signal.Signals, delay: float
) -> tuple[int, str]:
    """Run a command and send it a signal so many seconds after its start."""
    process = subprocess.Popen(
        [sys.executable, "-c", MAIN, *command.arguments, "--out", "out"],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    assert process.stdout is not None
    select.select([process.stdout], [], [], MOST_SECONDS)
    try:
        _, said = process.communicate(timeout=delay)
    except subprocess.TimeoutExpired:
        process.send_signal(number)
        try:
            _, said = process.communicate(timeout=MOST_SECONDS)
        except subprocess.TimeoutExpired:
            process.kill()
            return 1, "does not end"
    return process.returncode, said.decode("utf-8", "replace")


def _of_the_end(number: signal.Signals, status: int, said: str, delay: float) -> list[str]:
    """List what is wrong with how a run ended."""
    if status == -number and delay < EARLY:
        return []
    right = (0, -signal.SIGKILL) if number is signal.SIGKILL else (0, INTERRUPTED)
    faults = [] if status in right else [f"status {status}: {said[-300:]}"]
    if "Traceback" in said or "Error" in said:
        faults.append(f"says {said[-300:]!r}")
    return faults


def _of_the_files(out: Path) -> list[str]:
    """List the files that are half written."""
    faults = []
    for name, content in _contents(out).items():
        try:
            _check_whole(out / name, content)
        except (ValueError, OSError, zipfile.BadZipFile) as error:
            faults.append(f"{name} is half written: {error}")
    return faults


def _check_whole(path: Path, content: bytes) -> None:
    """Raise unless a file is whole, by its kind."""
    if path.suffix == ".json":
        json.loads(content)
    elif path.suffix == ".xlsx":
        with zipfile.ZipFile(path) as book:
            if book.testzip() is not None:
                raise ValueError("a part of it")
    elif not content.endswith(ENDINGS.get(path.suffix, b"")):
        raise ValueError("its end is missing")


def _contents(out: Path) -> dict[str, bytes]:
    """Read what is in a directory, without what is still to take its place."""
    if not out.is_dir():
        return {}
    return {each.name: each.read_bytes() for each in out.iterdir() if each.suffix != ".tmp"}


def _is_mixed(found: dict[str, bytes], before: dict[str, bytes], after: dict[str, bytes]) -> bool:
    """Whether files of the earlier answer stand beside files of the later one.

    What a run in motion keeps when it is stopped is a shorter answer of the later case: it need not
    be what a whole run writes, but nothing of the earlier answer may stand beside it.
    """
    earlier = {name for name in found if before.get(name) == found[name] != after.get(name)}
    return bool(earlier) and any(found[name] != before.get(name) for name in found)


def _is_refused(out: Path) -> bool:
    """Whether ``catopt report`` refuses a directory, or there is no case to report on."""
    if not (out / "case.toml").is_file():
        return True
    command = [sys.executable, "-m", "catopt", "report", str(out), "--no-verify"]
    ran = subprocess.run(command, capture_output=True, text=True, check=False, cwd=out.parent)
    return ran.returncode == 2 and "it is for another case" in ran.stderr
