"""Solve one line by particle swarm, as S1 does, and say how well that went."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from threading import RLock
from typing import Any

import numpy as np

from catopt.catenary.equilibrium import BY_FORCE
from catopt.catenary.pieces import LineProblem, cut
from catopt.catenary.solution import Solution, SwarmReport
from catopt.catenary.solve import solution_of, solve
from catopt.catenary.swarm.objective import Array, Objective, objective_of
from catopt.errors import NoAnswerError, NotConvergedError
from catopt.model import Case, Line, SwarmSettings
from catopt.model.kinds import Findings
from catopt.threads import environment
from catopt.words import Message

_VARIABLE = "LOG_CFG"
_NOTHING = Path(__file__).with_name("no-logging.yaml")
_LOCK = RLock()  # the environment belongs to the process: one thread at a time


@contextmanager
def without_logging() -> Iterator[None]:
    """Let pyswarms be imported and its objects be built without touching logging."""
    with _LOCK, environment({_VARIABLE: str(_NOTHING)}):
        yield


with without_logging():
    from pyswarms.backend.handlers import BoundaryHandler
    from pyswarms.backend.operators import compute_pbest
    from pyswarms.backend.swarms import Swarm
    from pyswarms.backend.topology import Star

PATIENCE = 25
"""Iterations without a better place after which a run that is down to rounding stops."""


@dataclass(frozen=True)
class Run:
    """What one run found."""

    number: int  # counted from 1
    objective: float  # smallest f, m
    objectives: tuple[float, ...]  # smallest f so far after each iteration flown, m
    places: Array  # where that was: (iterations flown, unknowns)


def optimiser(objective: Objective, settings: SwarmSettings) -> Callable[[int], Run]:
    """Prepare the swarm; return what carries out one run, given its number.

    A run depends on the objective, the settings, its number and the seed, and on nothing else.
    """
    lower, upper = objective.bounds
    with without_logging():
        star = Star()
        handler = _SeededBoundaryHandler(settings.boundary)

    def run(number: int) -> Run:
        generator = np.random.default_rng((settings.seed, number))
        swarm = _scatter(lower, upper, settings, generator)
        handler.memory, handler.generator = swarm.position, generator
        objectives: list[float] = []
        places: list[Array] = []
        while True:
            swarm.current_cost = objective(swarm.position)
            swarm.pbest_pos, swarm.pbest_cost = compute_pbest(swarm)
            swarm.best_pos, swarm.best_cost = star.compute_gbest(swarm)
            objectives.append(float(swarm.best_cost))
            places.append(swarm.best_pos.copy())
            if len(objectives) >= settings.iterations or _converged(objectives, objective.rounding):
                break
            swarm.velocity = velocity(swarm, generator.random((2, *swarm.position.shape)))
            # pyswarms' handlers may miss a bound by rounding.
            moved = star.compute_position(swarm, (lower, upper), handler)
            swarm.position = np.clip(moved, lower, upper, out=moved)
        return Run(number, objectives[-1], tuple(objectives), np.array(places))

    return run


def _scatter(
    lower: Array, upper: Array, settings: SwarmSettings, generator: np.random.Generator
) -> Swarm:
    """Place the particles at random, evenly over the bounds and at rest.

    pyswarms' own start gives every coordinate a velocity of 0 to 1 in whatever unit it has. At
    rest, the same line in another unit of length gives the same run.
    """
    shape = (settings.particles, len(lower))
    swarm = Swarm(
        position=lower + (upper - lower) * generator.random(shape),
        velocity=np.zeros(shape),
        options={"c1": settings.cognitive, "c2": settings.social, "w": settings.inertia},
    )
    swarm.pbest_cost = np.full(settings.particles, np.inf)
    return swarm


def velocity(swarm: Swarm, draws: Array) -> Array:
    """Apply the velocity rule, with draws of 0 to 1 of shape (2, particles, unknowns).

    The best place that the swarm follows may be one for all or one for each particle.
    """
    options = swarm.options
    cognitive = options["c1"] * draws[0] * (swarm.pbest_pos - swarm.position)
    social = options["c2"] * draws[1] * (swarm.best_pos - swarm.position)
    velocity: Array = (options["w"] * swarm.velocity) + cognitive + social
    return velocity


def _converged(objectives: list[float], rounding: float) -> bool:
    """Whether f cannot fall any more: it is 0, or down to its rounding and at rest there."""
    best = objectives[-1]
    if best == 0.0:
        return True
    return best <= rounding and len(objectives) > PATIENCE and objectives[-1 - PATIENCE] == best


class _SeededBoundaryHandler(BoundaryHandler):  # type: ignore[misc]
    """pyswarms' ways back into the bounds, with "random" drawing from the run's own generator.

    pyswarms' own "random" draws from numpy's global state, and sends all particles that left in
    one iteration to the same place.
    """

    generator: np.random.Generator

    def random(self, position: Array, bounds: tuple[Array, Array], **_: Any) -> Array:
        """Give every particle beyond a bound a new place, at random within the bounds."""
        lower, upper = bounds
        out = ((position < lower) | (position > upper)).any(axis=1)
        draws = self.generator.random((int(out.sum()), position.shape[1]))
        position[out] = lower + (upper - lower) * draws
        return position


CONVERGED = 1e-9
"""m: a run that ends with f below this counts as converged."""

RESULT = 1e-6
"""m: a swarm whose best f is not below this has no result to give."""

SPAN_AGREEMENT = 1e-3
"""m: by how much the span may differ from S1 (5), S1 (11)."""

FORCES = (1e-50, 1e50)
"""N: beyond these, products of forces are more or less than a number can hold."""

RunsDone = Callable[[int], None]


def solve_swarm(
    line: Line,
    *,
    height: float,
    horizontal_force: float,
    settings: SwarmSettings,
    seabed_friction: float = 0.0,
    progress: RunsDone | None = None,
) -> Solution:
    """Solve one line by the particle swarm method of S1, carried to any line anchored on the bed.

    Where part of the line lies on the bed, the grounded length takes the place of the inclination
    at the anchor among the unknowns, and with it what the bed carries of a clump weight. The
    closed form says first whether such a line hangs at all, and at the end how far the swarm's
    answer is from its own; it has no part in the search. Run k depends only on the seed and k; the
    answer is that of the best run, with its `swarm` report.

    InputError: a number is out of range. NoEquilibriumError: the line does not reach up to the
    fairlead. NoAnswerError: a buoyant part lifts the line off the bed between its touchdown and
    the anchor; f holds for one stretch on the bed. NotConvergedError: no run came below f = 1e-6 m,
    or its span misses S1 (5) by 1e-3 m or more.
    """
    _check(line, height, horizontal_force, seabed_friction)
    closed_form = solve(
        line, height=height, horizontal_force=horizontal_force, seabed_friction=seabed_friction
    )
    if closed_form.regime in ("grounded-between", "grounded-in-parts"):
        raise NoAnswerError(Message("catenary.not_for_swarm"))
    pieces, segment_of = cut(line)
    objective = objective_of(pieces, height, horizontal_force)
    runs = _search(objective, settings, progress)
    place = runs.best.places[-1]
    excess = objective.excess(place)
    _verify(runs, excess, settings)
    state = objective.state(place, seabed_friction)
    solution = solution_of(
        state._replace(span=state.span + excess),
        line,
        LineProblem(pieces, 0.0, height, seabed_friction),
        segment_of,
        method="pso",
        known=BY_FORCE,
    )
    difference = _less(solution, closed_form)
    return replace(solution, swarm=_report(objective, runs, settings, excess, difference))


def _check(line: Line, height: float, horizontal_force: float, seabed_friction: float) -> None:
    found = Findings("solve_swarm")
    found.number("height", height, "m", above=0.0)
    found.number("horizontal_force", horizontal_force, "N", above=0.0)
    found.number("seabed_friction", seabed_friction, "", at_least=0.0)
    found.raise_if_any()
    weight = sum(abs(part.submerged_weight) * part.length for part in line.segments)
    weight += sum(abs(load.submerged_weight) for load in line.point_loads)
    least, most = FORCES
    if not (least <= horizontal_force and horizontal_force + weight <= most):
        said = Message("refused_motion.weighs", force=horizontal_force, weight=weight)
        allowed = Message("refused_motion.forces_from_n_are_carried", least=least, most=most)
        found.add("horizontal_force", said, allowed)
    found.raise_if_any()


@dataclass(frozen=True)
class _Runs:
    """Every run's last f (m) and number of iterations, and the best run in full."""

    objectives: tuple[float, ...]
    iterations: tuple[int, ...]
    best: Run


def _search(objective: Objective, settings: SwarmSettings, progress: RunsDone | None) -> _Runs:
    run = optimiser(objective, settings)
    best: Run | None = None
    ends = []
    for number in range(1, settings.runs + 1):
        found = run(number)
        ends.append((found.objective, len(found.objectives)))
        if best is None or found.objective < best.objective:
            best = found
        if progress is not None:
            progress(number)
    assert best is not None
    objectives, iterations = zip(*ends, strict=True)
    return _Runs(objectives, iterations, best)


def _verify(runs: _Runs, excess: float, settings: SwarmSettings) -> None:
    """Hold the best place against f = 0 and S1 (11)."""
    effort = Message(
        "catenary.effort",
        runs=Message("catenary.runs", count=settings.runs),
        particles=settings.particles,
        iterations=Message("catenary.iterations", count=settings.iterations),
    )
    reported = {"effort": effort, "way_out": Message("catenary.swarm_way_out")}
    if not (f := runs.best.objective) < RESULT:
        raise NotConvergedError(Message("catenary.swarm_misses", f=f, limit=RESULT, **reported))
    if not abs(excess) < SPAN_AGREEMENT:
        values = {"excess": abs(excess), "limit": SPAN_AGREEMENT}
        raise NotConvergedError(Message("catenary.swarm_span", **values, **reported))


def _less(solution: Solution, closed_form: Solution) -> dict[str, float]:
    """Swarm less closed form, in what both found."""
    unknown = {"angle_rad": solution.anchor.angle - closed_form.anchor.angle}
    if solution.regime == "grounded":
        unknown = {"grounded_length_m": solution.grounded_length - closed_form.grounded_length}
    return {
        **unknown,
        "span_m": solution.span - closed_form.span,
        "tension_N": solution.fairlead.tension - closed_form.fairlead.tension,
    }


def _report(
    objective: Objective,
    runs: _Runs,
    settings: SwarmSettings,
    excess: float,
    difference: dict[str, float],
) -> SwarmReport:
    H = objective.horizontal_force
    return SwarmReport(
        objective=runs.best.objective,
        evaluations=settings.particles * sum(runs.iterations),
        iterations=settings.iterations,
        runs=settings.runs,
        seed=settings.seed,
        converged_runs=sum(f < CONVERGED for f in runs.objectives),
        best_run=runs.best.number,
        objectives=runs.objectives,
        span_consistency=abs(excess),
        closed_form_difference=difference,
        best_objective_history=runs.best.objectives,
        tension_history=tuple(
            math.hypot(H, V) for V in objective.vertical_force(runs.best.places).tolist()
        ),
        iterations_flown=runs.iterations,
    )


def solve_case_by_swarm(case: Case, *, progress: Callable[[int], None] | None = None) -> Solution:
    """Solve a case by the particle swarm method of S1; errors as for `solve_swarm`.

    The horizontal force is known and the anchor on the bed: S1 has no other.
    """
    found = Findings("swarm")
    if case.find is not None:
        allowed = Message("refused_motion.swarm_method_seeks_nothing_closed")
        found.add("find", case.find.quantity, allowed)
    force = None if case.load is None else case.load.horizontal_force
    if force is None:
        allowed = Message("refused_motion.swarm_method_wants_one_closed")
        found.add("load", Message("refused_motion.no_horizontal_force"), allowed)
    if case.anchor_height != 0.0:
        allowed = Message("refused_motion.swarm_method_has_anchor_on")
        found.add("line.anchor_height", f"{case.anchor_height:g} m", allowed)
    found.raise_if_any()
    assert force is not None
    return solve_swarm(
        case.line,
        height=case.fairlead_height,
        horizontal_force=force,
        settings=case.swarm,
        seabed_friction=case.site.seabed_friction,
        progress=progress,
    )
