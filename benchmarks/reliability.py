"""A probability near 1 in 1,000: a study's, by counting and by the first order, beside ten million.

    python -m benchmarks.reliability [--out benchmarks/results/reliability.md]

A chain without stretch that lies on the bed has the tension H + w h at its fairlead. H is drawn
from Gumbel's distribution, the depth from a normal one. Ten million direct draws are numpy's, of
that formula; the exact value is its integral. The study draws H ten million times in a known depth,
and both together a hundred thousand times.
"""

from __future__ import annotations

import argparse
import math
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from scipy.integrate import quad
from scipy.stats import gumbel_r, norm

from benchmarks.common import page
from catopt.study.reliability import counted_interval
from catopt.study.result import StudyResult
from catopt.study.run import run_study

WEIGHT, MEAN, DEVIATION, DEPTH, TIDE = 800.0, 50e3, 8e3, 20.0, 1.5
SCALE = DEVIATION * math.sqrt(6.0) / math.pi
FORCE = gumbel_r(MEAN - float(np.euler_gamma) * SCALE, SCALE)
DIRECT, COUNTED, BOTH = 10_000_000, 10_000_000, 100_000


def main() -> None:
    """Run all and print the tables."""
    page(
        argparse.ArgumentParser(description=__doc__),
        lambda of: tables(of.divided),
        divided=(1, 2000),
    )


def tables(divided: int) -> Iterator[str]:
    """Yield the lines of the page."""
    yield "# Reliability"
    yield ""
    yield (
        "One core. Tension H + w h of a chain on the bed: H of Gumbel's distribution "
        "(50 kN, 8 kN); h 20 m, or normal with 1.5 m."
    )
    for title, tide, samples, limit in (
        ("H alone", 0.0, COUNTED, 105.5e3),
        ("H and h", TIDE, BOTH, 105.7e3),
    ):
        yield ""
        yield f"## {title}, limit {limit / 1e3:g} kN"
        yield ""
        yield "| | probability | 95 % interval | beta | time |"
        yield "|---|---|---|---|---|"
        yield from rows(tide, max(100, samples // divided), DIRECT // divided, limit)


def rows(tide: float, samples: int, draws: int, limit: float) -> Iterator[str]:
    """Yield a row for each way."""
    yield f"| integral of the formula | {exact(limit, tide):.4e} | | | |"
    began = time.process_time()
    beyond = direct(limit, tide, draws)
    low, high = counted_interval(beyond, draws)
    took = time.process_time() - began
    share = beyond / draws
    yield f"| {draws:,} direct draws | {share:.4e} | {low:.4e} to {high:.4e} | | {took:.1f} s |"
    began = time.process_time()
    found = study(tide, samples, limit)
    of = found.statistics[0]
    took = time.process_time() - began
    assert of.interval is not None
    yield (
        f"| study, {samples:,} members | {of.beyond:.4e} | "
        f"{of.interval[0]:.4e} to {of.interval[1]:.4e} | | {took:.1f} s |"
    )
    began = time.process_time()
    order = found.first_orders["fairlead_tension"]
    took = time.process_time() - began
    assert order is not None
    yield f"| first order | {order.probability:.4e} | | {order.index:.4f} | {took:.2f} s |"


def exact(limit: float, tide: float) -> float:
    """Integrate the formula."""
    if tide == 0.0:
        return float(FORCE.sf(limit - WEIGHT * DEPTH))
    return float(
        quad(
            lambda z: norm.pdf(z) * FORCE.sf(limit - WEIGHT * (DEPTH + tide * z)),
            -9.0, 9.0, epsabs=1e-14,
        )[0]
    )  # fmt: skip


def direct(limit: float, tide: float, draws: int) -> int:
    """Count draws of the formula."""
    rng = np.random.default_rng(11)
    force = FORCE.rvs(draws, random_state=rng)
    depth = DEPTH + tide * rng.normal(size=draws)
    return int((force + WEIGHT * depth > limit).sum())


def study(tide: float, samples: int, limit: float) -> StudyResult:
    """Run the study."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "case.toml").write_text(
            f'[site]\nwater_depth = "{DEPTH} m"\n[[line.segments]]\nlength = "300 m"\n'
            f'submerged_weight = "{WEIGHT} N/m"\n[load]\nhorizontal_force = "{MEAN} N"\n'
        )
        text = f'case = "case.toml"\ncompute = "statics"\nsamples = {samples}\n'
        text += f'limits = {{ fairlead_tension = "{limit} N" }}\n'
        text += '[[vary]]\nkey = "load.horizontal_force"\ndistribution = "gumbel"\n'
        text += f'mean = "{MEAN} N"\ndeviation = "{DEVIATION} N"\n'
        if tide > 0.0:
            text += '[[vary]]\nkey = "site.water_depth"\ndistribution = "normal"\n'
            text += f'mean = "{DEPTH} m"\ndeviation = "{tide} m"\n'
        (folder / "study.toml").write_text(text)
        return run_study(folder / "study.toml", workers=1)


if __name__ == "__main__":
    main()
