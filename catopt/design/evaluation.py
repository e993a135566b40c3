"""Designs evaluated in one call: whole numbers in, objectives and excess out."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from catopt.catenary.batch import in_ranges
from catopt.checks.case import LOAD, check_line
from catopt.checks.criteria import criteria_of
from catopt.checks.evaluation import NO_CHECK
from catopt.compiled import compiled
from catopt.design.assess import ANCHOR_LOAD, COST, EXCURSION, LENGTH, MASS, OFFSET, assess
from catopt.design.front import Evaluated, Floats, Genes
from catopt.design.result import OBJECTIVES_MADE, DesignLoadCase, DesignPoint, Neighbour
from catopt.design.space import DesignSpace, resolve
from catopt.design.tables import Tables, room, tables_of
from catopt.errors import CatoptError
from catopt.model import Anchor, Case, Design, Line, LoadCase, SinkerChoice
from catopt.model.kinds import Findings
from catopt.model.line import weight_in_water
from catopt.words import Message

OBJECTIVE_KEYS: Final = {key.rpartition("_")[0]: key for key in OBJECTIVES_MADE}
"""Key of each objective in results and documents."""

_A_PIECE = 4e-5
"""Time that a segment or clump weight of a design takes in one load case as plain Python, s."""

_COLUMNS: Final = {
    "mass": MASS,
    "offset": OFFSET,
    "excursion": EXCURSION,
    "cost": COST,
    "length": LENGTH,
    "anchor_load": ANCHOR_LOAD,
}

AGREEMENT = 1e-8
"""By how much the compiled loop and the closed form in plain Python may differ, relatively: both
end their roots at 1e-12 of the line's length or better."""

LEAST_SHARE: Final = 1000
"""Designs a thread, below which starting it costs more than it saves."""


def objective_words(name: str) -> Message:
    """Return what an objective is called in a sentence."""
    return Message(f"design.objective_{name}")


class Assessed(NamedTuple):
    """All that one pass over designs gives."""

    # shape (n, 6): mass (kg), offset, excursion (m), cost (USD), length (m) and the
    # anchor's load (N), wanted or not
    objectives: Floats
    exceedance: Floats  # shape (n,): as in `Evaluated`
    # shape (n,): the lightest that holds, or the heaviest; -1: there is none
    sinker: NDArray[np.int64]
    unsolved: int  # lines that did not converge
    excluded: tuple[int, ...] = ()  # designs by bound (`catopt.design.assess.BOUNDS`), of moorings


@dataclass(frozen=True)
class DesignProblem:
    """A case's design space with its evaluation; serves `catopt.design.front.Problem`."""

    case: Case
    states: tuple[LoadCase, ...]  # those of the case, or its load as the only one
    space: DesignSpace
    tables: Tables
    warnings: tuple[str, ...]  # what an engineer should know of the figures

    least_share: ClassVar[int] = LEAST_SHARE

    @classmethod
    def of(cls, case: Case) -> DesignProblem:
        """Make the problem of a case; what the case seeks of its own line is left alone.

        InputError: the case has no design or no known horizontal force, or lacks what its
        objectives or checks need; all errors of that kind are reported at once.
        """
        states = load_cases_of(case)
        case = replace(case, find=None)
        assert case.design is not None
        sinkers = case.design.sinker
        # All sinkers have the same factors, which is all that the criteria want of an anchor.
        checked = case if sinkers is None else replace(case, anchor=sinker_of(case, sinkers, 0))
        criteria = criteria_of(checked, anchor_key="anchor" if sinkers is None else "design.sinker")
        space, remarks = resolve(case, criteria, states)
        tables = tables_of(checked, states, space, criteria, sinkers)
        nothing = () if criteria.all else (Message(NO_CHECK),)
        return cls(case, states, space, tables, (*remarks, *criteria.warnings, *nothing))

    @property
    def design(self) -> Design:
        """What may vary and what is made small."""
        assert self.case.design is not None
        return self.case.design

    @property
    def sizes(self) -> tuple[int, ...]:
        """How many values each gene has."""
        return self.space.sizes

    @property
    def names(self) -> tuple[str, ...]:
        """The objectives, as the case has them."""
        return self.design.objectives

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
        return Evaluated(assessed.objectives[:, self.columns], assessed.exceedance)

    def assess(
        self,
        genes: Genes,
        *,
        stops_early: bool = False,
        workers: int = 1,
        of: int = 0,
        best: Floats | None = None,
    ) -> Assessed:
        """Solve and check many designs, of shape (n, genes).

        Of so many in all, where that is known, with `of`. Where a design is left at its first
        failed check, its objectives are nan, and its excess is above ROUNDING but not the largest.
        What is feasible stays the same, and with any number of threads. `best` is what designs
        known to be feasible are worth, by which bounds exclude others; None: none is excluded.
        """
        genes = np.ascontiguousarray(genes, dtype=np.int64)
        count = len(genes)
        objectives, exceedance = np.empty((count, len(_COLUMNS))), np.empty(count)
        chosen = np.empty(count, dtype=np.int64)
        loop, given = self._loop(max(of, count), stops_early, best)

        def run(first: int, end: int) -> int:
            unsolved = np.zeros(1, dtype=np.int64)
            loop(genes, *given(), first, end, objectives, exceedance, chosen, unsolved)
            return int(unsolved[0])

        unsolved = sum(in_ranges(run, 0, count, workers, self.least_share))
        return Assessed(objectives, exceedance, chosen, unsolved)

    def _loop(
        self,
        designs: int,
        stops_early: bool,
        best: Floats | None,  # noqa: ARG002 - a line is solved sooner than a bound is found
    ) -> tuple[Callable[..., None], Callable[[], tuple[Any, ...]]]:
        """Return the loop over so many designs, and what makes its tables and a thread's room."""
        work = _A_PIECE * len(self.space.variables) * designs * len(self.states)
        return compiled(assess, work), lambda: (self.tables, room(self.tables), stops_early)

    def batches(self, chunk: int) -> Iterator[Genes]:
        """Yield all designs, so many at once."""
        for first in range(0, self.space.count, chunk):
            yield self.space.genes_between(first, min(first + chunk, self.space.count))

    def point(self, genes: tuple[int, ...]) -> DesignPoint:
        """Solve and check a design in plain closed form; errors as for `check_case`."""
        return self._point(self.space.line(genes), self.anchor(genes), genes)

    def anchor(self, genes: tuple[int, ...]) -> Anchor | None:
        """Return the anchor of a design: the sinker chosen for it, or that of the case."""
        if self.design.sinker is None:
            return self.case.anchor
        index = int(self.assess(np.array([genes])).sinker[0])
        return sinker_of(self.case, self.design.sinker, index)

    def load_cases(self, best: DesignPoint) -> tuple[DesignLoadCase, ...]:
        """List what every design is checked in, as one is."""
        states = {each.name: each for each in self.case.load_cases}
        return tuple(
            DesignLoadCase(
                name,
                states[name].kind if name in states else "extreme",
                states[name].water_level if name in states else 0.0,
                solution.horizontal_force,
                solution.fairlead_height,
            )
            for name, solution in best.checks.solutions
        )

    def present(self) -> DesignPoint:
        """Check the line of the case; a sinker that the search chooses is not part of it."""
        return self._point(self.case.line, self.case.anchor, ())

    def _point(self, line: Line, anchor: Anchor | None, genes: tuple[int, ...]) -> DesignPoint:
        checks = check_line(line, self.case, anchor)
        spans = [solution.span for _, solution in checks.solutions]
        kinds = [state.kind for state in self.states]
        at_rest = [span for span, kind in zip(spans, kinds, strict=True) if kind == "reference"]
        excursion = max(spans) - min(at_rest) if at_rest else None
        pull = max(solution.anchor.tension for _, solution in checks.solutions)
        objectives = self._by_key(line, max(spans), excursion, pull)
        return DesignPoint(line, anchor, genes, objectives, checks)

    def _by_key(
        self, line: Line, offset: float, excursion: float | None, anchor_load: float, lines: int = 1
    ) -> Mapping[str, float]:
        """List all known objectives of a number of equal lines, the wanted ones first.

        A line of the user's own may lack a mass or a price; what follows from them is left out.
        """
        priced = [(each.length, each.price) for each in line.segments if each.price is not None]
        cost = None
        if len(priced) == len(line.segments):
            cost = lines * math.fsum(length * price for length, price in priced)
        mass = None if line.mass is None else lines * line.mass
        values = {"mass": mass, "offset": offset, "excursion": excursion, "cost": cost}
        values |= {"length": lines * line.length, "anchor_load": anchor_load}
        named = ((OBJECTIVE_KEYS[name], values[name]) for name in self.known)
        return {key: value for key, value in named if value is not None}


def sinker_of(case: Case, choice: SinkerChoice, index: int) -> Anchor:
    """Make one of the sinkers that a design may be held by."""
    mass = choice.masses[index]
    return Anchor(
        kind="sinker",
        submerged_weight=weight_in_water(mass, choice.density, case.site.water_density),
        friction=choice.friction,
        base_holding=choice.base_holdings[index] if choice.base_holdings else None,
        safety_factor=choice.safety_factor,
        factor_source=choice.factor_source,
        mass=mass,
        accept=case.accept,
    )


def load_cases_of(case: Case) -> tuple[LoadCase, ...]:
    """List the load cases of a case with a design: its own, or its load as the only one.

    InputError: no design, no known horizontal force, or no reference for an excursion.
    """
    found = Findings("design")
    if case.design is None:
        found.add("design", "", Message("refused_case.missing_table_design_says_what"))
    elif "excursion" in case.design.objectives and not any(
        state.kind == "reference" for state in case.load_cases
    ):
        allowed = Message("refused_case.load_case_kind_reference_wanted")
        found.add("design.objectives", "excursion", allowed)
    force = None if case.load is None else case.load.horizontal_force
    if not case.load_cases and force is None:
        found.add("load_cases", "", Message("refused_case.missing_load_cases_or_load"))
    found.raise_if_any()
    return case.load_cases or (LoadCase(LOAD, force or 0.0),)


def design_point(problem: DesignProblem, genes: tuple[int, ...]) -> DesignPoint:
    """Build, solve and check one design in plain closed form.

    NoEquilibriumError: it has no equilibrium in one of the load cases. CatoptError: the answer is
    not that of the compiled loop, a fault of ours, never passed over.
    """
    point = problem.point(genes)
    if point.draws is not None:  # whose design by the case's own values was compared
        return point
    batch = problem.evaluate(np.array([genes]))
    steps = problem.tables.step[problem.columns]
    compared = [
        (name, batch.objectives[0, index], point.objectives[OBJECTIVE_KEYS[name]], steps[index])
        for index, name in enumerate(problem.names)
    ]
    size = max(point.line.length, 1.0)
    if point.checks.results:
        worst = max(result.exceedance for result in point.checks.results)
        compared.append(("excess", batch.exceedance[0], worst, 0.0))
    for name, compiled_one, plain, step in compared:
        room = AGREEMENT * max(abs(plain), size if name in ("offset", "excursion") else 1.0)
        # What is small beside the largest of the space was rounded by more than that.
        if not abs(compiled_one - plain) <= room + step:
            raise CatoptError(
                f"design {genes}: the {name} of the search, {compiled_one!r}, is not that of the "
                f"closed form, {plain!r}; please report this case"
            )
    return point


def present_line(problem: DesignProblem) -> Neighbour:
    """Check the line of the case by the same checks as the designs.

    Its `point` is None, with the reason, where the line has no equilibrium or a figure that a check
    needs is missing: that is no error of the search.
    """
    try:
        point = problem.present()
    except CatoptError as error:
        return Neighbour(Message("design.present"), None, error.message)
    key = "design.present" if point.mooring is None else "design.present_mooring"
    return Neighbour(Message(key), point)
