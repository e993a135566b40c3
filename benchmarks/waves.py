"""What the motion of the water costs: ns for each point, wave and time step.

    python -m benchmarks.waves [--out benchmarks/results/waves.md]

The compiled kernel is measured in turns with two others of the same formulas: compiled with the
library's exp, sin and cos, and numpy's arrays. One thread.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from benchmarks.common import page
from catopt.compiled import compiled
from catopt.waves import Flow, Sea, fill_kinematics, jonswap, random_waves, strongest_return
from catopt.waves.random_surface import Bands

DEPTH = 56.0
SPECTRUM = jonswap(8.48, 12.965)
STEP = 0.1
SIZES = [(41, 20), (41, 200), (181, 200), (41, 1)]

Filling = Callable[..., object]


def by_library(
    t: float, points: Any, flow: Flow, velocity: Any, acceleration: Any, surface: Any
) -> None:
    """Do the same with math.exp, math.cos and math.sin, point by point; without stretching."""
    for n in range(points.shape[0]):
        below = flow.depth - max(points[n, 2], 0.0)
        u = v = w = u_t = v_t = w_t = 0.0
        for i in range(flow.waves.shape[0]):
            wave = flow.waves[i]
            decay = wave[3] * below
            if decay > flow.reach:
                continue
            E = math.exp(-decay)
            theta = wave[1] * points[n, 0] + wave[2] * points[n, 1] - wave[0] * t + wave[4]
            cos, sin = math.cos(theta), math.sin(theta)
            along = flow.factors[i, 1] * (E + flow.factors[i, 0] / E)
            up = flow.factors[i, 1] * (E - flow.factors[i, 0] / E)
            u += along * cos * wave[5]
            v += along * cos * wave[6]
            w += up * sin
            u_t += wave[0] * along * sin * wave[5]
            v_t += wave[0] * along * sin * wave[6]
            w_t -= wave[0] * up * cos
        surface[n] = flow.depth
        velocity[n, 0], velocity[n, 1], velocity[n, 2] = u, v, w
        acceleration[n, 0], acceleration[n, 1], acceleration[n, 2] = u_t, v_t, w_t


def by_numpy(
    t: float, points: Any, flow: Flow, velocity: Any, acceleration: Any, surface: Any
) -> None:
    """Do the same with arrays of points by waves."""
    omega, k_x, k_y, k, phase, cos_b, sin_b, _ = flow.waves.T
    E = np.exp(-k * (flow.depth - points[:, 2:]))
    theta = points[:, :1] * k_x + points[:, 1:2] * k_y - omega * t + phase
    along = flow.factors[:, 1] * (E + flow.factors[:, 0] / E)
    up = flow.factors[:, 1] * (E - flow.factors[:, 0] / E)
    cos, sin = np.cos(theta), np.sin(theta)
    velocity[:, 0] = (along * cos) @ cos_b
    velocity[:, 1] = (along * cos) @ sin_b
    velocity[:, 2] = (up * sin).sum(axis=1)
    acceleration[:, 0] = (along * sin) @ (omega * cos_b)
    acceleration[:, 1] = (along * sin) @ (omega * sin_b)
    acceleration[:, 2] = -(up * cos) @ omega
    surface[:] = flow.depth


def sea(count: int, *, wheeler: bool = False) -> Sea:
    """Draw a sea of the storm."""
    waves = random_waves(SPECTRUM, count, np.random.default_rng(1))
    return Sea(DEPTH, waves, stretching="wheeler" if wheeler else "none")


def measured(count: int, nodes: int, rounds: int) -> dict[str, float]:
    """Least seconds a time step of each contender, taken in turns."""
    points = np.random.default_rng(2).uniform([0, 0, 0], [1000.0, 0.0, DEPTH], (nodes, 3))
    plain, stretched = sea(count).flow, sea(count, wheeler=True).flow
    contenders: dict[str, tuple[Filling, Flow]] = {
        "catopt": (compiled(fill_kinematics), plain),
        "catopt, Wheeler": (compiled(fill_kinematics), stretched),
        "compiled with the library's functions": (_njit(by_library), plain),
        "numpy": (by_numpy, plain),
    }
    steps = 1 if rounds == 1 else max(20, 400_000 // (count * nodes))
    if rounds == 1:  # of a smoke: nothing is compiled
        contenders = {"catopt": contenders["catopt"], "numpy": contenders["numpy"]}
    least = dict.fromkeys(contenders, math.inf)
    for _ in range(rounds):
        for name, (fill, flow) in contenders.items():
            out = np.empty((nodes, 3)), np.empty((nodes, 3)), np.empty(nodes)
            fill(0.0, points, flow, *out)
            start = time.perf_counter()
            for step in range(steps):
                fill(STEP * step, points, flow, *out)
            least[name] = min(least[name], (time.perf_counter() - start) / steps)
    return least


def _njit(function: Callable[..., None]) -> Filling:
    import numba

    result: Filling = numba.njit(function, error_model="numpy", nogil=True)
    return result


def cost(rounds: int) -> Iterator[str]:
    """Yield the table of times."""
    yield "| points | waves | | us a step | ns a point, wave and step | three hours at 0.1 s, s |"
    yield "|---|---|---|---|---|---|"
    for nodes, count in SIZES[:1] if rounds == 1 else SIZES:
        for name, seconds in measured(count, nodes, rounds).items():
            yield (
                f"| {nodes} | {count} | {name} | {1e6 * seconds:.1f} "
                f"| {1e9 * seconds / (nodes * count):.1f} | {10800.0 / STEP * seconds:.0f} |"
            )


def repetition(seeds: int) -> Iterator[str]:
    """Yield how strongly seas of different cuts return within a run."""
    yield "| bands | waves | run, s | mean of R over seeds | least | greatest |"
    yield "|---|---|---|---|---|---|"
    cuts: list[Bands] = ["equal-energy", "equal-width", "S4"]
    for bands in cuts:
        for count in (20,) if seeds == 1 else (20, 50, 100, 200, 400):
            for duration in (1200.0,) if seeds == 1 else (1200.0, 10800.0):
                R = [
                    strongest_return(
                        random_waves(SPECTRUM, count, np.random.default_rng(seed), bands=bands),
                        duration,
                    ).correlation
                    for seed in range(seeds)
                ]
                row = f"{np.mean(R):.2f} | {min(R):.2f} | {max(R):.2f}"
                yield f"| {bands} | {count} | {duration:.0f} | {row} |"


def report(rounds: int, seeds: int) -> Iterator[str]:
    """Yield the page."""
    yield "# Waves"
    yield ""
    yield f"One thread. Least of {rounds} rounds."
    yield ""
    yield "## The motion of the water, one call a time step"
    yield ""
    yield from cost(rounds)
    yield ""
    yield "## How strongly a sea returns: R of docs/waves.md, JONSWAP, Hs 8.48 m, Tp 12.965 s"
    yield ""
    yield from repetition(seeds)


def main() -> None:
    """Print the page as it grows; write it whole when asked to."""
    page(
        argparse.ArgumentParser(description=__doc__),
        lambda of: report(of.rounds, of.seeds),
        rounds=(7, 1),
        seeds=(10, 1),
    )


if __name__ == "__main__":
    main()
