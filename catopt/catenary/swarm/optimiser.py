"""One run of the global-best particle swarm, from the building blocks of pyswarms.

The run is that of pyswarms' GlobalBestPSO, iteration for iteration (a test holds them against each
other), but its random numbers come from a generator of its own, it stops when f cannot fall any
more, and it keeps only the history that is wanted.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from threading import RLock
from typing import Any

import numpy as np

from catopt.catenary.swarm.objective import Array, Objective
from catopt.model import SwarmSettings

_VARIABLE = "LOG_CFG"
_NOTHING = Path(__file__).with_name("no-logging.yaml")
_LOCK = RLock()  # the environment belongs to the process: one thread at a time


@contextmanager
def without_logging() -> Iterator[None]:
    """Let pyswarms be imported and its objects be built without touching logging."""
    with _LOCK:
        before = os.environ.get(_VARIABLE)
        os.environ[_VARIABLE] = str(_NOTHING)
        try:
            yield
        finally:
            if before is None:
                del os.environ[_VARIABLE]
            else:
                os.environ[_VARIABLE] = before


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
