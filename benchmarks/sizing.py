"""Time from the shell to the answer of ``catopt size``, each run a new process.

    python -m benchmarks.sizing [--rounds 11] [--out benchmarks/results/sizing.md]

Before the first round each command has run once, so that compiled loops and bytecode are on disk.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
import time

from benchmarks.common import page

SHIP = (
    *("tanker", "--length", "234 m", "--breadth", "31.3 m", "--draught", "12.4 m"),
    *("--moulded-depth", "16 m", "--depth", "22 m", "--low-water", "20 m"),
    *("--wind", "20 m/s", "--current", "1.2 m/s", "--hmax", "3.5 m", "--period", "8 s"),
)
COMMANDS = {
    "buoy of the library": ("buoy", "pillar 2.4 m", "--depth", "12 m", "--low-water", "10 m"),
    "buoy by its force": (
        *("buoy", "--depth", "9.5 m", "--force", "0.343 tf", "--reserve-buoyancy", "12 kN"),
    ),
    "buoy, chain of three grades": (
        *("buoy", "pillar 2.4 m", "--depth", "12 m", "--chain", "chain stud-link U1"),
        *("--chain", "chain stud-link U2", "--chain", "chain stud-link U3"),
    ),
    "tanker, one line": SHIP,
    "tanker, hawser and buoy": (*SHIP, "--buoy", "mooring buoy 5.0 m"),
    "tanker, six lines around a turret": (*SHIP, "--lines", "6"),
    "tanker, six lines around a buoy": (*SHIP, "--buoy", "mooring buoy 5.0 m", "--lines", "6"),
}


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(parser, lambda of: report(timed(of.rounds, of.smoke)), rounds=(11, 1))


def timed(rounds: int, smoke: bool) -> dict[str, list[tuple[float, float]]]:
    """Seconds that each command took in each round."""
    commands = dict(list(COMMANDS.items())[:1]) if smoke else COMMANDS
    if not smoke:
        for options in commands.values():
            once(options)
    taken: dict[str, list[tuple[float, float]]] = {name: [] for name in commands}
    for _ in range(rounds):
        for name, options in commands.items():
            taken[name].append(once(options))
    return taken


def once(options: tuple[str, ...]) -> tuple[float, float]:
    """Run a command; return its seconds, by the clock and of processor."""
    command = [sys.executable, "-m", "catopt", "size", *options]
    start, used = time.perf_counter(), _processor()
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    return time.perf_counter() - start, _processor() - used


def _processor() -> float:
    """Return the processor time of all processes that have ended, s."""
    times = os.times()
    return times.children_user + times.children_system


def report(taken: dict[str, list[tuple[float, float]]]) -> list[str]:
    """Lay the times out as a Markdown page."""
    rows = [
        f"| {name} | {statistics.median(wall):.2f} | {min(wall):.2f} | {max(wall):.2f} | "
        f"{statistics.median(processor):.2f} |"
        for name, times in taken.items()
        for wall, processor in (tuple(zip(*times, strict=True)),)
    ]
    return [
        "# Sizing",
        "",
        "Each command a new process, one after the other in turn; seconds from the shell to the "
        "end. Other work on the machine lengthens the clock; the processor time hardly minds "
        f"it. Load {os.getloadavg()[0]:.1f} at the end.",
        "",
        "| `catopt size` | median, s | fastest, s | slowest, s | processor, median, s |",
        "|---|---|---|---|---|",
        *rows,
    ]


if __name__ == "__main__":
    main()
