"""A multi-objective particle swarm, from the building blocks of pyswarms.

The velocity rule and its coefficients are those of S1, with two changes that many objectives need
(C. A. Coello Coello et al., IEEE Trans. Evol. Comp. 8 (2004) 256): what a particle follows is not
the one best place but a leader, drawn for each from the front of all that was ever evaluated, the
lonelier of two; and a particle's own best place gives way to a new one that is not beaten by it.

Particles fly over real numbers, half a step beyond the first and last value of each gene; rounded,
a place is a design. In a space of whole numbers a swarm would soon come to rest on known designs,
so some particles are stirred at every turn, and so is each one that lands on a known design.
"""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from catopt.catenary.swarm.solve import velocity, without_logging
from catopt.checks.kinds import ROUNDING
from catopt.design.front import (
    Evaluated,
    EvaluationArchive,
    Floats,
    Genes,
    Problem,
    crowding_distance,
)
from catopt.design.steps import explore, scattered
from catopt.model import SwarmSettings

with without_logging():
    from pyswarms.backend.handlers import BoundaryHandler
    from pyswarms.backend.operators import compute_position
    from pyswarms.backend.swarms import Swarm

STIRRED = 0.15
"""Share of the particles that are stirred at every turn."""
STIRRINGS = 5
"""Times that a particle on a known design is stirred before it stays there."""
SPREAD = 5.0
"""Distribution index of the stirring (`_stir`)."""
PATIENCE = 20
"""Turns without a new design after which the swarm has come to rest."""


def _fly(
    archive: EvaluationArchive, until: float, population: int, generator: np.random.Generator
) -> None:
    """Fly until a share of the budget is spent or the swarm has come to rest."""
    problem = archive.problem
    upper = np.array(problem.sizes) - 0.5
    bounds = np.full(len(upper), -0.5), upper
    genes = scattered(problem, population, generator)
    flock = _at_rest(genes)
    with without_logging():
        handler = BoundaryHandler("reflective")
    best = archive.evaluate(genes)
    idle = 0
    while archive.share_spent < until and idle < PATIENCE:
        flock.best_pos = _leaders(archive, population, generator)
        flock.velocity = velocity(flock, generator.random((2, *genes.shape)))
        flock.position = compute_position(flock, bounds, handler)
        _stir(flock.position, generator.random(population) < STIRRED, bounds, generator)
        genes = _new_designs(archive, flock.position, bounds, generator)
        before = archive.evaluations
        best = _remember(flock, best, genes, archive.evaluate(genes), generator)
        idle = 0 if archive.evaluations > before else idle + 1


swarm = partial(explore, _fly)
"""Search a design space by a particle swarm, the population that of particles; as of
`catopt.design.steps.explore`."""


def _at_rest(genes: Genes) -> Swarm:
    """Swarm of particles at rest, each at its best place, with the coefficients of S1."""
    settings = SwarmSettings()
    options = {"w": settings.inertia, "c1": settings.cognitive, "c2": settings.social}
    places = genes.astype(np.float64)
    flock = Swarm(position=places, velocity=np.zeros(places.shape), options=options)
    flock.pbest_pos = places.copy()
    return flock


def _leaders(archive: EvaluationArchive, count: int, generator: np.random.Generator) -> Floats:
    """Place for each particle to follow: the lonelier of two designs of the front.

    While no design is feasible all follow the one of the least excess.
    """
    genes, objectives = archive.front
    if not len(genes):
        places: Floats = np.repeat(archive.closest.astype(np.float64), count, axis=0)
        return places
    loneliness = crowding_distance(objectives)
    first, second = generator.integers(len(genes), size=(2, count))
    chosen = np.where(loneliness[first] >= loneliness[second], first, second)
    leaders: Floats = genes[chosen].astype(np.float64)
    return leaders


def _new_designs(
    archive: EvaluationArchive,
    places: Floats,
    bounds: tuple[Floats, Floats],
    generator: np.random.Generator,
) -> Genes:
    """Designs at the particles' places, stirring (in place) those that are on known ones."""
    problem = archive.problem
    genes = _designs(problem, places)
    for _ in range(STIRRINGS):
        is_known = archive.is_known(genes)
        if not is_known.any():
            break
        _stir(places, is_known, bounds, generator)
        genes = _designs(problem, places)
    return genes


def _designs(problem: Problem, places: Floats) -> Genes:
    """Round places to designs."""
    genes = np.rint(places).astype(np.int64)
    return problem.canonical(np.clip(genes, 0, np.array(problem.sizes) - 1))


def _stir(
    places: Floats,
    is_stirred: NDArray[np.bool_],
    bounds: tuple[Floats, Floats],
    generator: np.random.Generator,
) -> None:
    """Move one or a few genes of the chosen particles, mostly a little and at times far.

    The step is that of polynomial mutation, (2 u)^(1/(eta + 1)) - 1 of the range or as much
    upwards (K. Deb and M. Goyal, Computer Science and Informatics 26 (1996) 30).
    """
    lower, upper = bounds
    stirred = places[is_stirred]
    count, genes = stirred.shape
    is_moved = generator.random(stirred.shape) < 1.0 / genes
    is_moved[np.arange(count), generator.integers(genes, size=count)] = True
    u = generator.random(stirred.shape)
    step = 1.0 - (2.0 * np.minimum(u, 1.0 - u)) ** (1.0 / (SPREAD + 1.0))
    step = np.where(u < 0.5, -step, step) * (upper - lower)
    places[is_stirred] = np.clip(stirred + is_moved * step, lower, upper)


def _remember(
    flock: Swarm, best: Evaluated, genes: Genes, worth: Evaluated, generator: np.random.Generator
) -> Evaluated:
    """Let each particle keep the better of its best and its new place; say what those are worth.

    Less excess is better, none is best; of two feasible places the one that beats the other, and
    either by chance when neither does.
    """
    new, old = worth.objectives, best.objectives
    exceedance = np.maximum(worth.exceedance, ROUNDING), np.maximum(best.exceedance, ROUNDING)
    are_feasible = (exceedance[0] == ROUNDING) & (exceedance[1] == ROUNDING)
    is_beaten = (old <= new).all(axis=1)
    beats = (new <= old).all(axis=1) & ~is_beaten
    by_chance = generator.random(len(genes)) < 0.5
    takes = np.where(are_feasible, beats | (~is_beaten & by_chance), exceedance[0] < exceedance[1])
    flock.pbest_pos[takes] = genes[takes]
    return Evaluated(
        np.where(takes[:, np.newaxis], new, old), np.where(takes, worth.exceedance, best.exceedance)
    )
