"""Extremes: which tail finds a known three-hour value, 20 seeds beside 200, and seeds side by side.

    python -m benchmarks.extremes [--out benchmarks/results/extremes.md] [--sections ...] [--quick]

The processes are functions of Gaussian ones (JONSWAP, Tp 10 s, gamma 3.3), so that what is random
in them is alike; their three-hour value is that of 720 hours. The line is the chain of
`cases/dynamic-chain-56m`, led by its ship, with 12 bars, run once.
"""

from __future__ import annotations

import argparse
import math
import os
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np
import numpy.typing as npt

from benchmarks.common import page
from catopt.casefile import read_case
from catopt.fem.extremes import Extreme, gumbel, peaks_above_mean, weibull_tail
from catopt.model import Case
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_result import DynamicPart
from catopt.verify.motion_words import interval

Array = npt.NDArray[np.float64]

SECTIONS = ("study", "line", "speed")
THREE_HOURS = 10800.0
INTERVAL = 0.25
"""From sample to sample of the processes, s."""
CASE = Path(__file__).parents[1] / "cases" / "dynamic-chain-56m" / "case.toml"


def _gaussian(spectrum: Array, count: int, draw: np.random.Generator) -> Array:
    """Draw a Gaussian series of unit variance."""
    size = np.sqrt(0.5 * spectrum / spectrum.sum())
    amplitude = size * (draw.standard_normal(size.size) + 1j * draw.standard_normal(size.size))
    series: Array = np.fft.irfft(amplitude, count) * count
    return series


def _waves(time_: float, draw: np.random.Generator) -> Array:
    count = round(time_ / INTERVAL)
    f = np.maximum(np.fft.rfftfreq(count, INTERVAL), 1e-9)
    over = 10.0 * f
    width = np.where(over <= 1.0, 0.07, 0.09)
    peak = 3.3 ** np.exp(-0.5 * ((over - 1.0) / width) ** 2)
    spectrum = np.where(over < 4.0, over**-5.0 * np.exp(-1.25 * over**-4.0) * peak, 0.0)
    spectrum[over < 0.3] = 0.0
    return _gaussian(spectrum, count, draw)


def _drift(time_: float, draw: np.random.Generator) -> Array:
    count = round(time_ / INTERVAL)
    f = np.fft.rfftfreq(count, INTERVAL)
    return _gaussian(np.exp(-0.5 * ((f - 1.0 / 90.0) / 0.003) ** 2), count, draw)


def _of_waves(function: Callable[[Array], Array]) -> Callable[[float, np.random.Generator], Array]:
    return lambda time_, draw: function(_waves(time_, draw))


PROCESSES: dict[str, Callable[[float, np.random.Generator], Array]] = {
    "linear, z": _of_waves(lambda z: z),
    "drag, z + 0.3 z abs(z)": _of_waves(lambda z: z + 0.3 * z * np.abs(z)),
    "stiffening, exp(0.4 z)": _of_waves(lambda z: np.exp(0.4 * z)),
    "snaps, z + 2 max(z - 1.5, 0)": _of_waves(lambda z: z + 2.0 * np.maximum(z - 1.5, 0.0)),
    "saturating, 3 tanh(z/3)": _of_waves(lambda z: 3.0 * np.tanh(z / 3.0)),
    "waves and slow drift": lambda t, draw: 0.8 * _waves(t, draw) + 0.6 * _drift(t, draw),
}


@cache
def _known(process: Callable[[float, np.random.Generator], Array]) -> float:
    """Value that one peak in three hours is expected above, from 720 hours."""
    draw, each, pieces = np.random.default_rng(1), 18.0 * 3600.0, 40
    peaks = [peaks_above_mean(process(each, draw)) for _ in range(pieces)]
    highest = np.sort(np.concatenate(peaks))[::-1]
    return float(highest[round(each * pieces / THREE_HOURS)])


@dataclass(frozen=True)
class Sample:
    """Peaks of some runs over their mean, falling, with what is wanted of them."""

    heights: Array
    mean: float
    often: float

    def exceedances(self, part: float) -> tuple[float, Array]:
        """Threshold that leaves a part of the peaks above it, and these."""
        count = int(part * self.heights.size)
        return float(self.heights[count]), self.heights[:count]


def _pareto(sample: Sample, part: float = 0.3) -> float:
    """Generalised Pareto by probability-weighted moments (Hosking and Wallis 1987)."""
    u, above = sample.exceedances(part)
    over = above - u
    first = float(over.mean())
    second = float((over * (np.arange(over.size) + 0.35)).mean() / over.size)
    shape = 2.0 - first / (first - 2.0 * second)
    scale = 2.0 * first * second / (first - 2.0 * second)
    rise = (over.size * sample.often) ** shape - 1.0
    return float(u + scale / shape * rise)


def _exponential(sample: Sample) -> float:
    u, above = sample.exceedances(0.3)
    return u + float((above - u).mean()) * math.log(above.size * sample.often)


def _moments(sample: Sample) -> float:
    """Weibull's distribution of all peaks by mean and standard deviation."""
    from scipy.optimize import brentq

    m, s = float(sample.heights.mean()), float(sample.heights.std())

    def off(b: float) -> float:
        return math.gamma(1.0 + 2.0 / b) / math.gamma(1.0 + 1.0 / b) ** 2 - 1.0 - (s / m) ** 2

    shape = float(brentq(off, 0.3, 20.0))
    scale = m / math.gamma(1.0 + 1.0 / shape)
    return float(scale * math.log(sample.heights.size * sample.often) ** (1.0 / shape))


OTHERS: dict[str, Callable[[Sample], float]] = {
    "generalised Pareto": _pareto,
    "of the upper 10 %": lambda sample: _pareto(sample, 0.1),
    "exponential": _exponential,
    "Weibull, all peaks": _moments,
}


def _study(draws: dict[int, int]) -> Iterator[str]:
    yield "## Which tail"
    yield ""
    yield (
        "Most probable maximum in 3 h from runs of 10 min: median error, and in brackets the "
        "scatter (root mean square of the error), over the true value. `weibull_tail` is what "
        "catopt has; held: part of the draws whose 90 % interval holds the true value. Gumbel "
        "from 5 runs on."
    )
    for runs, count in draws.items():
        yield ""
        yield f"{runs} run{'s' * (runs > 1)} a draw, {count} draws:"
        yield ""
        heads = ["process", "`weibull_tail`", "held", *OTHERS, *(["Gumbel", "held"] * (runs > 4))]
        yield "| " + " | ".join(heads) + " |"
        yield "|---" * len(heads) + "|"
        for name, process in PROCESSES.items():
            yield f"| {name} | " + " | ".join(_row(process, runs, count)) + " |"
    yield ""


def _row(
    process: Callable[[float, np.random.Generator], Array], runs: int, count: int
) -> list[str]:
    true, draw = _known(process), np.random.default_rng(5)
    tails: list[Extreme] = []
    gumbels: list[Extreme] = []
    others: dict[str, list[float]] = {name: [] for name in OTHERS}
    for _ in range(count):
        series = [process(600.0, draw) for _ in range(runs)]
        tail = weibull_tail(series, 600.0 * runs, THREE_HOURS)
        assert tail is not None
        tails.append(tail.extreme)
        found = gumbel([float(each.max()) for each in series], 600.0, THREE_HOURS)
        if found is not None:
            gumbels.append(found.extreme)
        mean = float(np.concatenate(series).mean())
        peaks = np.concatenate([peaks_above_mean(each, mean) for each in series]) - mean
        sample = Sample(np.sort(peaks)[::-1], mean, THREE_HOURS / (600.0 * runs))
        for name, method in OTHERS.items():
            others[name].append(mean + method(sample))
    cells = _cells(tails, true)
    cells += [_error(np.array(values), true) for values in others.values()]
    return cells + (_cells(gumbels, true) if gumbels else [])


def _cells(found: Sequence[Extreme], true: float) -> list[str]:
    held = sum(each.low <= true <= each.high for each in found) / len(found)
    return [_error(np.array([each.most_probable for each in found]), true), f"{held:.0%}"]


def _error(values: Array, true: float) -> str:
    off = values / true - 1.0
    return f"{np.median(off):+.1%} ({math.sqrt(float((off**2).mean())):.1%})"


def _storm(runs: int) -> Case:
    """Chain of the example in runs of which 10 minutes count."""
    case: Case = read_case(CASE)
    assert case.dynamics is not None
    settings = replace(
        case.dynamics, duration=630.0, ramp=30.0, runs=runs, elements=12, output_interval=0.2
    )
    return replace(case, dynamics=settings)


def _line(many: int, few: int) -> Iterator[str]:
    began = time.perf_counter()
    (part,) = verify_dynamic(_storm(many), convergence_check="none").parts
    spent = time.perf_counter() - began
    yield f"## {few} seeds beside {many}"
    yield ""
    yield (
        f"Fairlead and anchor of 300 m of chain in 56 m, Hs 4 m, Tp 9 s, {many} runs of 10 min "
        f"after the ramp ({spent:.0f} s for all). Most probable maximum in 3 h, by the tail and by "
        "Gumbel; the tail's interval is what is printed."
    )
    yield ""
    yield "| | runs | by the tail | by Gumbel |"
    yield "|---|---|---|---|"
    groups = [replace(part, runs=part.runs[k : k + few]) for k in range(0, many, few)]
    for quantity in ("fairlead_tension", "anchor_tension", "offset"):
        for some in (part, groups[0]):
            yield f"| {quantity} | {len(some.runs)} | " + " | ".join(_found(some, quantity)) + " |"
    yield ""
    for quantity in ("fairlead_tension", "anchor_tension", "offset"):
        value = part.of(quantity).most_probable_maximum
        assert value is not None
        held = [_holds(each, quantity, value) for each in groups]
        yield (
            f"- {quantity}: the interval of the first {few} seeds "
            f"{'HOLDS' if held[0] else 'DOES NOT HOLD'} the value of all {many}; of the "
            f"{len(groups)} groups of {few} seeds {sum(held)} do."
        )
    yield ""


def _found(part: DynamicPart, quantity: str) -> list[str]:
    from catopt.verify.motion_words import DYNAMIC_QUANTITY_OF

    found, shown = part.of(quantity), DYNAMIC_QUANTITY_OF[quantity]
    assert found.tail is not None
    assert found.gumbel is not None
    return [interval(shown, each.extreme) for each in (found.tail, found.gumbel)]


def _holds(part: DynamicPart, quantity: str, value: float) -> bool:
    tail = part.of(quantity).tail
    assert tail is not None
    return tail.extreme.low <= value <= tail.extreme.high


def _speed(runs: int, elements: int, rounds: int) -> Iterator[str]:
    case = _storm(runs)
    assert case.dynamics is not None
    case = replace(case, dynamics=replace(case.dynamics, elements=elements))
    yield "## Seeds side by side"
    yield ""
    yield (
        f"{runs} runs of the same chain with {elements} bars, each with its proof at half the "
        f"step; seconds on the clock with the start of the processes, best of {rounds}; "
        f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the start."
    )
    yield ""
    yield "| processes | s | times as fast | same digits |"
    yield "|---|---|---|---|"
    times: dict[int, float] = {}
    digits: dict[int, object] = {}
    for workers in (1, 2):
        for _ in range(rounds):
            began = time.perf_counter()
            found = verify_dynamic(case, workers=workers)
            spent = time.perf_counter() - began
            times[workers] = min(times.get(workers, math.inf), spent)
            digits[workers] = found.to_dict()
        same = "yes" if digits[workers] == digits[1] else "NO"
        yield f"| {workers} | {times[workers]:.1f} | {times[1] / times[workers]:.2f} | {same} |"


def main() -> None:
    """Run all and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sections", nargs="+", choices=SECTIONS, default=SECTIONS)
    page(parser, _report)


def _report(of: argparse.Namespace) -> Iterator[str]:
    smoke = of.smoke
    yield "# Extremes"
    yield ""
    sections = {
        "study": lambda: _study({1: 3} if smoke else {1: 150, 5: 60, 20: 40}),
        "line": lambda: _line(20 if smoke else 200, 10 if smoke else 20),
        "speed": lambda: _speed(4 if smoke else 20, 12 if smoke else 40, 1),
    }
    for name in of.sections[:1] if smoke else of.sections:
        yield from sections[name]()


if __name__ == "__main__":
    main()
