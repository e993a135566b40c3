"""Designs evaluated in one call: whole numbers in, objectives and excess out."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from catopt.catenary.batch import in_ranges
from catopt.checks.case import LOAD, check_line
from catopt.checks.criteria import criteria_of
from catopt.checks.remarks import NO_CHECK
from catopt.checks.result import CheckReport
from catopt.compiled import compiled
from catopt.design.assess import COST, EXCURSION, MASS, OFFSET, assess
from catopt.design.options import resolve
from catopt.design.problem import Evaluated, Floats, Genes
from catopt.design.sinkers import sinker, with_a_sinker
from catopt.design.space import DesignSpace
from catopt.design.tables import Tables, room, tables_of
from catopt.model import Anchor, Case, LoadCase
from catopt.model.validity import Findings
from catopt.words import Message

OBJECTIVE_KEYS: Final = {
    "mass": "mass_kg",
    "offset": "offset_m",
    "excursion": "excursion_m",
    "cost": "cost_USD",
}
"""Key of each objective in results and documents."""

_OBJECTIVE_WORDS: Final = {
    "mass": "design.objective_mass",
    "offset": "design.objective_offset",
    "excursion": "design.objective_excursion",
    "cost": "design.objective_cost",
}

_A_PIECE = 4e-5
"""Time that a segment or clump weight of a design takes in one load case as plain Python, s."""

_COLUMNS: Final = {"mass": MASS, "offset": OFFSET, "excursion": EXCURSION, "cost": COST}
OBJECTIVE_COUNT: Final = len(_COLUMNS)


LEAST_SHARE: Final = 1000
"""Designs a thread, below which starting it costs more than it saves."""


def objective_words(name: str) -> Message:
    """Return what an objective is called in a sentence."""
    return Message(_OBJECTIVE_WORDS[name])


class Assessed(NamedTuple):
    """All that one pass over designs gives.

    Attributes
    ----------
    objectives : ndarray, shape (n, 4)
        Mass (kg), offset, excursion (m) and cost (USD), wanted or not.
    excess : ndarray, shape (n,)
        As in `Evaluated`.
    sinker : ndarray of int, shape (n,)
        The lightest that holds, or the heaviest; -1 where there is none.
    unsolved : int
        How many lines did not converge.
    excluded : tuple of int
        How many designs each of `catopt.design.bounds.BOUNDS` has excluded; empty for single lines,
        which have none.
    """

    objectives: Floats
    excess: Floats
    sinker: NDArray[np.int64]
    unsolved: int
    excluded: tuple[int, ...] = ()


@dataclass(frozen=True)
class DesignProblem:
    """A case's design space with its evaluation; serves `catopt.design.problem.Problem`.

    Attributes
    ----------
    case : Case
        What is asked.
    states : tuple of LoadCase
        Those of the case, or its load as the only one.
    space : DesignSpace
        All designs.
    tables : Tables
        The same as plain arrays, with load cases and limits.
    warnings : tuple of str
        What an engineer should know of the figures.
    """

    case: Case
    states: tuple[LoadCase, ...]
    space: DesignSpace
    tables: Tables
    warnings: tuple[str, ...] = ()

    @classmethod
    def of(cls, case: Case) -> DesignProblem:
        """Make the problem of a case; what the case seeks of its own line is left alone.

        InputError: the case has no design or no known horizontal force, or lacks what its
        objectives or checks need; all errors of that kind are reported at once.
        """
        states = load_cases_of(case)
        case = replace(case, find=None)
        assert case.design is not None
        checked = with_a_sinker(case)
        key = "anchor" if case.design.sinker is None else "design.sinker"
        criteria = criteria_of(checked, anchor_key=key)
        space, remarks = resolve(case, criteria, states)
        tables = tables_of(checked, states, space, criteria, case.design.sinker)
        warnings = (*remarks, *criteria.warnings)
        if not criteria.all:
            warnings = (*warnings, Message(NO_CHECK))
        return cls(case, states, space, tables, warnings)

    @property
    def sizes(self) -> tuple[int, ...]:
        """How many values each gene has."""
        return self.space.sizes

    @property
    def names(self) -> tuple[str, ...]:
        """The objectives, as the case has them."""
        assert self.case.design is not None
        return self.case.design.objectives

    @property
    def objectives(self) -> int:
        """How many objectives there are."""
        return len(self.names)

    @property
    def known(self) -> tuple[str, ...]:
        """Objectives that every design has a figure for, wanted or not; the wanted ones first."""
        options = [option for variable in self.space.segments for option in variable.options]
        there = {
            "mass": all(option.mass is not None for option in options),
            "offset": True,
            "excursion": any(state.kind == "reference" for state in self.states),
            "cost": all(option.price is not None for option in options),
        }
        others = (name for name, is_there in there.items() if is_there and name not in self.names)
        return (*self.names, *others)

    @property
    def columns(self) -> list[int]:
        """Columns of `Assessed.objectives` that are made small."""
        return [_COLUMNS[name] for name in self.names]

    def canonical(self, genes: Genes) -> Genes:
        """Set genes that do not matter to 0."""
        return self.space.canonical(genes)

    def evaluate(self, genes: Genes) -> Evaluated:
        """Solve and check many designs in all load cases."""
        assessed = self.assess(genes)
        return Evaluated(assessed.objectives[:, self.columns], assessed.excess)

    def assess(
        self,
        genes: Genes,
        *,
        stops_early: bool = False,
        workers: int = 1,
        of: int = 0,
        best: Floats | None = None,  # noqa: ARG002 - a line is solved sooner than a bound is found
    ) -> Assessed:
        """Solve and check many designs, of shape (n, genes).

        Of so many in all, where that is known, with `of`. Where a design is left at its first
        failed check, its objectives are nan, and its excess is above ROUNDING but not the largest.
        What is feasible stays the same, and with any number of threads.
        """
        genes = np.ascontiguousarray(genes, dtype=np.int64)
        count = len(genes)
        objectives, excess = np.empty((count, OBJECTIVE_COUNT)), np.empty(count)
        sinkers = np.empty(count, dtype=np.int64)
        lines = max(of, count) * len(self.states)
        loop = compiled(assess, _A_PIECE * len(self.space.variables) * lines)

        def run(first: int, end: int) -> int:
            left = np.zeros(1, dtype=np.int64)
            tables, space = self.tables, room(self.tables)
            loop(genes, tables, space, stops_early, first, end, objectives, excess, sinkers, left)
            return int(left[0])

        unsolved = sum(in_ranges(run, 0, count, workers, LEAST_SHARE))
        return Assessed(objectives, excess, sinkers, unsolved)

    def batches(self, chunk: int) -> Iterator[Genes]:
        """Yield all designs, so many at once."""
        for first in range(0, self.space.count, chunk):
            yield self.space.genes_between(first, min(first + chunk, self.space.count))

    def check(self, genes: tuple[int, ...]) -> CheckReport:
        """Check a design in plain closed form; errors as for `check_case`."""
        return check_line(self.space.line(genes), self.case, self.anchor(genes))

    def anchor(self, genes: tuple[int, ...]) -> Anchor | None:
        """Return the anchor of a design: the sinker chosen for it, or that of the case."""
        assert self.case.design is not None
        if self.case.design.sinker is None:
            return self.case.anchor
        index = int(self.assess(np.array([genes])).sinker[0])
        return sinker(self.case.design.sinker, index, self.case.site.water_density)


def load_cases_of(case: Case) -> tuple[LoadCase, ...]:
    """List the load cases of a case with a design: its own, or its load as the only one.

    InputError: no design, no known horizontal force, or no reference for an excursion.
    """
    found = Findings("design")
    if case.design is None:
        found.add("design", "", "missing; a table [design] says what may vary")
    elif "excursion" in case.design.objectives and not any(
        state.kind == "reference" for state in case.load_cases
    ):
        allowed = 'a load case of kind "reference" is wanted, which excursions start from'
        found.add("design.objectives", "excursion", allowed)
    force = None if case.load is None else case.load.horizontal_force
    if not case.load_cases and force is None:
        allowed = "missing; load cases, or a load with its horizontal_force, are wanted"
        found.add("load_cases", "", allowed)
    found.raise_if_any()
    if case.load_cases:
        return case.load_cases
    assert force is not None
    return (LoadCase(LOAD, force),)
