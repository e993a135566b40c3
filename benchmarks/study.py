"""Studies: members a second at rest and in motion, memory, and what more members and cores cost.

    python -m benchmarks.study [--years 40] [--runs 40] [--many 2000] [--out FILE]

Every study is one command in a process of its own, from its file to its tables; compiled code is
loaded from the cache, which a first study fills. `--many` adds so many runs of ten minutes of a
coarse model on one process, on two, and on a Dask cluster of two workers, and compares their files.
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import numpy as np

from benchmarks.common import page

CASES = Path(__file__).parents[1] / "cases"
HOURS = 8766
"""Of a year."""


class Took(NamedTuple):
    """What a command took: wall clock and processor (s), and its largest memory (MB)."""

    wall: float
    processor: float
    memory: float


def main() -> None:
    """Run all studies and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    with tempfile.TemporaryDirectory() as folder:
        page(
            parser,
            lambda of: _report(Path(folder), of),
            years=(40, 1),
            draws=(1_000_000, 100),
            runs=(40, 1),
            many=(0, 0),
        )


def _report(folder: Path, of: argparse.Namespace) -> Iterator[str]:
    years, runs = of.years, of.runs
    yield "# Studies"
    yield ""
    yield ("One run each, from the study file to the tables.")
    yield ""
    yield "At rest, one process."
    yield ""
    yield "| study | members | wall clock | processor | members a second | memory |"
    yield "| --- | --- | --- | --- | --- | --- |"
    if of.smoke:
        yield _row("one line", line(folder, of.draws), timed(folder, "line"))
        return
    hours(folder, years)
    timed(folder, "hours")  # fills the cache
    for each in (years, 2 * years):
        members = hours(folder, each)
        yield _row(f"nine lines, {each} years of hours", members, timed(folder, "hours"))
    for count in (of.draws // 10, of.draws):
        members = line(folder, count)
        yield _row("one line, drawn loads", members, timed(folder, "line"))
    yield ""
    yield f"In motion: a chain in 56 m of water, {runs} runs of 5 minutes, each once."
    yield ""
    yield "| processes | wall clock | processor | runs a minute |"
    yield "| --- | --- | --- | --- |"
    motion(folder, 2)
    timed(folder, "motion", "--workers", "1")  # fills the cache
    motion(folder, runs)
    for workers in (1, 2):
        took = timed(folder, "motion", "--workers", str(workers))
        rate = 60.0 * runs / took.wall
        yield f"| {workers} | {took.wall:.1f} s | {took.processor:.1f} s | {rate:.0f} |"
    yield ""
    yield from _planned(took.processor / runs, _bytes_a_run(folder) / runs)
    if of.many:
        yield ""
        yield from _many(folder, of.many)


def _many(folder: Path, runs: int) -> Iterator[str]:
    """Time many short runs, and say whether all ways to them leave the same files."""
    from distributed import LocalCluster

    motion(folder, runs, coarse=True)
    yield f"In motion: the chain by 12 bars in 40 waves, {runs:,} runs of 10 minutes, each once."
    yield ""
    yield "| on | wall clock | processor | times as fast |"
    yield "| --- | --- | --- | --- |"
    alone = timed(folder, "motion", "--workers", "1")
    yield f"| one process | {alone.wall:.1f} s | {alone.processor:.1f} s | 1.00 |"
    two = timed(folder, "motion", "--workers", "2")
    ratio = alone.wall / two.wall
    yield f"| two processes | {two.wall:.1f} s | {two.processor:.1f} s | {ratio:.2f} |"
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        dask = timed(folder, "motion", "--scheduler", cluster.scheduler_address)
    yield f"| Dask, two workers | {dask.wall:.1f} s | | {alone.wall / dask.wall:.2f} |"
    yield ""
    found = sorted(folder.glob("motion-*"))[-3:]
    prints = {
        tuple(sha256((out / name).read_bytes()).hexdigest() for name in FILES) for out in found
    }
    same = "the same bytes" if len(prints) == 1 else "**different bytes**"
    yield f"{', '.join(FILES)} of the three: {same}."


FILES = ("members.csv", "study.csv", "study.json")
"""That do not depend on how a study was computed."""


RUNS, CORES = 10_000_000, 1000
"""Of the study that is planned."""


def _planned(processor: float, size: float) -> Iterator[str]:
    days = RUNS * processor / CORES / 86400.0
    yield f"Planned from the last row: {RUNS:.0e} such runs on {CORES:,} cores."
    yield ""
    yield f"- {processor:.2f} s of a core a run: {days:.1f} days, if the cores are as fast."
    yield f"- {size:.0f} bytes a run in the directory: {RUNS * size / 1e9:.1f} GB."
    yield (
        f"- {CORES / processor:.0f} runs end in a second. Dask's scheduler takes some 0.2 ms for a "
        f"task, so that it is busy {0.02 * CORES / processor:.0f} % of the time; one core writes "
        "the store."
    )


def _bytes_a_run(folder: Path) -> int:
    out = max(folder.glob("motion-*"))
    return sum((out / name).stat().st_size for name in ("study.sqlite", "members.csv"))


def _row(name: str, members: int, took: Took) -> str:
    rate = members / took.processor
    return (
        f"| {name} | {members:,} | {took.wall:.1f} s | {took.processor:.1f} s | {rate:,.0f} "
        f"| {took.memory:.0f} MB |"
    )


def timed(folder: Path, name: str, *options: str) -> Took:
    """Run a study into a new directory."""
    out = folder / f"{name}-{time.monotonic_ns()}"
    words = [sys.executable, "-m", "catopt", "study", f"{folder / name}.toml", "--out", str(out)]
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    with subprocess.Popen([*words, *options], stdout=subprocess.DEVNULL) as process:
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    wall = time.perf_counter() - began
    if process.returncode:
        raise SystemExit(f"{name} ended with {process.returncode}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    children = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Took(wall, max(children, used.ru_utime + used.ru_stime), used.ru_maxrss / 1024.0)


def hours(folder: Path, years: int) -> int:
    """Write a study of the nine lines of S4's turret over hourly forces; return its members."""
    count = years * HOURS
    rng = np.random.default_rng(1)
    force, heading = 3000.0 * rng.weibull(2.0, count), rng.uniform(0.0, 2.0 * np.pi, count)
    table = np.column_stack([force * np.cos(heading), force * np.sin(heading)])
    head = "system.force[0] (kN),system.force[1] (kN)"
    np.savetxt(folder / "hours.csv", table, "%.3f", ",", header=head, comments="")
    case = (CASES / "fso-rang-dong" / "case.toml").as_posix()
    (folder / "hours.toml").write_text(
        f'case = "{case}"\ncompute = "statics"\n[[vary]]\ntable = "hours.csv"\n'
    )
    return count


def line(folder: Path, count: int) -> int:
    """Write a study of one chain: ten lengths, the rest draws of its load; return its members."""
    case = (CASES / "buoy-9.5m" / "case.toml").as_posix()
    (folder / "line.toml").write_text(
        f'case = "{case}"\ncompute = "statics"\nsamples = {count // 10}\n'
        '[[vary]]\nkey = "line.segments[0].length"\nmin = "19 m"\nmax = "23 m"\ncount = 10\n'
        '[[vary]]\nkey = "load.horizontal_force"\ndistribution = "gumbel"\nmean = "0.343 tf"\n'
        'deviation = "0.03 tf"\n'
    )
    return count


def motion(folder: Path, runs: int, *, coarse: bool = False) -> None:
    """Write a study of runs in motion, a seed each; of a coarse model, ten minutes long."""
    case = (CASES / "dynamic-chain-56m" / "case.toml").as_posix()
    if coarse:
        text = Path(case).read_text(encoding="utf-8")
        text = text.replace('"rao.csv"', f'"{Path(case).with_name("rao.csv").as_posix()}"')
        text = text.replace("[current]", "components = 40\n\n[current]")
        few = 'duration = "10 min"\nelements = 12\ntime_step = "0.2 s"'
        text = text.replace('duration = "5 min"', few)
        (folder / "coarse.toml").write_text(text, encoding="utf-8")
        case = (folder / "coarse.toml").as_posix()
    rows = "\n".join(str(seed) for seed in range(1, runs + 1))
    (folder / "seeds.csv").write_text(f"waves.seed\n{rows}\n", encoding="utf-8")
    (folder / "motion.toml").write_text(
        f'case = "{case}"\ncompute = "motion"\nproof = "none"\n[[vary]]\ntable = "seeds.csv"\n'
    )


if __name__ == "__main__":
    main()
