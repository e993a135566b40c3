"""One line, or a moored body, by both models."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, pairwise
from operator import attrgetter
from typing import Any, TypeVar

import numpy as np

from catopt.arrays import Array
from catopt.catenary.solution import Solution
from catopt.catenary.solve import ROUNDS, grown, has_table
from catopt.errors import NotConvergedError
from catopt.fem import Leg as TrussLeg
from catopt.fem import LineMesh, TrussSolution, mesh_line, solve_line
from catopt.fem import SystemSolution as TrussSystem
from catopt.fem import solve_system as solve_truss
from catopt.model import Case, Line, System
from catopt.model.line import StrainTable
from catopt.mooring.network_rest import BodyAtRest
from catopt.mooring.solution import SystemSolution, solve_system
from catopt.verify.comparison import ORDER, Compared, Unit
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
    assert case.load is not None
    span = case.load.span
    trusses = on_meshes(
        elements,
        lambda bars: [mesh_line(case.line, bars, bends=bends(closed))],
        lambda meshes: (
            _under_force(case, meshes[0], closed.horizontal_force)
            if span is None
            else _solved(case, meshes[0], span=span)
        ),
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
    remarks: list[str] = []
    if closed.regime == "slack":
        remarks.append(Several((Message(SLACK), Message("truss.bights"))))
    if case.load is not None and case.load.fairlead_tension is not None:
        remarks.append(Message("truss.tension_given"))
    return StaticComparison(
        name=name,
        kind="line",
        quantities=tuple(_quantities(case, closed, trusses, tolerance)),
        meshes=tuple(Mesh.of(truss, [truss]) for truss in trusses),
        lines=(LinePair(closed, tuple(trusses)),),
        tolerance=tolerance,
        remarks=tuple(remarks),
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
        exact = float(read(self.closed))
        fem = tuple(float(read(truss)) for truss in self.trusses)
        tolerance, line = self.tolerance, self.line
        return Compared(quantity, unit, exact, fem, scale, tolerance, line, theory=theory)


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
        found, limit = largest_distances(closed, trusses)
        yield Compared("shape", "m", 0.0, found, case.line.length, tolerance, limit=limit)


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

    A strain e + c T is that of a bar of (1 + e) times the length; see `catopt.catenary.solve`.
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
        if isinstance(own.EA, StrainTable):
            bars.append(grown(own, length, *own.EA.law(T, T)))
        else:
            bars.append(replace(own, length=length))
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


_LEAST_OFFSET = 0.01
"""Offset by which positions are measured at least, over the length of the longest line."""


def verify_system(
    system: System, *, elements: int, tolerance: float, name: str = ""
) -> StaticComparison:
    """Solve a moored body by the truss model on three meshes beside its closed form.

    The truss model's body does not turn: where the system's does, it is held in the closed form's
    yaw, and the moment of its lines is compared with the one that yaw balances.
    """
    closed = solve_system(system)
    legs, height = truss_legs(system, closed.position.yaw)
    trusses = on_meshes(
        elements,
        lambda bars: [
            mesh_line(leg.line, bars, bends=bends(each.solution))
            for leg, each in zip(legs, closed.lines, strict=True)
        ],
        lambda meshes: solve_truss(
            legs,
            height=height,
            force=system.force,
            seabed_friction=system.seabed_friction,
            meshes=meshes,
        ),
    )
    count = len(system.legs)
    return StaticComparison(
        name=name,
        kind="system",
        quantities=(
            *_body(system, closed, trusses, tolerance),
            *(each for k in range(count) for each in _line(k, closed, trusses, tolerance)),
        ),
        meshes=tuple(Mesh.of(truss, truss.lines) for truss in trusses),
        lines=tuple(
            LinePair(closed.lines[k].solution, tuple(truss.lines[k] for truss in trusses))
            for k in range(count)
        ),
        tolerance=tolerance,
        remarks=tuple(_system_remarks(system, closed)),
    )


def truss_legs(system: System, yaw: float) -> tuple[list[TrussLeg], float]:
    """Lay the lines of a system out for the truss model.

    `yaw`: in which the body is held, rad. Returns: the lines, and the height of the body's origin,
    m: that of the first fairlead.
    """
    height = system.legs[0].fairlead_height
    legs = [
        TrussLeg(
            leg.line,
            (*leg.anchor, leg.anchor_height),
            (*rotated(*leg.fairlead, yaw), leg.fairlead_height - height),
        )
        for leg in system.legs
    ]
    return legs, height


def rotated(x: float, y: float, angle: float) -> tuple[float, float]:
    """Turn a way in plan counter-clockwise by an angle, rad."""
    cosine, sine = math.cos(angle), math.sin(angle)
    return cosine * x - sine * y, sine * x + cosine * y


def _system_remarks(system: System, closed: SystemSolution) -> Iterator[str]:
    for k, line in enumerate(closed.lines):
        if line.solution.regime == "slack":
            yield Message("mooring.of_line", number=k + 1, warning=Message(SLACK))
    if system.turns:
        yield Message("truss.held_yaw", yaw=math.degrees(closed.position.yaw))


def _body(
    system: System, closed: SystemSolution, trusses: Sequence[TrussSystem], tolerance: float
) -> Iterator[Compared]:
    longest = max(leg.line.length for leg in system.legs)
    yield from compared_places(closed, longest, [each.position for each in trusses], tolerance)
    if system.turns:
        arm = max(leg.fairlead_radius for leg in system.legs)
        scale = arm * max(line.fairlead.tension for line in trusses[-1].lines)
        values = tuple(_moment(truss) for truss in trusses)
        yield Compared("moment_of_lines", "Nm", -system.moment, values, scale, tolerance)


def compared_places(
    closed: SystemSolution | BodyAtRest,
    longest: float,
    places: Sequence[Sequence[float]],
    tolerance: float,
    point: str = "",
) -> Iterator[Compared]:
    """Compare where a body is in plan; `longest`: of its lines, m; `places`: on each mesh.

    Errors are seen beside its offset where that is determined, else beside its lines alone.
    """
    scale, way = _LEAST_OFFSET * longest, math.hypot(*closed.offset)
    scale = max(scale, way) if math.isfinite(way) else scale
    exact = (closed.position.x, closed.position.y)
    for axis, key in enumerate(("position_x", "position_y")):
        values = tuple(place[axis] for place in places)
        yield Compared(key, "m", exact[axis], values, scale, tolerance, point=point)


def _moment(truss: TrussSystem) -> float:
    """Moment of the lines on the body about the vertical through its origin, N m."""
    total = 0.0
    for line in truss.lines:
        arm = line.nodes[-1, :2] - np.array(truss.position[:2])
        away = line.nodes[0, :2] - line.nodes[-1, :2]
        pull = line.horizontal_force * away / np.hypot(*away)
        total += float(arm[0] * pull[1] - arm[1] * pull[0])
    return total


def _line(
    k: int, closed: SystemSolution, trusses: Sequence[TrussSystem], tolerance: float
) -> Iterator[Compared]:
    lines = [truss.lines[k] for truss in trusses]
    both = Comparing(closed.lines[k].solution, lines, tolerance, k)
    force, length = both.scales
    yield both.of("fairlead_tension", "N", force, "fairlead.tension")
    yield both.of("anchor_tension", "N", force, "anchor.tension")
    yield from both.of_several(force, length)
