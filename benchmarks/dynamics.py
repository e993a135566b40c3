"""Time of the truss model's dynamics beside MoorDyn's, each at its largest good step.

    python -m benchmarks.dynamics [--out benchmarks/results/dynamics.md]

Good enough: the largest end force within 0.5 % of that program's own with a tenth of its smallest
step tried. Both run in the same process on one core, three times; the least time of the processor
counts.
MoorDyn (`pip install moordyn`, extra `peers`) is left out, and said to be, when it is not there.
"""

from __future__ import annotations

import argparse
import math
import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from benchmarks.common import page
from catopt.fem import (
    Fluid,
    Harmonic,
    History,
    Leg,
    LineDamping,
    LineProperties,
    MorisonSection,
    Scheme,
    Seabed,
    TimeStepping,
    run_dynamics,
    run_system_dynamics,
)
from catopt.model import Line, Segment
from catopt.waves import Sea, jonswap, random_waves

os.environ.setdefault("OMP_NUM_THREADS", "1")

G = 9.81
RHO = 1025.0  # MoorDyn's default
ROUNDS = 3
GOOD = 0.005


@dataclass(frozen=True)
class Run:
    """One run: largest end force from half time on, N, and seconds per simulated second."""

    peak: float
    cost: float
    note: str = ""


@dataclass(frozen=True)
class SectionFigures:
    """One segment: from the anchor."""

    length: float
    mass: float
    weight: float
    EA: float
    drag: float
    added: float
    bars: int

    @property
    def diameter(self) -> float:
        """Volume-equivalent, m."""
        return math.sqrt(4.0 / math.pi * (self.mass - self.weight / G) / RHO)


@dataclass(frozen=True)
class Task:
    """Lines that meet where they are led in surge."""

    name: str
    sections: tuple[SectionFigures, ...]
    anchors: tuple[tuple[float, float], ...]
    height: float
    depth: float
    amplitude: float
    period: float
    duration: float
    zeta: float

    @property
    def elements(self) -> int:
        """Bars of all lines."""
        return len(self.anchors) * sum(s.bars for s in self.sections)


CHAIN = Task(
    "600 m chain, 40 bars, +-2 m in 10 s",
    (SectionFigures(600.0, 115.0, 1000.0, 8e8, 1.33, 1.0, 40),),
    ((554.5, 0.0),), 200.0, 200.0, 2.0, 10.0, 100.0, 0.8,
)  # fmt: skip
FSO = Task(
    "FSO, nine legs, 180 bars, +-2 m in 12.9 s",
    tuple(
        SectionFigures(L, m, q * G, EA, 1.0, ca, 5)
        for L, m, q, EA, ca in (
            (750.0, 34.9, 30.4, 382.09e6, 0.0),
            (194.0, 157.7, 137.2, 721.98e6, 1.2),
            (80.0, 178.7, 155.4, 801.2e6, 1.2),
            (58.0, 178.7, 155.4, 801.2e6, 1.2),
        )
    ),
    tuple(
        (1056.0 * math.cos(math.radians(a)), 1056.0 * math.sin(math.radians(a)))
        for a in (-3, 0, 3, 117, 120, 123, 237, 240, 243)
    ),
    71.4, 71.4, 2.0, 12.9, 103.2, 0.8,
)  # fmt: skip


def main() -> None:
    """Run all and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    page(parser, _report, storm=(10800.0, 2.0))


def _report(of: argparse.Namespace) -> Iterator[str]:
    yield "# Dynamics"
    yield ""
    yield (
        "One core. Largest step of each whose largest end force is within 0.5 % of its own "
        "converged one. Seconds are the processor's, so that other programs count little."
    )
    yield ""
    if of.smoke:
        found = _ours(_short(CHAIN), Scheme.generalised_alpha(0.5), 0.4)
        yield f"A coarse chain, largest end force {found.peak / 1e3:.1f} kN."
        return
    for task in (CHAIN, FSO):
        yield from _compare(task)
    yield from _storm(of.storm)


def _short(task: Task) -> Task:
    """Two periods of a coarse model: to see it run."""
    (section,) = task.sections
    return replace(task, sections=(replace(section, bars=4),), duration=20.0)


def _compare(task: Task) -> list[str]:
    rows = [
        f"## {task.name}",
        "",
        "| | step | largest end force | off | ms per simulated second | Newton iterations a step |",
        "|---|---|---|---|---|---|",
    ]
    steps = (0.4, 0.3, 0.25, 0.2, 0.15, 0.1, 0.05)
    costs = {}
    for name, scheme in (
        ("catopt, generalised-alpha", Scheme.generalised_alpha(0.5)),
        ("catopt, average acceleration", Scheme.average_acceleration()),
    ):
        row, costs[name] = _best(name, steps, partial(_ours, task, scheme), 0.005)
        rows.append(row)
    try:
        import moordyn  # noqa: F401
    except ImportError:
        return [*rows, "", "MoorDyn is not installed: no comparison.", ""]
    for solver in ("rk2", "rk4"):
        name = f"MoorDyn, {solver}"
        peer_steps = (0.02, 0.01, 0.0067, 0.005, 0.0033, 0.0025, 0.002, 0.001)
        row, costs[name] = _best(name, peer_steps, partial(_moordyn, task, solver), 0.0005)
        rows.append(row)
    fastest = min(cost for name, cost in costs.items() if name.startswith("MoorDyn"))
    for name, cost in costs.items():
        if name.startswith("catopt"):
            rows.append(f"| {name} | | | | {fastest / cost:.1f} times faster than MoorDyn | |")
    return [*rows, ""]


def _best(
    name: str, steps: Sequence[float], run: Callable[[float], Run], fine: float
) -> tuple[str, float]:
    """Row of the largest step that is good enough, and what it costs."""
    converged = run(fine).peak
    for step in steps:
        found = run(step)
        if abs(found.peak / converged - 1.0) <= GOOD:
            cost = min([found.cost, *(run(step).cost for _ in range(ROUNDS - 1))])
            off = found.peak / converged - 1.0
            return (
                f"| {name} | {step * 1e3:g} ms | {found.peak / 1e3:.1f} kN | {100 * off:+.2f} % "
                f"| {cost * 1e3:.3f} | {found.note} |"
            ), cost
    return f"| {name} | none good enough | | | | |", math.inf


def _ours(task: Task, scheme: Scheme, step: float) -> Run:
    line = Line([Segment(s.length, s.weight, EA=s.EA, mass=s.mass) for s in task.sections])
    properties = LineProperties(
        [MorisonSection(s.diameter, s.drag, 0.0, s.added) for s in task.sections],
        LineDamping(critical_ratio=task.zeta, critical_length="bar"),
        Fluid(RHO, G),
        Seabed(3e6 * task.sections[0].diameter, 3e5 * task.sections[0].diameter),
    )
    # Timed between two calls of `progress`: rest and compilation are not part of the march.
    marks: list[tuple[float, float]] = []
    stepping = TimeStepping(task.duration, step, ramp_time=task.period, scheme=scheme,
                            since=0.5 * task.duration)  # fmt: skip

    def mark(t: float) -> None:
        marks.append((t, time.process_time()))

    motion = Harmonic(task.period, (task.amplitude, 0.0, 0.0), (-math.pi / 2, 0.0, 0.0))
    history: History
    if len(task.anchors) == 1:
        history = run_dynamics(
            line, stepping, height=task.height, span=task.anchors[0][0], properties=properties,
            motion=motion, elements=[s.bars for s in task.sections], progress=mark,
        )  # fmt: skip
    else:
        legs = [Leg(line, (*at, 0.0)) for at in task.anchors]
        history = run_system_dynamics(
            legs, stepping, height=task.height, position=(0.0, 0.0), properties=properties,
            motion=motion, elements=[s.bars for s in task.sections], progress=mark,
        )  # fmt: skip
    (t_0, clock_0), (t_1, clock_1) = marks[0], marks[-1]
    peak = max(history.tension_statistics(k).maximum for k in range(len(task.anchors)))
    iterations = f"{history.iterations / history.steps:.2f}"
    return Run(peak, (clock_1 - clock_0) / (t_1 - t_0), iterations)


def _moordyn(task: Task, solver: str, step: float) -> Run:
    import moordyn

    coupling = max(1, round(0.05 / step)) * step
    with tempfile.TemporaryDirectory() as folder, _quiet():
        path = Path(folder) / "lines.txt"
        path.write_text(_moordyn_input(task, step, solver), encoding="utf-8")
        system = moordyn.Create(str(path))
        count = len(task.anchors)
        base = np.tile([0.0, 0.0, task.height - task.depth], count)
        moordyn.Init(system, base.tolist(), [0.0] * (3 * count))
        omega, ramp = 2.0 * math.pi / task.period, math.pi / task.period
        peak, spent, t = 0.0, 0.0, 0.0
        velocity = np.zeros((count, 3))
        place = base.reshape(count, 3).copy()
        for _ in range(round(task.duration / coupling)):
            # MoorDyn goes on from the place given with this velocity over the coupling step.
            r = 0.5 * (1.0 - math.cos(ramp * t)) if t < task.period else 1.0
            r_1 = 0.5 * ramp * math.sin(ramp * t) if t < task.period else 0.0
            sin, cos = math.sin(omega * t), math.cos(omega * t)
            sign = -1.0 if count == 1 else 1.0
            place[:, 0] = sign * task.amplitude * r * sin
            velocity[:, 0] = sign * task.amplitude * (r_1 * sin + r * omega * cos)
            began = time.process_time()
            try:
                force = moordyn.Step(
                    system, place.ravel().tolist(), velocity.ravel().tolist(), t, coupling
                )
            except RuntimeError:
                peak, t = math.inf, max(t, coupling)
                break
            spent += time.process_time() - began
            t += coupling
            if t > 0.5 * task.duration:
                size = np.linalg.norm(np.reshape(force, (count, 3)), axis=1).max()
                peak = max(peak, float(size)) if math.isfinite(size) else math.inf
        moordyn.Close(system)
    return Run(peak, spent / t, "explicit")


@contextmanager
def _quiet() -> Iterator[None]:
    """Send what a library in another language prints to nowhere."""
    sys.stdout.flush()
    kept = [os.dup(1), os.dup(2)]
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 1)
        os.dup2(nowhere, 2)
        yield
    finally:
        for number, copy in enumerate(kept, start=1):
            os.dup2(copy, number)
            os.close(copy)
        os.close(nowhere)


def _moordyn_input(task: Task, step: float, solver: str) -> str:
    """Lines in MoorDyn's own format; segments meet in free points without mass."""
    types = [
        f"T{i} {s.diameter:.9g} {s.mass:.9g} {s.EA:.9g} {-task.zeta} 0 {s.drag} {s.added} 0 0"
        for i, s in enumerate(task.sections)
    ]
    points: list[str] = []
    lines: list[str] = []
    number = 0
    for x, y in task.anchors:
        far = np.array([-x if len(task.anchors) == 1 else x, y, -task.depth])
        top = np.array([0.0, 0.0, task.height - task.depth])
        total = sum(s.length for s in task.sections)
        done = 0.0
        number += 1
        points.append(f"{number} Fixed {far[0]:.9g} {far[1]:.9g} {far[2]:.9g} 0 0 0 0")
        for i, s in enumerate(task.sections):
            done += s.length
            at = far + done / total * (top - far)
            kind = "Coupled" if i == len(task.sections) - 1 else "Free"
            number += 1
            points.append(f"{number} {kind} {at[0]:.9g} {at[1]:.9g} {at[2]:.9g} 0 0 0 0")
            lines.append(f"{len(lines) + 1} T{i} {number - 1} {number} {s.length:.9g} {s.bars} -")
    options = [
        f"{step} dtM", f"{solver} tScheme", f"{G} g", f"{task.depth} WtrDpth",
        "3.0e6 kBot", "3.0e5 cBot", "0 writeLog", "1.0 dtIC", "300.0 TmaxIC", "4.0 CdScaleIC",
        "0.0001 threshIC",
    ]  # fmt: skip
    return "\n".join([
        "--- MoorDyn input ---", "--- LINE TYPES ---",
        "Name Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx", "(-) (m) (kg/m) (N) (-) (N-m2) - - - -",
        *types, "--- POINTS ---", "ID Type X Y Z Mass Volume CdA Ca", "- - m m m kg m3 m2 -",
        *points, "--- LINES ---", "ID LineType AttachA AttachB UnstrLen NumSegs Outputs",
        "- - - - m - -", *lines, "--- OPTIONS ---", *options, "--- end ---",
    ]) + "\n"  # fmt: skip


def _storm(duration: float) -> list[str]:
    """Three hours with 200 waves on one line, samples thinned."""
    waves = random_waves(jonswap(8.0, 12.0), 200, np.random.default_rng(2), direction=math.pi)
    amplitude = np.zeros((200, 3))
    amplitude[:, 0] = 0.5 * waves.amplitude
    motion = Harmonic(tuple(2.0 * math.pi / waves.omega), amplitude)
    section = CHAIN.sections[0]
    properties = LineProperties(
        [MorisonSection(section.diameter, 1.33, 0.0, 1.0)], LineDamping(critical_ratio=0.8),
        Fluid(RHO, G), Seabed(3e6 * section.diameter, 3e5 * section.diameter),
    )  # fmt: skip
    line = Line([Segment(600.0, 1000.0, EA=8e8, mass=115.0)])
    stepping = TimeStepping(duration, 0.1, ramp_time=min(60.0, 0.5 * duration), output_interval=0.5)
    began = time.process_time()
    history = run_dynamics(line, stepping, height=195.0, span=554.5, motion=motion,
                           properties=properties, sea=Sea(200.0, waves), elements=40)  # fmt: skip
    spent = time.process_time() - began
    statistics = history.tension_statistics()
    return [
        "## Three hours of a storm",
        "",
        "Hs 8 m, Tp 12 s, 200 waves, the fairlead led with half of the surface's amplitudes; the "
        "chain above at 40 bars, steps of 0.1 s, a sample each 0.5 s: "
        f"{spent:.0f} s, {history.iterations / history.steps:.2f} Newton iterations a step, "
        f"{history.time.size} samples. Tension {statistics.mean / 1e3:.0f} kN on average, at most "
        f"{statistics.maximum / 1e3:.0f} kN.",
    ]


if __name__ == "__main__":
    main()
