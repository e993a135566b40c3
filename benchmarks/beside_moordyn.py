"""Lines in motion beside MoorDyn: tensions at both ends by two programs, line by line.

    python -m benchmarks.beside_moordyn [--out benchmarks/results/beside_moordyn.md] [--smoke]

MoorDyn is an extra of the benchmarks (`pip install moordyn`); without it the page says so. Both
have the same nodes, masses lumped at them, damping by the bar, bed and coefficients. The last point
is led, smoothly from rest; statistics begin after the ramp.
"""

from __future__ import annotations

import argparse
import math
import os
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from benchmarks.common import page
from catopt.fem.dynamic_model import LineProperties
from catopt.fem.dynamics import run_network_dynamics
from catopt.fem.mesh import mesh_line
from catopt.fem.morison import MorisonSection
from catopt.fem.network import LineEnd
from catopt.fem.newmark import LineDamping
from catopt.fem.run_settings import TimeStepping
from catopt.fem.seabed import Seabed
from catopt.fem.series import Harmonic
from catopt.model import Line, Segment
from catopt.model.network import Point

Array = npt.NDArray[np.float64]

RHO, G, STEP, CRITICAL = 1025.0, 9.80665, 0.02, 0.5
RAMP, SINCE, DURATION = 16.0, 20.0, 60.0


class Kind(NamedTuple):
    """A line type: diameter, m, mass, kg/m, EA, N, drag across."""

    diameter: float
    mass: float
    EA: float
    drag: float = 1.6


class Run(NamedTuple):
    """A line from one point to another, by their numbers from 0."""

    kind: str
    first: int
    second: int
    length: float
    bars: int


class Set(NamedTuple):
    """What is run: the last point is led; joints have mass, volume, Cd A and Ca."""

    name: str
    depth: float
    kinds: Mapping[str, Kind]
    fixed: tuple[tuple[float, float, float], ...]
    joints: tuple[tuple[float, float, float, float], ...]
    led: tuple[float, float, float]
    runs: tuple[Run, ...]
    amplitude: tuple[float, float, float]
    period: float


CHAIN, ROPE = Kind(0.09, 100.0, 4e8, 2.0), Kind(0.16, 17.5, 2e7, 1.2)
NEITHER = (0.0, 0.0, 0.0, 0.0)
SETS = (
    Set("chain near slack", 56.0, {"chain": CHAIN}, ((0.0, 0.0, 0.0),), (), (282.0, 0.0, 54.0),
        (Run("chain", 0, 1, 300.0, 40),), (1.5, 0.0, 1.0), 9.0),
    Set("taut rope", 60.0, {"rope": ROPE}, ((0.0, 0.0, 0.0),), (), (150.0, 0.0, 55.0),
        (Run("rope", 0, 1, 155.0, 30),), (1.0, 0.0, 0.5), 8.0),
    Set("clump and buoy on a line", 80.0, {"chain": Kind(0.06, 35.0, 3e7, 2.0)},
        ((0.0, 0.0, 0.0),), ((3000.0, 0.4, 1.0, 0.5), (400.0, 1.6, 1.2, 0.5)), (150.0, 0.0, 75.0),
        (Run("chain", 0, 1, 60.0, 15), Run("chain", 1, 2, 60.0, 15), Run("chain", 2, 3, 62.0, 15)),
        (1.0, 0.3, 0.8), 8.0),
    Set("lazy wave", 100.0, {"bare": Kind(0.2, 60.0, 5e7, 1.2), "buoyed": Kind(0.32, 60.0, 5e7)},
        ((0.0, 0.0, 0.0),), (NEITHER, NEITHER), (150.0, 0.0, 95.0),
        (Run("bare", 0, 1, 90.0, 40), Run("buoyed", 1, 2, 50.0, 30), Run("bare", 2, 3, 80.0, 40)),
        (1.5, 0.0, 1.0), 10.0),
)  # fmt: skip


def _damping(kind: Kind, run: Run) -> float:
    return CRITICAL * math.sqrt(kind.EA * kind.mass) * run.length / run.bars


def _ours(of: Set) -> dict[str, Array]:
    """Find forces at the first and the last end, N, after the ramp, and where joints rest."""
    joints = [
        Point(f"{k}", "joint", submerged_weight=(mass - RHO * volume) * G, mass=mass,
              drag_area=area, drag_coefficient=1.0, added_mass_coefficient=Ca)
        for k, (mass, volume, area, Ca) in enumerate(of.joints)
    ]  # fmt: skip
    count = len(of.fixed)

    def end(number: int) -> LineEnd:
        if number < count:
            return LineEnd(of.fixed[number])
        if number < count + len(joints):
            return LineEnd((0.0, 0.0, 0.0), number - count)
        return LineEnd(of.led)

    last = count + len(joints)
    phase = np.array([-0.5 * math.pi, -0.5 * math.pi, 0.0])
    motion = Harmonic(of.period, of.amplitude, phase)
    kinds = [of.kinds[run.kind] for run in of.runs]
    lines = [
        Line([Segment(run.length, _weight(kind), EA=kind.EA, mass=kind.mass)])
        for run, kind in zip(of.runs, kinds, strict=True)
    ]
    thickest = max(kind.diameter for kind in kinds)
    found = run_network_dynamics(
        [mesh_line(line, run.bars) for line, run in zip(lines, of.runs, strict=True)],
        [(end(run.first), end(run.second)) for run in of.runs],
        joints,
        TimeStepping(DURATION, STEP, ramp_time=RAMP),
        motions=[(None, motion if run.second == last else None) for run in of.runs],
        properties=LineProperties(
            of_lines=[[MorisonSection(kind.diameter, kind.drag, 0.0, 1.0, 0.0)] for kind in kinds],
            damping=LineDamping(critical_ratio=CRITICAL, critical_length="bar"),
            seabed=Seabed(3e6 * thickest, 3e5 * thickest, friction=0.0),
            mass_matrix="lumped",
        ),
    )
    late = found.time > SINCE
    places = np.concatenate([found.nodes[0], [of.led]])
    return {
        "lower": found.anchor_tension[late, 0],
        "upper": found.fairlead_tension[late, -1],
        "places": places,
    }


def _weight(kind: Kind) -> float:
    return (kind.mass - RHO * 0.25 * math.pi * kind.diameter**2) * G


def _input(of: Set, places: Array) -> str:
    count = len(of.fixed)
    points = [f"{k + 1} Fixed {x} {y} {z - of.depth} 0 0 0 0"
              for k, (x, y, z) in enumerate(of.fixed)]  # fmt: skip
    for k, (what, place) in enumerate(zip(of.joints, places[:-1], strict=True)):
        x, y, z = place
        said = " ".join(f"{each}" for each in what)
        points.append(f"{count + k + 1} Free {x} {y} {z - of.depth} {said}")
    x, y, z = of.led
    points.append(f"{count + len(of.joints) + 1} Coupled {x} {y} {z - of.depth} 0 0 0 0")
    kinds = [
        f"{name} {kind.diameter} {kind.mass} {kind.EA} "
        f"{_damping(kind, next(r for r in of.runs if r.kind == name))} 0 {kind.drag} 1.0 0 0"
        for name, kind in of.kinds.items()
    ]
    lines = [f"{k + 1} {run.kind} {run.first + 1} {run.second + 1} {run.length} {run.bars} -"
             for k, run in enumerate(of.runs)]  # fmt: skip
    return "\n".join([
        "MoorDyn", "---- LINE TYPES ----",
        "TypeName Diam Mass/m EA BA EI Cd Ca CdAx CaAx", "(-) (-) (-) (-) (-) (-) (-) (-) (-) (-)",
        *kinds, "---- POINTS ----", "ID Attachment X Y Z Mass Volume CdA CA",
        "(-) (-) (-) (-) (-) (-) (-) (-) (-)", *points, "---- LINES ----",
        "ID LineType AttachA AttachB UnstrLen NumSegs Outputs", "(-) (-) (-) (-) (-) (-) (-)",
        *lines, "---- OPTIONS ----", "0 writeLog", "2e-4 dtM", "3e6 kBot", "3e5 cBot",
        f"{of.depth} WtrDpth", f"{RHO} WtrDens", f"{G} gravity", "0.0 FrictionCoefficient",
        "300 TmaxIC", "4.0 CdScaleIC", "1e-5 threshIC", "---- OUTPUT ----", "---- END ----", "",
    ])  # fmt: skip


def _theirs(moordyn: Any, of: Set, places: Array) -> dict[str, Array]:
    """Run MoorDyn: the same."""
    here, omega = Path.cwd(), 2.0 * math.pi / of.period
    amplitude = np.array(of.amplitude)
    phase = np.array([-0.5 * math.pi, -0.5 * math.pi, 0.0])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            Path("set.txt").write_text(_input(of, places))
            system = moordyn.Create("set.txt")
            place = np.subtract(of.led, (0.0, 0.0, of.depth))
            moordyn.Init(system, place.tolist(), [0.0, 0.0, 0.0])
            first = moordyn.GetLine(system, 1)
            lower, upper = [], []
            for i in range(round(DURATION / STEP)):
                t = i * STEP
                grown = 0.5 * (1.0 - math.cos(math.pi * min(t / RAMP, 1.0)))
                rate = 0.5 * math.pi / RAMP * math.sin(math.pi * t / RAMP) if t < RAMP else 0.0
                way, speed = (
                    amplitude * np.cos(omega * t + phase),
                    -omega * amplitude * np.sin(omega * t + phase),
                )
                at, fast = place + grown * way, grown * speed + rate * way
                force = moordyn.Step(system, at.tolist(), fast.tolist(), t, STEP)
                if t + STEP > SINCE:
                    lower.append(np.linalg.norm(moordyn.GetLineNodeTen(first, 0)))
                    upper.append(np.linalg.norm(force))
            moordyn.Close(system)
        finally:
            os.chdir(here)
    return {"lower": np.array(lower), "upper": np.array(upper)}


def _report(of: argparse.Namespace) -> Iterator[str]:
    yield "# Lines in motion beside MoorDyn"
    yield ""
    try:
        import moordyn
    except ImportError:
        yield "MoorDyn is not installed: `pip install moordyn`."
        return
    yield (
        "Forces at the ends, kN, by the same nodes, lumped masses and damping by the bar; largest "
        f"difference over MoorDyn's largest value there. Ramp {RAMP:.0f} s, statistics "
        f"{SINCE:.0f} to {DURATION:.0f} s."
    )
    yield ""
    yield "| case | end | largest | MoorDyn | least | MoorDyn | deviation | MoorDyn | difference |"
    yield "|---|---|---|---|---|---|---|---|---|"
    for each in SETS[1:2] if of.smoke else SETS:
        own = _ours(each)
        other = _theirs(moordyn, each, own["places"])
        for end in ("lower", "upper"):
            a, b = own[end] / 1e3, other[end] / 1e3
            pairs = [(f(a), f(b)) for f in (np.max, np.min, np.std)]
            off = max(abs(x - y) for x, y in pairs) / b.max()
            cells = " | ".join(f"{x:.2f} | {y:.2f}" for x, y in pairs)
            yield f"| {each.name} | {end} | {cells} | {off:.1%} |"


def main() -> None:
    """Run all and print the table."""
    page(argparse.ArgumentParser(description=__doc__), _report)


if __name__ == "__main__":
    main()
