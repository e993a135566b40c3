"""Broken files of every kind that catopt reads, by the thousand.

    python -m tests.fuzz --files 20000 --seed 1
    python -m tests.fuzz --files 300 --processes

Prints how they ended, by kind, and every fault. Exit status 1 when there was one. All that catopt
compiles is compiled first, so that no file is said to be slow for it.
"""

from __future__ import annotations

import argparse
import sys
import time

from catopt.compile_jobs import JOBS, compile_always
from tests.fuzz.kinds import kinds
from tests.fuzz.run import STATUSES, run


def main(arguments: list[str] | None = None) -> int:
    """Run a campaign; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--files", type=int, default=20_000, help="how many files")
    parser.add_argument("--first", type=int, default=0, help="number of the first")
    parser.add_argument("--seed", type=int, default=1, help="seed of all of them")
    parser.add_argument("--slow", type=float, default=0.02, help="part with much computing")
    parser.add_argument("--processes", action="store_true", help="each as a process of its own")
    given = parser.parse_args(arguments)
    with compile_always():
        for job in JOBS.values():
            job()
    start = time.process_time()
    tally = run(
        given.files, given.seed, slow=given.slow, processes=given.processes, first=given.first
    )
    say(f"{given.files:,} files, seed {given.seed}, {time.process_time() - start:.0f} s")
    say(f"{'kind':20}" + "".join(f"{status:>8}" for status in STATUSES))
    for kind in kinds():
        counts = (tally.statuses[kind.name, status] for status in STATUSES)
        say(f"{kind.name:20}" + "".join(f"{count:8,}" for count in counts))
    say(f"slowest: {tally.slowest[0]:.1f} s, {tally.slowest[1]}")
    say(f"{len(tally.faults)} faults")
    for fault in tally.faults:
        say(fault)
    return 1 if tally.faults else 0


def say(text: str) -> None:
    """Print a line."""
    sys.stdout.write(text + "\n")


if __name__ == "__main__":
    sys.exit(main())
