"""A buoy on its line by linear motion beside runs in time: a hundred lines in one sea, ranked.

    python -m benchmarks.linear_afloat [--out benchmarks/results/linear_afloat.md]

A T-5000l-2.4m in 12 m of water, wind 25 m/s and current 1 m/s, on chain of ten sizes and ten
lengths, ten minutes in time each, in two seeds. What is compared is the order of the lines by their
largest tension (linear: most probable in the ten minutes; in time: mean of both seeds) and by the
deviation, among those that have no slack in time, and among all; and what one seed says of the
other. Where lines went slack, the largest reserve (`LinearLine.reserve`) that any of them had.
"""

from __future__ import annotations

import argparse
import itertools
import time
from collections.abc import Iterator
from typing import NamedTuple

from scipy.stats import spearmanr

from benchmarks.common import page
from catopt.casefile import parse_case
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.linear import linear_lines

SIZES = (22, 24, 26, 28, 30, 32, 34, 36, 38, 40)
LENGTHS = (24, 27, 30, 33, 36, 40, 44, 48, 54, 60)
SEAS = ((0.3, 3.5), (0.5, 4.0), (0.8, 4.5))
WANTED = 0.95
CASE = """
title = "A buoy"
[site]
water_depth = "12 m"
[line]
fairlead_height = "9.4 m"
[[line.segments]]
component = "chain open-link 4D Q2"
diameter = "{size} mm"
length = "{length} m"
EA = "{EA} MN"
[load]
horizontal_force = "8.6 kN"
[floater]
buoy = "T-5000l-2.4m"
wind_speed = "25 m/s"
[waves]
spectrum = "jonswap"
height = "{height} m"
period = "{period} s"
components = 100
seed = {seed}
[current]
profile = "power"
speed = "1 m/s"
[dynamics]
duration = "{duration} s"
elements = 20
"""


class Row(NamedTuple):
    """What a line came to, both ways."""

    linear: tuple[float, float]  # deviation and most probable largest tension, N
    in_time: tuple[float, float]
    largest: tuple[float, float]  # of each seed, N
    reserve: float
    slack: float  # s
    seconds: tuple[float, float]  # of either, s


def main() -> None:
    """Run the lines in every sea and print the table."""
    page(
        argparse.ArgumentParser(description=__doc__),
        lambda of: table(of.lines, of.seas, of.duration),
        lines=(100, 3),
        seas=(3, 1),
        duration=(600.0, 40.0),
    )


def table(lines: int, seas: int, duration: float) -> Iterator[str]:
    """Yield the lines of the table."""
    yield "# Linear motion of a buoy on its line"
    yield ""
    yield (
        f"{lines} lines in each sea; Spearman's rank correlation of linear motion with the run in "
        f"time, by largest tension and by its deviation; the limit is {WANTED:g} without slack."
    )
    yield ""
    yield (
        "| Hs | Tp | without slack | by largest | one seed by the other | by deviation "
        "| all, by largest | deviation, linear over in time | reserve with slack "
        "| in time | linear | ratio |"
    )
    yield "|---|---|---|---|---|---|---|---|---|---|---|---|"
    for height, period in SEAS[:seas]:
        drawn = list(itertools.product(SIZES, LENGTHS))[: max(lines, 2)]
        rows = [compare(*each, height, period, duration) for each in drawn]
        taut = [row for row in rows if row.slack == 0.0]
        slack = max((row.reserve for row in rows if row.slack > 0.0), default=None)
        over = sorted(row.linear[0] / row.in_time[0] for row in (taut or rows))
        linear, in_time = (sum(row.seconds[k] for row in rows) / len(rows) for k in range(2))
        yield (
            f"| {height:g} m | {period:g} s | {len(taut)} | {ranked(taut, 1)} "
            f"| {correlated([row.largest for row in taut])} "
            f"| {ranked(taut, 0)} | {ranked(rows, 1)} | {over[0]:.2f} to {over[-1]:.2f} "
            f"| {'-' if slack is None else f'{slack:.1f}'} "
            f"| {in_time:.1f} s | {1e3 * linear:.0f} ms | {in_time / linear:.0f} |"
        )


def ranked(rows: list[Row], which: int) -> str:
    """Correlate the ranks of the lines, linear and in time."""
    return correlated([(row.linear[which], row.in_time[which]) for row in rows])


def correlated(pairs: list[tuple[float, float]]) -> str:
    """Correlate ranks."""
    if len(pairs) < 3:
        return "-"
    return f"{spearmanr(*zip(*pairs, strict=True)).statistic:.3f}"


def compare(size: int, length: int, height: float, period: float, duration: float) -> Row:
    """Run a line both ways; the linear one with buoy and line at rest known already."""
    cases = [
        parse_case(
            CASE.format(
                size=size,
                EA=0.0824 * size**2,
                length=length,
                height=height,
                period=period,
                duration=duration,
                seed=seed,
            )
        )
        for seed in (1, 2)
    ]
    linear_lines(cases[0])
    began = time.process_time()
    (line,) = linear_lines(cases[0])
    linear = time.process_time() - began
    began = time.process_time()
    parts = [
        verify_dynamic(each, convergence_check="none", workers=1, compares_at_rest=False).parts[0]
        for each in cases
    ]
    in_time = 0.5 * (time.process_time() - began)
    found = [part.of("fairlead_tension") for part in parts]
    first, second = (each.maximum for each in found)
    return Row(
        (line.deviation, line.most_probable(duration)),
        (sum(each.std for each in found) / 2.0, 0.5 * (first + second)),
        (first, second),
        line.reserve,
        sum(part.slack_time for part in parts),
        (linear, in_time),
    )


if __name__ == "__main__":
    main()
