"""The swarm method beside a plain pyswarms call: how small f ends, and what a run costs.

    python -m benchmarks.swarm [--seeds 1000] [--lines 300] [--out benchmarks/results/swarm.md]

Both sides minimise the same f within the same bounds, with 200 particles and 200 iterations, one
run a seed, taken in turns so that a slow moment of the machine meets both. The last table has lines
of segments with clump weights, and how far the swarm's answer is from the closed form.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import logging
import os
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path
from typing import get_args

import numpy as np

from benchmarks.common import page
from catopt.catenary.pieces import cut
from catopt.catenary.solve import solve
from catopt.catenary.swarm import solve_swarm
from catopt.catenary.swarm.objective import Array, Objective, SuspendedObjective, objective_of
from catopt.catenary.swarm.solve import optimiser
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import NotConvergedError
from catopt.model import Line, PointLoad, Segment, SwarmSettings
from catopt.model.case import Boundary

LENGTH, HEIGHT, FORCE = 20.0, 9.5, 343.0 * STANDARD_GRAVITY
WEIGHTS = {"buoy, 9.5 kgf/m": 9.5, "slack sister, 30 kgf/m": 30.0}
SETTINGS = SwarmSettings()

PLAIN = "pyswarms as it comes"
EXAMPLE_OPTIONS = {"c1": 0.5, "c2": 0.3, "w": 0.9}
"""pyswarms has no defaults for these; they are those of its documentation's first example."""

Solver = Callable[[Objective, int], float]


def uniform(length: float, height: float, force: float, weight: float) -> Objective:
    """Give f of one uniform inextensible segment."""
    return objective_of(cut(Line([Segment(length, weight)]))[0], height, force)


@dataclass(frozen=True)
class Sample:
    """f (m) and wall time (s) of one run a seed."""

    objectives: Array
    seconds: Array


@contextlib.contextmanager
def plain_pyswarms() -> Iterator[None]:
    """Give pyswarms a folder for its report.log, and put the root logger back afterwards."""
    root = logging.getLogger()
    handlers, level, folder = list(root.handlers), root.level, Path.cwd()
    with tempfile.TemporaryDirectory() as scratch:
        os.chdir(scratch)
        try:
            yield
        finally:
            os.chdir(folder)
            for handler in set(root.handlers) - set(handlers):
                handler.close()
            root.handlers, root.level = handlers, level


def plain(objective: Objective, seed: int) -> float:
    """Call pyswarms with its defaults ("periodic") and its example's coefficients, silently."""
    from pyswarms.single import GlobalBestPSO

    np.random.seed(seed)  # noqa: NPY002 - pyswarms draws from the global state
    swarm = GlobalBestPSO(
        n_particles=SETTINGS.particles,
        dimensions=2,
        options=EXAMPLE_OPTIONS,
        bounds=objective.bounds,
    )
    best, _ = swarm.optimize(objective, iters=SETTINGS.iterations, verbose=False)
    return float(best)


def with_settings(settings: SwarmSettings) -> Solver:
    """Return one run of ours under these settings."""

    def solve(objective: Objective, seed: int) -> float:
        return optimiser(objective, replace(settings, seed=seed))(1).objective

    return solve


CONTENDERS: dict[str, Solver] = {
    PLAIN: plain,
    "catopt": with_settings(SETTINGS),
    "catopt, nearest, w = 0.5": with_settings(replace(SETTINGS, boundary="nearest", inertia=0.5)),
    "catopt, periodic": with_settings(replace(SETTINGS, boundary="periodic")),
}


def compare(objective: Objective, seeds: int) -> dict[str, Sample]:
    """Run every contender once a seed, in turns."""
    taken: dict[str, list[tuple[float, float]]] = {name: [] for name in CONTENDERS}
    with plain_pyswarms(), contextlib.redirect_stderr(io.StringIO()):
        for seed in range(1, seeds + 1):
            for name, solve in CONTENDERS.items():
                start = time.perf_counter()
                f = solve(objective, seed)
                taken[name].append((f, time.perf_counter() - start))
    return {name: Sample(*np.array(pairs).T) for name, pairs in taken.items()}


def comparison_rows(samples: dict[str, Sample]) -> Iterator[str]:
    """Yield the table's rows: distribution of f, time, and time against the plain call."""
    reference = float(np.median(samples[PLAIN].seconds))
    for name, sample in samples.items():
        f, seconds = sample.objectives, float(np.median(sample.seconds))
        spread = " | ".join(
            f"{x:.1e}" for x in (f.min(), np.median(f), np.quantile(f, 0.99), f.max())
        )
        yield (
            f"| {name} | {spread} | {(f < 1e-12).mean():.1%} | {(f < 1e-9).mean():.1%} "
            f"| {1e3 * seconds:.1f} | {reference / seconds:.1f} |"
        )


def comparison(seeds: int) -> Iterator[str]:
    """Yield one table a case."""
    for case, weight in WEIGHTS.items():
        objective = uniform(LENGTH, HEIGHT, FORCE, weight * STANDARD_GRAVITY)
        yield f"## {case[0].upper()}{case[1:]}: f in m at the end of a run, seeds 1 to {seeds}"
        yield ""
        yield (
            "| | min | median | 99 % | max | f < 1e-12 | f < 1e-9 | median ms a run "
            f"| times as fast as {PLAIN} |"
        )
        yield "|---|---|---|---|---|---|---|---|---|"
        yield from comparison_rows(compare(objective, seeds))
        yield ""


def article(repeats: int = 3) -> Iterator[str]:
    """Yield the article's own setting: 200 runs of 200 particles and 200 iterations."""
    yield "## The article's setting: 200 runs of 200 particles and 200 iterations"
    yield ""
    yield "| case | wall time, s | runs with f < 1e-9 m | evaluations of f | of those allowed |"
    yield "|---|---|---|---|---|"
    for case, weight in WEIGHTS.items():
        line = Line([Segment(LENGTH, weight * STANDARD_GRAVITY)])
        settings = replace(SETTINGS, runs=200)
        seconds = []
        for _ in range(repeats):
            start = time.perf_counter()
            solution = solve_swarm(line, height=HEIGHT, horizontal_force=FORCE, settings=settings)
            seconds.append(time.perf_counter() - start)
        report = solution.swarm
        assert report is not None
        allowed = settings.runs * settings.particles * settings.iterations
        yield (
            f"| {case} | {min(seconds):.2f} to {max(seconds):.2f} | {report.converged_runs} "
            f"| {report.evaluations} | {report.evaluations / allowed:.0%} |"
        )
    yield ""
    yield f"Wall time: least and greatest of {repeats}. The article names 31 s for its buoy."
    yield ""


def random_lines(
    count: int, scope: tuple[float, float], force: tuple[float, float] = (0.03, 1000.0)
) -> list[Objective]:
    """Draw lines: h of 1 to 1000 m, L/h in `scope`, a/h in `force`, evenly by logarithm."""
    generator = np.random.default_rng(3)

    def draw(low: float, high: float) -> float:
        return float(np.exp(generator.uniform(np.log(low), np.log(high))))

    found = []
    for _ in range(count):
        h = draw(1.0, 1000.0)
        a = h * draw(*force)
        length = h * (1.0 + draw(scope[0] - 1.0, scope[1] - 1.0))
        found.append(uniform(length, h, a, 1.0))
    return found


def robustness(count: int) -> Iterator[str]:
    """Yield how handlings, inertias and scopes fare over lines of many shapes."""
    yield f"## {count} lines of many shapes, one run each: share of lines whose f stays at or above"
    yield ""
    yield "L/h from 1.05 to 11, a/h from 0.03 to 1000, seed 1."
    yield ""
    yield "| boundary handling | inertia | 1e-12 L | 1e-9 L | 1e-6 L | worst f / L |"
    yield "|---|---|---|---|---|---|"
    lines = random_lines(count, (1.05, 11.0))
    handlings: tuple[Boundary, ...] = get_args(Boundary)
    variants = [(boundary, SETTINGS.inertia) for boundary in handlings]
    variants += [(SETTINGS.boundary, 0.5), (SETTINGS.boundary, 0.6), ("nearest", 0.5)]
    for boundary, inertia in variants:
        settings = replace(SETTINGS, boundary=boundary, inertia=inertia)
        f = np.array([optimiser(o, settings)(1).objective / o.length for o in lines])
        shares = " | ".join(f"{(f >= limit).mean():.1%}" for limit in (1e-12, 1e-9, 1e-6))
        yield f"| {boundary} | {inertia} | {shares} | {f.max():.1e} |"
    yield ""
    yield "Lines that are hardly longer than the height, with the default settings:"
    yield ""
    yield "| L/h | f >= 1e-9 m | f >= 1e-6 m: no result |"
    yield "|---|---|---|"
    for scope in ((1.001, 1.01), (1.01, 1.02), (1.02, 1.03), (1.03, 1.05), (1.05, 1.1)):
        near = random_lines(count, scope)
        f = np.array([optimiser(o, SETTINGS)(1).objective for o in near])
        yield (
            f"| {scope[0]} to {scope[1]} | {(f >= 1e-9).mean():.1%} | {(f >= 1e-6).mean():.1%} |"
        )
    yield ""


@dataclass(frozen=True)
class Moored:
    """A line, the height of its fairlead (m) and its horizontal force (N)."""

    line: Line
    height: float
    force: float

    @property
    def objective(self) -> Objective:
        """Give f over the places that catopt searches."""
        return objective_of(cut(self.line)[0], self.height, self.force)


def general_lines(count: int, *, loads: bool, elastic: bool) -> list[Moored]:
    """Draw lines of 2 to 4 segments, their weights 1 to 30 apart, L/h 1.05 to 5, H/(w h) 0.1 to 30.

    With loads, 1 or 2 clump weights of 3 to 100 % of the line's weight anywhere on it; elastic, EA
    of 30 to 10,000 times that weight.
    """
    generator = np.random.default_rng(4)
    found = []
    for _ in range(count):
        height = 10.0 ** generator.uniform(0.7, 2.7)
        length = height * (1.0 + 0.05 * 80.0 ** generator.random())
        parts = generator.uniform(0.1, 1.0, int(generator.integers(2, 5)))
        parts *= length / parts.sum()
        weights = 1000.0 * 30.0 ** -generator.random(len(parts))
        total = float(parts @ weights)
        EA = total * 10.0 ** generator.uniform(1.5, 4.0) if elastic else float("inf")
        segments = [
            Segment(float(part), float(w), EA) for part, w in zip(parts, weights, strict=True)
        ]
        places = length * generator.uniform(0.05, 0.95, int(generator.integers(1, 3)) * loads)
        points = [
            PointLoad(s, total * 10.0 ** generator.uniform(-1.5, 0.0)) for s in places.tolist()
        ]
        force = total * height / length * 10.0 ** generator.uniform(-1.0, 1.5)
        found.append(Moored(Line(segments, points), height, force))
    return found


@dataclass(frozen=True)
class OverSpan(SuspendedObjective):
    """Search an inextensible line `within` its own bounds, but over S in place of r."""

    within: Objective

    @property
    def bounds(self) -> tuple[Array, Array]:
        """S1 (9), (10) for S."""
        lower, upper = self.within.bounds
        chord = float(np.sqrt(self.length**2 - self.height**2))
        return lower, np.array([upper[0], chord])

    def misses(self, places: Array) -> tuple[Array, Array]:
        """Take off S what lies on the bed and what hangs below the last piece."""
        slope, lengths, loads = self.within.hanging(places[:, 0])
        lying = self.length - sum(np.broadcast_to(part, len(places)) for part in lengths)
        reach = places[:, 1] - lying
        for k, length in enumerate(lengths[:-1]):
            a = self.parameters[k]
            upper = slope + length / a
            reach -= a * (np.arcsinh(upper) - np.arcsinh(slope))
            slope = upper + loads[k + 1] / self.horizontal_force
        with np.errstate(over="ignore", invalid="ignore"):
            missed = self.within.misses(np.column_stack([places[:, 0], reach]))
        length, height = (np.nan_to_num(part, nan=1e300, posinf=1e300) for part in missed)
        return length, height


def general(count: int) -> Iterator[str]:
    """Yield how lines of segments with clump weights fare, beside the closed form."""
    yield f"## {count} lines of 2 to 4 segments of each kind, one run each"
    yield ""
    yield (
        "L/h from 1.05 to 5, H/(w h) from 0.1 to 30, weights of segments 1 to 30 apart; 1 or 2 "
        "clump weights, each of 3 to 100 % of the line's weight; EA of 30 to 10,000 times that. "
        "Distance from the closed form: the largest of all results, of the span as a part of L, of "
        "the fairlead tension as a part of it."
    )
    yield ""
    yield (
        "| | f >= 1e-12 L | f >= 1e-9 L | f >= 1e-6 L | worst f / L | median ms a run "
        "| no result | distance, span | distance, tension |"
    )
    yield "|---|---|---|---|---|---|---|---|---|"
    kinds = {
        "inextensible": general_lines(count, loads=False, elastic=False),
        "inextensible, clump weights": general_lines(count, loads=True, elastic=False),
        "elastic, clump weights": general_lines(count, loads=True, elastic=True),
    }
    for name, lines in kinds.items():
        f, seconds = _flown(lines, [one.objective for one in lines])
        milliseconds = f"{1e3 * float(np.median(seconds)):.1f}"
        yield f"| {name} | {_shares(f)} | {milliseconds} | {_distances(lines)} |"
    lines = kinds["inextensible, clump weights"]
    own = [one.objective for one in lines]
    f, _ = _flown(lines, [OverSpan(o.pieces, o.height, o.horizontal_force, o) for o in own])
    yield f"| the same lines, over S in place of r | {_shares(f)} | | | | |"
    yield ""


def _flown(lines: list[Moored], objectives: Sequence[Objective]) -> tuple[Array, Array]:
    """Return f / L at the end of one run a line, and its wall time, s."""
    taken = []
    for one, objective in zip(lines, objectives, strict=True):
        run = optimiser(objective, SETTINGS)
        start = time.perf_counter()
        f = run(1).objective
        taken.append((f / one.line.length, time.perf_counter() - start))
    f, seconds = np.array(taken).T
    return f, seconds


def _shares(f: Array) -> str:
    """Return the cells of how small f / L ends."""
    shares = " | ".join(f"{(f >= limit).mean():.1%}" for limit in (1e-12, 1e-9, 1e-6))
    return f"{shares} | {f.max():.1e}"


def _distances(lines: list[Moored]) -> str:
    """Return the cells of how far the swarm's answers are from the closed form."""
    span, tension, without = [0.0], [0.0], 0
    for one in lines:
        exact = solve(one.line, height=one.height, horizontal_force=one.force)
        try:
            ours = solve_swarm(
                one.line, height=one.height, horizontal_force=one.force, settings=SETTINGS
            )
        except NotConvergedError:
            without += 1
            continue
        span.append(abs(ours.span - exact.span) / one.line.length)
        tension.append(abs(ours.fairlead.tension / exact.fairlead.tension - 1.0))
    return f"{without} | {max(span):.1e} | {max(tension):.1e}"


def heading() -> Iterator[str]:
    """Say what was run, on what."""
    yield "# The swarm method beside pyswarms"
    yield ""
    packages = ", ".join(f"{name} {version(name)}" for name in ("pyswarms", "numpy"))
    yield f"{packages}; one thread."
    yield ""
    yield (
        f"catopt: {SETTINGS.particles} particles, {SETTINGS.iterations} iterations, c1 = "
        f"{SETTINGS.cognitive}, c2 = {SETTINGS.social}, w = {SETTINGS.inertia}, "
        f"{SETTINGS.boundary}. {PLAIN}: GlobalBestPSO with its default boundary handling "
        '"periodic", verbose=False, and, because it asks for them, the c1 = 0.5, c2 = 0.3, w = 0.9 '
        "of its documentation's example. Both minimise the same f within the same bounds. "
        "catopt stops a run once f is 0, or at rest at its rounding; pyswarms flies all iterations."
    )
    yield ""


def report(arguments: argparse.Namespace) -> Iterator[str]:
    """Yield the whole page, line by line."""
    yield from heading()
    yield from comparison(arguments.seeds)
    yield from article()
    yield from robustness(arguments.lines)
    yield from general(arguments.lines)


def main() -> None:
    """Print the page as it grows; write it whole when asked to."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(parser, report, seeds=(100, 1), lines=(60, 1))


if __name__ == "__main__":
    main()
