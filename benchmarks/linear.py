"""Linear motion beside runs in time: standard deviation of a fairlead's tension in 20 sea states.

    python -m benchmarks.linear [--out benchmarks/results/linear.md]

A chain in 56 m of water (cases/dynamic-chain-56m), half an hour in each sea state, once. Both have
the same waves, and the deviations are of the same time. The least of three times counts for linear
motion, with the line at rest known already.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import catopt
from benchmarks.common import page
from catopt.fem.linear_model import LinearModel, linear_model
from catopt.fem.linear_motion import linear_motion
from catopt.fem.series import Harmonic
from catopt.model import Case
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_lines import OneLine, lines_at_rest
from catopt.verify.dynamic_setup import Excitation, read_drive

CASE = Path(__file__).parents[1] / "cases" / "dynamic-chain-56m" / "case.toml"
HEIGHTS, PERIODS = (1.0, 2.0, 3.0, 4.0), (8.0, 9.5, 11.0, 12.5, 14.0)
ROUNDS = 3


def main() -> None:
    """Run all sea states and print the table."""
    page(
        argparse.ArgumentParser(description=__doc__),
        lambda of: table(of.seas, of.duration),
        seas=(20, 1),
        duration=(1800.0, 2.0),
    )


def table(seas: int, time_: float) -> Iterator[str]:
    """Yield the lines of the table."""
    yield "# Linear motion"
    yield ""
    yield (
        "One core. A chain in 56 m of water, the same 200 waves, half an hour in each sea state."
    )
    yield ""
    yield (
        "| Hs | Tp | deviation in time | linear over it | slack | largest in time over linear | "
        "time | linear | ratio |"
    )
    yield "|---|---|---|---|---|---|---|---|---|"
    states = [(height, period) for height in HEIGHTS for period in PERIODS][:seas]
    rows = [compare(*state, time_) for state in states]
    for row in rows:
        yield (
            f"| {row[0]:g} m | {row[1]:g} s | {row[2] / 1e3:.1f} kN | {row[3]:.3f} | {row[4]:.1f} s"
            f" | {row[5]:.2f} | {row[6]:.1f} s | {1e3 * row[7]:.0f} ms | {row[6] / row[7]:.0f} |"
        )
    ratios, speed = [row[3] for row in rows], [row[6] / row[7] for row in rows]
    yield ""
    yield (
        f"Deviations from {min(ratios):.3f} to {max(ratios):.3f} of those in time; "
        f"{min(speed):.0f} to {max(speed):.0f} times as fast as half an hour, and twice that as an "
        "hour. What a code checks, the largest tension, is not normally distributed: the last of "
        "the columns of tensions says by how much."
    )


def compare(height: float, period: float, duration: float) -> tuple[float, ...]:
    """Deviation in time, that of linear motion over it, and what both take."""
    case = in_sea(height, period, duration)
    drive = read_drive(case)
    lines = lines_at_rest(drive)
    assert isinstance(lines, OneLine)
    model = linear_model(lines.simulation())
    if duration > 60.0:
        verify_dynamic(shorter(case), convergence_check="none", workers=1)
    began = time.process_time()
    run = (
        verify_dynamic(case, convergence_check="none", workers=1, compares_at_rest=False)
        .parts[0]
        .runs[0]
    )
    took = time.process_time() - began
    history = run.history
    at = history.counted
    tension = history.bar_tension[at, 0, 1]
    series, quick = linear(drive, lines, model, history.time[at])
    return (
        height, period, tension.std(), series.std() / tension.std(), history.line_slack_time(),
        tension.max() / series.max(), took, quick,
    )  # fmt: skip


def linear(drive: Excitation, lines: OneLine, model: LinearModel, times):  # type: ignore[no-untyped-def]
    """Tension at the fairlead over time, and what it took."""
    quick = []
    for _ in range(ROUNDS):
        began = time.process_time()
        sea = drive.sea(0)
        motion = drive.motion(sea, lines.span)
        assert isinstance(motion, Harmonic)
        found = linear_motion(model, sea, motion.amplitudes[None])
        quick.append(time.process_time() - began)
    return found.series(times)[:, -1], min(quick)


def in_sea(height: float, period: float, duration: float) -> Case:
    """Put a sea state into the case."""
    case: Case = catopt.read_case(CASE)
    assert case.waves is not None
    assert case.dynamics is not None
    waves = replace(case.waves, height=height, period=period)
    return replace(case, waves=waves, dynamics=replace(case.dynamics, duration=duration))


def shorter(case: Case) -> Case:
    """Have what is compiled at hand."""
    assert case.dynamics is not None
    return replace(case, dynamics=replace(case.dynamics, duration=60.0))


if __name__ == "__main__":
    main()
