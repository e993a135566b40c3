"""A front of designs in motion: every design in every seed, the recommended one proven.

    python -m benchmarks.front [--twice 30] [--out benchmarks/results/front.md]

A chain in 56 m of water, led by a ship in a random sea of 3 m (cases/dynamic-chain-56m), with size
and length free: the whole front, five seeds of ten minutes each, on all cores. With ``--twice N``
the first N members are run again with twice the bars, beside their dynamic factors with one time.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from benchmarks.common import page
from catopt import design_case
from catopt.casefile import parse_case
from catopt.notes.front_in_motion import DesignInMotion, front_in_motion
from catopt.notes.motion import checks_in_motion
from catopt.verify.dynamic import verify_dynamic

FOLDER = Path(__file__).parents[1] / "cases" / "dynamic-chain-56m"
LIMIT = 120.0
"""Seconds on two cores for 30 members, five seeds of ten minutes each."""
CASE = """
title = "Chain in 56 m, in motion"
[site]
water_depth = "56 m"
seabed_friction = 0.5
[line]
[[line.segments]]
component = "chain studless R3"
diameter = "76 mm"
length = "300 m"
[load]
horizontal_force = "500 kN"
[waves]
spectrum = "jonswap"
height = "3 m"
period = "9 s"
direction = "180 deg"
[motion]
rao_file = "{raos}"
[dynamics]
duration = "{duration} s"
runs = {seeds}
elements = 40
[checks]
codes = ["API-RP-2SK"]
[design]
objectives = ["mass", "offset"]
[[design.segments]]
components = ["chain studless R3", "chain studless R4"]
diameter_min = "50 mm"
diameter_max = "122 mm"
length_min = "250 m"
length_max = "500 m"
length_step = "10 m"
"""


def main() -> None:
    """Run the front and print what it took."""
    page(
        argparse.ArgumentParser(description=__doc__),
        lambda of: table(of.members, of.seeds, of.duration, of.twice),
        members=(30, 2),
        seeds=(5, 2),
        duration=(600.0, 20.0),
        twice=(0, 1),
    )


def table(members: int, seeds: int, duration: float, twice: int) -> Iterator[str]:
    """Yield the lines of the table."""
    yield "# A front in motion"
    yield ""
    raos = (FOLDER / "rao.csv").as_posix()
    case = parse_case(CASE.format(raos=raos, seeds=seeds, duration=duration))
    result = design_case(case)
    chosen = [
        (
            number,
            replace(case, line=each.line, design=None),
            tuple(
                each.objectives[f"{name}_{unit}"]
                for name, unit in (("mass", "kg"), ("offset", "m"))
            ),
        )
        for number, each in enumerate(result.front[:members], start=1)
    ]
    began, spent = time.perf_counter(), processor_time()
    found = front_in_motion(chosen, min(result.recommended, len(chosen)))
    wall, spent = time.perf_counter() - began, processor_time() - spent
    runs = sum(len(each.found.parts[0].runs) for each in found.designs if each.found)
    passing = sum(each.passes for each in found.designs)
    yield f"{os.cpu_count()} cores; {seeds} seeds of {duration:g} s; 40 bars a line."
    yield ""
    yield "| members | runs | pass | proven | wall time | limit | over limit | processor time |"
    yield "|---|---|---|---|---|---|---|---|"
    proven = sum(not each.is_run_once for each in found.designs)
    yield (
        f"| {len(chosen)} | {runs} | {passing} | {proven} | {wall:.0f} s | {LIMIT:g} s "
        f"| {wall / LIMIT:.2f} | {spent:.0f} s |"
    )
    if twice:
        yield from with_twice_the_bars(found.designs[:twice])


def with_twice_the_bars(designs: Sequence[DesignInMotion]) -> Iterator[str]:
    """Yield by how much the dynamic factor of members that pass differs with twice the bars."""
    ratios, passing = [], 0
    for each in designs:
        if each.found is None or each.amplification is None or not each.passes:
            continue
        case = each.found.case
        assert case.dynamics is not None
        finer = replace(case.dynamics, elements=2 * case.dynamics.bars)
        again = verify_dynamic(replace(case, dynamics=finer), convergence_check="none")
        factor = again.governing.dynamic_amplification
        assert factor is not None
        ratios.append(factor / each.amplification)
        passing += checks_in_motion(again).passes
    yield ""
    yield "Dynamic factors with twice the bars, over those with one time the bars:"
    yield ""
    yield "| members that pass | pass again | least | largest | limit |"
    yield "|---|---|---|---|---|"
    ends = (f"{min(ratios):.4f}", f"{max(ratios):.4f}") if ratios else ("-", "-")
    yield f"| {len(ratios)} | {passing} | {ends[0]} | {ends[1]} | 1.05 |"


def processor_time() -> float:
    """Return s of this process and of those that it waited for."""
    return sum(os.times()[:4])


if __name__ == "__main__":
    main()
