"""A buoy on its line by linear motion beside runs in time: a hundred lines in one sea, ranked.

    python -m benchmarks.linear_afloat [--out benchmarks/results/linear_afloat.md]

A T-5000l-2.4m in 12 m of water, wind 25 m/s and current 1 m/s, on chain of ten sizes and ten
lengths, ten minutes in time each. What is compared is the order of the lines by their largest
tension (linear: most probable in the ten minutes) and by the deviation, among those that have no
slack in time, and among all.
"""

from __future__ import annotations

import argparse
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
        "| Hs | Tp | without slack | by largest | by deviation | all, by largest | deviation, "
        "linear over in time | in time | linear | ratio |"
    )
    yield "|---|---|---|---|---|---|---|---|---|---|"
    for height, period in SEAS[:seas]:
        cases = [
            CASE.format(
                size=size,
                EA=0.0824 * size**2,
                length=length,
                height=height,
                period=period,
                duration=duration,
            )
            for size in SIZES
            for length in LENGTHS
        ][: max(lines, 2)]
        rows = [compare(each, duration) for each in cases]
        taut = [row for row in rows if row.slack == 0.0]
        over = sorted(row.linear[0] / row.in_time[0] for row in (taut or rows))
        linear, in_time = (sum(row.seconds[k] for row in rows) / len(rows) for k in range(2))
        yield (
            f"| {height:g} m | {period:g} s | {len(taut)} | {ranked(taut, 1)} "
            f"| {ranked(taut, 0)} | {ranked(rows, 1)} | {over[0]:.2f} to {over[-1]:.2f} "
            f"| {in_time:.1f} s | {1e3 * linear:.0f} ms | {in_time / linear:.0f} |"
        )


def ranked(rows: list[Row], which: int) -> str:
    """Correlate the ranks of the lines."""
    if len(rows) < 3:
        return "-"
    found = spearmanr([row.linear[which] for row in rows], [row.in_time[which] for row in rows])
    return f"{found.statistic:.3f}"


def compare(text: str, duration: float) -> Row:
    """Run a line both ways; the linear one with buoy and line at rest known already."""
    case = parse_case(text)
    linear_lines(case)
    began = time.process_time()
    (line,) = linear_lines(case)
    linear = time.process_time() - began
    began = time.process_time()
    found = verify_dynamic(case, convergence_check="none", workers=1, compares_at_rest=False)
    in_time, part = time.process_time() - began, found.parts[0]
    of = part.of("fairlead_tension")
    return Row(
        (line.deviation, line.most_probable(duration)),
        (of.std, of.maximum),
        part.slack_time,
        (linear, in_time),
    )


if __name__ == "__main__":
    main()
