"""Random lines and moorings of every kind, each answer and each refusal checked.

    python -m tests.campaign --lines 1000000 --seed 1 --workers 8 --out campaign

Prints a table and writes the simplest failing line as a case file that `catopt solve` reads. Exit
status 1 when anything failed.
"""

from __future__ import annotations

import argparse
import sys
import time
from importlib import import_module
from pathlib import Path

from catopt.casefile.writing import write_case
from tests.campaign.evaluation import evaluate
from tests.campaign.run import run
from tests.campaign.shrinking import shrunk
from tests.campaign.tally import Tally


def main(arguments: list[str] | None = None) -> int:
    """Run a campaign; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign", description=__doc__)
    parser.add_argument("--lines", type=int, default=1_000_000, help="how many lines")
    parser.add_argument("--first", type=int, default=0, help="index of the first line")
    parser.add_argument("--systems", type=int, default=0, help="how many moored bodies")
    parser.add_argument("--networks", type=int, default=0, help="how many networks, from --first")
    parser.add_argument("--afloat", type=int, default=0, help="how many with floats and rafts")
    parser.add_argument("--in-current", type=int, default=0, help="how many of these in a current")
    parser.add_argument(
        "--trusses", type=int, default=0, help="how many by both models, from --first"
    )
    parser.add_argument("--faces", type=int, default=0, help="moorings by every face, from --first")
    parser.add_argument("--in-motion", type=int, default=0, help="sizings in motion, from --first")
    parser.add_argument("--seed", type=int, default=1, help="seed of all of them")
    parser.add_argument("--workers", type=int, default=1, help="processes")
    parser.add_argument("--out", type=Path, default=Path(), help="where a failing case goes")
    given = parser.parse_args(arguments)
    failures = 0
    if given.lines > 0:
        start = time.perf_counter()
        tally = run(given.lines, given.seed, workers=given.workers, first=given.first)
        seconds = time.perf_counter() - start
        say(f"{tally.lines:,} lines, seed {given.seed}\n\n{tally.table()}")
        say(f"{tally.lines / seconds:,.0f} lines a second")
        write_simplest(tally, given.out)
        failures += tally.failures
    if given.systems > 0:
        failures += _systems(given.systems, given.seed)
    if given.networks > 0:
        networks = import_module("tests.campaign.network_check")
        say(f"\n{given.networks:,} networks from {given.first}")
        failures += networks.run(given.networks, given.first, say)
    if given.afloat > 0:
        networks = import_module("tests.campaign.network_check")
        say(f"\n{given.afloat:,} networks afloat from {given.first}")
        failures += networks.run_afloat(given.afloat, given.first, say)
    if given.in_current > 0:
        streaming = import_module("tests.campaign.current_check")
        say(f"\n{given.in_current:,} networks in a current from {given.first}")
        failures += streaming.run(given.in_current, given.first, say)
    if given.trusses > 0:
        trusses = import_module("tests.campaign.truss_check")
        say(f"\n{given.trusses:,} networks from {given.first} by both models")
        failures += trusses.run(given.trusses, given.first, say)
    if given.faces > 0:
        faces = import_module("tests.campaign.faces")
        say(f"\n{given.faces:,} moorings from {given.first} by every command and face")
        failures += faces.run(given.faces, given.first, say)
    if given.in_motion > 0:
        in_motion = import_module("tests.campaign.in_motion")
        say(f"\n{given.in_motion:,} sizings in motion from {given.first}")
        failures += in_motion.run(given.in_motion, given.first, say)
    return 1 if failures else 0


def _systems(count: int, seed: int) -> int:
    """Run the campaign over moored bodies; returns how many failed."""
    systems = import_module("tests.campaign.systems")
    tally = systems.run(count, seed)
    columns = ("answered", "wrong", "refused_rightly", "refused_wrongly", "exceptions")
    say(f"\n{count:,} moored bodies, seed {seed}")
    say("".join(f"{name.replace('_', ' '):>17}" for name in columns))
    say("".join(f"{getattr(tally, name):>17,}" for name in columns))
    for each in tally.failures:
        say(f"number {each.index}: {each.fault}")
    return len(tally.failures)


def write_simplest(tally: Tally, folder: Path) -> Path | None:
    """Write the simplest failing line, made simpler still, as a case file."""
    trial = tally.simplest()
    if trial is None:
        return None
    (before,) = evaluate([trial])
    verdict = before.verdict
    small = shrunk(trial, lambda each: evaluate([each])[0].verdict == verdict)
    (outcome,) = evaluate([small])
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "failing-case.toml"
    path.write_text(write_case(small.case), encoding="utf-8")
    say(f"simplest failing line: number {trial.index}, {outcome.verdict}: {outcome.reason}; {path}")
    return path


def say(text: str) -> None:
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
