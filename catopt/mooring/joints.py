"""Free joints of lines at rest: where the pulls of the lines balance what hangs there.

The energy of lines that only pull, over a bed that only pushes, is convex in the places of their
ends, so that there is one equilibrium; Newton's method goes down to it. A step is cut back while
the forces at its end push back by more than a part of what they pulled at its start.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from catopt.catenary.pieces import Pieces, cut
from catopt.catenary.solve import refusal
from catopt.catenary.state import CONVERGED
from catopt.errors import FloatsUpError, NoEquilibriumError, NotConvergedError
from catopt.model import Line, Load
from catopt.model.network import LineBetween, Network
from catopt.mooring.line_ends import Ends, Matrix, Vector, ends_of
from catopt.words import Message

TOLERANCE = 1e-9
"""Force left over at a joint, over the largest end force of a line."""

ROUNDING = 2e-15
"""Of the longest line, by which rounding moves an end: over the stiffness that is a force."""

WORTH_A_STEP = 1e-3
"""Of what may be left over: more than that is brought down as long as a step halves it."""

_STEPS = 200
_CUTS = 60
_OVERSHOOT = 0.3
"""Of what the forces pulled at the start of a step, what they may push back at its end."""
_SETTLED = 0.02
"""The same once a step has been cut back: a line that comes taut on the way stops it there, and the
next step has to know how stiff it is."""
_HELD_BACK = 1e-9
"""Spring to where a joint is in one step, over the largest stiffness: nothing else may hold it."""

_GENTLE = 1e-6
"""The same, over what the forces would make of it along the longest line."""


class Run(NamedTuple):
    """A line as the kernel takes it, with the numbers of its points.

    It runs from an anchor, where it has one; else as it was given.
    """

    name: str
    first: int
    second: int
    line: Line
    pieces: Pieces
    segment_of: tuple[int, ...]


class JointsAtRest(NamedTuple):
    """Lines whose joints have come to rest: x, y and height (m) of every point, ends of every line.

    reactions (N) are those with which the bed carries each point, residual the largest force left
    over at a joint (N), steps those of Newton's method.
    """

    places: tuple[Vector, ...]
    ends: tuple[Ends, ...]
    reactions: tuple[float, ...]
    residual: float
    steps: int


def runs_of(network: Network) -> tuple[Run, ...]:
    """Lay out the lines of a network, each from its anchor where it has one."""
    return tuple(_run(k, line, network) for k, line in enumerate(network.lines, start=1))


def _run(number: int, given: LineBetween, network: Network) -> Run:
    first, second = (network.numbers[end] for end in (given.start, given.end))
    line = given.line
    kinds = network.points[first].kind, network.points[second].kind
    if kinds[1] == "anchor" and kinds[0] != "anchor":
        first, second = second, first
        line = turned_line(line)
    return run_of(given.name or f"{number}", first, second, line)


def run_of(name: str, first: int, second: int, line: Line) -> Run:
    """Lay out a line from one point to another."""
    return Run(name, first, second, line, *cut(line))


def turned_line(line: Line) -> Line:
    """Return a line counted from its other end."""
    loads = [replace(load, position=line.length - load.position) for load in line.point_loads]
    return Line(line.segments[::-1], loads)


def joints_at_rest(network: Network, runs: Sequence[Run], held: dict[int, Vector]) -> JointsAtRest:
    """Bring the joints of a network to rest: `held` has the place of its anchors and fairleads, m.

    Raises NoEquilibriumError where friction leaves open where a joint lies or a line that does not
    stretch is too short, FloatsUpError, or NotConvergedError with the force left over.
    """
    found = _Search(network, runs, held).rest() if len(held) < len(network.points) else None
    if found is None:
        places = tuple(held[k] for k in range(len(network.points)))
        ends = tuple(solved(run, places, network.site.seabed_friction) for run in runs)
        found = JointsAtRest(places, ends, (0.0,) * len(places), 0.0, 0)
    _check(network, runs, found)
    return found


class _Search:
    """Newton's method on the places of the joints."""

    def __init__(self, network: Network, runs: Sequence[Run], held: dict[int, Vector]) -> None:
        self.network, self.runs, self.held = network, runs, held
        self.friction = network.site.seabed_friction
        self.joints = [k for k in range(len(network.points)) if k not in held]
        self.motions = {p: (3 * k, UNIT) for k, p in enumerate(self.joints)}
        self.stride = max(run.line.length for run in runs)

    def rest(self) -> JointsAtRest:
        """Step until the forces are in balance, and as long as that still gets better."""
        at = _start(self.network, self.runs, self.held)
        ends = self.ends(at, None)
        best = math.inf
        for step in range(_STEPS):
            forces, laid = self.forces(at, ends)
            largest = max(math.hypot(*pull) for each in ends for pull in (each.first, each.second))
            left = max(math.hypot(*forces[3 * k : 3 * k + 3]) for k in range(len(self.joints)))
            stiffest = max(each.stiffness[i][i] for each in ends for i in range(6))
            limit = TOLERANCE * largest + ROUNDING * self.stride * stiffest
            if left <= limit and not WORTH_A_STEP * limit < left < 0.5 * best:
                reactions = [0.0] * len(at)
                for k, point in enumerate(self.joints):
                    reactions[point] = laid.get(3 * k + 2, 0.0)
                return JointsAtRest(tuple(at), tuple(ends), tuple(reactions), left, step)
            best = min(best, left)
            at, ends = self.step(at, ends, forces, laid)
        values = {"left": left, "steps": _STEPS, "part": left / largest}
        raise NotConvergedError(Message("mooring.joints_not_at_rest", **values))

    def ends(self, at: Sequence[Vector], known: Sequence[Ends] | None) -> list[Ends]:
        """Solve every line."""
        return [
            solved(run, at, self.friction, None if known is None else known[k])
            for k, run in enumerate(self.runs)
        ]

    def forces(
        self, at: Sequence[Vector], ends: Sequence[Ends]
    ) -> tuple[list[float], dict[int, float]]:
        """Sum what is left over at the joints; and what the bed carries, by its freedom."""
        left = [0.0] * (3 * len(self.joints))
        for run, each in zip(self.runs, ends, strict=True):
            for point, force in ((run.first, each.first), (run.second, each.second)):
                if point in self.motions:
                    first = self.motions[point][0]
                    for i in range(3):
                        left[first + i] += force[i]
        laid = {}
        for k, point in enumerate(self.joints):
            up = 3 * k + 2
            for i, hung in enumerate(self.network.points[point].hung):
                left[3 * k + i] += hung
            if at[point][2] <= 0.0 and left[up] <= 0.0:
                laid[up] = -left[up]
                left[up] = 0.0
        return left, laid

    def step(
        self, at: list[Vector], ends: list[Ends], forces: list[float], laid: dict[int, float]
    ) -> tuple[list[Vector], list[Ends]]:
        """Take a step of Newton's method, or as much of it as goes down."""
        matrix = assembled(self.runs, ends, self.motions, len(forces))
        stiffest = max(matrix[i][i] for i in range(len(forces)))
        strongest = max(map(abs, forces))
        for i in range(len(forces)):
            matrix[i][i] += _HELD_BACK * stiffest + _GENTLE * strongest / self.stride
        for i in laid:
            matrix[i] = [float(i == j) for j in range(len(forces))]
        way = [row[0] for row in solve(matrix, [[each] for each in forces])]
        part = min(1.0, self.stride / max(map(abs, way)))
        short, far, pull, push, last = 0.0, math.inf, 0.0, 0.0, part
        for cut_back in range(_CUTS):
            moved = self.moved(at, way, part)
            went = [
                new - old for p in self.joints for new, old in zip(moved[p], at[p], strict=True)
            ]
            downhill = math.fsum(map(float.__mul__, forces, went))
            there = self.ends(moved, ends)
            slope = math.fsum(map(float.__mul__, self.forces(moved, there)[0], went))
            most = _SETTLED if cut_back else _OVERSHOOT
            if abs(slope) <= most * downhill or (slope > 0.0 and math.isinf(far)):
                break
            # Illinois: regula falsi between where the forces still pull on and where they push
            # back; the end that stays counts half, so that a kink between them is closed in on.
            if short == 0.0:
                pull = downhill / part
            if slope > 0.0:
                push = 0.5 * push if short == last else push
                short, pull = part, slope / part
            else:
                pull = 0.5 * pull if far == last else pull
                far, push = part, slope / part
            last = part
            share = pull / (pull - push)
            part = short + min(max(share, 0.01), 0.99) * (far - short)
        return moved, there

    def moved(self, at: Sequence[Vector], way: Sequence[float], part: float) -> list[Vector]:
        """Move the joints, none below the bed."""
        places = list(at)
        for k, point in enumerate(self.joints):
            x, y, z = (at[point][i] + part * way[3 * k + i] for i in range(3))
            places[point] = (x, y, max(z, 0.0))
        return places


UNIT: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def solved(
    run: Run,
    at: Mapping[int, Vector] | Sequence[Vector],
    friction: float,
    known: Ends | None = None,
) -> Ends:
    """Solve a line between its points; an error where it has no answer."""
    a, b = at[run.first], at[run.second]
    ends = ends_of(run.pieces, a, b, friction, None if known is None else known.state)
    if ends.state.status != CONVERGED:
        load = Load(span=max(math.dist(a[:2], b[:2]), 1e-9))
        raise refusal(ends.state.status, run.line, load, ends.problem)
    return ends


def assembled(
    runs: Sequence[Run],
    ends: Sequence[Ends],
    motions: dict[int, tuple[int, Matrix]],
    size: int,
) -> list[list[float]]:
    """Sum the stiffness of lines over the freedoms of their points.

    `motions`: of a point its first freedom, and how it moves by that and those after it (3 rows).
    """
    total = [[0.0] * size for _ in range(size)]
    for run, each in zip(runs, ends, strict=True):
        points = (run.first, run.second)
        for k, p in enumerate(points):
            for m, q in enumerate(points):
                if p not in motions or q not in motions:
                    continue
                (row, by_p), (column, by_q) = motions[p], motions[q]
                own = [line[3 * m : 3 * m + 3] for line in each.stiffness[3 * k : 3 * k + 3]]
                half = product(own, by_q)
                for i, values in enumerate(product(tuple(zip(*by_p, strict=True)), half)):
                    for j, value in enumerate(values):
                        total[row + i][column + j] += value
    return total


def product(a: Sequence[Sequence[float]], b: Sequence[Sequence[float]]) -> Matrix:
    """Multiply two matrices."""
    columns = tuple(zip(*b, strict=True))
    return tuple(
        tuple(sum(map(float.__mul__, row, each)) for each in columns) for row in map(tuple, a)
    )


def solve(matrix: Sequence[Sequence[float]], sides: Sequence[Sequence[float]]) -> list[list[float]]:
    """Solve linear equations for several right hand sides (columns), with exchange of rows."""
    size = len(matrix)
    rows = [[*row, *side] for row, side in zip(matrix, sides, strict=True)]
    for j in range(size):
        pivot = max(range(j, size), key=lambda r: abs(rows[r][j]))
        rows[j], rows[pivot] = rows[pivot], rows[j]
        for r in range(j + 1, size):
            if factor := rows[r][j] / rows[j][j]:
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[j], strict=True)]
    for j in reversed(range(size)):
        rows[j] = [each / rows[j][j] for each in rows[j]]
        for r in range(j):
            if factor := rows[r][j]:
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[j], strict=True)]
    return [row[size:] for row in rows]


def _start(network: Network, runs: Sequence[Run], held: dict[int, Vector]) -> list[Vector]:
    """Put joints where lines would hold them that are springs without a length of their own.

    What ends one line alone stands off by its length, the way it is pulled.
    """
    joints = [k for k in range(len(network.points)) if k not in held]
    order = {point: k for k, point in enumerate(joints)}
    matrix = [[0.0] * len(joints) for _ in joints]
    sides = [[0.0] * 3 for _ in joints]
    for run in runs:
        stiffness = 1.0 / run.line.length
        for p, q in ((run.first, run.second), (run.second, run.first)):
            if p in order:
                row = order[p]
                matrix[row][row] += stiffness
                if q in order:
                    matrix[row][order[q]] -= stiffness
                else:
                    sides[row] = [
                        a + stiffness * b for a, b in zip(sides[row], held[q], strict=True)
                    ]
    lone = [k for k in joints if sum(k in (run.first, run.second) for run in runs) == 1]
    for point in lone:
        hung = network.points[point].hung
        pull = math.hypot(*hung)
        sides[order[point]] = [
            side + force / pull for side, force in zip(sides[order[point]], hung, strict=True)
        ]
    found = solve(matrix, sides)
    return [held[k] if k in held else _place(found[order[k]]) for k in range(len(network.points))]


def _place(row: Sequence[float]) -> Vector:
    x, y, z = row
    return (x, y, z)


def _check(network: Network, runs: Sequence[Run], found: JointsAtRest) -> None:
    """Refuse what lies where friction leaves it open, and buoys above the surface."""
    site = network.site
    for point, reaction in zip(network.points, found.reactions, strict=True):
        if reaction > 0.0 and site.seabed_friction > 0.0:
            said = Message("mooring.joint_on_bed", name=point.name, reaction=reaction)
            raise NoEquilibriumError(said, "force", reaction)
    check_afloat(network, found.places)
    for run, each in zip(runs, found.ends, strict=True):
        is_anchored = network.points[run.first].kind == "anchor"
        length = each.state.grounded
        if length > 0.0 and site.seabed_friction > 0.0 and not is_anchored:
            said = Message("mooring.drags_both_ways", number=run.name, length=length)
            raise NoEquilibriumError(said, "force", length)


def check_afloat(network: Network, places: Sequence[Vector]) -> None:
    """Refuse buoys above the surface."""
    depth = network.site.water_depth
    for point, place in zip(network.points, places, strict=True):
        above = place[2] - depth
        if point.submerged_weight < 0.0 and above > 1e-9 * depth:
            values = {"name": point.name, "above": above, "lift": -point.submerged_weight}
            raise FloatsUpError(Message("mooring.joint_floats_up", **values))
