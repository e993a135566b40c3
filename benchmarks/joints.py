"""Joints and a body at rest: many loads in one compiled call beside each load by itself.

    python -m benchmarks.joints [--loads N] [--smoke] [--out FILE]

Three legs of chain that each part into two ropes, on a body that is free in x, y and yaw: nine
lines and twelve freedoms. Processor time; each load by itself is plain Python, as one answer is.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import TypeVar

import numpy as np

from benchmarks.common import page
from catopt.compile_jobs import compile_always
from catopt.compiled import VARIABLE
from catopt.model import Line, Segment, Site
from catopt.model.network import LineBetween, MooredBody, Network, Point
from catopt.mooring.fixed_body import without_load
from catopt.mooring.many import solve_network_many
from catopt.threads import environment

T = TypeVar("T")
DEPTH = 100.0
CHAIN, ROPE = Line([Segment(500.0, 1500.0, EA=5e8)]), Line([Segment(45.0, 300.0, EA=6e7)])
ALONE = 20
"""Loads that are solved each by itself."""


def mooring() -> Network:
    """Lay out nine lines between an anchor, a joint and two fairleads of each leg."""
    points, lines = [], []
    for k in range(3):
        leg = 2.0 * math.pi * k / 3.0
        x, y = 545.0 * math.cos(leg), 545.0 * math.sin(leg)
        points.append(Point(f"anchor {k}", "anchor", x, y, 0.0))
        points.append(Point(f"joint {k}", "joint", submerged_weight=5e3))
        lines.append(LineBetween(CHAIN, f"anchor {k}", f"joint {k}"))
        for side in (-0.5, 0.5):
            x, y = 15.0 * math.cos(leg + side), 15.0 * math.sin(leg + side)
            name = f"fairlead {k} {side:+}"
            points.append(Point(name, "fairlead", x, y, DEPTH, body="spar"))
            lines.append(LineBetween(ROPE, f"joint {k}", name))
    return Network(Site(DEPTH), tuple(points), tuple(lines), bodies=(MooredBody("spar"),))


def main() -> None:
    """Time both, and compare what they say."""
    page(argparse.ArgumentParser(description=__doc__), _report, loads=(5000, 200))


def _report(of: argparse.Namespace) -> Iterator[str]:
    network, random = mooring(), np.random.default_rng(1)
    size, side = random.uniform(0.0, 4e5, of.loads), random.uniform(0.0, 2.0 * math.pi, of.loads)
    moment = random.uniform(-2e6, 2e6, of.loads)
    loads = np.column_stack([size * np.cos(side), size * np.sin(side), moment])[:, None]
    with compile_always():
        solve_network_many(network, force=loads[:2])
        many, found = _timed(lambda: solve_network_many(network, force=loads))
    alone, apart = math.inf, 0.0
    with environment({VARIABLE: "never"}):
        start = without_load(network)
        for load in range(ALONE):
            x, y, turn = loads[load, 0].tolist()
            body = replace(network.bodies[0], force=(x, y), moment=turn)
            took, rest = _timed(partial(start.under, (body,)))
            alone = min(alone, took)
            there = rest.bodies[0].position
            other = found.position[load, 0] - [there.x, there.y, there.yaw]
            apart = max(apart, float(np.abs(other).max()))
    each = many / of.loads
    yield "# Joints and a body at rest"
    yield ""
    yield "Nine lines, three joints and a body free in x, y and yaw, brought to rest under a load."
    yield ""
    yield "| way | loads | processor time a load | times | largest difference |"
    yield "|---|---|---|---|---|"
    yield f"| each by itself, the least | {ALONE} | {1e3 * alone:.2f} ms | 1 | - |"
    said = f"{1e6 * each:.0f} us | {alone / each:.0f} | {apart:.1e} m or rad"
    yield f"| `solve_network_many` | {of.loads:,} | {said} |"


def _timed(run: Callable[[], T]) -> tuple[float, T]:
    began = time.process_time()
    found = run()
    return time.process_time() - began, found


if __name__ == "__main__":
    main()
