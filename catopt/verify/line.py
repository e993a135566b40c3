"""One line by both models."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from operator import attrgetter
from typing import TypeVar

import numpy as np

from catopt.catenary.solution import Solution
from catopt.errors import NotConvergedError
from catopt.fem import LineMesh, TrussSolution, mesh_line, solve_line
from catopt.model import Case
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

_NO_PULL = 1e-9
"""Horizontal force, over the tension or the line's weight, that is rounding."""
_STRAIGHT = 2e-3
"""Radius, over the line's length, of the bend where it hangs straight down to a rough bed."""
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
    if hangs_slack(closed):
        return found  # a slack line has no radius, and is known to a bar
    for stretch in closed.stretches:
        w = stretch.submerged_weight
        if stretch.on_bed or w == 0.0 or stretch.length == 0.0:
            continue
        if stretch.horizontal_force == 0.0:
            # friction has used up its pull, and it hangs straight down to where it lies
            found.append((stretch.start + stretch.length, _STRAIGHT * closed.line.length))
            continue
        level = -stretch.vertical_force / w
        if -_AT_END <= level / stretch.length <= 1.0 + _AT_END:
            found.append((stretch.start + level, stretch.horizontal_force / abs(w)))
    return found


def hangs_slack(closed: Solution) -> bool:
    """Whether a line hangs straight down to bights on the bed, or lies there unpulled."""
    least = _NO_PULL * max(closed.fairlead.tension, abs(closed.line.submerged_weight))
    return closed.regime == "slack" or closed.horizontal_force <= least


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
    A slack line is known to a bar, which is the least that its forces and lengths are measured by,
    its part on the bed to one at each touchdown;
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
        return hangs_slack(self.closed)

    @property
    def touchdowns(self) -> int:
        """Where it comes down to the bed or leaves it; at least 1."""
        lies = [stretch.on_bed for stretch in self.closed.stretches if stretch.length > 0.0]
        return max(sum(a != b for a, b in pairwise(lies)), 1)

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
        yield self.of("grounded_length", "m", length * (self.touchdowns if self.is_slack else 1))

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
    return solve_line(
        case.line,
        height=case.fairlead_height,
        horizontal_force=horizontal_force,
        span=span,
        seabed_friction=case.site.seabed_friction,
        anchor_height=case.anchor_height,
        mesh=mesh,
        start=start,
    )


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
