"""Broken files of every kind that catopt reads, by the thousand; and single changes that count.

    python -m tests.fuzz --files 20000 --seed 1
    python -m tests.fuzz --files 300 --processes
    python -m tests.fuzz --files 4000 --changes 6000 --out benchmarks/results/fuzz.md

Prints how they ended, by kind, and every fault. Exit status 1 when there was one. All that catopt
compiles is compiled first, so that no file is said to be slow for it. A change of one unit, key,
value or row of a table, a form, a case file, coefficients or an array has to change what is read,
or is refused (`tests.fuzz.silence`).
"""

from __future__ import annotations

import argparse
import sys
import time
import warnings
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from catopt.compile_jobs import JOBS, compile_always
from tests.fuzz.kinds import kinds
from tests.fuzz.run import LARGEST, LONGEST, STATUSES, Tally, run
from tests.fuzz.silence import KINDS, campaign


def main(arguments: list[str] | None = None) -> int:
    """Run a campaign; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--files", type=int, default=20_000, help="how many files")
    parser.add_argument("--changes", type=int, default=0, help="how many single changes")
    parser.add_argument("--first", type=int, default=0, help="number of the first")
    parser.add_argument("--seed", type=int, default=1, help="seed of all of them")
    parser.add_argument("--slow", type=float, default=0.02, help="part with much computing")
    parser.add_argument("--processes", action="store_true", help="each as a process of its own")
    parser.add_argument("--minutes", type=float, default=600.0, help="after which no more begins")
    parser.add_argument("--out", type=Path, help="Markdown file for the result")
    given = parser.parse_args(arguments)
    with compile_always():
        for job in JOBS.values():
            job()
    start = time.process_time()
    seconds = 60.0 * given.minutes
    tally = run(
        given.files,
        given.seed,
        slow=given.slow,
        processes=given.processes,
        first=given.first,
        seconds=seconds,
    )
    took = time.process_time() - start
    say(f"{tally.statuses.total():,} files, seed {given.seed}, {took:.0f} s")
    say(f"{'kind':20}" + "".join(f"{status:>8}" for status in STATUSES))
    for kind in kinds():
        counts = (tally.statuses[kind.name, status] for status in STATUSES)
        say(f"{kind.name:20}" + "".join(f"{count:8,}" for count in counts))
    say(f"slowest: {tally.slowest[0]:.1f} s, {tally.slowest[1]}")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of openpyxl, which makes the forms
        made, silent = campaign(given.changes, given.seed, seconds)
    say(f"{made.total():,} single changes, {len(silent)} of them silent")
    faults = [*tally.faults, *silent]
    say(f"{len(faults)} faults")
    for fault in faults:
        say(fault)
    if given.out is not None:
        text = "\n".join(_page(given, tally, took, made, silent)) + "\n"
        given.out.write_text(text, encoding="utf-8")
    return 1 if faults else 0


def _page(
    given: argparse.Namespace, tally: Tally, took: float, made: Counter[str], silent: list[str]
) -> Iterator[str]:
    """Yield the lines of the result."""
    yield "# What enters, broken"
    yield ""
    asked = f"--files {given.files} --changes {given.changes} --minutes {given.minutes:g}"
    yield f"`python -m tests.fuzz {asked}`, seed {given.seed}."
    yield f"{tally.statuses.total():,} broken files and {made.total():,} single changes, as many as"
    yield f"were run. {len(tally.faults)} files ended as a fault of catopt's own, without key and"
    yield f"reason, after more than {LONGEST:g} s of processor time or {LARGEST / 1000:g} MB; the"
    yield f"slowest took {tally.slowest[0]:.1f} s, all of them {took:.0f} s. {len(silent)} changes"
    yield "changed nothing in silence."
    yield ""
    yield "| files of the kind | answered | refused | no answer exists | not converged |"
    yield "|---|---|---|---|---|"
    for kind in kinds():
        counts = (f"{tally.statuses[kind.name, status]:,}" for status in STATUSES)
        yield f"| {kind.name} | {' | '.join(counts)} |"
    yield ""
    yield "Single changes, by turns as many of each: " + ", ".join(KINDS) + "."


def say(text: str) -> None:
    """Print a line."""
    sys.stdout.write(text + "\n")


if __name__ == "__main__":
    sys.exit(main())
