"""NSGA-II over whole numbers, by pymoo (K. Deb et al., IEEE Trans. Evol. Comp. 6 (2002) 182).

pymoo's simulated binary crossover and polynomial mutation give real numbers; these are rounded and
made canonical, and offspring that were evaluated before are bred anew. A design with any excess
loses to one with less and to every feasible one (constrained domination). What is returned is not
pymoo's last population but the front of all that was ever evaluated.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pymoo.algorithms.moo.nsga2 import NSGA2
from pymoo.config import Config
from pymoo.core.duplicate import DuplicateElimination, NoDuplicateElimination
from pymoo.core.problem import Problem as PymooProblem
from pymoo.core.repair import Repair
from pymoo.core.termination import NoTermination
from pymoo.operators.crossover.sbx import SBX
from pymoo.operators.mutation.pm import PM

from catopt.checks.kinds import ROUNDING
from catopt.design.front import EvaluationArchive, Genes
from catopt.design.steps import explore, scattered

CROSSOVER_PROBABILITY = 0.9
SPREAD = 3.0
"""Distribution index of crossover and mutation, the usual one for whole numbers: at the 15 to 20
that suit real numbers most offspring round to their parents."""
BREEDINGS = 20
"""Times that known offspring are bred anew before a generation makes do with fewer."""

# On an interpreter for which pymoo has no compiled parts it would print a hint.
Config.warnings["not_compiled"] = False


def _evolve(
    archive: EvaluationArchive, until: float, population: int, generator: np.random.Generator
) -> None:
    """Evolve until a share of the budget is spent or there are no new designs."""
    algorithm = _algorithm(archive, population, generator)
    while archive.share_spent < until:
        algorithm.next()
        if not algorithm.has_next():
            return


nsga2 = partial(explore, _evolve)
"""Search a design space by NSGA-II; as of `catopt.design.steps.explore`."""


def _algorithm(archive: EvaluationArchive, population: int, generator: np.random.Generator) -> Any:
    """Set up pymoo's algorithm, at its start."""
    # Designs all over the space; after the first round half of them, or fewer, of the front.
    genes = scattered(archive.problem, population, generator)
    front = generator.permutation(archive.front.genes)[: population // 2]
    genes[: len(front)] = front
    algorithm = NSGA2(
        pop_size=population,
        sampling=genes,
        crossover=SBX(prob=CROSSOVER_PROBABILITY, eta=SPREAD),
        mutation=PM(eta=SPREAD),
        repair=_Rounding(),
        eliminate_duplicates=NoDuplicateElimination(),
    )
    # The first generation may hold known designs, its offspring not.
    algorithm.mating.eliminate_duplicates = _KnownElimination(archive)
    algorithm.mating.n_max_iterations = BREEDINGS
    algorithm.setup(_Space(archive), termination=NoTermination())
    algorithm.random_state = generator
    return algorithm


class _Space(PymooProblem):  # type: ignore[misc]
    """The design space as pymoo wants it: real variables, one constraint."""

    def __init__(self, archive: EvaluationArchive) -> None:
        sizes = archive.problem.sizes
        super().__init__(
            n_var=len(sizes),
            n_obj=archive.problem.objectives,
            n_ieq_constr=1,
            xl=np.zeros(len(sizes)),
            xu=np.array(sizes) - 1.0,
        )
        self.archive = archive

    def _evaluate(self, x: Genes, out: dict[str, Any], *_: Any, **__: Any) -> None:
        objectives, exceedance = self.archive.evaluate(x.astype(np.int64))
        # Of an infeasible design pymoo compares the constraint alone, but sorts do not like nan.
        out["F"] = np.nan_to_num(objectives)
        out["G"] = (exceedance - ROUNDING)[:, np.newaxis]


class _Rounding(Repair):  # type: ignore[misc]
    """Makes real variables a canonical design."""

    def _do(self, problem: _Space, X: NDArray[Any], **_: Any) -> Genes:
        space = problem.archive.problem
        return space.canonical(np.rint(X).astype(np.int64))


class _KnownElimination(DuplicateElimination):  # type: ignore[misc]
    """Leaves out offspring that are equal to each other or were evaluated before."""

    def __init__(self, archive: EvaluationArchive) -> None:
        super().__init__()
        self.archive = archive

    def _do(self, pop: Any, other: Any, is_duplicate: NDArray[np.bool_]) -> NDArray[np.bool_]:
        genes = pop.get("X").astype(np.int64)
        others = () if other is None else other.get("X").astype(np.int64)
        seen = {each.tobytes() for each in others}
        for k, each in enumerate(genes):
            key = each.tobytes()
            is_duplicate[k] |= key in seen
            if other is None:
                seen.add(key)
        return is_duplicate | self.archive.is_known(genes)
