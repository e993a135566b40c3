"""Tension series of chains in heave beside OrcaFlex's: catopt, MoorDyn, CableDyn in one run.

    python -m benchmarks.series [--out benchmarks/results/series.md]

The runs are those of `catopt reproduce chain_in_waves`. The series are each program's with a tenth
of its smallest step; its time is that of its largest step whose largest tension is within 0.5 % of
that, as in benchmarks/dynamics.py. MoorDyn (`pip install moordyn`) and CableDyn (`pip install
cabledyn`) are left out, and said to be, when they are not there.
"""

from __future__ import annotations

import argparse
import importlib.metadata
import importlib.util
import math
import os
import resource
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
import numpy.typing as npt

from benchmarks.common import page
from catopt.reproduce.reference_moorings import (
    BARS,
    CHAIN,
    DURATION,
    RAMP_TIME,
    SETTLED,
    Depth,
    Heave,
    chain_of,
    run_chain,
)

os.environ.setdefault("OMP_NUM_THREADS", "1")

Array = npt.NDArray[np.float64]

DATA = Path(__file__).parents[1] / "tests" / "fem" / "data"
SEGMENTS: Final = BARS[CHAIN]
SINCE: Final = SETTLED[CHAIN]
PERIOD: Final = 10.0
GOOD: Final = 0.005
COUPLING: Final = 0.01
"""s: in which MoorDyn is told where its fairlead is."""
ROUNDS: Final = 3
RUNS: Final[tuple[tuple[str, Depth, Heave], ...]] = (
    ("WD0050_heave_A1", 50, 2),
    ("WD0050_heave_A2", 50, 5),
    ("WD0600_heave_A1", 600, 2),
    ("WD0600_heave_A2", 600, 5),
)


@dataclass(frozen=True)
class Task:
    """A chain from its anchor at x = 0 to a fairlead at the still surface; SI."""

    name: str
    depth: Depth
    heave: Heave

    @property
    def of(self) -> dict[str, float]:
        """What went into the study; the bed under a contact radius."""
        radius = 0.5 * chain_of(self.depth).inputs["contact_diameter_m"]
        return chain_of(self.depth, radius).inputs

    @property
    def bed_stiffness(self) -> float:
        """Of an area of MoorDyn's diameter, Pa/m: what acts on OrcaFlex's contact diameter."""
        of = self.of
        per_area = of["bed_stiffness_kN_per_m3"] * 1e3
        return per_area * of["contact_diameter_m"] / of["volume_diameter_m"]

    def motion(self, t: float) -> tuple[float, float, float]:
        """Heave, its rate and its acceleration: a sine that begins over the ramp."""
        w, q = 2.0 * math.pi / PERIOD, math.pi / RAMP_TIME
        r, r1, r2 = 1.0, 0.0, 0.0
        if t < RAMP_TIME:
            r, r1 = 0.5 * (1.0 - math.cos(q * t)), 0.5 * q * math.sin(q * t)
            r2 = 0.5 * q * q * math.cos(q * t)
        s, c = math.sin(w * t), math.cos(w * t)
        return (
            self.heave * r * s,
            self.heave * (r1 * s + r * w * c),
            self.heave * ((r2 - r * w * w) * s + 2.0 * r1 * w * c),
        )


@dataclass(frozen=True)
class Run:
    """Time, s, fairlead tension, N, and processor time for each simulated second, s."""

    time: Array
    tension: Array
    cost: float

    @property
    def peak(self) -> float:
        """Largest settled tension, N; infinite for a run that failed."""
        settled = self.tension[self.time >= SINCE]
        return float(settled.max()) if settled.size and np.isfinite(settled).all() else math.inf


def main() -> None:
    """Run all and print the table."""
    page(argparse.ArgumentParser(description=__doc__), lambda of: tables(of.smoke))


def tables(smoke: bool) -> Iterator[str]:
    """Yield the page."""
    programs: list[tuple[str, Callable[[Task, float], Run], Sequence[float], float]] = [
        ("catopt", _catopt, (0.5, 0.4, 0.25, 0.2, 0.1, 0.05), 0.005)
    ]
    absent: list[str] = []
    peers: tuple[tuple[str, str, Callable[[Task, float], Run], Sequence[float]], ...] = (
        ("MoorDyn", "moordyn", _moordyn, (0.01, 0.005, 0.0025, 0.00125)),
        ("CableDyn", "cabledyn", _cabledyn, (0.5, 0.4, 0.25, 0.2, 0.1, 0.05)),
    )
    for name, module, run, steps in peers:
        if importlib.util.find_spec(module) is None:
            absent.append(name)
        else:
            version = importlib.metadata.version(module)
            programs.append((f"{name} {version}", run, steps, 0.1 * steps[-1]))
    yield from _head(absent)
    for run_of in RUNS[:1] if smoke else RUNS:
        task = Task(*run_of)
        series = np.loadtxt(DATA / f"{task.name}.csv", delimiter=",", skiprows=1)
        t, theirs = series[:, 0], series[:, 2]
        yield f"## {task.depth} m, heave of {task.heave} m in {PERIOD:g} s"
        yield ""
        yield (
            "| | rms of the difference (kN) | largest (kN) | off | smallest (kN) | step (ms) "
            "| processor, ms per simulated second |"
        )
        yield "|---|---|---|---|---|---|---|"
        yield f"| OrcaFlex, printed | | {theirs.max():.1f} | | {theirs.min():.1f} | | |"
        for name, run, steps, fine in programs:
            few, finest = ((0.5,), 0.25) if smoke and name == "catopt" else (steps, fine)
            if smoke and name != "catopt":
                continue
            print(task.name, name, file=sys.stderr, flush=True)
            yield _row(name, run, few, finest, task, t, theirs)
        yield ""


def _head(absent: Sequence[str]) -> list[str]:
    missing = [f"Not installed, left out: {', '.join(absent)}.", ""] if absent else []
    return [
        "# Series of chains in heave",
        "",
        "One core. OrcaFlex's series are those of MoorDyn's tests, two periods of "
        "settled motion, sampled each 0.1 s.",
        "",
        "Conventions, the same for all three programs:",
        "",
        f"* {SEGMENTS} equal bars or segments; the fairlead's heave begins over {RAMP_TIME:g} s; "
        f"compared from {SINCE:g} to {DURATION:g} s, in phase with the heave.",
        "* The line's own end force at the fairlead: MoorDyn's force on its coupled point "
        "(its `FairTen` is that of its last segment: 0.9 % less in 50 m with 10 m segments), "
        "CableDyn's `FairTen`, catopt's end force. MoorDyn is told where its fairlead is each "
        f"{COUPLING * 1e3:g} ms and goes straight between.",
        "* The bed lies a contact radius, 0.2345 m, higher than the print's and yields by "
        "100 kN/m3 on the contact diameter, as OrcaFlex's does; friction of 0.5.",
        "* Series: with a tenth of each program's smallest step tried. Step and time: the largest "
        "step whose largest tension is within 0.5 % of that.",
        "* Processor time: catopt's and CableDyn's are whole runs with their statics (CableDyn's a "
        "process of its own that also reads and writes files); MoorDyn's is the march alone, "
        f"without its relaxation to rest. Least of {ROUNDS} runs.",
        "",
        *missing,
    ]


def _row(
    name: str,
    run: Callable[[Task, float], Run],
    steps: Sequence[float],
    fine: float,
    task: Task,
    t: Array,
    theirs: Array,
) -> str:
    converged = run(task, fine)
    settled = converged.time >= SINCE - 1e-9
    since, tension = converged.time[settled] - SINCE, converged.tension[settled] / 1e3
    rms = float(np.sqrt(np.mean((np.interp(t, since, tension) - theirs) ** 2)))
    off = 100.0 * (tension.max() / float(theirs.max()) - 1.0)
    series = f"| {name} | {rms:.1f} | {tension.max():.1f} | {off:+.2f} % | {tension.min():.1f} "
    for step in steps:
        found = run(task, step)
        if abs(found.peak / converged.peak - 1.0) <= GOOD:
            cost = min([found.cost, *(run(task, step).cost for _ in range(ROUNDS - 1))])
            return f"{series}| {step * 1e3:g} | {cost * 1e3:.2f} |"
    return f"{series}| none good enough | |"


def _catopt(task: Task, step: float) -> Run:
    run_chain.cache_clear()
    began = time.process_time()
    history = run_chain(task.depth, task.heave, step)
    cost = (time.process_time() - began) / DURATION
    return Run(history.time, history.fairlead_tension[:, 0], cost)


def _moordyn(task: Task, step: float) -> Run:
    import moordyn

    of = task.of
    coupling = max(COUPLING, step)
    with tempfile.TemporaryDirectory() as folder, _quiet():
        path = Path(folder) / "lines.txt"
        path.write_text(_moordyn_input(task, step), encoding="utf-8")
        system = moordyn.Create(str(path))
        moordyn.Init(system, [of["span_m"], 0.0, 0.0], [0.0, 0.0, 0.0])
        times, tensions, spent = [0.0], [math.nan], 0.0
        for i in range(round(DURATION / coupling)):
            # MoorDyn goes on from the place given with this velocity over the coupling step.
            t = i * coupling
            z, rate, _ = task.motion(t)
            began = time.process_time()
            try:
                force = moordyn.Step(system, [of["span_m"], 0.0, z], [0.0, 0.0, rate], t, coupling)
            except RuntimeError:
                force = [math.inf]
            spent += time.process_time() - began
            times.append(t + coupling)
            tensions.append(float(np.linalg.norm(force)))
            if not math.isfinite(tensions[-1]):
                break
        moordyn.Close(system)
    tensions[0] = tensions[1]
    return Run(np.array(times), np.array(tensions), spent / times[-1])


def _moordyn_input(task: Task, step: float) -> str:
    of, zeta = task.of, task.of["damping_ratio"]
    return "\n".join([
        "--- MoorDyn input ---", "--- LINE TYPES ---",
        "Name Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx", "(-) (m) (kg/m) (N) (-) (N-m2) - - - -",
        f"chain {of['volume_diameter_m']} {of['mass_kg_per_m']} {of['EA_N']} {-zeta} 0 "
        f"{of['drag_coefficient']} {of['added_mass_coefficient']} {of['axial_drag_on_pi_D']} 0",
        "--- POINTS ---", "ID Type X Y Z Mass Volume CdA Ca", "- - m m m kg m3 m2 -",
        f"1 Fixed 0 0 {-of['fairlead_height_m']:.9g} 0 0 0 0",
        f"2 Coupled {of['span_m']} 0 0 0 0 0 0",
        "--- LINES ---", "ID LineType AttachA AttachB UnstrLen NumSegs Outputs",
        "- - - - m - -", f"1 chain 1 2 {of['line_length_m']} {SEGMENTS} -",
        "--- OPTIONS ---", f"{step} dtM", "rk2 tScheme", f"{of['gravity_m_per_s2']} g",
        f"{of['water_density_kg_per_m3']} rhoW", f"{of['fairlead_height_m']:.9g} WtrDpth",
        f"{task.bed_stiffness:.9g} kBot", "0 cBot", f"{of['friction_in_motion']} FricCoeff",
        "0 writeLog", "1.0 dtIC", "100.0 TmaxIC", "4.0 CdScaleIC", "0.0001 threshIC",
        "--- end ---",
    ]) + "\n"  # fmt: skip


def _cabledyn(task: Task, step: float) -> Run:
    from cabledyn import CableDynDriver, DriverError
    from cabledyn.builder import DeckModel

    of = task.of
    with tempfile.TemporaryDirectory() as folder:
        deck = DeckModel.new(path=Path(folder) / "deck.dat")
        chain = deck.add_line_type(
            "chain", diam=of["volume_diameter_m"], mass=of["mass_kg_per_m"], ea=of["EA_N"],
            ba=-of["damping_ratio"], cdn=of["drag_coefficient"], cdt=of["axial_drag_on_pi_D"],
            can=of["added_mass_coefficient"],
        )  # fmt: skip
        fairlead = deck.add_point(1, "Coupled", of["span_m"], 0.0, 0.0)
        anchor = deck.add_point(2, "Fixed", 0.0, 0.0, -of["fairlead_height_m"])
        deck.add_line(1, fairlead, anchor, chain, length=of["line_length_m"], num_segs=SEGMENTS)
        for key, value in (
            ("g", of["gravity_m_per_s2"]), ("rhoW", of["water_density_kg_per_m3"]),
            ("WtrDpth", of["fairlead_height_m"]), ("kBot", task.bed_stiffness),
            ("frictionMu", of["friction_in_motion"]), ("staticsFriction", "none"),
            ("dtM", step), ("TMax", DURATION), ("motionFile", "motion.txt"),
        ):  # fmt: skip
            deck.options.set(key, value)
        deck.outputs.add("FairTen1")
        times = [k * step for k in range(round(DURATION / step) + 1)]
        rows = ((t, *task.motion(t)) for t in times)
        Path(folder, "motion.txt").write_text(
            "\n".join(f"{t:.12g} 1 {of['span_m']} 0 {z} 0 0 {v} 0 0 {a}" for t, z, v, a in rows)
        )
        deck.save(deck.path)
        began = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            result = CableDynDriver().run(deck.path, Path(folder) / "out", timeout=600.0)
        except DriverError as error:
            print(error, file=sys.stderr)
            return Run(np.array([DURATION]), np.array([math.inf]), math.inf)
        ended = resource.getrusage(resource.RUSAGE_CHILDREN)
        history = result.read_main()
        spent = ended.ru_utime + ended.ru_stime - began.ru_utime - began.ru_stime
        return Run(history.time, history.column("FairTen1"), spent / DURATION)


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


if __name__ == "__main__":
    main()
