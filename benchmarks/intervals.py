"""Intervals that hold: 90 % intervals of most probable maxima beside the truth, 200 times over.

    python -m benchmarks.intervals [--out benchmarks/results/intervals.md] [--smoke]

Four cheap processes with the nature of the full ones: a taut and a slack line hung by closed form
from a fairlead that moves at random, a buoy on a line that snaps (one freedom, a stiff spring
beyond its slack), a ship with slow drift by the square of the waves' envelope, 140 s, 15 % damped,
on a chain. The truth is the value that one of 1,000 runs of three hours in e stays below. Each
repetition takes runs of its own and finds its interval as catopt does (`weibull_tail`; of a snap
Gumbel's distribution of equal blocks).
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from benchmarks.common import page
from benchmarks.extremes import THREE_HOURS, _gaussian, _waves
from catopt.catenary.batch import solve_many
from catopt.compiled import compiled
from catopt.fem.extremes import Extreme, gumbel, weibull_tail
from catopt.model import Line, Segment
from catopt.verify.snap_rerun import BLOCK, STORM_BLOCKS

Array = npt.NDArray[np.float64]
Process = Callable[[float, np.random.Generator], Array]
Method = Callable[[Sequence[Array], float], Extreme | None]

STEP = 0.25
"""s, of a series; a snap has a fifth of it."""
FINER = 5
START = 1200.0
"""s, that a resonator is given to forget how it began."""


class Hung(NamedTuple):
    """Tension of a line by its span, by closed form."""

    span: Array
    tension: Array

    @classmethod
    def of(cls, line: Line, height: float, spans: tuple[float, float]) -> Hung:
        """Tabulate it, as far as it has an answer."""
        span = np.linspace(*spans, 3000)
        found = solve_many(
            line, height=np.full(span.size, height), span=span, seabed_friction=0.0,
            anchor_height=0.0,
        )  # fmt: skip
        return cls(span[found.converged], found.tension[found.converged])

    def at(self, span: Array) -> Array:
        """Read it."""
        return np.interp(span, self.span, self.tension)


TAUT = Hung.of(Line([Segment(130.0, 20.0, EA=40e6)]), 50.0, (100.0, 132.0))
SLACK = Hung.of(Line([Segment(150.0, 1000.0, EA=500e6)]), 50.0, (60.0, 141.2))
CHAIN = Hung.of(Line([Segment(900.0, 1500.0, EA=700e6)]), 150.0, (500.0, 880.0))


def taut(time: float, draw: np.random.Generator) -> Array:
    """Move the fairlead of a taut line by 0.5 m, standard deviation."""
    return TAUT.at(121.5 + 0.5 * _waves(time, draw))


def slack(time: float, draw: np.random.Generator) -> Array:
    """Move that of a slack chain by 1.2 m."""
    return SLACK.at(132.0 + 1.2 * _waves(time, draw))


def snapping(time: float, draw: np.random.Generator) -> Array:
    """Push a buoy of 20 t on a soft spring that meets a stiff one."""
    surface = _waves(time + 60.0, draw)
    at = np.arange(surface.size * FINER) / FINER
    force = 60e3 * np.interp(at, np.arange(surface.size), surface)
    out = np.zeros(force.size)
    compiled(_snaps)(force, STEP / FINER, out)
    return out[round(60.0 * FINER / STEP) :]


def _snaps(force: Array, h: float, out: Array) -> None:
    x = v = 0.0
    for i in range(force.shape[0]):
        tension = 5e3 * x + 0.6e6 * max(x - 2.5, 0.0)
        v += h * (force[i] - tension - 6e3 * v) / 20e3
        x += h * v
        out[i] = max(tension, 0.0)


def drifting(time: float, draw: np.random.Generator) -> Array:
    """Let a ship drift slowly by 3 m, standard deviation, and move in the waves by 1 m."""
    count = round((time + START) / STEP)
    f = np.maximum(np.fft.rfftfreq(count, STEP), 1e-9)
    over = 10.0 * f
    peak = 3.3 ** np.exp(-0.5 * ((over - 1.0) / np.where(over <= 1.0, 0.07, 0.09)) ** 2)
    inside = (over > 0.3) & (over < 4.0)
    spectrum = np.where(inside, over**-5.0 * np.exp(-1.25 * over**-4.0) * peak, 0.0)
    waves = _gaussian(spectrum, count, draw)
    half = np.fft.rfft(waves)
    whole = np.zeros(count, dtype=complex)
    whole[: half.size] = 2.0 * half
    envelope = np.abs(np.fft.ifft(whole))
    own, w = 2.0 * math.pi / 140.0, 2.0 * math.pi * f
    answer = own**2 / (own**2 - w**2 + 0.3j * own * w)
    slow = np.fft.irfft(np.fft.rfft(envelope**2 - 2.0) * answer, count)
    return CHAIN.at(860.0 + SLOW * slow + waves)[round(START / STEP) :]


SLOW = 3.0 / 3.6
"""m, over the standard deviation of the slow motion as it comes."""


def by_tail(runs: Sequence[Array], time: float) -> Extreme | None:
    """Find it as catopt does of a line that stays taut, and of a ship."""
    found = weibull_tail(runs, time * len(runs), THREE_HOURS)
    return None if found is None else found.extreme


def by_blocks(runs: Sequence[Array], time: float, block: float | None = None) -> Extreme | None:
    """Find it as catopt does of a line that snaps; of blocks of a length, s, that is given."""
    block = block or max(BLOCK, time * len(runs) / STORM_BLOCKS)
    count = max(1, round(time / block))
    maxima = [float(each.max()) for run in runs for each in np.array_split(run, count)]
    found = gumbel(maxima, time / count, THREE_HOURS)
    return None if found is None else found.extreme


def by_minutes(runs: Sequence[Array], time: float) -> Extreme | None:
    """Find it by every minute's largest."""
    return by_blocks(runs, time, BLOCK)


class Case(NamedTuple):
    """What is repeated."""

    name: str
    process: Process
    time: float
    runs: int
    methods: dict[str, Method]


USED = "as used"
CASES = (
    Case("taut line", taut, 600.0, 5, {USED: by_tail}),
    Case("slack line", slack, 600.0, 5, {USED: by_tail}),
    Case("snapping buoy", snapping, 600.0, 5, {USED: by_blocks, "every minute": by_minutes}),
    Case("snapping buoy", snapping, 600.0, 10, {USED: by_blocks, "every minute": by_minutes}),
    Case("ship with slow cycles", drifting, 3600.0, 5, {USED: by_tail}),
    Case("ship with slow cycles", drifting, 10800.0, 1, {USED: by_tail}),
)
HELD = (0.85, 0.95)
"""Part of the repetitions whose interval is to hold the truth; a binomial deviation of 200 is
0.02."""


def truth(process: Process, runs: int) -> float:
    """Value that the largest of three hours stays below in one of e runs."""
    draw = np.random.default_rng(1)
    largest = [float(process(THREE_HOURS, draw).max()) for _ in range(runs)]
    return float(np.quantile(largest, math.exp(-1.0)))


def _rows(repetitions: int, storms: int) -> Iterator[str]:
    known: dict[Process, float] = {}
    for case in CASES:
        if case.process not in known:
            known[case.process] = truth(case.process, storms)
        true, draw = known[case.process], np.random.default_rng(7)
        found: dict[str, list[Extreme]] = {key: [] for key in case.methods}
        for _ in range(repetitions):
            runs = [case.process(case.time, draw) for _ in range(case.runs)]
            for key, method in case.methods.items():
                extreme = method(runs, case.time)
                if extreme is not None:
                    found[key].append(extreme)
        for key, some in found.items():
            yield f"| {case.name} | {case.runs} x {case.time / 60.0:.0f} min | {key} | " + _cells(
                some, true
            )


def _cells(found: Sequence[Extreme], true: float) -> str:
    held = float(np.mean([each.low <= true <= each.high for each in found]))
    low = float(np.mean([each.high < true for each in found]))
    off = float(np.median([each.most_probable for each in found])) / true - 1.0
    width = float(np.median([each.high - each.low for each in found])) / true
    says = "yes" if HELD[0] <= held <= HELD[1] else "NO"
    return f"{held:.1%} | {low:.1%} | {off:+.1%} | {width:.0%} | {says} |"


def _report(of: argparse.Namespace) -> Iterator[str]:
    repetitions, storms = (20, 20) if of.smoke else (200, 1000)
    yield "# Intervals that hold"
    yield ""
    yield (
        f"Most probable maximum in three hours: part of {repetitions} repetitions whose 90 % "
        f"interval holds the value from {storms} runs of three hours; wanted 85 to 95 %."
    )
    yield ""
    yield "| process | runs | method | holds | too low | median off | width | within the limit |"
    yield "|---|---|---|---|---|---|---|---|"
    yield from _rows(repetitions, storms)


def main() -> None:
    """Run all and print the table."""
    page(argparse.ArgumentParser(description=__doc__), _report)


if __name__ == "__main__":
    main()
