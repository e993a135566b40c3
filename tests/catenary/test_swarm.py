"""The swarm method of S1: its figures, its promises, and nothing of pyswarms beside them."""

from __future__ import annotations

import json
import math
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, get_args

import jsonschema
import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from catopt.catenary.pieces import Pieces, cut
from catopt.catenary.solution import Solution, SwarmReport
from catopt.catenary.swarm import solve, solve_swarm
from catopt.catenary.swarm.objective import (
    Array,
    GroundedObjective,
    Objective,
    SuspendedObjective,
    objective_of,
)
from catopt.catenary.swarm.solve import PATIENCE, optimiser, without_logging
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError, NoEquilibriumError, NotConvergedError
from catopt.model import Line, Segment, SwarmSettings
from catopt.model.case import Boundary
from catopt.schemas import schema

L, DEPTH = 20.0, 9.5
H = 343.0 * STANDARD_GRAVITY
BUOY = Line([Segment(L, 9.5 * STANDARD_GRAVITY)])
SLACK = Line([Segment(L, 30.0 * STANDARD_GRAVITY)])
HANDLINGS: tuple[Boundary, ...] = get_args(Boundary)


def swarm(line: Line = BUOY, **settings: Any) -> Solution:
    return solve_swarm(line, height=DEPTH, horizontal_force=H, settings=SwarmSettings(**settings))


def report_of(solution: Solution) -> SwarmReport:
    assert solution.swarm is not None
    return solution.swarm


def objective(line: Line = BUOY) -> Objective:
    return objective_of(pieces_of(line), DEPTH, H)


def pieces_of(line: Line) -> Pieces:
    return cut(line)[0]


def uniform(length: float, weight: float) -> Pieces:
    return pieces_of(Line([Segment(length, weight)]))


# ------------------------------------------------------------------ what S1 prints, what it skips


def test_the_buoy_gives_the_figures_that_s1_prints() -> None:
    """S1, Table 1: theta0 0.272 rad, S 17.430 m, T 0.446 tf."""
    solution = swarm()
    assert f"{solution.anchor.angle:.3f}" == "0.272"
    assert f"{solution.span:.3f}" == "17.430"
    assert f"{solution.fairlead.tension / (1000.0 * STANDARD_GRAVITY):.3f}" == "0.446"
    assert solution.method == "pso"
    assert solution.regime == "suspended"
    assert solution.grounded_length == 0.0


def test_the_slack_sister_keeps_to_the_closed_form() -> None:
    """L_min = sqrt(h (h + 2a)) and T = H + w h (S2 (1), (4)), S by S1 (5) at theta0 = 0.

    f = 0 to rounding, a few 1e-15 m; a miss of f moves g and S by no more than a few times f.
    """
    solution = swarm(SLACK)
    a = 343.0 / 30.0
    hanging = math.sqrt(DEPTH * (DEPTH + 2.0 * a))
    assert solution.regime == "grounded"
    assert solution.grounded_length == pytest.approx(L - hanging, abs=1e-13)
    assert solution.suspended_length == pytest.approx(hanging, abs=1e-13)
    assert solution.span == pytest.approx(L - hanging + a * math.acosh(1 + DEPTH / a), abs=1e-13)
    weight = 30.0 * STANDARD_GRAVITY
    assert solution.fairlead.tension == pytest.approx(H + weight * DEPTH, rel=1e-14)
    assert solution.anchor.tension == H
    assert solution.anchor.angle == solution.anchor.vertical_force == 0.0


def test_the_line_that_just_lifts_off_has_its_answer_in_a_corner_of_the_bounds() -> None:
    """With h = 8 and a = 5, h (h + 2a) = 144: L = L_min = 12 exactly; S = a asinh(L/a)."""
    line = Line([Segment(12.0, 100.0)])
    solution = solve_swarm(line, height=8.0, horizontal_force=500.0, settings=SwarmSettings())
    assert report_of(solution).objective < 1e-12
    assert solution.anchor.angle == pytest.approx(0.0, abs=1e-12)
    assert solution.span == pytest.approx(5.0 * math.asinh(12.0 / 5.0), abs=1e-12)
    assert solution.fairlead.tension == pytest.approx(1300.0, abs=1e-9)  # hypot(500, 1200)


@dataclass(frozen=True)
class Hung:
    """theta0 (rad), S, grounded length (m)."""

    angle: float
    span: float
    grounded: float


def hang(length: float, h: float, a: float) -> Hung:
    """Solve S1 (1), (6) without iteration: l2 - z2 = 4 a2 sinh2(S/2a), z/l = tanh(S/2a + b)."""
    hanging = math.sqrt(h * (h + 2.0 * a))
    if length > hanging:
        return Hung(0.0, length - hanging + a * math.asinh(hanging / a), length - hanging)
    half = math.asinh(math.sqrt((length - h) * (length + h)) / (2.0 * a))
    return Hung(math.atan(math.sinh(math.atanh(h / length) - half)), 2.0 * a * half, 0.0)


@hypothesis_settings(max_examples=40, deadline=None, derandomize=True)
@given(
    h=st.floats(1.0, 1000.0),
    scope=st.floats(1.1, 11.0),
    parameter=st.floats(-1.3, 2.3).map(lambda x: 10.0**x),
)
def test_lines_of_many_shapes(h: float, scope: float, parameter: float) -> None:
    """L/h from 1.1 to 11, a/h from 0.05 to 200: one run each.

    f and with it span and grounded length to 1e-8 of the length, a hundred times what the hardest
    of 300 such lines leaves (benchmarks/results/swarm.md).
    """
    length, a = scope * h, parameter * h
    line = Line([Segment(length, 100.0)])
    solution = solve_swarm(line, height=h, horizontal_force=100.0 * a, settings=SwarmSettings())
    expected = hang(length, h, a)
    assert report_of(solution).objective < 1e-8 * length
    assert solution.span == pytest.approx(expected.span, abs=1e-6 * length)
    assert solution.grounded_length == pytest.approx(expected.grounded, abs=1e-6 * length)
    assert solution.anchor.angle == pytest.approx(expected.angle, abs=1e-6)


@pytest.mark.parametrize("line", [BUOY, SLACK])
def test_every_one_of_30_seeds_comes_down_to_rounding(line: Line) -> None:
    assert max(seed_objectives(line, 30)) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("line", [BUOY, SLACK])
def test_every_one_of_1000_seeds_comes_down_to_rounding(line: Line) -> None:
    assert max(seed_objectives(line, 1000)) < 1e-12


def seed_objectives(line: Line, seeds: int) -> Iterator[float]:
    """Smallest f of one run of 200 particles and 200 iterations under each seed from 1 on."""
    f = objective(line)
    for seed in range(1, seeds + 1):
        settings = SwarmSettings(particles=200, iterations=200, seed=seed)
        yield optimiser(f, settings)(1).objective


# ------------------------------------------------------------------ f


@pytest.mark.parametrize("line", [BUOY, SLACK])
def test_f_is_that_of_s1(line: Line) -> None:
    """S1 (1), (6) as printed, in the range where they do not cancel; rel 1e-12 for that reason."""
    f = objective(line)
    (a,) = f.parameters
    for first, second in ((0.3, 12.0), (0.1, 15.0), (1.2, 3.0)):
        theta0, g, reach = (first, 0.0, second) if line is BUOY else (0.0, first, second)
        b = math.asinh(math.tan(theta0))
        l_S = a * math.sinh(reach / a + b) - a * math.tan(theta0)
        z_S = a * math.cosh(reach / a + b) - a * math.cosh(b)
        expected = abs(g + l_S - L) + abs(z_S - DEPTH)
        assert f(np.array([[first, second]]))[0] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("parameter", [1e-9, 1e-4, 1.0, 1e4, 1e12])
@pytest.mark.parametrize("length", [10.0 + 1e-9, 10.5, 30.0, 1e5])
def test_f_is_finite_all_over_the_bounds(length: float, parameter: float) -> None:
    """No overflow and no warning, at the corners and inside; height 10 m."""
    f = objective_of(uniform(length, 1.0), 10.0, parameter)
    lower, upper = f.bounds
    assert (lower < upper).all()
    grid = np.linspace(0.0, 1.0, 21)
    places = np.array([lower + (upper - lower) * (i, k) for i in grid for k in grid])
    with np.errstate(all="raise", under="ignore"):
        assert np.isfinite(f(places)).all()


def test_f_keeps_its_digits_on_a_nearly_straight_line() -> None:
    """At a = 1e9 m, S1 (1) as printed is good to 1e-7 m only: a times a double's rounding."""
    f = objective_of(uniform(15.0, 1.0), 9.0, 1e9)
    expected = hang(15.0, 9.0, 1e9)
    assert expected.span == pytest.approx(12.0, rel=1e-15)  # 9, 12, 15
    assert f(np.array([[expected.angle, expected.span]]))[0] < 1e-13


@pytest.mark.parametrize("line", [BUOY, SLACK])
def test_the_bounds_are_those_of_s1(line: Line) -> None:
    """(8) 0 <= theta0 < pi/2, (9) S > 0, (10) S2 + h2 < L2."""
    f = objective(line)
    lower, upper = f.bounds
    assert lower[0] == 0.0
    assert lower[1] > 0.0
    assert upper[1] ** 2 + DEPTH**2 < L**2
    assert upper[0] < math.pi / 2 if line is BUOY else upper[0] == L - DEPTH


# ------------------------------------------------------------------ the report


def test_the_report_counts_what_happened() -> None:
    solution = swarm(runs=4, seed=7)
    report = report_of(solution)
    assert (report.runs, report.seed, report.iterations) == (4, 7, 200)
    assert report.evaluations == 200 * sum(report.iterations_flown)
    assert len(report.objectives) == len(report.iterations_flown) == 4
    assert report.objective == min(report.objectives)
    assert report.best_run == 1 + report.objectives.index(report.objective)
    assert report.converged_runs == sum(f < 1e-9 for f in report.objectives) == 4
    flown = report.iterations_flown[report.best_run - 1]
    assert len(report.best_objective_history) == len(report.tension_history) == flown
    assert report.best_objective_history[-1] == report.objective
    assert list(report.best_objective_history) == sorted(
        report.best_objective_history, reverse=True
    )
    assert report.tension_history[-1] == solution.fairlead.tension
    assert report.tension_history[0] != solution.fairlead.tension


def test_the_number_of_evaluations_is_true() -> None:
    seen = 0

    class Counted(SuspendedObjective):
        def __call__(self, places: Array) -> Array:
            nonlocal seen
            seen += len(places)
            return super().__call__(places)

    counted = Counted(pieces_of(BUOY), DEPTH, H)
    run = optimiser(counted, SwarmSettings(particles=30))(1)
    assert seen == 30 * len(run.objectives)


@pytest.mark.parametrize("line", [BUOY, SLACK])
def test_distance_from_the_closed_form_and_from_s1_5(line: Line) -> None:
    """Both are rounding, some 1e-15 of 20 m and of 4 to 6 kN."""
    report = report_of(swarm(line))
    unknown = "angle_rad" if line is BUOY else "grounded_length_m"
    assert set(report.closed_form_difference) == {unknown, "span_m", "tension_N"}
    assert abs(report.closed_form_difference[unknown]) < 1e-13
    assert abs(report.closed_form_difference["span_m"]) < 1e-13
    assert abs(report.closed_form_difference["tension_N"]) < 1e-10
    assert report.span_consistency < 1e-13


def test_the_distance_from_the_closed_form_is_a_difference() -> None:
    """Few particles leave some f; swarm less `hang` is then the difference that is reported."""
    solution = swarm(particles=20, iterations=60)
    difference = report_of(solution).closed_form_difference
    expected = hang(L, DEPTH, 343.0 / 9.5)
    assert abs(difference["span_m"]) > 1e-12
    assert difference["span_m"] == pytest.approx(solution.span - expected.span, abs=1e-13)
    assert difference["angle_rad"] == pytest.approx(
        solution.anchor.angle - expected.angle, abs=1e-14
    )


@pytest.mark.parametrize("line", [BUOY, SLACK])
def test_the_solution_is_the_swarms_own_and_keeps_to_its_schema(line: Line) -> None:
    """Laid out from the anchor, the line meets the fairlead as closely as f says; rounding."""
    solution = swarm(line)
    assert abs(solution.residual.height) < 1e-13
    assert abs(solution.residual.span) < 1e-13
    profile = solution.profile(51)
    assert profile.s[-1] == pytest.approx(L, rel=1e-15)
    assert profile.x[-1] == pytest.approx(solution.span, abs=1e-13)
    assert profile.z[-1] == pytest.approx(DEPTH, abs=1e-13)
    assert profile.tension[-1] == pytest.approx(solution.fairlead.tension, rel=1e-14)
    assert sum(s.length for s in solution.stretches if s.on_bed) == solution.grounded_length
    document = json.loads(json.dumps(solution.to_dict(profile=True)))
    jsonschema.validate(document, schema("catopt.solution/1"))


def test_the_residual_shows_what_the_swarm_left() -> None:
    solution = swarm(particles=20, iterations=60)
    assert report_of(solution).objective > 1e-10
    assert math.hypot(solution.residual.height, solution.residual.span) > 1e-12


# ------------------------------------------------------------------ when a run stops


def test_a_run_stops_where_f_cannot_fall_any_more() -> None:
    run = optimiser(objective(), SwarmSettings())(1)
    assert run.objectives[-1] == 0.0
    assert all(f > 0.0 for f in run.objectives[:-1])
    assert len(run.objectives) < 200


def test_a_run_down_to_rounding_stops_after_its_patience() -> None:
    """The two lengths compared here, of some 10 m, never meet exactly: f stays at 2e-15 m."""
    f = objective_of(uniform(L, 1.0), DEPTH, 2.0)
    runs = [optimiser(f, SwarmSettings(seed=seed))(1) for seed in range(1, 11)]
    at_rest = [run for run in runs if run.objective > 0.0 and len(run.objectives) < 200]
    assert at_rest
    for run in at_rest:
        assert run.objective < f.rounding == pytest.approx(4 * 2**-52 * (L + DEPTH))
        assert len(set(run.objectives[-1 - PATIENCE :])) == 1
        assert run.objectives[-2 - PATIENCE] > run.objective


def test_a_run_above_rounding_takes_all_its_iterations() -> None:
    """Stalled by "periodic" at a few millimetres, it does not give up early."""
    runs = [
        optimiser(objective(), SwarmSettings(boundary="periodic", seed=seed))(1)
        for seed in range(1, 31)
    ]
    stalled = [run for run in runs if run.objective > 1e-6]
    assert stalled
    assert all(len(run.objectives) == 200 for run in stalled)


# ------------------------------------------------------------------ one seed, one answer


def test_a_seed_gives_the_same_digits() -> None:
    first, again = swarm(runs=2, seed=5), swarm(runs=2, seed=5)
    assert first == again
    assert (
        report_of(swarm(seed=6)).best_objective_history
        != report_of(swarm(seed=5)).best_objective_history
    )


def test_a_run_depends_on_the_seed_and_its_number_only() -> None:
    settings = SwarmSettings(particles=20, iterations=60, runs=5, seed=3)
    together = report_of(
        solve_swarm(BUOY, height=DEPTH, horizontal_force=H, settings=settings)
    ).objectives
    np.random.seed(1)  # noqa: NPY002 - must not matter
    alone = [optimiser(objective(), settings)(number).objective for number in (5, 4, 3, 2, 1)]
    assert together == tuple(reversed(alone))
    assert len(set(together)) == 5


@pytest.mark.parametrize("line", [BUOY, SLACK])
def test_twice_as_large_a_line_flies_the_same_way(line: Line) -> None:
    """Lengths times 2, an exact operation: f is 2 f to the last digit, at every iteration."""
    (segment,) = line.segments
    large = objective_of(uniform(2 * L, segment.submerged_weight), 2 * DEPTH, 2 * H)
    settings = SwarmSettings(particles=40, iterations=60)
    once, twice = (optimiser(f, settings)(1).objectives for f in (objective(line), large))
    assert [2.0 * f for f in once] == list(twice)


def test_progress_is_told_of_every_run() -> None:
    told: list[int] = []
    solve_swarm(
        BUOY,
        height=DEPTH,
        horizontal_force=H,
        settings=SwarmSettings(runs=3),
        progress=told.append,
    )
    assert told == [1, 2, 3]


# ------------------------------------------------------------------ bounds


@contextmanager
def watched(kind: type[Objective]) -> Iterator[tuple[type[Objective], list[Array]]]:
    places: list[Array] = []

    class Watched(kind):  # type: ignore[misc, valid-type]
        def __call__(self, seen: Array) -> Array:
            places.append(seen.copy())
            f: Array = super().__call__(seen)
            return f

    yield Watched, places


@pytest.mark.parametrize("boundary", HANDLINGS)
@pytest.mark.parametrize(("kind", "line"), [(SuspendedObjective, BUOY), (GroundedObjective, SLACK)])
def test_no_particle_is_beyond_a_bound(
    kind: type[Objective], line: Line, boundary: Boundary
) -> None:
    with watched(kind) as (watching, places):
        f = watching(pieces_of(line), DEPTH, H)
        optimiser(f, SwarmSettings(boundary=boundary, inertia=0.9))(1)
    lower, upper = f.bounds
    seen = np.concatenate(places)
    assert (seen >= lower).all()
    assert (seen <= upper).all()


def test_the_boundary_handling_is_passed_on() -> None:
    """With "nearest" particles stop on a bound, with "reflective" they do not; all six differ."""
    histories = set()
    on_bound = {}
    for boundary in HANDLINGS:
        with watched(SuspendedObjective) as (watching, places):
            f = watching(pieces_of(BUOY), DEPTH, H)
            histories.add(optimiser(f, SwarmSettings(boundary=boundary))(1).objectives)
        lower, upper = f.bounds
        seen = np.concatenate(places)
        on_bound[boundary] = int(((seen == lower) | (seen == upper)).sum())
    assert len(histories) == len(HANDLINGS)
    assert on_bound["nearest"] > 0
    assert on_bound["reflective"] == 0


def test_random_sends_each_particle_to_a_place_of_its_own() -> None:
    with watched(SuspendedObjective) as (watching, places):
        f = watching(pieces_of(BUOY), DEPTH, H)
        optimiser(f, SwarmSettings(boundary="random", iterations=3))(1)
    assert all(len(np.unique(seen, axis=0)) == len(seen) for seen in places)


# ------------------------------------------------------------------ pyswarms


@pytest.mark.parametrize("boundary", ["nearest", "reflective", "periodic"])
def test_the_run_is_that_of_pyswarms_global_best(
    monkeypatch: pytest.MonkeyPatch, boundary: Boundary
) -> None:
    """GlobalBestPSO itself, fed with the same start and the same random numbers, to the digit."""
    from pyswarms.single import GlobalBestPSO

    settings = SwarmSettings(boundary=boundary, iterations=50)
    ours = optimiser(objective(), settings)(1)
    generator = np.random.default_rng((settings.seed, 1))
    lower, upper = objective().bounds
    start = lower + (upper - lower) * generator.random((200, 2))
    with without_logging():
        theirs = GlobalBestPSO(
            n_particles=200,
            dimensions=2,
            options={"c1": 1.5, "c2": 1.5, "w": 0.4},
            bounds=(lower, upper),
            bh_strategy=boundary,
            init_pos=start,
        )
    theirs.swarm.velocity = np.zeros((200, 2))
    monkeypatch.setattr(np.random, "uniform", lambda _low, _high, size: generator.random(size))
    theirs.optimize(objective(), iters=50, verbose=False)
    assert theirs.cost_history == list(ours.objectives)


SIDE_EFFECTS = """
import logging, os, sys
written = []
def watch(event, args):
    if event == "open" and isinstance(args[2], int) and args[2] & (os.O_WRONLY | os.O_RDWR):
        written.append(args[0])
sys.addaudithook(watch)
import numpy as np
np.random.seed(12)
before = np.random.get_state()[1].copy()
def logging_state():
    root = logging.getLogger()
    return (list(root.handlers), root.level, logging.root.manager.disable, logging.lastResort)
logs = logging_state()
mine = logging.getLogger("somebody")
mine.addHandler(logging.NullHandler())
environment = dict(os.environ)
from catopt.catenary.swarm import solve_swarm
from catopt.model import Line, Segment, SwarmSettings
for boundary in ("reflective", "random"):
    solution = solve_swarm(
        Line([Segment(20.0, 93.163)]), height=9.5, horizontal_force=3363.68,
        settings=SwarmSettings(runs=2, boundary=boundary),
    )
assert "pyswarms" in sys.modules
assert (np.random.get_state()[1] == before).all(), "numpy's global random state"
assert logging_state() == logs, logging_state()
assert not mine.disabled and len(mine.handlers) == 1
assert dict(os.environ) == environment, "environment"
assert written == [], written
print(f"{solution.span:.3f}")
"""


@pytest.mark.slow
@pytest.mark.parametrize("log_cfg", [None, "/no/such/folder/logging.yaml", "broken.yaml"])
def test_nothing_of_pyswarms_reaches_the_user(tmp_path: Path, log_cfg: str | None) -> None:
    """No file opened for writing, no logging set up, no output, no use of the global random state.

    LOG_CFG is what pyswarms reads its logging from; an application may have one of its own.
    """
    folder = tmp_path / "read-only"
    folder.mkdir()
    (folder / "broken.yaml").write_text("handlers: [", encoding="utf-8")
    folder.chmod(0o500)
    environment = {key: value for key, value in os.environ.items() if key != "LOG_CFG"}
    if log_cfg is not None:
        environment["LOG_CFG"] = log_cfg
    done = subprocess.run(
        [sys.executable, "-B", "-W", "error", "-c", SIDE_EFFECTS],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "17.430\n", "")
    assert [path.name for path in folder.iterdir()] == ["broken.yaml"]


# ------------------------------------------------------------------ refusals


def test_too_small_a_swarm_has_no_result() -> None:
    f = optimiser(objective(), SwarmSettings(particles=2, iterations=1))(1).objective
    with pytest.raises(NotConvergedError) as caught:
        swarm(particles=2, iterations=1)
    assert caught.value.exit_status == 4
    assert str(caught.value) == (
        "the swarm did not converge: the smallest f of 1 run of 2 particles and 1 iteration is "
        f"{f:.3g} m, and a result needs f below 1e-06 m. "
        "Give it more particles, iterations or runs, or use the closed form."
    )


def test_s1_11_is_held(monkeypatch: pytest.MonkeyPatch) -> None:
    """dl/dS >= 1, so that f < 1e-6 m implies (11); without that limit (11) stands alone."""
    monkeypatch.setattr(solve, "RESULT", math.inf)
    with pytest.raises(NotConvergedError, match=r"its span differs by [\d.]+ m from that of S1"):
        swarm(particles=2, iterations=1)


def test_every_number_out_of_range_is_named_at_once() -> None:
    with pytest.raises(InputError) as caught:
        solve_swarm(
            BUOY,
            height=0.0,
            horizontal_force=math.nan,
            seabed_friction=-0.1,
            settings=SwarmSettings(),
        )
    assert [str(problem) for problem in caught.value.problems] == [
        "height: found 0.0; must be above 0 m",
        "horizontal_force: found nan; a number in N is required",
        "seabed_friction: found -0.1; must be 0 or more",
    ]


@pytest.mark.parametrize(("force", "weight"), [(1e-60, 1.0), (1e60, 1.0), (1.0, 1e60)])
def test_forces_whose_products_no_number_holds(force: float, weight: float) -> None:
    line = Line([Segment(L, weight)])
    with pytest.raises(InputError, match=re.escape("horizontal_force: found")):
        solve_swarm(line, height=DEPTH, horizontal_force=force, settings=SwarmSettings())


@pytest.mark.parametrize("length", [8.0, 9.5])
def test_a_line_that_does_not_reach_up(length: float) -> None:
    line = replace_length(BUOY, length)
    with pytest.raises(NoEquilibriumError) as caught:
        solve_swarm(line, height=DEPTH, horizontal_force=H, settings=SwarmSettings())
    assert caught.value.quantity == "length"
    assert caught.value.missing == DEPTH - length
    assert f"the line is {length:g} m long" in str(caught.value)


def replace_length(line: Line, length: float) -> Line:
    return Line([replace(line.segments[0], length=length)])
