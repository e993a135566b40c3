"""The front: the designs that no other beats in all objectives, and what a search ends with."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from catopt.checks.kinds import ROUNDING
from catopt.compiled import compiled
from catopt.progress import Progress

Genes = NDArray[np.int64]
"""Designs as whole numbers, shape (n, genes); gene k counts from 0 to below ``sizes[k]``."""
Floats = NDArray[np.float64]


class Evaluated(NamedTuple):
    """What many designs are worth."""

    objectives: Floats  # to be made small; nan where a design has no equilibrium
    # the largest excess of all checks over all load cases (`catopt.checks.kinds`); a design
    # is feasible when it is at most ROUNDING. Finite also where there is no equilibrium
    exceedance: Floats


class Problem(Protocol):
    """A design space with its evaluation."""

    @property
    def sizes(self) -> tuple[int, ...]:
        """How many values each gene has. Neighbouring values are alike: sizes and lengths rise."""

    @property
    def objectives(self) -> int:
        """How many objectives there are, two or three."""

    def canonical(self, genes: Genes) -> Genes:
        """Set genes that do not matter (the length of an absent segment) to 0."""

    def evaluate(self, genes: Genes) -> Evaluated:
        """Solve and check many designs under all load cases."""


Indices = NDArray[np.int64]

_A_ROW = 4e-6
"""Time that a row takes as plain Python, s."""
_A_PAIR = 1e-7
"""Time that two designs beside each other take as plain Python, s."""

MARGIN = 0.1
"""How far beyond the front the reference point lies, as a share of the front's range: far enough
for the ends to count, near enough for them not to outweigh the rest (usual practice)."""


class Front(NamedTuple):
    """Designs of which none beats another, by rising first objective."""

    genes: Genes  # shape (n, genes)
    objectives: Floats  # shape (n, objectives)


def empty_front(genes: int, objectives: int) -> Front:
    """Front of no design, to which designs are merged."""
    return Front(np.empty((0, genes), dtype=np.int64), np.empty((0, objectives)))


def merge(front: Front, genes: Genes, objectives: Floats) -> Front:
    """Merge more feasible designs into a front.

    Of two that are equal in all objectives the front's stays. A row of objectives that is not
    finite is left out. Designs given in many batches end in the front of all of them together.
    """
    best = non_dominated(objectives)
    genes = np.concatenate((front.genes, genes[best]))
    objectives = np.concatenate((front.objectives, objectives[best]))
    best = non_dominated(objectives)
    return Front(genes[best], objectives[best])


def non_dominated(objectives: Floats) -> Indices:
    """Find the rows of two or three objectives, made small, that no other row beats.

    By rising first, then second objective. Of equal rows the first alone, and none that is not
    finite. In the order of the sorted rows only an earlier row can beat a later one. With two
    objectives the running minimum of the second says whether one does. With three, those kept so
    far form a staircase in the second and third, on which a row's place is found by bisection (H.
    T. Kung, F. Luccio and F. P. Preparata, Journal of the ACM 22 (1975) 469).
    """
    finite = np.flatnonzero(np.isfinite(objectives).all(axis=1))
    rows = objectives[finite]
    # lexsort is stable, so that the first of equal rows stays the first.
    order = np.lexsort(rows.T[::-1])
    rows = rows[order]
    find = _best_of_two if rows.shape[1] == 2 else compiled(_best_of_three, _A_ROW * len(rows))
    is_best = find(rows)
    best: Indices = finite[order[is_best]]
    return best


def _best_of_two(rows: Floats) -> NDArray[np.bool_]:
    """Whether each of the sorted rows is smaller in the second objective than all before it."""
    second = rows[:, 1]
    least_before = np.empty_like(second)
    least_before[:1] = np.inf
    np.minimum.accumulate(second[:-1], out=least_before[1:])
    is_best: NDArray[np.bool_] = second < least_before
    return is_best


def _best_of_three(rows: Floats) -> NDArray[np.bool_]:
    """Whether no earlier one of the sorted rows is as small in the second and third objective.

    The staircase holds the steps of the rows kept so far: y rises and z falls.
    """
    count = len(rows)
    is_best = np.zeros(count, dtype=np.bool_)
    steps_y, steps_z = np.empty(count), np.empty(count)
    steps = 0
    for row in range(count):
        y, z = rows[row, 1], rows[row, 2]
        after = np.searchsorted(steps_y[:steps], y, side="right")
        if after > 0 and steps_z[after - 1] <= z:
            continue
        is_best[row] = True
        # Steps at or right of y and not lower than z disappear under the new one.
        first = after - 1 if after > 0 and steps_y[after - 1] == y else after
        last = first
        while last < steps and steps_z[last] >= z:
            last += 1
        shift = first + 1 - last
        if shift > 0:
            for step in range(steps - 1, last - 1, -1):
                steps_y[step + shift], steps_z[step + shift] = steps_y[step], steps_z[step]
        elif shift < 0:
            for step in range(last, steps):
                steps_y[step + shift], steps_z[step + shift] = steps_y[step], steps_z[step]
        steps += shift
        steps_y[first], steps_z[first] = y, z
    return is_best


def crowding_distance(objectives: Floats) -> Floats:
    """Distance between the two neighbours of each design of a front, summed over the objectives.

    From shape (n, objectives), shape (n,). Each objective counts as a share of its range on the
    front. The ends of an objective are infinitely lonely (K. Deb et al., IEEE Trans. Evol. Comp. 6
    (2002) 182, III B).
    """
    distance = np.zeros(len(objectives))
    for values in objectives.T:
        order = np.argsort(values, kind="stable")
        ordered = values[order]
        gaps = np.full(len(values), np.inf)
        gaps[1:-1] = ordered[2:] - ordered[:-2]
        length = np.ptp(values) if len(values) else 0.0
        distance[order] += gaps / (length if length > 0.0 else 1.0)
    return distance


def reference_point(front: Floats) -> Floats:
    """Worst corner to measure fronts from, given the best front that is known.

    The worst of each objective and a tenth of its range more; of its value where all are equal.
    """
    worst = front.max(axis=0)
    length = np.ptp(front, axis=0)
    point: Floats = worst + MARGIN * np.where(length > 0.0, length, np.abs(worst))
    return point


def hypervolume(objectives: Floats, reference: Floats) -> float:
    """Area or volume that designs beat, up to the reference point; exact, in the objectives' units.

    It is the one measure of a front's worth: it grows with every design that is added and with
    nothing else. Of any designs; those beyond the reference point add nothing.
    """
    inside = objectives[(objectives < reference).all(axis=1)]
    rows = inside[np.lexsort(inside.T[::-1])]
    if rows.shape[1] == 2:
        # Each row adds a bar below the lowest before it.
        lowest = np.minimum.accumulate(np.concatenate((reference[1:], rows[:, 1])))
        return float(((reference[0] - rows[:, 0]) * -np.diff(lowest)).sum())
    by_second = np.argsort(rows[:, 1], kind="stable")
    return float(compiled(_volume, _A_PAIR * len(rows) ** 2)(rows, by_second, reference))


def _volume(rows: Floats, by_second: Floats, reference: Floats) -> float:
    """Volume, slice by slice along the first objective; in each the area of the rows up to it."""
    count = len(rows)
    total = 0.0
    for row in range(count):
        end = rows[row + 1, 0] if row + 1 < count else reference[0]
        depth = end - rows[row, 0]
        if depth <= 0.0:
            continue
        area, lowest = 0.0, reference[2]
        for other in by_second:
            if other <= row and rows[other, 2] < lowest:
                area += (reference[1] - rows[other, 1]) * (lowest - rows[other, 2])
                lowest = rows[other, 2]
        total += depth * area
    return total


@dataclass(frozen=True)
class Knee:
    """The recommended design of a front."""

    index: int  # its row
    shares: tuple[float, ...]  # of the range of each objective, 0 at its best and 1 at its worst
    # 1 less the sum of the shares, for two objectives sqrt(2) times the distance from the chord; at
    # most 0 where the front has no knee: then every compromise costs more than it gives
    depth: float


def knee(objectives: Floats) -> Knee:
    """Find the knee of a front, of shape (n, objectives): the design where nothing else decides.

    Every objective is measured as a share of its range on the front, 0 at its best and 1 at its
    worst. The knee has the least sum of shares. With two objectives the ends of the front are
    (0, 1) and (1, 0), and the knee is the design furthest below the chord that joins them: to leave
    it for any other design takes a larger share of one objective than it gives of the other. The
    rule needs no weights, no unit matters to it, and it holds for three objectives as it stands.
    (The other common rule, the sharpest bend, depends on the designs next to it alone and jumps
    about on a front of sizes that can be bought.) Of one or two designs, and where no design lies
    below the chord, the recommended one is the end with the best first objective.
    """
    if not len(objectives):
        raise ValueError("an empty front has no knee")
    length = np.ptp(objectives, axis=0)
    shares = (objectives - objectives.min(axis=0)) / np.where(length > 0.0, length, 1.0)
    total = shares.sum(axis=1)
    # Of designs that are equal to rounding, the one with the best first objective.
    equal = np.flatnonzero(total <= total.min() + 1e-12)
    index = int(equal[np.argmin(shares[equal, 0])])
    return Knee(index, tuple(shares[index].tolist()), 1.0 - float(total[index]))


@dataclass(frozen=True)
class Outcome:
    """The front that a search found, and what it took.

    The front is of all designs that were ever evaluated: those that are feasible and that no other
    feasible one beats, by rising first objective.
    """

    genes: Genes  # no row where none is feasible
    objectives: Floats
    evaluations: int  # each design counts once
    feasible: int
    interrupted: bool
    # the design of the least excess, which explains what stops the others where none is feasible;
    # None where none was evaluated, its excess is infinite then
    closest: tuple[int, ...] | None
    least_exceedance: float
    unsolved: int = 0  # lines that did not converge, of an enumeration
    # designs that each of `catopt.design.assess.BOUNDS` has proved needless, and that were not
    # evaluated; empty where nothing is proved
    excluded: tuple[int, ...] = ()


class Tally:
    """What is kept of the designs evaluated so far; as of `Outcome`."""

    def __init__(self, problem: Problem, progress: Progress | None = None) -> None:
        self.problem = problem
        self.progress = progress
        self.front = empty_front(len(problem.sizes), problem.objectives)
        self.evaluations = 0
        self.feasible = 0
        self.closest: Genes = self.front.genes  # one row, none as long as there is no such design
        self.least_exceedance = float("inf")
        self.unsolved = 0
        self.excluded: tuple[int, ...] = ()

    def count(
        self,
        genes: Genes,
        objectives: Floats,
        exceedance: Floats,
        *,
        is_whole: bool = True,
        excluded: tuple[int, ...] = (),
    ) -> None:
        """Add designs; an excess that is not of all checks tells nothing of the closest design."""
        is_feasible = exceedance <= ROUNDING
        front = merge(self.front, genes[is_feasible], objectives[is_feasible])
        least = int(np.argmax(exceedance <= exceedance.min() + ROUNDING))
        # Nothing slow from here on: what Ctrl-C leaves belongs together.
        self.front = front
        self.evaluations += len(genes) - sum(excluded)
        before = self.excluded or (0,) * len(excluded)
        self.excluded = tuple(map(int.__add__, before, excluded)) or before
        self.feasible += int(is_feasible.sum())
        if is_whole and exceedance[least] < self.least_exceedance - ROUNDING:
            self.closest, self.least_exceedance = genes[[least]], float(exceedance[least])

    def outcome(self, *, interrupted: bool, evaluated: int = 0) -> Outcome:
        """Sum up; `evaluated` says how many designs an earlier pass over them has evaluated."""
        return Outcome(
            *self.front,
            evaluations=max(self.evaluations, evaluated),
            feasible=self.feasible,
            interrupted=interrupted,
            closest=tuple(self.closest[0].tolist()) if len(self.closest) else None,
            least_exceedance=self.least_exceedance,
            unsolved=self.unsolved,
            excluded=self.excluded,
        )


class BudgetSpentError(Exception):
    """The search has evaluated as many designs as it may. It never leaves `explore`."""


class EvaluationArchive(Tally):
    """What one search knows of a design space: each design is evaluated once, within a budget."""

    def __init__(self, problem: Problem, budget: int, progress: Progress | None = None) -> None:
        super().__init__(problem, progress)
        self._budget = budget
        self._row: dict[bytes, int] = {}
        self._objectives: Floats = np.empty((0, problem.objectives))
        self._exceedance: Floats = np.empty(0)

    @property
    def share_spent(self) -> float:
        """Share of the budget that is spent, 0 to 1."""
        return self.evaluations / self._budget

    def is_known(self, genes: Genes) -> NDArray[np.bool_]:
        """Say which of the canonical designs were evaluated before, shape (n,)."""
        known = (each.tobytes() in self._row for each in genes)
        return np.fromiter(known, dtype=np.bool_, count=len(genes))

    def evaluate(self, genes: Genes) -> Evaluated:
        """Evaluate those of the canonical designs that are not known yet; return all.

        BudgetSpentError after the designs for which the budget was enough.
        """
        keys = [each.tobytes() for each in genes]
        new = {key: k for k, key in enumerate(keys) if key not in self._row}
        room = self._budget - self.evaluations
        chosen = list(new.values())[:room]
        if chosen:
            self._record(genes[chosen])
        if len(new) > room:
            raise BudgetSpentError
        rows = [self._row[key] for key in keys]
        return Evaluated(self._objectives[rows], self._exceedance[rows])

    def _record(self, genes: Genes) -> None:
        """Evaluate designs of which none is known."""
        objectives, exceedance = self.problem.evaluate(genes)
        # What cannot be compared is no answer, whatever its checks say.
        exceedance = np.where(
            np.isfinite(objectives).all(axis=1), exceedance, np.maximum(exceedance, 1.0)
        )
        first, last = self.evaluations, self.evaluations + len(genes)
        # Lengthen what is remembered to a number of rows or more; a budget may be any number.
        more = max(last, 2 * len(self._exceedance)) - len(self._exceedance)
        if last > len(self._exceedance):
            room = np.empty((more, self.problem.objectives))
            self._objectives = np.concatenate((self._objectives, room))
            self._exceedance = np.concatenate((self._exceedance, np.empty(more)))
        self._objectives[first:last] = objectives
        self._exceedance[first:last] = exceedance
        self._row.update((each.tobytes(), first + k) for k, each in enumerate(genes))
        self.count(genes, objectives, exceedance)
        if self.progress is not None:
            self.progress(last, self._budget)
