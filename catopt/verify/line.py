"""One line by both models."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate
from operator import attrgetter
from typing import Any, TypeVar

import numpy as np

from catopt.arrays import Array
from catopt.catenary.by_table import ROUNDS, has_table
from catopt.catenary.solution import Solution
from catopt.errors import NotConvergedError
from catopt.fem import LineMesh, TrussSolution, mesh_line, solve_line
from catopt.model import Case, Line
from catopt.model.strain_table import StrainTable
from catopt.verify.compared import ORDER, Compared, Unit
from catopt.verify.result import LinePair, Mesh, StaticComparison, largest_distances
from catopt.words import Message, Several

Truss = TypeVar("Truss")

MESHES = 3
"""How many meshes: the fewest that show an order."""

SLACK_ORDER = 1.0
"""Of a line that hangs straight down to bights on the bed: it is known to a bar."""

SLACK = "truss.slack"
"""Key of what is to be known of a slack line."""

_SAME_TENSION = 1e-11
"""Change of a bar's tension, over the largest, at which the law of its table is found."""
_NO_PULL = 1e-9
"""Horizontal force, over the tension, that is rounding."""
_AT_END = 1e-9
"""How far beyond its end, over its length, a stretch may be level."""


def verify_line(
    case: Case, closed: Solution, *, elements: int, tolerance: float, name: str = ""
) -> StaticComparison:
    """Solve a line by the truss model on three meshes and hold it against the closed form.

    `tolerance`: allowed difference: of the fairlead tension, of the line's length, in rad.
    """
    trusses = on_meshes(
        elements,
        lambda bars: [mesh_line(case.line, bars, bends=bends(closed))],
        lambda meshes: _under_load(case, meshes[0], closed),
    )
    return compare_line(case, closed, trusses, tolerance=tolerance, name=name)


def bends(closed: Solution) -> list[tuple[float, float]]:
    """Arc length and radius of curvature H/w, m, of where the closed form is level.

    There it bends most, and there bars have to be short beside H/w. Where they end is all that the
    truss model takes from the closed form.
    """
    found: list[tuple[float, float]] = []
    if closed.regime == "slack":
        return found  # a slack line has no radius, and is known to a bar
    for stretch in closed.stretches:
        w = stretch.submerged_weight
        if stretch.on_bed or w == 0.0 or stretch.length == 0.0 or stretch.horizontal_force == 0.0:
            continue
        level = -stretch.vertical_force / w
        if -_AT_END <= level / stretch.length <= 1.0 + _AT_END:
            found.append((stretch.start + level, stretch.horizontal_force / abs(w)))
    return found


def on_meshes(
    elements: int,
    cut: Callable[[int], list[LineMesh]],
    solve: Callable[[list[LineMesh]], Truss],
) -> tuple[Truss, ...]:
    """Solve on a mesh and on those of twice and four times as many bars."""
    meshes = cut(elements)
    solutions = []
    for _ in range(MESHES):
        solutions.append(solve(meshes))
        meshes = [mesh.refined() for mesh in meshes]
    return tuple(solutions)


def compare_line(
    case: Case,
    closed: Solution,
    trusses: Sequence[TrussSolution],
    *,
    tolerance: float,
    name: str = "",
) -> StaticComparison:
    """Hold solutions of the truss model against a closed form."""
    return StaticComparison(
        name=name,
        kind="line",
        quantities=tuple(_quantities(case, closed, trusses, tolerance)),
        meshes=tuple(Mesh.of(truss, [truss]) for truss in trusses),
        lines=(LinePair(closed, tuple(trusses)),),
        tolerance=tolerance,
        remarks=tuple(_remarks(case, closed)),
    )


# ------------------------------------------------------------------ quantities


@dataclass(frozen=True)
class Comparing:
    """One line by both models, whose figures are compared.

    `trusses`: on each mesh, from the coarsest; `line`: of a system: which of its lines, from 0.
    A slack line is known to a bar, which is the least that its forces and lengths are measured by;
    `beside`: those of slack lines that move with this one, N and m.
    """

    closed: Solution
    trusses: Sequence[TrussSolution]
    tolerance: float
    line: int | None = None
    beside: tuple[float, float] = (0.0, 0.0)

    @property
    def is_slack(self) -> bool:
        """Whether the line hangs straight down to bights on the bed."""
        pull, tension = self.closed.horizontal_force, self.closed.fairlead.tension
        return self.closed.regime == "slack" or pull <= _NO_PULL * tension

    @property
    def scales(self) -> tuple[float, float]:
        """What forces, N, and lengths, m, are measured by."""
        force, length = self.closed.fairlead.tension, self.closed.line.length
        heaviest, longest = self.bar if self.is_slack else (0.0, 0.0)
        heaviest, longest = max(heaviest, self.beside[0]), max(longest, self.beside[1])
        return max(force, heaviest / self.tolerance), max(length, longest / self.tolerance)

    @property
    def bar(self) -> tuple[float, float]:
        """Weight of the heaviest bar of the finest mesh, N, and length of the longest, m."""
        mesh = self.trusses[-1].mesh
        weight = np.array([abs(each.submerged_weight) for each in mesh.line.segments])
        return float((weight[mesh.segment] * mesh.length).max()), float(mesh.length.max())

    def of_several(self, force: float, length: float) -> Iterator[Compared]:
        """Compare what is compared of every line of several beside its tensions."""
        yield self.of("horizontal_force", "N", force)
        yield self.of("span", "m", length)
        yield self.of("grounded_length", "m", length)

    def of(self, quantity: str, unit: Unit, scale: float, path: str = "") -> Compared:
        """Compare a figure of both models, by its path where that is not its name."""
        read = attrgetter(path or quantity)
        theory = SLACK_ORDER if self.is_slack else ORDER
        values = tuple(float(read(truss)) for truss in self.trusses)
        return Compared(
            quantity,
            unit,
            float(read(self.closed)),
            values,
            scale,
            self.tolerance,
            self.line,
            theory=theory,
        )


def _quantities(
    case: Case, closed: Solution, trusses: Sequence[TrussSolution], tolerance: float
) -> Iterator[Compared]:
    both = Comparing(closed, trusses, tolerance)
    force, reach = both.scales
    assert case.load is not None
    if case.load.span is None:
        yield both.of("span", "m", reach)
    else:
        yield both.of("horizontal_force", "N", force)
    for end, there in (("fairlead", closed.fairlead), ("anchor", closed.anchor)):
        yield both.of(f"{end}_tension", "N", force, f"{end}.tension")
        yield both.of(f"{end}_vertical_force", "N", force, f"{end}.vertical_force")
        if not both.is_slack:
            # What turns the force at that end by the same part of the tension at the fairlead.
            turns = closed.fairlead.tension / there.tension if there.tension > 0.0 else math.inf
            scale = min(turns, math.pi / tolerance)
            yield both.of(f"{end}_angle", "rad", scale, f"{end}.angle")
    yield both.of("grounded_length", "m", reach)
    if not both.is_slack:
        distances, limit = largest_distances(closed, trusses)
        length = case.line.length
        yield Compared("shape", "m", 0.0, distances, length, tolerance, limit=limit)


def _remarks(case: Case, closed: Solution) -> Iterator[str]:
    if closed.regime == "slack":
        yield Several((Message(SLACK), Message("truss.bights")))
    if case.load is not None and case.load.fairlead_tension is not None:
        yield Message("truss.tension_given")


# ------------------------------------------------------------------ solving


def _solved(
    case: Case,
    mesh: LineMesh,
    *,
    horizontal_force: float | None = None,
    span: float | None = None,
    start: TrussSolution | None = None,
) -> TrussSolution:
    if has_table(mesh.line):
        return _by_table(case, mesh, horizontal_force=horizontal_force, span=span, start=start)
    return solve_line(
        mesh.line,
        height=case.fairlead_height,
        horizontal_force=horizontal_force,
        span=span,
        seabed_friction=case.site.seabed_friction,
        anchor_height=case.anchor_height,
        mesh=mesh,
        start=start,
    )


def _by_table(case: Case, mesh: LineMesh, **load: Any) -> TrussSolution:
    """Solve with bars that each stretch as their table does about their own tension.

    A strain e + c T is that of a bar of (1 + e) times the length; see `catopt.catenary.by_table`.
    """
    tension = np.zeros(mesh.elements)
    for _ in range(ROUNDS):
        found = _solved(case, _grown(mesh, tension), **load)
        moved = float(np.abs(found.tension - tension).max())
        tension = found.tension
        if moved <= _SAME_TENSION * float(tension.max()):
            return replace(found, mesh=mesh)
    raise NotConvergedError(Message("catenary.not_converged"))


def _grown(mesh: LineMesh, tension: Array) -> LineMesh:
    """Cut a line with tables into bars that have the law of their table at their own tension."""
    bars = []
    for k, length, T in zip(mesh.segment, mesh.length.tolist(), tension.tolist(), strict=True):
        own = mesh.line.segments[k]
        table, e, EA = own.EA, 0.0, own.EA
        if isinstance(table, StrainTable):
            e, c = table.law(T, T)
            EA = (1.0 + e) / c
        weight = own.submerged_weight / (1.0 + e)
        bars.append(replace(own, length=(1.0 + e) * length, submerged_weight=weight, EA=EA))
    arc = [0.0, *accumulate(bar.length for bar in bars)]
    loads = [replace(load, position=arc[node]) for load, node in mesh.loads]
    return LineMesh(Line(bars, loads), tuple(arc), (1,) * len(bars))


def _under_force(case: Case, mesh: LineMesh, H: float) -> TrussSolution:
    """Solve from straight, or where that fails from twice the force, which bends the line less."""
    try:
        return _solved(case, mesh, horizontal_force=H)
    except NotConvergedError:
        if H > abs(case.line.submerged_weight):
            raise
    return _solved(case, mesh, horizontal_force=H, start=_under_force(case, mesh, 2.0 * H))


def _under_load(case: Case, mesh: LineMesh, closed: Solution) -> TrussSolution:
    assert case.load is not None
    if case.load.span is not None:
        return _solved(case, mesh, span=case.load.span)
    return _under_force(case, mesh, closed.horizontal_force)
