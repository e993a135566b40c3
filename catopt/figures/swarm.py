"""How the best run of a swarm converged."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from catopt.figures.chart import IN_TONNES, Axis, Chart, Level, Series, axis, pointed, span_of
from catopt.quantities import Quantity
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.solution import SwarmReport

_CONVERGED = 1e-9
_MOST_POINTS = 400
COUNT = Quantity("count", "Number", "", "-", "-", 1.0, 0)
"""A whole number along an axis."""


def fitness(swarm: SwarmReport) -> Chart:
    """Draw the best objective over the iterations, logarithmic (figure 3 of S1).

    It ends where the run has converged: what f is further on, rounding decides, and each processor
    rounds in its own way.
    """
    history = [float(f"{f:.4g}") for f in swarm.best_objective_history[: _shown(swarm)]]
    powers = [math.log10(f) for f in (*history, _CONVERGED)]
    low, high = math.floor(min(powers) + 1e-9), math.ceil(max(powers) - 1e-9)
    size = max(high - low, 1)
    step = max(1, math.ceil((size + 1) / 8))
    ticks = tuple(10.0**power for power in range(low + size, low - 1, -step))
    ends, up = (10.0**low, 10.0 ** (low + size)), Message("figures.best_objective")
    return _over_iterations(
        swarm,
        history,
        "figures.run",
        Level("limit", "y", _CONVERGED, Message("figures.converged")),
        name="swarm",
        title=Message("figures.fitness"),
        y=axis("objective", ends, up, foot=0.0, ticks=ticks),
    )


def swarm_tension(swarm: SwarmReport, closed_form: float) -> Chart:
    """Draw the fairlead tension over the iterations (figure 4 of S1); `closed_form` is in N."""
    history = [float(f"{T:.6g}") for T in swarm.tension_history[: _shown(swarm)]]
    exact = Message("figures.closed_form", T=Measure("tension", closed_form))
    ends = span_of([*history, closed_form], 0.15, 0.15)
    return _over_iterations(
        swarm,
        history,
        "figures.best_particle",
        Level("limit", "y", closed_form, exact),
        name="swarm_tension",
        title=Message("figures.swarm_tension"),
        y=axis("tension", ends, Message("figures.fairlead_tension_axis"), second=IN_TONNES),
    )


def _over_iterations(
    swarm: SwarmReport, history: Sequence[float], label: str, level: Level, **how: Any
) -> Chart:
    """Draw a history; say what is known of all of a few iterations, of some of many."""
    shown, count = _shown(swarm), len(history)
    stopped = Message("figures.stopped", iteration=shown + 1, iterations=swarm.iterations)
    step = max(1, math.ceil(count / _MOST_POINTS))
    chosen = sorted({*range(1, count + 1, step), count} - {0})
    iterations, run = range(1, count + 1), swarm.best_run
    return Chart(
        x=Axis(Message("figures.iteration"), COUNT, 0.0, float(max(shown + 1, 2))),
        series=(Series("first", iterations, history, Message(label, run=run)),),
        levels=(level,),
        points=pointed(
            "figures.iteration_at",
            chosen,
            [history[n - 1] for n in chosen],
            iteration=("", chosen),
            f=("objective", [swarm.best_objective_history[n - 1] for n in chosen]),
            T=("tension", [swarm.tension_history[n - 1] for n in chosen]),
        ),
        notes=(stopped,) if shown < len(swarm.best_objective_history) else (),
        **how,
    )


def _shown(swarm: SwarmReport) -> int:
    """Count the iterations before the one at which the run has converged."""
    return sum(f >= _CONVERGED for f in swarm.best_objective_history)
