"""Time from the shell to the answer: ``catopt solve`` beside ``python -c "import numpy"``.

    python -m benchmarks.cold_start [--rounds 21] [--out benchmarks/results/cold_start.md]

Every process is new. The commands alternate, so that a slow moment of the machine meets all of
them; before the first round each has run once, so that bytecode is on disk. Quote the ratios.

Then the first answers on a new machine: processor time of larger commands on one core, with an
empty folder for compiled code and once more with what the first run left there.
"""

from __future__ import annotations

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from benchmarks.common import page

CASE = Path("cases/buoy-9.5m/case.toml")
NUMPY = 'python -c "import numpy"'
COMMANDS = {
    "python -c pass": [sys.executable, "-c", "pass"],
    NUMPY: [sys.executable, "-c", "import numpy"],
    "catopt --help": [sys.executable, "-m", "catopt", "--help"],
    f"catopt solve {CASE}": [sys.executable, "-m", "catopt", "solve", str(CASE)],
    f"catopt solve {CASE} --json": [sys.executable, "-m", "catopt", "solve", str(CASE), "--json"],
}

FIRST = (
    "size tanker cases/size-tanker/sizing.toml",
    "size buoy cases/size-buoy/sizing.toml",
    "design cases/design-buoy-9.5m/case.toml",
    "check cases/design-buoy-9.5m/case.toml",
    "system cases/fso-rang-dong/case.toml",
    "report cases/buoy-9.5m/case.toml --out {folder}/note.html",
    "verify cases/buoy-9.5m/case.toml",
    "verify --dynamic cases/dynamic-chain-56m/case.toml",
)
"""Commands whose first run on a machine is measured."""


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(
        parser,
        lambda of: report(timed(of.rounds), first_runs(FIRST[3:4] if of.smoke else FIRST)),
        rounds=(11, 1),
    )


def timed(rounds: int) -> dict[str, list[float]]:
    """Seconds that each command took in each round."""
    for command in COMMANDS.values():
        once(command)
    taken: dict[str, list[float]] = {name: [] for name in COMMANDS}
    for _ in range(rounds):
        for name, command in COMMANDS.items():
            taken[name].append(once(command))
    return taken


def once(command: list[str]) -> float:
    """Run a command from the root of the project; return its seconds."""
    root = Path(__file__).parents[1]
    start = time.perf_counter()
    subprocess.run(command, cwd=root, stdout=subprocess.DEVNULL, check=True)
    return time.perf_counter() - start


def first_runs(lines: Sequence[str]) -> dict[str, list[float]]:
    """Processor time of each command on one core: with nothing compiled, and once more, s."""
    taken = {}
    for line in lines:
        with tempfile.TemporaryDirectory() as folder:
            arguments = line.format(folder=folder).split()
            taken[line] = [processor_time(arguments, folder) for _ in range(2)]
    return taken


def processor_time(arguments: list[str], folder: str) -> float:
    """Run catopt on one core with a folder for compiled code; return its processor time, s."""
    start = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        [sys.executable, "-m", "catopt", *arguments],
        cwd=Path(__file__).parents[1],
        env={**os.environ, "NUMBA_CACHE_DIR": folder, "OPENBLAS_NUM_THREADS": "1"},
        stdout=subprocess.DEVNULL,
        preexec_fn=lambda: os.sched_setaffinity(0, {min(os.sched_getaffinity(0))}),
        check=True,
    )
    end = resource.getrusage(resource.RUSAGE_CHILDREN)
    return end.ru_utime - start.ru_utime + end.ru_stime - start.ru_stime


def report(taken: dict[str, list[float]], first: dict[str, list[float]]) -> list[str]:
    """Lay the times out as a Markdown page."""
    base = statistics.median(taken[NUMPY])
    rows = [
        f"| `{name}` | {1e3 * statistics.median(times):.0f} | {1e3 * min(times):.0f} | "
        f"{statistics.median(times) / base:.2f} |"
        for name, times in taken.items()
    ]
    return [
        "# Cold start",
        "",
        "Each command a new process, one after the other in turn.",
        "",
        "| command | median, ms | fastest, ms | median over that of numpy |",
        "|---|---|---|---|",
        *rows,
        "",
        "| command, on one core | first run, processor time in s | second |",
        "|---|---|---|",
        *(f"| `catopt {line}` | {one:.1f} | {two:.1f} |" for line, (one, two) in first.items()),
    ]


if __name__ == "__main__":
    main()
