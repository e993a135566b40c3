"""Solve one line by particle swarm, as S1 does, and say how well that went."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from catopt.catenary.layout import end_of
from catopt.catenary.solution import (
    EndState,
    Residual,
    SegmentState,
    Solution,
    Stretch,
    SwarmReport,
)
from catopt.catenary.swarm.objective import Objective, Shape, objective_of
from catopt.catenary.warnings import plausibility
from catopt.errors import NoEquilibriumError, NotConvergedError
from catopt.model import Line, SwarmSettings
from catopt.model.validity import Findings

if TYPE_CHECKING:
    from catopt.catenary.swarm.optimiser import Run

__all__ = ["CONVERGED", "RESULT", "SPAN_AGREEMENT", "solve_swarm"]

CONVERGED = 1e-9
"""m: a run that ends with f below this counts as converged."""

RESULT = 1e-6
"""m: a swarm whose best f is not below this has no result to give."""

SPAN_AGREEMENT = 1e-3
"""m: by how much the span may differ from S1 (5), S1 (11)."""

_CARRIED = (
    "the swarm method carries one uniform inextensible segment without point loads today; "
    "the closed form carries this line"
)

Progress = Callable[[int], None]


def solve_swarm(
    line: Line,
    *,
    height: float,
    horizontal_force: float,
    settings: SwarmSettings,
    progress: Progress | None = None,
) -> Solution:
    """Solve one line by the particle swarm method of S1.

    The anchor is on the bed. Where part of the line lies there, too, the grounded length takes the
    place of the inclination at the anchor among the unknowns.

    Parameters
    ----------
    line : Line
        One segment that does not stretch, without point loads.
    height : float
        Height of the fairlead above the anchor, m.
    horizontal_force : float
        N.
    settings : SwarmSettings
        Of the swarm. Run k depends only on the seed and k.
    progress : callable, optional
        Called after each run with the number of runs done.

    Returns
    -------
    Solution
        Of the best run, with its `swarm` report.

    Raises
    ------
    InputError
        When the line is not one that the method carries, or a number is out of range.
    NoEquilibriumError
        When the line does not reach up to the fairlead.
    NotConvergedError
        When no run came below f = 1e-6 m, or its span misses S1 (5) by 1e-3 m or more.
    """
    _check(line, height, horizontal_force)
    (segment,) = line.segments
    objective = objective_of(line.length, height, horizontal_force, segment.submerged_weight)
    runs = _search(objective, settings, progress)
    shape = objective.shape(runs.best.places[-1])
    _verify(objective, shape, runs, settings)
    solution = _solution(line, objective, shape)
    report = _report(objective, runs, settings, _less_closed_form(solution))
    return replace(solution, swarm=report).with_warnings(plausibility(solution))


def _check(line: Line, height: float, horizontal_force: float) -> None:
    found = Findings("solve_swarm")
    if len(line.segments) != 1:
        found.add("line.segments", f"{len(line.segments)} of them", _CARRIED)
    if line.point_loads:
        found.add("line.point_loads", f"{len(line.point_loads)} of them", _CARRIED)
    for index, segment in enumerate(line.segments):
        key = f"line.segments[{index}]"
        if math.isfinite(segment.EA):
            found.add(f"{key}.EA", f"{segment.EA:g} N", _CARRIED)
        found.number(f"{key}.submerged_weight", segment.submerged_weight, "N/m", above=0.0)
    found.number("height", height, "m", above=0.0)
    found.number("horizontal_force", horizontal_force, "N", above=0.0)
    found.raise_if_any()
    a = horizontal_force / line.segments[0].submerged_weight
    if not (0.0 < a < math.inf and 0.0 < line.length / a < math.inf):
        found.add("horizontal_force", f"{horizontal_force:g} N", "beyond what a number can hold")
    found.raise_if_any()
    if line.length <= height:
        missing = height - line.length
        raise NoEquilibriumError(
            f"the line is {line.length:.6g} m long and the fairlead {height:.6g} m above the "
            f"anchor: it needs more than that, {missing:.6g} m are missing",
            "length",
            missing,
        )


@dataclass(frozen=True)
class _Runs:
    """Every run's last f (m) and number of iterations, and the best run in full."""

    objectives: tuple[float, ...]
    iterations: tuple[int, ...]
    best: Run


def _search(objective: Objective, settings: SwarmSettings, progress: Progress | None) -> _Runs:
    from catopt.catenary.swarm.optimiser import optimiser

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


def _verify(objective: Objective, shape: Shape, runs: _Runs, settings: SwarmSettings) -> None:
    """Hold the best place against f = 0 and S1 (11)."""
    effort = (
        f"{settings.runs} run{'s' * (settings.runs > 1)} of {settings.particles} particles and "
        f"{settings.iterations} iteration{'s' * (settings.iterations > 1)}"
    )
    way_out = "Give it more particles, iterations or runs, or take the closed form."
    if not runs.best.objective < RESULT:
        raise NotConvergedError(
            f"the swarm did not converge: the smallest f of {effort} is "
            f"{runs.best.objective:.3g} m, and only below {RESULT:g} m is it a result. {way_out}"
        )
    off = _span_consistency(objective, shape)
    if not off < SPAN_AGREEMENT:
        raise NotConvergedError(
            f"the swarm did not converge: after {effort} its span differs by {off:.3g} m from "
            f"that of S1 (5), and only below {SPAN_AGREEMENT:g} m is it a result. {way_out}"
        )


def _span_consistency(objective: Objective, shape: Shape) -> float:
    return abs(shape.span - objective.span_by_length(shape))


def _solution(line: Line, objective: Objective, shape: Shape) -> Solution:
    """Fill in the solution from the place found; nothing is improved on it."""
    (segment,) = line.segments
    H, V = objective.horizontal_force, objective.vertical_force(shape)
    V_anchor = H * math.tan(shape.angle)
    tension = objective.tension(shape)
    stretches = _stretches(objective, shape)
    x, z = end_of(stretches[-1], stretches[-1].length)
    return Solution(
        line=line,
        method="pso",
        regime="grounded" if shape.grounded_length > 0.0 else "suspended",
        fairlead_height=objective.height,
        anchor_height=0.0,
        seabed_friction=0.0,
        span=shape.span,
        fairlead=EndState(tension, H, V, math.atan2(V, H)),
        anchor=EndState(math.hypot(H, V_anchor), H, V_anchor, shape.angle),
        grounded_length=shape.grounded_length,
        suspended_length=line.length - shape.grounded_length,
        stretched_length=line.length,
        segments=(SegmentState(segment.name, segment.length, tension, segment.MBL),),
        point_loads=(),
        stretches=stretches,
        residual=Residual(height=z - objective.height, span=x - shape.span),
    )


def _stretches(objective: Objective, shape: Shape) -> tuple[Stretch, ...]:
    """Lay out what lies on the bed, if any, and what hangs."""
    H, w, grounded = objective.horizontal_force, objective.submerged_weight, shape.grounded_length
    on_bed = Stretch(0.0, grounded, w, 0.0, 0.0, 0.0, H, 0.0, 0.0, on_bed=True)
    hanging = Stretch(
        start=grounded,
        length=objective.length - grounded,
        submerged_weight=w,
        compliance=0.0,
        x=grounded,
        z=0.0,
        horizontal_force=H,
        vertical_force=H * math.tan(shape.angle),
        friction=0.0,
        on_bed=False,
    )
    return (on_bed, hanging) if grounded > 0.0 else (hanging,)


def _less_closed_form(solution: Solution) -> dict[str, float]:
    """Swarm less closed form, in what both found."""
    from catopt.catenary.solve import solve

    exact = solve(
        solution.line,
        height=solution.fairlead_height,
        horizontal_force=solution.horizontal_force,
    )
    unknown = (
        {"grounded_length_m": solution.grounded_length - exact.grounded_length}
        if solution.regime == "grounded"
        else {"angle_rad": solution.anchor.angle - exact.anchor.angle}
    )
    return {
        **unknown,
        "span_m": solution.span - exact.span,
        "tension_N": solution.fairlead.tension - exact.fairlead.tension,
    }


def _report(
    objective: Objective, runs: _Runs, settings: SwarmSettings, difference: dict[str, float]
) -> SwarmReport:
    shapes = [objective.shape(place) for place in runs.best.places]
    return SwarmReport(
        objective=runs.best.objective,
        evaluations=settings.particles * sum(runs.iterations),
        iterations=settings.iterations,
        runs=settings.runs,
        seed=settings.seed,
        converged_runs=sum(f < CONVERGED for f in runs.objectives),
        best_run=runs.best.number,
        objectives=runs.objectives,
        span_consistency=_span_consistency(objective, shapes[-1]),
        closed_form_difference=difference,
        best_objective_history=runs.best.objectives,
        tension_history=tuple(objective.tension(shape) for shape in shapes),
        iterations_flown=runs.iterations,
    )
