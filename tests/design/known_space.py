"""Design spaces small enough to be evaluated whole, so that their front is known exactly.

Three moorings out of chain and wire with the laws of their sizes: stud-link chain 21.9 d^2 t/m and
studless 19.9 d^2 t/m with d in m, strength c d^2 (44 - 0.08 d) kN with d in mm; round figures for
six-strand wire. The spaces differ in what makes them hard, so that no search is tuned to one.
They are solved once, under two load cases each; a search then reads a table, in microseconds.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property
from math import prod

import numpy as np

from catopt import Line, PointLoad, Segment, solve_many
from catopt.checks.kinds import ROUNDING
from catopt.design.front import Evaluated, Floats, Front, Genes, non_dominated

GRAVITY = 9.80665
BUOYANT = 1.0 - 1025.0 / 7850.0
"""Weight in sea water of steel over its weight in air."""
CLUMP_BUOYANT = 1.0 - 1025.0 / 2400.0
"""The same of a concrete clump weight."""
SAFETY_FACTOR = 5.0


@dataclass(frozen=True)
class KnownSpace:
    """A design space of which every design has been evaluated."""

    name: str  # for reports
    sizes: tuple[int, ...]  # values of each gene
    clump: int  # gene of the clump weight, absent when 0; -1 where there is none
    position: int  # gene of its place, which does not matter when it is absent; -1 likewise
    # shape (designs, objectives), in the order of `numpy.ravel_multi_index`; nan without
    # equilibrium
    table: Floats
    exceedance: Floats  # shape (designs,): the largest of all checks under both load cases

    @property
    def objectives(self) -> int:
        return int(self.table.shape[1])

    @property
    def designs(self) -> int:
        return len(self.table)

    def canonical(self, genes: Genes) -> Genes:
        genes = genes.copy()
        if self.position >= 0:
            genes[genes[:, self.clump] == 0, self.position] = 0
        return genes

    def evaluate(self, genes: Genes) -> Evaluated:
        rows = np.ravel_multi_index(tuple(genes.T), self.sizes)
        return Evaluated(self.table[rows], self.exceedance[rows])

    @cached_property
    def front(self) -> Front:
        """The exact front."""
        feasible = np.flatnonzero(self.exceedance <= ROUNDING)
        best = feasible[non_dominated(self.table[feasible])]
        return Front(np.stack(np.unravel_index(best, self.sizes), axis=1), self.table[best])


def chain_strength(d: Floats, factor: Floats | float) -> Floats:
    """MBL in N of chain of nominal diameter d (m); `factor` 0.0223 for R3, 0.0274 for R4."""
    mm = 1000.0 * d
    return 1000.0 * factor * mm**2 * (44.0 - 0.08 * mm)


def grid(*values: Floats) -> tuple[tuple[int, ...], list[Floats]]:
    """Sizes of a space, and one column for each gene over all designs."""
    mesh = np.meshgrid(*values, indexing="ij")
    return tuple(len(each) for each in values), [each.ravel() for each in mesh]


@cache
def tanker() -> KnownSpace:
    """Moor a tanker in 20 m of water: mass and swing radius of a chain with a clump weight.

    900 kN in the storm and 200 kN as reference, T_break/5, no uplift; 224,640 designs.
    """
    sizes, (strength, d, length, clump, position) = grid(
        np.array([0.0223, 0.0274]),
        np.arange(0.070, 0.1205, 0.002),
        np.arange(100.0, 246.0, 5.0),
        np.arange(0.0, 16.1, 2.0) * 1000.0,
        np.arange(20.0, 171.0, 10.0),
    )
    mass = 21.9e3 * d**2
    # A clump weight beyond the end is not a design; the line is solved with it near its end.
    is_design = position < length
    solved = solve_cases(
        height=20.0,
        forces=(900e3, 200e3),
        lengths=length[:, np.newaxis],
        weights=(mass * GRAVITY * BUOYANT)[:, np.newaxis],
        EA=(1.0e11 * d**2)[:, np.newaxis],
        positions=np.minimum(position, length - 1.0)[:, np.newaxis],
        loads=(clump * GRAVITY * CLUMP_BUOYANT)[:, np.newaxis],
    )
    exceedance = np.max(
        [
            np.maximum(
                case.tension / (chain_strength(d, strength) / SAFETY_FACTOR) - 1.0,
                case.lift / case.force,
            )
            for case in solved
        ],
        axis=0,
    )
    objectives = np.stack((mass * length + clump, solved[0].span), axis=1)
    objectives[~is_design] = np.nan
    return known("tanker, 20 m", sizes, 3, 4, objectives, np.where(is_design, exceedance, 10.0))


@cache
def leg() -> KnownSpace:
    """Lay a leg of chain and wire in 56 m: mass, excursion and cost; 230,400 designs.

    A clump weight may hang where chain and wire meet. 50 m of chain stay on the bed.
    """
    sizes, (grade, d, chain, wire_d, wire, clump) = grid(
        np.array([0.0, 1.0]),
        np.arange(0.040, 0.0845, 0.004),
        np.arange(150.0, 531.0, 20.0),
        np.arange(0.048, 0.0765, 0.004),
        np.arange(40.0, 221.0, 20.0),
        np.arange(0.0, 10.1, 2.0) * 1000.0,
    )
    mass = 19.9e3 * d**2
    wire_mass = 4.0e3 * wire_d**2
    wire_weight = wire_mass * GRAVITY * 0.83
    strength = chain_strength(d, np.where(grade > 0.0, 0.0274, 0.0223))
    wire_strength = 6.3e8 * wire_d**2
    solved = solve_cases(
        height=56.0,
        forces=(600e3, 150e3),
        lengths=np.stack((chain, wire), axis=1),
        weights=np.stack((mass * GRAVITY * BUOYANT, wire_weight), axis=1),
        EA=np.stack((0.9e11 * d**2, 4.0e10 * wire_d**2), axis=1),
        positions=chain[:, np.newaxis],
        loads=(clump * GRAVITY * CLUMP_BUOYANT)[:, np.newaxis],
    )
    exceedance = np.full(len(d), -np.inf)
    for case in solved:
        below = np.hypot(case.force, np.maximum(case.vertical - wire_weight * wire, 0.0))
        for each in (
            case.tension / (wire_strength / 3.0) - 1.0,
            below / (strength / 3.0) - 1.0,
            1.0 - case.grounded / 50.0,
        ):
            exceedance = np.maximum(exceedance, each)
    cost = mass * chain * (2.2 + 0.5 * grade) + 5.0 * wire_mass * wire + 0.4 * clump
    objectives = np.stack(
        (mass * chain + wire_mass * wire + clump, solved[0].span - solved[1].span, cost), axis=1
    )
    return known("leg, 56 m", sizes, -1, -1, objectives, exceedance)


@cache
def buoy() -> KnownSpace:
    """Moor a buoy in 9.5 m: mass and swing radius of two chains and a sinker; 259,200 designs.

    The families follow each other in one gene, so that neighbouring values need not be alike.
    The sinker has to hold by its weight and the chains by three times their pull.
    """
    d = np.array([0.012, 0.014, 0.016, 0.018, 0.020, 0.022])
    family = [(21.9e3, 0.0098), (19.9e3, 0.0140), (25.0e3, 0.0060), (19.9e3, 0.0223)]
    per_metre = np.concatenate([each * d**2 for each, _ in family])
    breaking = np.concatenate([chain_strength(d, factor) for _, factor in family])
    sizes, (lower, upper, lower_length, upper_length, sinker) = grid(
        np.arange(24.0),
        np.arange(0.0, 24.0, 2.0),
        np.arange(3.0, 18.0, 1.0),
        np.arange(1.0, 11.0, 1.0),
        np.arange(300.0, 950.0, 100.0)[:6],
    )
    first, second = lower.astype(int), upper.astype(int)
    mass = np.stack((per_metre[first], per_metre[second]), axis=1)
    lengths = np.stack((lower_length, upper_length), axis=1)
    solved = solve_cases(
        height=9.5,
        forces=(1500.0, 300.0),
        lengths=lengths,
        weights=mass * GRAVITY * BUOYANT,
        EA=np.full(mass.shape, 5.0e7),
        positions=lower_length[:, np.newaxis],
        loads=np.zeros((len(sinker), 1)),
    )
    exceedance = np.full(len(sinker), -np.inf)
    for case in solved:
        needed = case.lift + 1.2 * case.force / 0.8
        below = np.hypot(case.force, case.vertical - mass[:, 1] * GRAVITY * BUOYANT * upper_length)
        for each in (
            needed / (sinker * GRAVITY * CLUMP_BUOYANT) - 1.0,
            case.tension / (breaking[second] / 3.0) - 1.0,
            below / (breaking[first] / 3.0) - 1.0,
            case.vertical / 2200.0 - 1.0,
        ):
            exceedance = np.maximum(exceedance, each)
    objectives = np.stack(((mass * lengths).sum(axis=1) + sinker, solved[0].span), axis=1)
    return known("buoy, 9.5 m", sizes, -1, -1, objectives, exceedance)


@dataclass(frozen=True)
class CaseColumns:
    """What the checks read of one load case; arrays of shape (designs,), N and m."""

    force: float
    tension: Floats
    vertical: Floats
    lift: Floats
    grounded: Floats
    span: Floats


def solve_cases(
    *,
    height: float,
    forces: tuple[float, ...],
    lengths: Floats,
    weights: Floats,
    EA: Floats,
    positions: Floats,
    loads: Floats,
) -> list[CaseColumns]:
    """Solve all designs under every force; without equilibrium a design has nan."""
    line = Line(
        [Segment(length=1e4, submerged_weight=1.0)] * lengths.shape[1],
        point_loads=[PointLoad(position=1.0, submerged_weight=1.0)] * positions.shape[1],
    )
    solved = []
    for force in forces:
        s = solve_many(
            line,
            height=height,
            horizontal_force=force,
            lengths=lengths,
            submerged_weights=weights,
            EA=EA,
            positions=positions,
            point_weights=loads,
        )
        solved.append(
            CaseColumns(
                force=force,
                tension=s.tension,
                vertical=s.vertical_force,
                lift=s.anchor_vertical_force,
                grounded=s.grounded_length,
                span=s.span,
            )
        )
    return solved


def known(
    name: str,
    sizes: tuple[int, ...],
    clump: int,
    position: int,
    objectives: Floats,
    exceedance: Floats,
) -> KnownSpace:
    """Space with nan for objectives and a finite excess where there is no equilibrium."""
    assert len(objectives) == prod(sizes)
    fails = np.isnan(exceedance) | np.isnan(objectives).any(axis=1)
    table = np.where(fails[:, np.newaxis], np.nan, objectives)
    return KnownSpace(name, sizes, clump, position, table, np.where(fails, 10.0, exceedance))


def scrambled(
    sizes: tuple[int, ...], objectives: int, feasible: float, seed: int = 0
) -> KnownSpace:
    """Make a small space of random objectives and excesses, a share of it feasible."""
    generator = np.random.default_rng(seed)
    count = prod(sizes)
    table = generator.random((count, objectives))
    # 0.1 from the limit, so that feasible or not is no matter of rounding.
    exceedance = np.where(generator.random(count) < feasible, -0.1, 0.1 + generator.random(count))
    table[exceedance > 1.0] = np.nan
    return KnownSpace("scrambled", sizes, -1, -1, table, exceedance)


def funnel(sizes: tuple[int, ...], target: tuple[int, ...]) -> KnownSpace:
    """Make a space with a single feasible design; the excess grows with the distance from it."""
    _, columns = grid(*(np.arange(float(size)) for size in sizes))
    distance = sum(abs(column - t) for column, t in zip(columns, target, strict=True))
    table = np.stack((columns[0], -columns[0]), axis=1)
    return KnownSpace("funnel", sizes, -1, -1, table, np.asarray(distance))


class Recorded:
    """A space that keeps what was evaluated, in order."""

    def __init__(self, space: KnownSpace) -> None:
        self.space = space
        self.asked: list[Genes] = []

    @property
    def sizes(self) -> tuple[int, ...]:
        return self.space.sizes

    @property
    def objectives(self) -> int:
        return self.space.objectives

    @property
    def designs(self) -> Genes:
        """All designs that were evaluated, in order."""
        return np.concatenate(self.asked)

    def canonical(self, genes: Genes) -> Genes:
        return self.space.canonical(genes)

    def evaluate(self, genes: Genes) -> Evaluated:
        self.asked.append(genes.copy())
        return self.space.evaluate(genes)
