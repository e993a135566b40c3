"""What all benchmarks share: their options, the head of their page, and processor time."""

from __future__ import annotations

import argparse
import os
import platform
import resource
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
RESULTS = ROOT / "benchmarks" / "results"
PACKAGES = ("numpy", "numba", "scipy")


def page(
    parser: argparse.ArgumentParser,
    report: Callable[[argparse.Namespace], Iterable[str]],
    **sizes: tuple[Any, Any],
) -> str:
    """Read the options, print a report as it grows, and write it where asked; return its text.

    `sizes` are options with their default and what ``--smoke`` makes of it: the same code in
    seconds, with figures that mean nothing. The report begins with its heading; below it stands
    what was run on what, when and with what.
    """
    for name, (full, small) in sizes.items():
        said = f"{full}; {small} with --smoke"
        parser.add_argument(f"--{name}", type=type(full), metavar="N", help=said)
    parser.add_argument("--smoke", action="store_true", help="see it run, within seconds")
    parser.add_argument("--out", type=Path, help="file to write the page to, too")
    of = parser.parse_args()
    for name, (full, small) in sizes.items():
        if getattr(of, name) is None:
            setattr(of, name, small if of.smoke else full)
    lines: list[str] = []
    for line in _headed(report(of)):
        print(line, flush=True)
        lines.append(line)
    text = "\n".join(lines).rstrip() + "\n"
    if of.out is not None:
        of.out.write_text(text, encoding="utf-8")
    return text


def _headed(lines: Iterable[str]) -> Iterator[str]:
    rows = iter(lines)
    yield next(rows)
    yield ""
    yield stamp()
    yield ""
    if (second := next(rows, "")) != "":
        yield second
    yield from rows


def stamp() -> str:
    """Say what was run, of which commit, when, with what and on what."""
    words = [word for word in sys.argv[1:] if not word.startswith("--out")]
    words = [word for word in words if not word.endswith(".md")]
    command = " ".join(["python -m benchmarks." + Path(sys.argv[0]).stem, *words])
    packages = ", ".join(f"{name} {_version(name)}" for name in PACKAGES)
    load = f", load {os.getloadavg()[0]:.1f} at the start" if hasattr(os, "getloadavg") else ""
    return (
        f"`{command}`, commit {commit()}, {datetime.now(UTC):%Y-%m-%d}; catopt "
        f"{_version('catopt')}, Python {platform.python_version()}, {packages}; "
        f"{platform.system()} {platform.machine()}, {_processor()}, {os.cpu_count()} cores{load}."
    )


def commit() -> str:
    """Return the commit of this tree, and whether it was changed since."""
    try:
        found = _git("rev-parse", "--short=8", "HEAD")
        changed = _git("status", "--porcelain", "--", "catopt", "benchmarks/*.py")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
    return f"{found}, changed since" if changed else found


def _git(*words: str) -> str:
    done = subprocess.run(
        ["git", "-C", str(ROOT), *words], check=True, capture_output=True, text=True
    )
    return done.stdout.strip()


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"


def _processor() -> str:
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return platform.processor() or "unknown processor"
    names = [line.partition(":")[2].strip() for line in text.splitlines() if "model name" in line]
    return names[0] if names else "unknown processor"


def processor_time(
    command: Sequence[str], cwd: Path = ROOT, env: dict[str, str] | None = None
) -> float:
    """Run a command; return the processor time of it and its children, s."""
    start = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=cwd, env=env, stdout=subprocess.DEVNULL, check=True)
    end = resource.getrusage(resource.RUSAGE_CHILDREN)
    return end.ru_utime - start.ru_utime + end.ru_stime - start.ru_stime
