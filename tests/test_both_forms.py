"""Every function that is compiled anywhere: the same bits plain and compiled, call by call."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import catopt
from catopt import Line, PointLoad, Segment, System, read_case, solve_many
from catopt.compile_jobs import _afloat as compile_afloat
from catopt.compile_jobs import _ship as compile_ship
from catopt.compiled import VARIABLE
from catopt.design.evaluation import DesignProblem
from catopt.design.front import hypervolume, non_dominated
from catopt.design.mooring import MooringProblem
from catopt.fem import (
    Bed,
    Harmonic,
    LineDamping,
    LineProperties,
    MorisonSection,
    Seabed,
    TimeStepping,
    run_dynamics,
    solve_line,
)
from catopt.fem.dynamics import line_at_rest
from catopt.fem.linear_model import linear_model
from catopt.fem.linear_motion import linear_motion
from catopt.fem.mesh import mesh_line
from catopt.fem.series import series_rows, series_values
from catopt.floater import alone, two_scales  # noqa: F401 - before their `compiled` is watched
from catopt.model import Leg
from catopt.mooring import under_loads
from catopt.mooring.batch import solve_system_many
from catopt.mooring.fixed_body import at_rest
from catopt.waves import PowerLawCurrent, Sea, TableCurrent, jonswap, random_waves

from .both_forms import both_forms
from .campaign.networks import drawn

PACKAGE = Path(catopt.__file__).parent
CASES = Path(__file__).parents[1] / "cases"


def waves() -> None:
    """Two ways to go on above still water, in a current that is the sum of two."""
    points = np.array([[0.0, 0.0, 55.0], [5.0, 6.0, 57.0], [9.0, -3.0, 20.0], [0.0, 1.0, 0.0]])
    for stretching in ("none", "wheeler"):
        sea = Sea(
            56.0,
            random_waves(jonswap(4.0, 9.0), 30, np.random.default_rng(1), direction=1.0),
            [PowerLawCurrent(1.0, 0.3), TableCurrent([0.0, 30.0, 56.0], [1.5, 1.4, 1.0])],
            stretching=stretching,
            ramp_time=10.0,
        )
        for t in (3.0, 55.0):
            sea.kinematics(t, points)
        sea.elevation(np.linspace(0.0, 60.0, 20), 5.0, 6.0)


def fronts() -> None:
    """Three objectives, some designs alike in one of them."""
    rows = np.random.default_rng(1).integers(0, 12, (200, 3)).astype(float)
    front = rows[non_dominated(rows)]
    hypervolume(front, np.full(3, 13.0))


def lines() -> None:
    """Lines in every regime, on a bed with friction, under each load that may be known."""
    line = Line(
        [Segment(200.0, 300.0, EA=4e8), Segment(150.0, 900.0, EA=8e8)],
        [PointLoad(120.0, 2e4), PointLoad(260.0, -3e4)],
    )
    for friction in (0.0, 0.6):
        for known, values in (
            ("horizontal_force", np.geomspace(1e2, 1e7, 40)),
            ("span", np.linspace(250.0, 345.0, 40)),
            ("fairlead_tension", np.geomspace(1e4, 1e7, 40)),
        ):
            load: dict[str, Any] = {known: values}
            solve_many(line, height=80.0, seabed_friction=friction, **load)


def systems() -> None:
    """Nine lines of a tanker under forces from no force to more than they bear."""
    system = read_case(CASES / "fso-rang-dong" / "case.toml").system
    assert system is not None
    with as_arrays():
        solve_system_many(system, force=[[-4e6 * k / 10, 1e5] for k in range(12)])
        # One line on an arm: it turns over, goes round, or rests.
        leg = Leg(CHAIN, 0.3, 280.0, 80.0, fairlead_radius=20.0)
        moments = [0.0, 1.9e6, -2.1e6]
        solve_system_many(System((leg,)), force=[(1e5, 0.0)] * 3, moment=moments)


def networks() -> None:
    """Joints and bodies: bed, friction, a body that turns."""
    with as_arrays():
        for seed in (5, 16, 17):
            at_rest(drawn(seed))
        at_rest(read_case(PACKAGE.parent / "tests/answers/cases/points-and-body.toml"))


@contextmanager
def as_arrays() -> Iterator[None]:
    """Hand lines between points on as arrays, as compiled code has them."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(under_loads, "is_compiled", lambda _: True)
        yield


def designs() -> None:
    """Designs of three spaces, in all checks and up to the first that fails."""
    for name in ("design-buoy-9.5m", "design-leg-56m", "design-tanker-20m"):
        problem = DesignProblem.of(read_case(CASES / name / "case.toml"))
        numbers = np.random.default_rng(1).integers(0, problem.space.count, 200)
        for stops_early in (False, True):
            problem.assess(problem.space.genes_of(numbers), stops_early=stops_early)


def moorings() -> None:
    """Whole moorings, in all their states and up to the first that fails."""
    problem = MooringProblem.of(read_case(CASES / "design-mooring-30m" / "case.toml"))
    numbers = np.random.default_rng(1).integers(0, problem.space.count, 30)
    for best in (None, np.array([[2e5, 10.0]])):
        genes = problem.space.genes_of(numbers)
        problem.assess(genes, stops_early=best is not None, best=best)


CHAIN = Line([Segment(300.0, 1000.0, EA=5e8, mass=117.0)], [PointLoad(100.0, 1e4, mass=1200.0)])


def bars() -> None:
    """At rest with friction, as pulled and as it was laid, and dragging springs."""
    for law in ("pulled", "laid", "history"):
        bed = Bed(friction_law=law)
        solve_line(
            CHAIN, height=80.0, horizontal_force=2e5, seabed_friction=0.5, elements=30, bed=bed
        )


def motion() -> None:
    """In waves and current, on a bed with friction, with energies."""
    properties = LineProperties(
        [MorisonSection(0.13, 1.3, 0.5, 1.0, 0.2)],
        LineDamping(critical_ratio=0.5),
        seabed=Seabed(1e6, friction=0.5),
    )
    surface = random_waves(jonswap(4.0, 9.0), 20, np.random.default_rng(1))
    sea = Sea(80.0, surface, [PowerLawCurrent(1.0, 0.3)])
    run_dynamics(
        CHAIN, TimeStepping(6.0, 0.2, ramp_time=2.0, energy=True), height=80.0, span=280.0,
        elements=20, motion=Harmonic(8.0, (2.0, 0.5, 1.0)), properties=properties, sea=sea,
    )  # fmt: skip


def linear() -> None:
    """Move the same line linearly, in a stream across the waves."""
    properties = LineProperties(
        [MorisonSection(0.13, 1.3, 0.5, 1.0, 0.2)], seabed=Seabed(1e6, friction=0.5)
    )
    surface = random_waves(jonswap(4.0, 9.0), 12, np.random.default_rng(1), direction=0.7)
    sea = Sea(80.0, surface, [PowerLawCurrent(1.0, 0.3)])
    rest = line_at_rest(
        mesh_line(CHAIN, 12), height=80.0, span=280.0, properties=properties,
        sea=replace(sea, waves=None),
    )  # fmt: skip
    led = np.empty((1, 12, 3), dtype=complex)
    led[:] = (1.0 + 0.5j) * surface.amplitude[:, np.newaxis]
    linear_motion(linear_model(rest), sea, led)


def series() -> None:
    """Fill a harmonic motion that grows."""
    rows = series_rows(np.zeros((1, 3)), [Harmonic(8.0, (2.0, 0.5, 1.0))], 5.0)
    series_values(rows, np.linspace(0.0, 20.0, 50))


def afloat() -> None:
    """Run a buoy with its line and by itself, as ``catopt compile`` does."""
    compile_afloat()


def ship() -> None:
    """Step a ship on its lines, as ``catopt compile`` does."""
    compile_ship()


JOBS: dict[Callable[[], None], set[str]] = {
    waves: {"fill_elevation", "fill_kinematics", "fill_wave_numbers"},
    fronts: {"_best_of_three", "_volume"},
    lines: {"fill"},
    systems: {"rest_under_each"},
    networks: {"rest_under_each"},
    designs: {"assess"},
    moorings: {"assess_moorings"},
    series: {"_fill_values"},
    bars: {"take_steps"},
    motion: {
        "assemble_moving", "fill_water", "march", "solve_moving",
    },
    linear: {"fill_equivalents", "respond_linearly"},
    afloat: {"march", "run_hull"},
    ship: {"step_slowly", "hang_lines", "fill_table"},
}  # fmt: skip
"""What is run, and which functions that calls; to compile them all takes two minutes."""

QUICK = {waves, fronts, series}


@pytest.mark.parametrize(
    "job",
    [job if job in QUICK else pytest.param(job, marks=pytest.mark.slow) for job in JOBS],
    ids=lambda job: job.__name__,
)
def test_plain_and_compiled_are_one(job: Callable[[], None]) -> None:
    with both_forms() as called:
        job()
    assert called >= JOBS[job]


def test_no_compiled_function_is_left_out() -> None:
    found = set()
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Call) and _name(node.func) in {"compiled", "_form"}:
                found.add(_name(node.args[0]))
    found.discard("function")  # what Simulation._form hands on
    assert found == set().union(*JOBS.values())


def _name(node: ast.expr) -> str:
    return node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "")


AT_ONCE = """
import threading
import time
import numpy as np
from catopt import machine_code
from catopt.compiled import compiled
from catopt.design.front import _best_of_three, _volume
from catopt.fem.series import fill_series, series_rows
from catopt.waves import Sea, fill_elevation, fill_kinematics, regular_wave
from catopt.waves.random_surface import fill_wave_numbers

flow, points = Sea(10.0, regular_wave(1.0, 5.0)).flow, np.ones((4, 3))
rows, found = np.random.default_rng(1).uniform(size=(3, 4, 3)), np.zeros(4)
series = series_rows(np.zeros((1, 3)), [None], 0.0)
calls = [
    lambda: compiled(fill_kinematics)(0.0, points, flow, rows[0], rows[1], found),
    lambda: compiled(fill_wave_numbers)(np.ones(3), 10.0, np.zeros(3)),
    lambda: compiled(_volume)(rows[2], np.arange(4), np.ones(3)),
    lambda: compiled(fill_series)(0.0, series, 0, np.zeros((3, 3))),
    lambda: compiled(_best_of_three)(rows[2]),
    lambda: compiled(fill_elevation)(found, found, found, flow, np.zeros(4)),
]


def call(number):
    time.sleep(0.25 * number)
    calls[number]()


threads = [threading.Thread(target=call, args=(k,)) for k in range(len(calls))]
for each in threads:
    each.start()
for each in threads:
    each.join()
print("compiled")
"""


def test_threads_compile_one_after_the_other(tmp_path: Path) -> None:
    """Else what one compiles goes where another's is to go, and the process dies."""
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path), VARIABLE: "always"}
    ran = subprocess.run(
        [sys.executable, "-c", AT_ONCE], env=environment, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "compiled\n", "")
