"""Signals to commands at random times.

    python -m tests.signals --sigint 300 --sigterm 100 --sigkill 100

Prints how the runs ended, and every fault. Exit status 1 when there was one.
"""

from __future__ import annotations

import argparse
import signal
import sys

from tests.signals.campaign import run


def main(arguments: list[str] | None = None) -> int:
    """Run a campaign; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m tests.signals", description=__doc__)
    for name, count in (("sigint", 300), ("sigterm", 100), ("sigkill", 100)):
        parser.add_argument(f"--{name}", type=int, default=count, help=f"how often {name.upper()}")
    parser.add_argument("--seed", type=int, default=1, help="seed of the times")
    given = parser.parse_args(arguments)
    failed = 0
    for name in ("sigint", "sigterm", "sigkill"):
        count = getattr(given, name)
        tally = run(signal.Signals[name.upper()], count, given.seed)
        say(f"{count} {name.upper()}: {len(tally.faults)} faults, {tally.mixed} of two answers")
        for (command, status), times in sorted(tally.ends.items()):
            say(f"  {command:45} status {status:4}: {times:4}")
        for fault in tally.faults:
            say(f"  {fault}")
        failed += len(tally.faults)
    return 1 if failed else 0


def say(text: str) -> None:
    """Print a line."""
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
