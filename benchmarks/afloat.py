"""Ten hours of a buoy whose line goes slack, in its line's plane and in weather from three sides.

    python -m benchmarks.afloat [--out benchmarks/results/afloat.md]

Ten seeds of an hour, T-5000l-2.4m on 30 m of chain in 12 m, Hs 1.5 m, 20 bars, on all cores.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Iterator
from dataclasses import replace

from benchmarks.common import page
from benchmarks.linear_afloat import CASE
from catopt.casefile import parse_case
from catopt.model import Case
from catopt.verify.dynamic import verify_dynamic

LIMIT = 60.0
"""Seconds on two cores for ten seeds of an hour."""


def main() -> None:
    """Run them and print what they took."""
    page(
        argparse.ArgumentParser(description=__doc__),
        lambda of: table(of.seeds, of.duration),
        seeds=(10, 2),
        duration=(3600.0, 20.0),
    )


def table(seeds: int, duration: float) -> Iterator[str]:
    """Yield the lines of the table."""
    yield "# A buoy afloat"
    yield ""
    yield f"{os.cpu_count()} cores; {seeds} seeds of {duration:g} s."
    yield ""
    yield "| weather | freedoms | wall time | limit | over limit |"
    yield "|---|---|---|---|---|"
    for name, case in (("along the line", along()), ("from three sides", aside())):
        assert case.dynamics is not None
        runs = replace(case.dynamics, duration=duration, runs=seeds)
        began = time.perf_counter()
        found = verify_dynamic(
            replace(case, dynamics=runs), convergence_check="none", compares_at_rest=False
        )
        wall, freedoms = time.perf_counter() - began, len(found.body) - 1
        yield f"| {name} | {freedoms} | {wall:.1f} s | {LIMIT:g} s | {wall / LIMIT:.2f} |"


def along() -> Case:
    """Make the case whose wind, waves and current go along the line."""
    sizes = {"size": 38, "length": 30, "EA": 119}
    return parse_case(CASE.format(**sizes, height=1.5, period=5, seed=1, duration=600))


def aside() -> Case:
    """Turn the wind and the waves aside."""
    case = along()
    assert case.floater is not None
    assert case.waves is not None
    return replace(
        case,
        floater=replace(case.floater, wind_direction=0.7),
        waves=replace(case.waves, direction=-0.5),
    )


if __name__ == "__main__":
    main()
